"""Records by the program's own mechanics: `flexslip simulate` on friction tables, with snaps, cracks, rollers and bars."""

import dataclasses
import itertools
import json
import pathlib
import subprocess
import tempfile

import numpy as np

from passes import MOBILISED, Path, event_of

SLIDES = {"slip_in": 1, "snap": 1, "crack": 1, "slip_out": -1}
TABLE_POINTS = 20000  # at most
SAME_STAGE = 1e-9  # between events that are one


@dataclasses.dataclass
class Test:
    """What is simulated, in reduced units."""

    k: float
    frictions: list  # Frictions of the supports: one, or one each
    reach: float  # stretch of S slid over
    losses: list = dataclasses.field(default_factory=list)  # deflections and shares
    wear: float = 1.0
    snaps: str = "nearest"
    roller_radius: float = 0.0
    height: float = 0.0  # of a bar


class Simulator:
    """Runs a program in a folder that lives as long as this object; knife is the map of a specimen on knife edges."""

    def __init__(self, program, knife):
        self.program, self.knife = pathlib.Path(program).resolve(), knife
        self.folder = tempfile.TemporaryDirectory()

    def run(self, test, legs):
        """The path of a specimen whose stage goes through legs of positions; None where the program refuses the test, or the
        specimen slips through its supports."""
        stage = np.concatenate(legs)
        touching = stage > 0
        folder = pathlib.Path(self.folder.name)
        (folder / "case.toml").write_text(case_of(test, folder), encoding="utf-8")
        np.savetxt(folder / "stage.csv", np.r_[0, stage[touching]], fmt="%.9f", header="w_s", comments="")
        command = [self.program, "simulate", folder / "case.toml", "--json", "--quiet"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            return None
        answer = json.loads(done.stdout)
        passed = np.concatenate([np.full(len(leg), number) for number, leg in enumerate(legs)])
        return path_of(answer, stage, touching, passed, test.losses, events_of(answer, self.knife))


def case_of(test, folder):
    """The case file; writes its friction tables."""
    cracks = ", ".join(f"{{deflection = {w:.9f}, loss = {loss:.6f}}}" for w, loss in test.losses)
    lines = ["reduced = true", "[specimen]"] + ([f"cracks = [{cracks}]"] if cracks else [])
    lines += [f"width = {3 * test.height}", f"height = {test.height}"] if test.height else []
    lines += ["[rig]", f"stiffness = {test.k}"] + ([f"roller_radius = {test.roller_radius}"] if test.roller_radius else [])
    for number, friction in enumerate(test.frictions):
        write_table(folder / f"friction-{number}.csv", friction, test.reach)
        lines += ["[friction]" if number == 0 else "[friction.other]", 'model = "table"', f'file = "friction-{number}.csv"']
        lines += ['length = "S"', 'mu = "mu"']
        lines += [f"wear = {test.wear}"] if number == 0 and test.wear < 1 else []
        lines += [f"static_excess = {friction.excess}"] if friction.excess else []
    lines += ["[stage]", 'file = "stage.csv"', 'stage = "w_s"', f'snaps = "{test.snaps}"']
    return "\n".join(lines) + "\n"


def write_table(file, friction, reach):
    """Four points on what friction varies over."""
    points = int(np.clip(1.5 * reach / friction.finest * 4, 60, TABLE_POINTS))
    S = np.linspace(1, 1 + 1.5 * reach, points)
    np.savetxt(file, np.c_[S, friction.of(S)], delimiter=",", fmt="%.9f", header="S,mu", comments="")


def path_of(answer, stage, touching, passed, losses, events):
    """The rows of the answer, behind those before the contact."""
    column = lambda name, free: fill(touching, [row[name] for row in answer["path"][1:]], free)
    w = column("deflection", 0.0)
    shares = np.cumprod([1.0] + [1 - loss for _, loss in losses])
    left = shares[np.searchsorted([place for place, _ in losses], np.maximum.accumulate(w), side="right")]
    sliding = fill(touching, [SLIDES.get(row["motion"], 0) for row in answer["path"][1:]], 0)
    return Path(stage, column("length", 1.0), column("q", 0.0), w, column("force", 0.0), left, sliding, passed, events)


def fill(touching, values, free):
    column = np.full(len(touching), free, dtype=float)
    column[touching] = values
    return column


def events_of(answer, knife):
    """The sudden events of the first loading. A crack and the snap that it sets off, at the same stage position, are one."""
    together = first_loading(answer["snaps"]) + answer["cracks"]
    together.sort(key=lambda event: (event["stage"], event["deflection_before"]))
    events, left = [], 1.0
    for _, group in itertools.groupby(together, key=lambda event: round(event["stage"] / SAME_STAGE)):
        group = list(group)
        after = min([left] + [event["left"] for event in group if "left" in event])
        events.append(one_event(knife, group[0], group[-1], left, after))
        left = after
    return events


def one_event(knife, begin, end, left, after):
    """From the beginning of one fall to the end of another, with the shares of stiffness left before and after."""
    stage, before, rest = begin["stage"], begin["force_before"], end["force_after"]
    if after == left:
        return event_of(stage, before, rest, 0.0, 0.0)
    q = mobilised(knife, begin["deflection_before"], before / left)
    by_friction = after * float(knife.force.ev(end["deflection_after"], q)) - rest
    return event_of(stage, before, rest, 1 - after / left, by_friction)


def first_loading(snaps):
    """Those before the stage first turns back."""
    stages = np.array([snap["stage"] for snap in snaps])
    back = np.flatnonzero(np.diff(stages) < -SAME_STAGE)
    return snaps[: back[0] + 1] if len(back) else list(snaps)


def mobilised(knife, deflection, force):
    """The friction at which a sound specimen on knife edges bears a force."""
    return np.interp(force, knife.force.ev(np.full(len(MOBILISED), deflection), MOBILISED), MOBILISED)
