"""FlexSlip: friction at the supports of a three-point bending test, read off its force curve.

>>> import flexslip
>>> fit = flexslip.fit("examples/simulated/case.toml")
>>> fit.params["wavelength"].unit
'm'

Quantities are strings with units, ``"1.278 mm"``, or floats in SI. Answers have the names and units of the program's JSON. :mod:`flexslip.types` has all
classes.
"""
from . import types
from ._answers import Estimate, Quantity
from ._campaign import Campaign, campaign
from ._case import Case, keys
from ._design import design
from ._equilibrium import equilibrium, equilibrium_region
from ._errors import InputError
from ._fit import Fit, fit
from ._flexslip import version as __version__
from ._modulus import Modulus, modulus
from ._read import read
from ._rollers import elastica_on_rollers, elastica_on_rollers_inverse
from ._simulate import friction_profile, simulate
from ._states import elastica, elastica_details, elastica_inverse, elastica_slopes
from ._surface import surface
from ._sweep import sweep

__all__ = [
    "Campaign", "Case", "Estimate", "Fit", "InputError", "Modulus", "Quantity", "campaign", "design", "elastica", "elastica_details",
    "elastica_inverse", "elastica_on_rollers", "elastica_on_rollers_inverse", "elastica_slopes", "equilibrium", "equilibrium_region", "fit",
    "friction_profile", "keys", "modulus", "read", "simulate", "surface", "sweep",
]


def __getattr__(name: str) -> type:
    """A class of :mod:`flexslip.types`; all of them once had their names here."""
    if name in types.__all__:
        return vars(types)[name]  # type: ignore[no-any-return]
    raise AttributeError(f"module 'flexslip' has no attribute {name!r}")
