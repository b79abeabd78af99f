"""A specimen of a foreign mechanics, loaded and unloaded any number of times.

The map of the bent specimen, S(w, q) and F(w, q), comes from the shooting program mech3.py of the prototypes, which uses nothing
of FlexSlip. Everything is reduced: span 1, bending stiffness EI 1; the load train has the stiffness k in EI/L^3, and the stage
stands at w + F/k, or farther where the supports have given way.

A specimen slides in on q = +mu(S), sticks while |q| < mu(S), and slides out on q = -mu(S). At each stage position it takes the
first state on its way that is in balance with the load train, so that it snaps over stretches where none is stable.
"""

import dataclasses
import hashlib
import importlib
import pathlib
import sys
import tempfile

import numpy as np
from scipy.interpolate import RectBivariateSpline

ARC_POINTS = 15000  # of the grid in S; a row moves the support by some hundred of these
MOBILISED = np.arange(-1.15, 1.56, 0.05)  # grid of the mobilised friction q in the maps
STUCK_POINTS = 160  # between q = -mu and q = +mu, where S is constant
FRICTION_LIMIT = 1.1  # the maps reach a little farther


@dataclasses.dataclass
class Path:
    """What a specimen does: a row each stage position, in reduced units."""

    stage: np.ndarray
    S: np.ndarray
    q: np.ndarray
    w: np.ndarray
    F: np.ndarray
    left: np.ndarray  # share of the stiffness
    sliding: np.ndarray  # +1 in, 0 stuck, -1 out
    passed: np.ndarray  # number of the pass
    events: list  # Events of the first pass


@dataclasses.dataclass
class Event:
    """A sudden fall of the force at a stage position, and what of it came of falling friction, and of lost stiffness."""

    stage: float
    slipped: float
    cracked: float


SUDDEN = 0.002  # share of the stiffness that is lost at once, from which a loss counts as a crack


def event_of(stage, before, after, lost, by_friction):
    """The event between two forces. What stiffness takes is what falling friction leaves of the fall; by_friction is the force that
    the friction lost would bear at the end."""
    fall = max(before - after, 0.0)
    if lost <= SUDDEN:
        return Event(stage, fall, 0.0)
    slipped = min(max(by_friction, 0.0), fall)
    return Event(stage, slipped, fall - slipped)


def by_cracks(path):
    """The path, on friction that varies too slowly to snap: whatever falls where stiffness is lost, the crack takes."""
    whole = lambda event: Event(event.stage, 0.0, event.slipped + event.cracked) if event.cracked else event
    return dataclasses.replace(path, events=[whole(event) for event in path.events])


class Map:
    """S(w, q) and F(w, q) of one specimen as splines."""

    def __init__(self, deflections, arc, force):
        self.deepest = deflections[-1]
        self.arc = RectBivariateSpline(deflections, MOBILISED, arc)
        self.force = RectBivariateSpline(deflections, MOBILISED, force)

    def deflection(self, S, q):
        """The deflection at which the arc between the supports is S, by Newton's method."""
        w = np.clip(np.sqrt(np.maximum(S - 1, 1e-9) / 2.4), 1e-4, self.deepest)
        for _ in range(7):
            slope = np.maximum(self.arc.ev(w, q, dx=1), 1e-3)
            w = np.clip(w - np.clip((self.arc.ev(w, q) - S) / slope, -0.05, 0.05), 1e-4, self.deepest)
        return w


