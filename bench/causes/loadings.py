"""Plans of records of one loading, some of them unloaded and loaded again, by three simulators."""

import dataclasses
import zlib

import numpy as np
from scipy.signal import lfilter

import friction as frictions
import own
import rod
from friction import draw_levels, logarithmic
from passes import Hinged, Specimen, by_cracks, draw_curvature, follow, growth, legs_of, openings_of, stage_at, stepwise
from record import Record, falls_of, mean_friction
from rig import RIGID, any_reading, draw_rig, smaller_errors

DEEPEST = 0.42  # deflection
MOST_DROPS = 150
SOUGHT = 25  # attempts at a record that shows what is meant to act in it
AS_IT_COMES = 0.2  # share of the records in which it need not show
BOWED_FROM = 0.06  # deflection; the maps hold no bow of a specimen that is bent little


@dataclasses.dataclass(frozen=True)
class Kind:
    """What may act on the specimens of a kind, and on what rig."""

    simulator: str
    cause: str  # slips, cracks, both or none
    details: tuple = ("constant",)
    trends: tuple = ("level",)
    losses: str = "none"  # a key of LOSSES, "at_slips" or "hinge"
    snaps: str = "nearest"
    supports: int = 1  # frictions: one of both supports, or one each
    roller_radius: tuple = (0.0, 0.0)
    height: tuple = (0.0, 0.0)
    gradual: str = "none"  # yields, relaxes or settles
    reload: bool = False

    @property
    def slow(self):
        return set(self.details) <= set(SLOW) and self.trends != ("falling",)


SLOW = ("constant", "slow")  # of themselves they snap nothing
SNAPPING = ("wave", "rough", "stick_slip")
ROLLERS, BAR = (0.005, 0.08), (0.02, 0.12)

ONE_LOADING = {
    "constant": Kind("own", "slips"),
    "wave": Kind("own", "slips", ("wave",)),
    "two_waves": Kind("own", "slips", ("two_waves",)),
    "rough": Kind("own", "slips", ("rough",)),
    "granular": Kind("own", "slips", ("granular",)),
    "climbing": Kind("own", "slips", SNAPPING, ("climbing",)),
    "falling": Kind("own", "slips", ("constant",) + SNAPPING, ("falling",)),
    "stick_slip": Kind("own", "slips", ("stick_slip",)),
    "overshoot": Kind("own", "slips", SNAPPING, snaps="overshoot"),
    "rollers": Kind("own", "slips", ("wave", "rough"), roller_radius=ROLLERS),
    "thick": Kind("own", "slips", ("stick_slip", "rough"), height=BAR),
    "thick_rollers": Kind("own", "slips", ("wave", "rough"), height=BAR, roller_radius=ROLLERS),
    "unlike": Kind("own", "slips", ("wave", "rough"), supports=2),
    "map_constant": Kind("map", "slips"),
    "map_wave": Kind("map", "slips", ("wave",)),
    "map_rough": Kind("map", "slips", ("rough",)),
    "map_slow": Kind("map", "slips", ("slow",)),
    "rod_constant": Kind("rod", "slips"),
    "rod_wave": Kind("rod", "slips", ("wave",)),
    "rod_stick_slip": Kind("rod", "slips", ("stick_slip",)),
    "cracks_equal": Kind("own", "cracks", SLOW, losses="equal"),
    "cracks_growing": Kind("own", "cracks", SLOW, losses="growing"),
    "cracks_few": Kind("own", "cracks", SLOW, losses="few"),
    "cracks_one": Kind("own", "cracks", SLOW, losses="one"),
    "cracks_many": Kind("own", "cracks", SLOW, losses="many"),
    "cracks_climbing": Kind("own", "cracks", SLOW, ("climbing",), losses="any"),
    "cracks_rollers": Kind("own", "cracks", SLOW, losses="any", roller_radius=ROLLERS),
    "cracks_thick": Kind("own", "cracks", SLOW, losses="up_to_five", height=BAR),
    "map_cracks": Kind("map", "cracks", SLOW, losses="any"),
    "map_hinge": Kind("map", "cracks", SLOW, losses="hinge"),
    "cracks_on_wave": Kind("own", "both", ("wave", "two_waves"), losses="any"),
    "cracks_on_rough": Kind("own", "both", ("rough", "granular"), losses="any"),
    "cracks_on_stick_slip": Kind("own", "both", ("stick_slip",), losses="any"),
    "cracks_hidden": Kind("own", "both", ("stick_slip",), losses="hidden"),
    "cracks_at_slips": Kind("own", "both", ("stick_slip", "wave"), losses="at_slips"),
    "map_both": Kind("map", "both", ("wave", "rough"), losses="any"),
    "yields": Kind("map", "none", SLOW, gradual="yields"),
    "relaxes": Kind("map", "none", SLOW, gradual="relaxes"),
    "settles": Kind("map", "none", SLOW, gradual="settles"),
}
LOADED_AGAIN = (
    "wave rough stick_slip overshoot thick map_wave cracks_equal cracks_few cracks_many cracks_thick map_cracks "
    "cracks_on_wave cracks_on_stick_slip cracks_at_slips map_both"
).split()
KINDS = ONE_LOADING | {f"{name}_reload": dataclasses.replace(ONE_LOADING[name], reload=True) for name in LOADED_AGAIN}


