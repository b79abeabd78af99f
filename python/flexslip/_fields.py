"""The classes of the answers, made from what the program says of them; _fields.pyi, which the build writes (tools/write-python-stubs), has their types."""
from __future__ import annotations

from ._answers import ANSWERS, made_classes, make_class


def _made(path: str, answer: str, name: str, what: str) -> type:
    return make_class((path,), ANSWERS[answer]["entries"], name, what)


FitFields = _made("fit", "fit --json", "FitFields", "What a measured test shows.")
SimulationFields = _made("simulation", "simulate --json", "SimulationFields", "What a test would measure.")
ProfileFields = _made("profile", "invert --json", "ProfileFields", "Friction point by point.")
DesignFields = _made("design", "design --json", "DesignFields", "What a planned test will show.")
CampaignFields = _made("campaign", "campaign --json", "CampaignFields", "What many tests show.")
EquilibriumFields = _made("equilibrium", "equilibrium --json", "EquilibriumFields", "The curve of loading.")
EquilibriumRegionFields = _made("equilibrium_region", "equilibrium --region --json", "EquilibriumRegionFields", "All equilibria.")
ModulusFields = _made("modulus", "modulus --json", "ModulusFields", "The numbers of the bending standards.")
ExportFields = _made("export", "read --json", "ExportFields", "What an export holds.")

globals().update({made.__name__: made for made in made_classes()})
