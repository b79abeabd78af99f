"""FlexSlip: friction at the supports of a three-point bending test, read off its force curve.

>>> import flexslip
>>> fit = flexslip.fit("examples/simulated/case.toml")
>>> fit.params["wavelength"].unit
'm'

Quantities are strings with units, ``"1.278 mm"``, or floats in SI. Answers have the names and units of the program's JSON.
"""
from ._answers import Answer, Description, Estimate, Quantity, Table
from ._case import Case, keys
from ._errors import InputError
from ._fit import Draws, Fit, fit
from ._flexslip import version as __version__

__all__ = ["Answer", "Case", "Description", "Draws", "Estimate", "Fit", "InputError", "Quantity", "Table", "fit", "keys"]