class Maps:
    """Maps by hinge compliance and natural curvature, made once and kept in the temporary folder."""

    def __init__(self, prototypes):
        sys.path.insert(0, str(prototypes))
        self.mech3 = importlib.import_module("mech3")
        source = (pathlib.Path(prototypes) / "mech3.py").read_bytes()
        self.folder = pathlib.Path(tempfile.gettempdir()) / ("flexslip-maps-" + hashlib.sha256(source).hexdigest()[:12])
        self.folder.mkdir(exist_ok=True)
        self.made = {}

    def get(self, hinge=0.0, curvature=0.0):
        key = f"hinge{hinge:.4f}-curvature{curvature:.4f}"
        if key not in self.made:
            file = self.folder / (key + ".npz")
            if not file.exists():
                self._shoot(file, hinge, curvature)
            values = np.load(file)
            self.made[key] = Map(values["deflections"], values["arc"], values["force"])
        return self.made[key]

    def _shoot(self, file, hinge, curvature):
        depths = self.mech3.WG[self.mech3.WG < 0.6]
        shot = self.mech3.Mech(hinge=hinge, kn=curvature, qg=MOBILISED, wg=depths, N=80)
        solved = np.flatnonzero(shot.err.max(axis=1) < 1e-9)
        deflections = np.r_[0, depths[: solved[-1] + 1][shot.err[: solved[-1] + 1].max(axis=1) < 1e-9]]
        np.savez(file, deflections=deflections, arc=shot.S(deflections, MOBILISED), force=shot.F(deflections, MOBILISED))


class Branch:
    """States on the way from S on, inwards (direction +1, q = +mu) or outwards (-1, q = -mu), one a step of the grid.

    Outwards it ends where the force would become negative: there the nose lifts off and the specimen stays as it is.
    """

    def __init__(self, specimen, S, direction, level):
        grid = specimen.grid[specimen.grid > S] if direction > 0 else specimen.grid[specimen.grid < S][::-1]
        self.direction = direction
        self.S = np.r_[S, grid]
        self.q = direction * level * specimen.friction(self.S)
        self.w = specimen.map.deflection(self.S, self.q)
        self.shape = specimen.map.force.ev(self.w, self.q)  # force of a specimen that has lost no stiffness
        if direction < 0 and np.any(self.shape < 0):
            last = int(np.argmax(self.shape < 0))
            self.S, self.q, self.w, self.shape = (a[: max(last, 1)] for a in (self.S, self.q, self.w, self.shape))


class Specimen:
    """The state of a specimen on its rig, and what its past has left: stiffness, and the settling of its supports.

    friction(S) is the coefficient in the first loading. stiffness(w) is the share left, and settling(w) the way the supports have
    given way, when the greatest deflection so far is w.
    """

    def __init__(self, map_, k, friction, stiffness=None, settling=None, deepest=0.5, points=ARC_POINTS):
        self.map, self.k = map_, k
        self.friction = lambda S: np.minimum(friction(S), FRICTION_LIMIT)
        self.stiffness = stiffness or (lambda w: np.ones_like(w))
        self.settling = settling or (lambda w: np.zeros_like(w))
        last = float(map_.arc.ev(min(deepest, map_.deepest - 0.01), 0.0))
        step = (last - 1) / points
        self.grid = np.arange(1 + step, last, step)
        self.S = self.grid[0]
        self.events = []
        self.greatest = 0.0  # deflection so far

    def stage(self, branch):
        """Stage positions at which the states of a branch are in balance, and the share of stiffness left there."""
        greatest = np.maximum(branch.w, self.greatest)
        if branch.direction > 0:
            greatest = np.maximum.accumulate(greatest)
        left = self.stiffness(greatest)
        return branch.w + left * branch.shape / self.k + self.settling(greatest), left

    def move(self, stages, direction, level):
        """Goes through stage positions that rise (direction +1) or fall (-1), where friction is level times that of the first pass.

        Returns a row each: S, q, w, F, stiffness left, and +1, 0, -1 for sliding in, stuck, sliding out.
        """
        if len(stages) == 0:
            return np.zeros((0, 6))
        branch = Branch(self, self.S, direction, level)
        balance, left = self.stage(branch)
        slides = direction * (stages - balance[0]) > 0
        rows = np.zeros((len(stages), 6))
        rows[~slides] = Stuck(self, branch.S[0]).rows(stages[~slides])
        rows[slides] = first_passages(branch, balance, left, stages[slides])
        self.events += self._events(branch, balance, left, stages) if direction > 0 else []
        lifted = slides & (rows[:, 5] == 0)
        if np.any(lifted):
            rows[lifted] = Stuck(self, branch.S[-1]).rows(stages[lifted])
        if len(rows):
            self.S = rows[-1, 0]
            self.greatest = max(self.greatest, rows[:, 2].max()) if direction > 0 else self.greatest
        return rows


    def _events(self, branch, balance, left, stages):
        """Where a branch snaps or loses stiffness at stage positions that are gone through."""
        reached = np.maximum.accumulate(balance)
        within = balance < reached
        within[1:] |= left[1:] < (1 - SUDDEN) * left[:-1]
        begins, ends = np.flatnonzero(np.diff(within.astype(int)) > 0), np.flatnonzero(np.diff(within.astype(int)) < 0) + 1
        events = []
        for a, b in zip(begins, ends):
            if stages[0] < reached[a] <= stages[-1]:
                by_friction = left[b] * float(self.map.force.ev(branch.w[b], branch.q[a]) - branch.shape[b])
                before, after = left[a] * branch.shape[a], left[b] * branch.shape[b]
                events.append(event_of(float(reached[a]), before, after, 1 - left[b] / left[a], by_friction))
        return events


