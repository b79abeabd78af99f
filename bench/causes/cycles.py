"""Plans of cyclic records: loadings, unloadings and reloads of specimens that crack or not, by the maps and by the rod."""

import dataclasses
import zlib

import numpy as np

import rod
from friction import draw_levels, draw_of_cycles, logarithmic
from passes import Hinged, Specimen, by_cracks, draw_curvature, follow, growth, legs_of, openings_of, stage_at, stepwise
from record import Record, mean_friction
from rig import draw_rig, smaller_errors

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


def draw_losses(random, damage, deepest):
    """Deflections at which a share of the remaining stiffness is lost at once."""
    if damage not in ("cracks", "both", "hinge"):
        return []
    number = int(random.integers(1, 9))
    total = random.uniform(0.04, 0.25 if damage == "hinge" else 0.30)
    parts = random.dirichlet(np.full(number, 2.0))
    places = np.sort(random.uniform(0.06, 0.96 * deepest, number))
    return [(float(w), float(1 - (1 - total) ** part)) for w, part in zip(places, parts)]


def draw_depth(random):
    return 0.0 if random.uniform() < 0.12 else random.uniform(0, 0.55)


def draw_plan(random, shapes, kind):
    """A plan. The curves by which stiffness and supports give way come from random numbers of their own."""
    damage, programme = KINDS[kind]
    if damage == "any":
        damage = str(random.choice(["none", "cracks", "both"], p=[0.4, 0.35, 0.25]))
    passes = {"cycle": 3, "unload": 2, "twice": 5, "farther": 3}[programme]
    deepest = random.uniform(0.15, 0.30 if programme == "farther" else 0.38)
    farther = min(deepest * random.uniform(1.08, 1.5), 0.38) if programme == "farther" else deepest
    friction_kind, friction = draw_of_cycles(random, damage, 2.4 * farther**2)
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


def make_specimen(plan, maps):
    if plan.damage == "hinge":
        return Hinged(maps, plan.k, plan.friction, openings_of(plan.losses))
    sudden = stepwise(plan.losses)
    gradual = growth(0.06, plan.deepest, plan.slow_loss_power)
    giving = growth(plan.settling_begins, plan.deepest, plan.settling_power)
    stiffness = lambda w: sudden(w) * (1 - plan.slow_loss * gradual(w))
    settling = lambda w: plan.settled * giving(w)
    return Specimen(maps.get(curvature=plan.curvature), plan.k, plan.friction, stiffness, settling)


def turns_of(plan, top, last):
    """Stage positions of the turns, from the contact on: every loading ends at the top, but the last where it goes farther."""
    turns = [0.0, top]
    for depth in plan.depths:
        turns += [depth * top, top]
    return turns[:-1] if plan.programme == "unload" else turns[:-1] + [last]


# ---- records


def reaches(plan, maps, deflection):
    """The stage position at which a deflection is first reached."""
    if plan.damage == "hinge":
        specimen = Specimen(maps.get(hinge=openings_of(plan.losses)[-1][1]), plan.k, plan.friction)
    else:
        specimen = make_specimen(plan, maps)
    return stage_at(specimen, deflection)


def of_map(kind, name, number, seed, attempt, maps):
    """A record, and the random numbers for what is read; None if the rig does not hold the specimen at the depth drawn."""
    random = np.random.default_rng([zlib.crc32(kind.encode()), number, seed, attempt])
    shapes = np.random.default_rng([zlib.crc32(name.encode()), seed, attempt])
    plan = draw_plan(random, shapes, kind)
    top, last = reaches(plan, maps, plan.deepest), reaches(plan, maps, plan.farther)
    if top is None or last is None:
        return None
    rig = dataclasses.replace(draw_rig(random, plan.k), toe=plan.toe)
    specimen = make_specimen(plan, maps)
    path = follow(specimen, legs_of(turns_of(plan, top, last), -rig.contact, plan.rows), plan.levels)
    if path.w.max() > 0.40:
        return None
    friction = mean_friction(path, specimen.friction)
    path = by_cracks(path) if plan.friction_kind in ("constant", "slow") else path
    return Record(kind, "map", rig, path, plan.friction_kind, friction, plan.curvature / 8), random


def of_rod(kind, number, seed, attempt, rods):
    """The same of the dynamic rod; None if it blew up."""
    random = np.random.default_rng([zlib.crc32(kind.encode()), number, seed, attempt])
    made = rod.cycle(random, rods)
    if made is None:
        return None
    path, friction, k, name = made
    return Record(kind, "rod", smaller_errors(draw_rig(random, k)), path, name, friction), random


def make(kind, name, number, seed, attempt, workshop):
    if kind == "rod":
        return of_rod(kind, number, seed, attempt, workshop.rods)
    return of_map(kind, name, number, seed, attempt, workshop.maps)
