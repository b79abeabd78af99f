"""FlexSlip: friction at the supports of a three-point bending test, read off its force curve.

>>> import flexslip
>>> fit = flexslip.fit("examples/simulated/case.toml")
>>> fit.params["wavelength"].unit
'm'

Quantities are strings with units, ``"1.278 mm"``, or floats in SI. Answers have the names and units of the program's JSON.
"""
from ._answers import Answer, Description, Estimate, Quantity, Table
from ._campaign import Campaign, campaign
from ._case import Case, keys
from ._design import Design, DesignMap, design
from ._equilibrium import Equilibrium, EquilibriumRegion, equilibrium, equilibrium_region
from ._errors import FolderError, ForbiddenFileError, InputError, MissingFileError
from ._fit import Draws, Fit, fit
from ._flexslip import version as __version__
from ._modulus import Modulus, modulus
from ._read import Export, read
from ._rollers import RollerStates, elastica_on_rollers, elastica_on_rollers_inverse
from ._simulate import Profile, Simulation, friction_profile, simulate
from ._states import Details, Inverse, Slopes, States, elastica, elastica_details, elastica_inverse, elastica_slopes
from ._surface import Surface, surface
from ._sweep import sweep

__all__ = [
    "Answer", "Campaign", "Case", "Description", "Design", "DesignMap", "Details", "Draws", "Equilibrium", "EquilibriumRegion", "Estimate",
    "Export", "Fit", "FolderError", "ForbiddenFileError", "InputError", "Inverse", "MissingFileError", "Modulus", "Profile", "Quantity",
    "RollerStates", "Simulation", "Slopes", "States", "Surface", "Table", "campaign", "design", "elastica", "elastica_details",
    "elastica_inverse", "elastica_on_rollers", "elastica_on_rollers_inverse", "elastica_slopes", "equilibrium", "equilibrium_region", "fit",
    "friction_profile", "keys", "modulus", "read", "simulate", "surface", "sweep",
]