def first_passages(branch, balance, left, stages):
    """The rows of the first states of a branch that are in balance at each stage position; zeros beyond its end."""
    sign = branch.direction
    rows = np.zeros((len(stages), 6))
    if len(balance) < 2:
        return rows
    passed = np.maximum.accumulate(sign * balance)
    after = np.searchsorted(passed, sign * stages)  # first state at which the balance has reached the stage
    within = after < len(balance)
    after = np.clip(after[within], 1, None)
    step = balance[after] - balance[after - 1]
    part = np.where(sign * step > 0, (stages[within] - balance[after - 1]) / np.where(step == 0, 1, step), 1.0)
    part = np.clip(part, 0, 1)
    between = lambda a: a[after - 1] + part * (a[after] - a[after - 1])
    states = [between(a) for a in (branch.S, branch.q, branch.w, left * branch.shape)]
    rows[within] = np.c_[tuple(states) + (left[after], np.full(len(after), sign))]
    return rows


class Hinged(Specimen):
    """A specimen that cracks at midspan: at each of its deflections a hinge opens to a compliance c, an angle per moment, and the
    stiffness at small deflection falls to 1/(1 + 3 c)."""

    def __init__(self, maps, k, friction, openings, deepest=0.5):
        super().__init__(maps.get(), k, friction, deepest=deepest)
        self.maps, self.openings, self.share = maps, list(openings), 1.0

    def move(self, stages, direction, level):
        if self.openings and direction > 0:
            rows = self._load_until_it_cracks(stages, level)
        else:
            rows = super().move(stages, direction, level)
        rows[:, 4] = np.where(rows[:, 4] == 1, self.share, rows[:, 4])
        return rows

    def _load_until_it_cracks(self, stages, level):
        before = self.S, self.greatest, list(self.events)
        rows = super().move(stages, +1, level)
        cracked = rows[:, 2] > self.openings[0][0]
        if not np.any(cracked):
            return rows
        first = int(np.argmax(cracked))
        self.S, self.greatest, self.events = before
        rows[:first] = super().move(stages[:first], +1, level)
        rows[:first, 4] = self.share
        self.S = rows[first, 0]
        before, whole = rows[first].copy(), self.share
        self._open()
        super().move(stages[first : first + 1], -1, level)  # the open hinge needs less arc, so that the specimen may slide out
        rows[first:] = self.move(stages[first:], +1, level)
        by_friction = float(self.map.force.ev(rows[first, 2], before[1]) - rows[first, 3])
        self.events.append(event_of(stages[first], before[3], rows[first, 3], 1 - self.share / whole, by_friction))
        return rows

    def _open(self):
        compliance = self.openings.pop(0)[1]
        self.map = self.maps.get(hinge=compliance)
        self.share = 1 / (1 + 3 * compliance)


