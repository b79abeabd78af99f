"""Simulated records of cyclic bending tests, made by a foreign mechanics, with the truth of each.

    /usr/bin/python3 bench/reload/records.py OUT --kinds none cracks --count 20 --seed 1

Writes OUT/NAME/case.toml and OUT/NAME/test.csv for each record, and OUT/truth.csv. The mechanics are those of the prototypes
(--prototypes, ../shared/prototypes unless given), which are no part of the repository.
"""

import argparse
import csv
import dataclasses
import pathlib
import shutil
import sys
import zlib

import numpy as np

import rod
from passes import Branch, Hinged, Maps, Specimen, follow

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]

# What happens to the specimen, and how it is loaded, by kind. "any" is one of none, cracks, both.
KINDS = {
    "none": ("none", "cycle"),
    "cracks": ("cracks", "cycle"),
    "both": ("both", "cycle"),
    "hinge": ("hinge", "cycle"),
    "settled": ("settled", "cycle"),
    "toe": ("toe", "cycle"),
    "slow": ("slow", "cycle"),
    "stiff": ("any", "cycle"),
    "unload": ("any", "unload"),
    "twice": ("any", "twice"),
    "farther": ("any", "farther"),
    "rod": ("none", "cycle"),  # of another mechanics: rod.py
}


@dataclasses.dataclass
class Plan:
    """What a record is drawn to be, in reduced units: span 1, EI 1."""

    kind: str
    damage: str
    programme: str
    k: float
    deepest: float  # deflection at the first turn
    farther: float  # deflection at the last turn, where a reload goes farther, else that of the first
    depths: list  # stage at each bottom turn over the stage at the top
    rows: int
    levels: list  # friction of each pass over that of the first
    friction_kind: str
    friction: object
    losses: list  # deflections and shares of sudden losses
    slow_loss: float = 0.0
    slow_loss_power: float = 1.0  # of its growth with deflection
    settled: float = 0.0  # for good at the greatest deflection of the first loading
    settling_begins: float = 0.0  # deflection
    settling_power: float = 1.0
    toe: float = 0.0
    curvature: float = 0.0  # natural, of the unloaded specimen


# ---- what is drawn


def logarithmic(random, low, high):
    return float(np.exp(random.uniform(np.log(low), np.log(high))))


def rough(random, rms, length, reach=0.8, step=2e-4):
    """A Gaussian process over S - 1 with a Matern 3/2 correlation, drawn exactly by circulant embedding."""
    points = 16384
    lag = np.minimum(np.arange(points), points - np.arange(points)) * step * np.sqrt(3) / length
    spectrum = np.sqrt(np.maximum(np.fft.fft((1 + lag) * np.exp(-lag)).real, 0))
    noise = random.normal(size=points) + 1j * random.normal(size=points)
    values = rms * np.fft.fft(spectrum * noise).real / np.sqrt(points)
    places = np.arange(int(reach / step)) * step
    values = values[: len(places)]
    return lambda S: np.interp(S - 1, places, values)


def slow(random, size, reach):
    """Friction that varies slowly: a slope, and a wave about as long as the stretch slid over."""
    slope, height, phase = random.uniform(-size, size), random.uniform(0, size / 2), random.uniform(0, 2 * np.pi)
    length = reach * random.uniform(0.7, 2)
    return lambda S: slope * ((S - 1) / reach - 0.5) + height * np.cos(2 * np.pi * (S - 1) / length + phase)


def draw_friction(random, damage, reach):
    """The name and the function of friction over S; friction is nowhere below .02."""
    mean = random.uniform(0.15, 0.9)
    choices = {"cracks": ["constant", "slow"], "both": ["wave", "rough"]}
    kind = random.choice(choices.get(damage, ["constant", "wave", "rough", "slow"]))
    trend = slow(random, 0.15, reach) if kind == "slow" or random.uniform() < 0.25 else lambda S: 0 * S
    if kind == "wave":
        height, length, phase = mean * random.uniform(0.05, 0.3), logarithmic(random, 0.008, 0.05), random.uniform(0, 2 * np.pi)
        detail = lambda S: height * np.cos(2 * np.pi * (S - 1) / length + phase)
    elif kind == "rough":
        detail = rough(random, random.uniform(0.03, 0.12), random.uniform(0.004, 0.015))
    else:
        detail = lambda S: 0 * S
    return str(kind), lambda S: np.maximum(mean + trend(S) + detail(S), 0.02)


