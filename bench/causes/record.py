"""A record as it was simulated, and its truth."""

import dataclasses

import numpy as np

from passes import Path
from rig import Rig

DEEP = 4  # noises, from which a fall of the force is a drop
VERTICAL = 0.6  # share of the fall of a row that is sudden
BOTH = 0.1  # share of the summed falls that a cause takes at least where both act


@dataclasses.dataclass
class Record:
    """What a simulator makes; numbers are reduced."""

    kind: str
    simulator: str
    rig: Rig
    path: Path
    friction: str
    mean_friction: float
    bow: float = 0.0
    excess: float = 0.0  # of static over kinetic friction


def falls_of(path, noise):
    """What slips, and cracks, took of the force in each drop of the first loading.

    A drop is a row whose force falls by more than four noises, most of it at once. What takes less than that is no drop of its own.
    """
    first = path.passed == 0
    stage, F = path.stage[first], path.F[first]
    deep = DEEP * noise * F.max()
    parts = np.zeros((len(F) + 1, 2))
    for event in path.events:
        parts[np.searchsorted(stage, event.stage)] += event.slipped, event.cracked
    parts, fall = parts[1:-1], -np.diff(F)
    whole = parts.sum(axis=1)
    drops = (fall > deep) & (whole > VERTICAL * fall)
    parts *= np.minimum(1, fall / np.maximum(whole, 1e-300))[:, None]  # of many falls in a row only the sum is seen
    return np.where(parts > deep, parts, 0)[drops].T


def cause_of(slipped, cracked):
    """What made the drops: both only if each made a tenth of their sum."""
    total = slipped.sum() + cracked.sum()
    if total == 0:
        return "none"
    share = cracked.sum() / total
    return "slips" if share < BOTH else "cracks" if share > 1 - BOTH else "both"


def truth_of(name, record):
    path, rig = record.path, record.rig
    slipped, cracked = falls_of(path, rig.noise)
    return {
        "name": name,
        "kind": record.kind,
        "simulator": record.simulator,
        "cause": cause_of(slipped, cracked),
        "drops_by_slips": int(np.sum(slipped > 0)),
        "drops_by_cracks": int(np.sum(cracked > 0)),
        "fallen_by_slips": f"{slipped.sum():.5f}",
        "fallen_by_cracks": f"{cracked.sum():.5f}",
        "k": f"{rig.k:.2f}",
        "w_max": f"{path.w.max():.4f}",
        "rows": len(path.stage),
        "rows_out": int(np.sum(path.sliding < 0)),
        "noise": f"{rig.noise:.5f}",
        "steps": f"{rig.steps:.3f}",
        "lag": f"{rig.lag:.3f}",
        "stiffness_lost": f"{1 - path.left[-1]:.5f}",
        "friction": record.friction,
        "mean_friction": f"{record.mean_friction:.5f}",
        "static_excess": f"{record.excess:.3f}",
        "EI_true_over_stated": f"{1 / (1 + rig.bending_error):.5f}" if rig.states_bending else "",
        "EI_true": f"{rig.bending_stiffness:.6g}",
        "contact": f"{rig.contact:.5f}",
        "bow": f"{record.bow + 0.0:.5f}",
        "roller_radius": f"{rig.roller_radius:.4f}",
        "height": f"{rig.height:.4f}",
        "reload": int(path.passed.max() > 0),
    }


def mean_friction(path, friction):
    """The mean over the arc slid over in the first loading, from where the deflection is .06 on, or half of the greatest."""
    first = path.passed == 0
    start = float(np.interp(min(0.06, path.w[first].max() / 2), path.w[first], path.S[first]))
    return float(np.mean(friction(np.linspace(start, path.S[first].max(), 4000))))