class Stuck:
    """States of a specimen that holds its arc S, over the friction that the maps hold."""

    def __init__(self, specimen, S):
        self.specimen, self.S = specimen, S
        self.q = np.linspace(MOBILISED[0], MOBILISED[-1], STUCK_POINTS)
        self.w = specimen.map.deflection(np.full(STUCK_POINTS, S), self.q)
        self.left = float(specimen.stiffness(np.array([specimen.greatest]))[0])
        self.F = self.left * specimen.map.force.ev(self.w, self.q)
        self.given = float(specimen.settling(np.array([specimen.greatest]))[0])
        self.balance = self.w + self.F / specimen.k + self.given

    def rows(self, stages):
        """A row for each stage position: without force where the nose has lifted off."""
        if self.S <= self.specimen.grid[0] * (1 + 1e-12):
            return self._straight(stages)
        q = np.interp(stages, self.balance, self.q)
        w = np.interp(stages, self.balance, self.w)
        F = np.interp(stages, self.balance, self.F)
        F = np.maximum(F, 0)
        none = np.zeros_like(q)
        return np.c_[none + self.S, q, w, F, none + self.left, none]

    def _straight(self, stages):
        """A specimen that is all but straight follows Euler and Bernoulli."""
        way = np.maximum(stages - self.given, 0)
        w = way / (1 + 48 * self.left / self.specimen.k)
        none = np.zeros_like(w)
        return np.c_[none + self.S, none, w, 48 * self.left * w, none + self.left, none]


def follow(specimen, legs, levels):
    """The path of a specimen whose stage goes through legs of positions, up and down in turn, with a level of friction each."""
    rows, events = [], []
    for number, leg in enumerate(legs):
        rows.append(specimen.move(leg, +1 if number % 2 == 0 else -1, levels[number]))
        events = events or (list(specimen.events) if number == 0 else [])
    passed = np.concatenate([np.full(len(leg), number) for number, leg in enumerate(legs)])
    return Path(np.concatenate(legs), *np.concatenate(rows).T, passed, events)


def legs_of(turns, start, rows):
    """Stage positions of each pass, at equal steps; the first begins at start."""
    turns = [start] + turns[1:]
    step = np.abs(np.diff(turns)).sum() / rows
    legs = []
    for a, b in zip(turns[:-1], turns[1:]):
        number = max(int(round(abs(b - a) / step)), 2)
        legs.append(a + (b - a) * np.arange(0 if not legs else 1, number + 1) / number)
    return legs


def stage_at(specimen, deflection):
    """The stage position of the first loading at which a deflection is first reached; None if the rig never comes to rest there."""
    branch = Branch(specimen, specimen.S, +1, 1.0)
    balance, _ = specimen.stage(branch)
    stable = balance >= np.maximum.accumulate(balance)
    reached = stable & (branch.w >= deflection)
    if not np.any(reached):
        return None
    first = int(np.argmax(reached))
    return float(balance[first]) if branch.w[first] < deflection + 0.04 else None


def hinge_compliance(left):
    """The compliance of a hinge that leaves this share of the stiffness, on the grid for which maps are kept."""
    return round((1 / left - 1) / 3 / 0.005) * 0.005


def draw_curvature(random):
    """The natural curvature of a bow of .0013 spans (standard deviation), on the grid for which maps are kept."""
    step = 0.0007
    return 8 * step * float(np.clip(np.round(random.normal(0, 0.0013) / step), -4, 4))


def growth(start, end, power):
    """Grows from 0 to 1 with the greatest deflection, between two deflections."""
    return lambda w: np.clip((w - start) / (end - start), 0, 1) ** power


def stepwise(losses):
    """The share of stiffness left when a deflection is the greatest so far."""
    places, left = np.array([w for w, _ in losses]), np.cumprod([1.0] + [1 - loss for _, loss in losses])
    return lambda w: left[np.searchsorted(places, w)]


def openings_of(losses):
    """Deflections at which a hinge opens, and its compliances, that lose about these shares of the stiffness."""
    left = np.cumprod([1 - loss for _, loss in losses])
    return [(w, hinge_compliance(share)) for (w, _), share in zip(losses, left)]