# ---- the losses of stiffness


def shares(total, parts):
    """Losses that make up a total, in proportion to parts."""
    return 1 - (1 - total) ** (parts / parts.sum())


def spread(random, number, depth):
    return np.sort(random.uniform(0.12 * depth, 0.97 * depth, number))


def equal(random, depth):
    number = int(round(logarithmic(random, 2, 40)))
    places = depth * (0.12 + 0.85 * (np.arange(number) + random.uniform(0.2, 0.8, number)) / number)
    return places, shares(random.uniform(0.04, 0.5), random.uniform(0.85, 1.15, number))


def growing(random, depth):
    number = int(round(logarithmic(random, 3, 40)))
    return spread(random, number, depth), shares(random.uniform(0.06, 0.5), np.arange(1, number + 1) ** random.uniform(0.5, 2))


def few(random, depth):
    number = int(random.integers(1, 5))
    return spread(random, number, depth), np.exp(random.uniform(np.log(0.03), np.log(0.3), number))


def one(random, depth):
    return spread(random, 1, depth), np.array([logarithmic(random, 0.03, 0.4)])


def many(random, depth):
    number = int(random.integers(20, 61))
    return spread(random, number, depth), shares(random.uniform(0.1, 0.7), random.dirichlet(np.full(number, 3.0)))


def up_to_five(random, depth):
    number = int(random.integers(1, 6))
    return spread(random, number, depth), shares(random.uniform(0.03, 0.4), random.dirichlet(np.full(number, 2.0)))


def any_number(random, depth):
    number = int(round(logarithmic(random, 1, 20)))
    return spread(random, number, depth), shares(random.uniform(0.04, 0.4), random.dirichlet(np.full(number, 2.0)))


def hidden(random, depth):
    number = int(random.integers(1, 4))
    return spread(random, number, depth), np.exp(random.uniform(np.log(0.005), np.log(0.05), number))


def hinges(random, depth):
    """Losses of one to eight openings of a hinge."""
    number = int(random.integers(1, 9))
    return spread(random, number, depth), shares(random.uniform(0.04, 0.3), random.dirichlet(np.full(number, 2.0)))


LOSSES = {
    "none": lambda random, depth: (np.array([]), np.array([])),
    "equal": equal,
    "growing": growing,
    "few": few,
    "one": one,
    "many": many,
    "up_to_five": up_to_five,
    "any": any_number,
    "hidden": hidden,
    "hinge": hinges,
    "at_slips": lambda random, depth: (np.array([]), np.array([])),
}


# ---- a plan


@dataclasses.dataclass
class Plan:
    """What a record is drawn to be, in reduced units."""

    k: float
    depth: float  # deflection
    rows: int
    frictions: list
    losses: list  # deflections and shares
    levels: list  # friction of each pass over that of the first
    unloaded_to: float  # stage at the bottom over that at the top

    @property
    def reach(self):
        """The stretch of the arc that is slid over, about."""
        return 2.4 * self.depth**2

    def turns(self, top):
        return [0.0, top] if len(self.levels) == 1 else [0.0, top, self.unloaded_to * top, top]