def draw_losses(random, damage, deepest):
    """Deflections at which a share of the remaining stiffness is lost at once."""
    if damage not in ("cracks", "both", "hinge"):
        return []
    number = int(random.integers(1, 9))
    total = random.uniform(0.04, 0.25 if damage == "hinge" else 0.30)
    parts = random.dirichlet(np.full(number, 2.0))
    places = np.sort(random.uniform(0.06, 0.96 * deepest, number))
    return [(float(w), float(1 - (1 - total) ** part)) for w, part in zip(places, parts)]


def draw_levels(random, passes):
    """Friction of each pass over that of the first: in half of the records it wears."""
    levels = [1.0]
    wears = random.uniform() < 0.5
    for turn in range(1, passes):
        top = turn % 2 == 1
        levels.append(levels[-1] * (random.uniform(0.85 if top else 0.5, 1) if wears else 1.0))
    return levels


def draw_depth(random):
    return 0.0 if random.uniform() < 0.12 else random.uniform(0, 0.55)


def draw_curvature(random):
    """The natural curvature of a bow of .0013 spans (standard deviation), on the grid for which maps are kept."""
    step = 0.0007
    return 8 * step * float(np.clip(np.round(random.normal(0, 0.0013) / step), -4, 4))


def draw_plan(random, shapes, kind):
    """A plan. The curves by which stiffness and supports give way come from random numbers of their own."""
    damage, programme = KINDS[kind]
    if damage == "any":
        damage = str(random.choice(["none", "cracks", "both"], p=[0.4, 0.35, 0.25]))
    passes = {"cycle": 3, "unload": 2, "twice": 5, "farther": 3}[programme]
    deepest = random.uniform(0.15, 0.30 if programme == "farther" else 0.38)
    farther = min(deepest * random.uniform(1.08, 1.5), 0.38) if programme == "farther" else deepest
    friction_kind, friction = draw_friction(random, damage, 2.4 * farther**2)
    return Plan(
        kind=kind,
        damage=damage,
        programme=programme,
        k=logarithmic(random, 300, 3000) if kind == "stiff" else logarithmic(random, 8, 300),
        deepest=deepest,
        farther=farther,
        depths=[draw_depth(random) for _ in range(passes // 2)],
        rows=int(random.integers(120, 701)),
        levels=draw_levels(random, passes),
        friction_kind=friction_kind,
        friction=friction,
        losses=draw_losses(random, damage, deepest),
        slow_loss=random.uniform(0.04, 0.25) if damage == "slow" else 0.0,
        settled=random.uniform(0, 0.05) * deepest if damage == "settled" else 0.0,
        toe=random.uniform(0.001, 0.008) if damage == "toe" else 0.0,
        curvature=0.0 if damage == "hinge" else draw_curvature(random),
        slow_loss_power=shapes.uniform(0.7, 2),
        settling_begins=shapes.uniform(0.1, 0.5) * deepest,
        settling_power=shapes.uniform(0.8, 2),
    )


# ---- the mechanics


def growth(start, end, power):
    """Grows from 0 to 1 with the greatest deflection, between two deflections."""
    return lambda w: np.clip((w - start) / (end - start), 0, 1) ** power


def hinge_compliance(left):
    """The compliance of a hinge that leaves this share of the stiffness, on the grid for which maps are kept."""
    return round((1 / left - 1) / 3 / 0.005) * 0.005


def shares_left(plan):
    """The share of the stiffness that is left after each sudden loss, from 1 on."""
    return np.cumprod([1.0] + [1 - loss for _, loss in plan.losses])


def make_specimen(plan, maps):
    places, shares = np.array([w for w, _ in plan.losses]), shares_left(plan)
    if plan.damage == "hinge":
        openings = [(w, hinge_compliance(left)) for w, left in zip(places, shares[1:])]
        return Hinged(maps, plan.k, plan.friction, openings)
    gradual = growth(0.06, plan.deepest, plan.slow_loss_power)
    giving = growth(plan.settling_begins, plan.deepest, plan.settling_power)
    stiffness = lambda w: shares[np.searchsorted(places, w)] * (1 - plan.slow_loss * gradual(w))
    settling = lambda w: plan.settled * giving(w)
    return Specimen(maps.get(curvature=plan.curvature), plan.k, plan.friction, stiffness, settling)


def stage_at(plan, maps, deflection):
    """The stage position of the first loading at which a deflection is first reached; None if the rig never comes to rest there."""
    if plan.damage == "hinge":
        specimen = Specimen(maps.get(hinge=hinge_compliance(shares_left(plan)[-1])), plan.k, plan.friction)
    else:
        specimen = make_specimen(plan, maps)
    branch = Branch(specimen, specimen.S, +1, 1.0)
    balance, _ = specimen.stage(branch)
    stable = balance >= np.maximum.accumulate(balance)
    reached = stable & (branch.w >= deflection)
    if not np.any(reached):
        return None
    first = int(np.argmax(reached))
    return float(balance[first]) if branch.w[first] < deflection + 0.04 else None


def turns_of(plan, top, last):
    """Stage positions of the turns, from the contact on: every loading ends at the top, but the last where it goes farther."""
    turns = [0.0, top]
    for depth in plan.depths:
        turns += [depth * top, top]
    return turns[:-1] if plan.programme == "unload" else turns[:-1] + [last]


def legs_of(turns, start, rows):
    """Stage positions of each pass, at equal steps; the first begins at start."""
    turns = [start] + turns[1:]
    step = np.abs(np.diff(turns)).sum() / rows
    legs = []
    for a, b in zip(turns[:-1], turns[1:]):
        number = max(int(round(abs(b - a) / step)), 2)
        legs.append(a + (b - a) * np.arange(0 if not legs else 1, number + 1) / number)
    return legs


# ---- the rig, and what is written


@dataclasses.dataclass
class Rig:
    """A real rig: its true numbers in SI units, and what the laboratory states and reads."""

    span: float
    stiffness: float
    bending_stiffness: float
    contact: float  # reduced; positive where the record begins before the contact
    span_error: float = 0.0
    stiffness_error: float = 0.0
    bending_error: float = 0.0
    gain: float = 0.0
    drift: float = 0.0
    lag: float = 0.0
    noise: float = 0.0
    memory: float = 0.0
    steps: float = 0.0  # of the force, over the noise
    states_bending: bool = True
    states_rig: bool = False


def draw_rig(random, k):
    bench = random.uniform() < 0.3
    span = random.uniform(20e-3, 60e-3) if bench else logarithmic(random, 0.6e-3, 3e-3)
    stiffness = logarithmic(random, 500, 5000) if bench else logarithmic(random, 10, 150)
    return Rig(
        span=span,
        stiffness=stiffness,
        bending_stiffness=stiffness * span**3 / k,
        contact=random.choice([-1, 1]) * random.uniform(0.0005, 0.002),
        span_error=0.005 * random.normal(),
        stiffness_error=0.01 * random.normal(),
        bending_error=0.03 * random.normal(),
        gain=0.007 * random.normal(),
        drift=0.003 * random.normal(),
        lag=random.uniform() if random.uniform() < 0.5 else 0.0,
        noise=random.uniform(0.001, 0.004),
        memory=random.uniform(0.3, 0.8) if random.uniform() < 0.5 else 0.0,
        steps=random.uniform(0.5, 2) if random.uniform() < 1 / 3 else 0.0,
        states_bending=random.uniform() >= 0.2,
        states_rig=random.uniform() < 0.5,
    )


def smaller_errors(rig):
    """The rig of a rod: half of the errors, and a record that begins under a small force."""
    halves = {name: getattr(rig, name) / 2 for name in ("span_error", "stiffness_error", "gain", "drift", "noise")}
    return dataclasses.replace(rig, contact=-abs(rig.contact), **halves)


def autoregressive(random, number, memory):
    values = random.normal(size=number)
    for i in range(1, number):
        values[i] = memory * values[i - 1] + np.sqrt(1 - memory**2) * values[i]
    return values


def read(random, rig, plan, path):
    """Stage and force as the rig records them, in reduced units."""
    F = path.F.copy()
    stage = path.stage.copy()
    if plan.toe:
        stage = stage + plan.toe * (1 - np.exp(-F / (0.05 * F.max())))
    if rig.lag:
        F = (1 - rig.lag) * F + rig.lag * np.r_[F[0], F[:-1]]
    time = np.linspace(0, 1, len(F))
    wander = rig.drift * (time + 0.4 * np.sin(2 * np.pi * (1.3 * time + random.uniform())))
    F = F * (1 + rig.gain) + F.max() * (wander - wander[0])
    noise = rig.noise * path.F.max()
    F = F + noise * autoregressive(random, len(F), rig.memory)
    if rig.steps:
        F = np.round(F / (rig.steps * noise)) * rig.steps * noise
    return stage - stage[0] if rig.contact < 0 else stage + rig.contact, F


def case_text(name, rig):
    spread = lambda share: f" ± {share}"
    bending = "fit" if not rig.states_bending else f"{rig.bending_stiffness * (1 + rig.bending_error):.5g} N m^2" + spread("3 %")
    lines = [
        f"# Simulated: {name}. Made by bench/reload/records.py.",
        "[specimen]",
        f'bending_stiffness = "{bending}"',
        "",
        "[rig]",
        f'span = "{rig.span * (1 + rig.span_error) * 1e6:.2f} um{spread("0.5 %")}"',
        f'stiffness = "{rig.stiffness * (1 + rig.stiffness_error):.5g} N/m{spread("1 %")}"',
        "",
        "[record]",
        'file = "test.csv"',
        'stage = "stage [um]"',
        'force = "force [mN]"',
    ]
    if rig.states_rig:
        lines += ['gain_error = "0.7 %"', f'preload_error = "{0.0013 * rig.span * 1e6:.2f} um"']
    return "\n".join(lines) + "\n"


def write_record(folder, name, rig, stage, F):
    target = folder / name
    target.mkdir(parents=True, exist_ok=True)
    (target / "case.toml").write_text(case_text(name, rig), encoding="utf-8")
    force = F * rig.bending_stiffness / rig.span**2 * 1e3
    with open(target / "test.csv", "w", encoding="utf-8") as file:
        file.write("stage [um],force [mN]\n")
        for x, f in zip(stage * rig.span * 1e6, force):
            file.write(f"{x:.4f},{f:.7g}\n")


# ---- the truth


def count_drops(plan, path, noise):
    """Falls of the force within one step of the first loading, deeper than the noise, that came of slips, and of cracks.

    A slip draws in three times the arc of the steps around it: a force that falls slowly is none.
    """
    first = path.passed == 0
    fall, lost, drawn_in = -np.diff(path.F[first]), -np.diff(path.left[first]), np.diff(path.S[first])
    deep = fall > max(4 * noise, 0.003) * path.F.max()
    usual = np.array([np.median(drawn_in[max(i - 10, 0) : i + 11]) for i in range(len(drawn_in))])
    cracks = deep & (lost > 0.002) & bool(plan.losses)
    slips = deep & ~cracks & (drawn_in > 3 * usual)
    return int(np.sum(slips)), int(np.sum(cracks))


def mean_friction(path, specimen):
    """The mean over the arc slid over in the first loading, from where the deflection is .06 on."""
    first = path.passed == 0
    start = float(np.interp(0.06, path.w[first], path.S[first]))
    return float(np.mean(specimen.friction(np.linspace(start, path.S[first].max(), 4000))))


def truth_of(name, plan, rig, path, friction, settled):
    slips, cracks = count_drops(plan, path, rig.noise)
    return {
        "name": name,
        "kind": plan.kind,
        "damage": plan.damage,
        "mean_friction": f"{friction:.5f}",
        "friction": plan.friction_kind,
        "EI_true_over_stated": f"{1 / (1 + rig.bending_error):.5f}" if rig.states_bending else "",
        "EI_true": f"{rig.bending_stiffness:.6g}",
        "stiffness_lost": f"{1 - path.left[-1]:.5f}",
        "settled": f"{settled:.5f}",
        "toe": f"{plan.toe:.5f}",
        "cause": "both" if slips and cracks else "slips" if slips else "cracks" if cracks else "none",
        "drops": slips + cracks,
        "drops_by_slips": slips,
        "drops_by_cracks": cracks,
        "k": f"{plan.k:.2f}",
        "w_max": f"{path.w.max():.4f}",
        "depth": " ".join(f"{depth:.3f}" for depth in plan.depths),
        "rows": len(path.stage),
        "rows_out": int(np.sum(path.sliding < 0)),
        "levels": " ".join(f"{level:.3f}" for level in plan.levels),
        "S_end": f"{path.S[path.passed == 0].max():.5f}",
        "noise": f"{rig.noise:.4f}",
        "contact": f"{rig.contact:.5f}",
        "bow": f"{plan.curvature / 8 + 0.0:.5f}",
        "lag": f"{rig.lag:.3f}",
    }


# ---- one record, and all


def record_of_map(name, kind, number, seed, attempt, maps):
    """Plan, rig, path, mean friction and settling of one record; None if the rig does not hold the specimen at the depth drawn."""
    random = np.random.default_rng([zlib.crc32(kind.encode()), number, seed, attempt])
    shapes = np.random.default_rng([zlib.crc32(name.encode()), seed, attempt])
    plan = draw_plan(random, shapes, kind)
    top, last = stage_at(plan, maps, plan.deepest), stage_at(plan, maps, plan.farther)
    if top is None or last is None:
        return None
    rig = draw_rig(random, plan.k)
    specimen = make_specimen(plan, maps)
    path = follow(specimen, legs_of(turns_of(plan, top, last), -rig.contact, plan.rows), plan.levels)
    if path.w.max() > 0.40:
        return None
    settled = float(specimen.settling(np.array([specimen.greatest]))[0])
    return random, plan, rig, path, mean_friction(path, specimen), settled


def record_of_rod(kind, number, seed, attempt, rods):
    """The same of the dynamic rod; None if it blew up."""
    random = np.random.default_rng([zlib.crc32(kind.encode()), number, seed, attempt])
    made = rod.simulate(random, rods)
    if made is None:
        return None
    path, friction, k, turns, friction_kind = made
    plan = Plan(
        kind=kind,
        damage="none",
        programme="cycle",
        k=k,
        deepest=path.w.max(),
        farther=path.w.max(),
        depths=[turns[2] / turns[1]],
        rows=len(path.stage),
        levels=[1.0, 1.0, 1.0],
        friction_kind=friction_kind,
        friction=None,
        losses=[],
    )
    return random, plan, smaller_errors(draw_rig(random, k)), path, friction, 0.0


def make_record(kind, number, seed, maps, rods, folder):
    """Draws until a record can be made, and writes it. Returns its truth."""
    name = f"{kind}-{number:03d}"
    for attempt in range(100):
        if kind == "rod":
            made = record_of_rod(kind, number, seed, attempt, rods)
        else:
            made = record_of_map(name, kind, number, seed, attempt, maps)
        if made is not None:
            random, plan, rig, path, friction, settled = made
            write_record(folder, name, rig, *read(random, rig, plan, path))
            return truth_of(name, plan, rig, path, friction, settled)
    raise RuntimeError(f"{name}: no plan of a hundred comes to rest")


def write_truth(folder, truths):
    """Writes the truths into truth.csv, beside those of other records that are there already."""
    file = folder / "truth.csv"
    new = {truth["name"] for truth in truths}
    kept = [line for line in csv.DictReader(file.open(encoding="utf-8")) if line["name"] not in new] if file.exists() else []
    with file.open("w", newline="", encoding="utf-8") as target:
        writer = csv.DictWriter(target, fieldnames=list(truths[0]))
        writer.writeheader()
        writer.writerows(kept + truths)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--kinds", nargs="+", default=[kind for kind in KINDS if kind != "rod"], choices=list(KINDS))
    parser.add_argument("--count", type=int, default=20, help="records of each kind; a rod takes about 10 s")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--prototypes", type=pathlib.Path, default=REPOSITORY.parent / "shared" / "prototypes")
    options = parser.parse_args()
    needed = [options.prototypes / "realrig" / "mech3.py", options.prototypes / "rod" / "der.cpp"]
    if not all(file.exists() for file in needed):
        print(f"No records made: the prototypes are not in {options.prototypes}; say where they are with --prototypes.")
        return 0
    maps = Maps(options.prototypes / "realrig")
    if "rod" in options.kinds and shutil.which("g++") is None:
        print("No records made: rods need g++, which is not installed.")
        return 0
    rods = rod.Rods(options.prototypes) if "rod" in options.kinds else None
    options.out.mkdir(parents=True, exist_ok=True)
    truths = [
        make_record(kind, number, options.seed, maps, rods, options.out) for kind in options.kinds for number in range(options.count)
    ]
    write_truth(options.out, truths)
    print(f"{len(truths)} records in {options.out}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
