"""The classes of what functions of the package give and raise, for annotations and isinstance.

>>> import flexslip.types
>>> isinstance(flexslip.fit("examples/simulated/case.toml").profile, flexslip.types.Table)
True
"""
from ._answers import Answer, Description, Estimate, Quantity, Table
from ._campaign import Campaign
from ._case import Case
from ._design import Design, DesignMap
from ._equilibrium import Equilibrium, EquilibriumRegion
from ._errors import FolderError, ForbiddenFileError, InputError, MissingFileError
from ._fit import Draws, Fit
from ._modulus import Modulus
from ._read import Export
from ._rollers import RollerStates
from ._simulate import Profile, Simulation
from ._states import Details, Inverse, Slopes, States
from ._surface import Surface, SurfaceWave, WaveResolution

__all__ = [
    "Answer", "Campaign", "Case", "Description", "Design", "DesignMap", "Details", "Draws", "Equilibrium", "EquilibriumRegion", "Estimate",
    "Export", "Fit", "FolderError", "ForbiddenFileError", "InputError", "Inverse", "MissingFileError", "Modulus", "Profile", "Quantity",
    "RollerStates", "Simulation", "Slopes", "States", "Surface", "SurfaceWave", "Table", "WaveResolution",
]