def draw_rows(random, passes):
    rows = logarithmic(random, 3000, 100000) if random.uniform() < 0.03 else logarithmic(random, 30, 3000) * passes
    return int(rows)


def draw_plan(random, kind):
    depth = logarithmic(random, 0.015, 0.4)
    k = RIGID if random.uniform() < 0.05 else logarithmic(random, 3, 30000)
    places, losses = LOSSES[kind.losses](random, depth)
    return Plan(
        k=k,
        depth=depth,
        rows=draw_rows(random, 3 if kind.reload else 1),
        frictions=[frictions.draw(random, kind.details, kind.trends, 2.4 * depth**2) for _ in range(kind.supports)],
        losses=[(float(w), float(loss)) for w, loss in zip(places, losses)],
        levels=draw_levels(random, 3) if kind.reload else [1.0],
        unloaded_to=random.uniform(0, 0.6),
    )


# ---- by the program


def without_detail(plan):
    """Friction averaged over twentieths of the stretch slid over."""
    edges = np.linspace(1, 1 + plan.reach, 21)
    centres = (edges[1:] + edges[:-1]) / 2
    of = lambda S: np.mean([friction.of(S) * (1 + friction.excess / 2) for friction in plan.frictions], axis=0)
    means = [np.mean(of(np.linspace(a, b, 50))) for a, b in zip(edges[:-1], edges[1:])]
    return lambda S: np.interp(S, centres, means)


def apart(places, distance):
    """Of rising places those that keep a distance from the one kept before."""
    kept = []
    for place in places:
        if not kept or place > kept[-1] + distance:
            kept.append(float(place))
    return kept


def crack_at_slips(random, simulator, test, legs):
    """Losses of .5 to 4 % at slips, not so near that one sets off the next. Each moves the slips behind it: their places are sought
    again until they hold about."""
    cost = np.exp(random.uniform(np.log(0.005), np.log(0.04), 40))
    for _ in range(4):
        path = simulator.run(test, legs)
        if path is None:
            return None
        first = path.passed == 0
        deep = [event.stage for event in path.events if event.slipped > 0.004 * path.F.max()]
        places = np.interp(deep, path.stage[first], path.w[first])
        test.losses = list(zip(apart(places, path.w.max() / len(cost)), cost.tolist()))
    return test


def of_program(random, name, kind, workshop):
    """A record; None if the rig does not hold the specimen."""
    plan = draw_plan(random, kind)
    knife = workshop.maps.get()
    alike = Specimen(knife, plan.k, without_detail(plan), stepwise(plan.losses), deepest=1.3 * plan.depth, points=2000)
    top = stage_at(alike, plan.depth)
    if top is None:
        return None
    rig = any_reading(random, draw_rig(random, plan.k), top)
    radius = logarithmic(random, *kind.roller_radius) if kind.roller_radius[1] else 0.0
    height = logarithmic(random, *kind.height) if kind.height[1] else 0.0
    errors = dict(roller_error=0.01 * random.normal(), height_error=0.005 * random.normal())
    rig = dataclasses.replace(rig, roller_radius=radius, height=height, **errors)
    wear = plan.levels[1] if kind.reload else 1.0
    test = own.Test(plan.k, plan.frictions, plan.reach, plan.losses, wear, kind.snaps, radius, height)
    legs = legs_of(plan.turns(top), -rig.contact, plan.rows)
    if kind.losses == "at_slips":
        test = crack_at_slips(random, workshop.simulator, test, legs)
    path = workshop.simulator.run(test, legs) if test else None
    if path is None or path.w.max() > DEEPEST:
        return None
    mean = np.mean([mean_friction(path, friction.of) for friction in plan.frictions])
    return Record(name, "own", rig, path, plan.frictions[0].name, mean, excess=plan.frictions[0].excess)


# ---- by the maps


def make_specimen(random, kind, plan, maps):
    """The specimen, and its bow."""
    deepest = 1.25 * plan.depth
    if kind.losses == "hinge":
        return Hinged(maps, plan.k, plan.frictions[0].of, openings_of(plan.losses), deepest), 0.0
    curvature = draw_curvature(random) if plan.depth > BOWED_FROM else 0.0
    lost = random.uniform(0.05, 0.3) if kind.gradual == "yields" else 0.0
    yielding = growth(random.uniform(0.1, 0.5) * plan.depth, 1.1 * plan.depth, random.uniform(0.7, 2))
    given = random.uniform(0, 0.05) * plan.depth if kind.gradual == "settles" else 0.0
    giving = growth(random.uniform(0.1, 0.5) * plan.depth, plan.depth, random.uniform(0.8, 2))
    sudden = stepwise(plan.losses)
    stiffness, settling = lambda w: sudden(w) * (1 - lost * yielding(w)), lambda w: given * giving(w)
    return Specimen(maps.get(curvature=curvature), plan.k, plan.frictions[0].of, stiffness, settling, deepest), curvature / 8


def relaxed(random, path, k):
    """The path of a specimen that relaxes towards a share of its force, as a standard linear solid. The stage stands where the
    smaller force lets it."""
    share, time = random.uniform(0.03, 0.2), random.uniform(0.1, 0.6) * len(path.F)
    fading = np.exp(-1 / time)
    lasting = lfilter([1.0, -1.0], [1.0, -fading], path.F)
    F = (1 - share) * path.F + share * lasting
    return dataclasses.replace(path, F=F, stage=path.stage + (F - path.F) / k)


def of_map(random, name, kind, workshop):
    """A record; None if the rig does not hold the specimen."""
    plan = draw_plan(random, kind)
    specimen, bow = make_specimen(random, kind, plan, workshop.maps)
    sought = specimen
    if kind.losses == "hinge":
        weakest = workshop.maps.get(hinge=specimen.openings[-1][1])
        sought = Specimen(weakest, plan.k, plan.frictions[0].of, deepest=1.25 * plan.depth)
    top = stage_at(sought, plan.depth)
    if top is None:
        return None
    rig = any_reading(random, draw_rig(random, plan.k), top)
    path = follow(specimen, legs_of(plan.turns(top), -rig.contact, plan.rows), plan.levels)
    path = relaxed(random, path, plan.k) if kind.gradual == "relaxes" else path
    if path.w.max() > DEEPEST or np.any(np.diff(path.stage[path.passed == 0]) <= 0):
        return None
    return Record(name, "map", rig, path, plan.frictions[0].name, mean_friction(path, specimen.friction), bow)


# ---- by the rod


def of_rod(random, name, kind, workshop):
    """A record; None if the rod blew up."""
    detail = kind.details[0]
    made = rod.loading(random, workshop.rods, detail == "wave", detail == "stick_slip")
    if made is None:
        return None
    path, friction, k, shape = made
    rig = smaller_errors(draw_rig(random, k))
    return Record(name, "rod", dataclasses.replace(rig, noise=logarithmic(random, 0.0005, 0.01)), path, shape, friction)


SIMULATORS = {"own": of_program, "map": of_map, "rod": of_rod}


def shows(kind, record):
    """True if every cause that is meant to act makes a drop, and not more of them than a laboratory would count."""
    slipped, cracked = (int(np.sum(parts > 0)) for parts in falls_of(record.path, record.rig.noise))
    slips = kind.slow or kind.cause not in ("slips", "both") or 0 < slipped <= MOST_DROPS
    return slips and (kind.cause not in ("cracks", "both") or cracked > 0)


def make(kind, number, seed, attempt, workshop):
    """A record, and the random numbers for what is read; None if the attempt failed.

    In most records what is meant to act shows. Friction on a stiff rig seldom snaps: such records are sought.
    """
    place = [zlib.crc32(kind.encode()), number, seed]
    random = np.random.default_rng([*place, attempt])
    record = SIMULATORS[KINDS[kind].simulator](random, kind, KINDS[kind], workshop)
    if record is None:
        return None
    if KINDS[kind].slow:
        record.path = by_cracks(record.path)
    sought = attempt < SOUGHT and np.random.default_rng(place).uniform() > AS_IT_COMES
    return None if sought and not shows(KINDS[kind], record) else (record, random)
