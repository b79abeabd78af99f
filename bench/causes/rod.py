"""Loading, unloading and reloading of a dynamic discrete elastic rod: der.cpp of the prototypes, another mechanics than passes.py.

The rod slides, sticks and snaps over two supports by itself, with a nose that has a mass. Where the supports see different friction,
one side may slide alone. Nothing is lost and nothing wears.
"""

import pathlib
import subprocess
import tempfile

import numpy as np

from friction import logarithmic
from passes import Event, Path

ROW = 0.0025  # of the stage, between two rows of a cyclic record
ELEMENTS, TIME_STEP, SPEED, STRETCH_DAMPING = 80, 9e-5, 0.004, 1e-5  # 80 and 128 elements differ by less than .1 % of the force


class Rods:
    """The program, compiled into a folder that lives as long as this object."""

    def __init__(self, prototypes):
        self.folder = tempfile.TemporaryDirectory()
        self.program = pathlib.Path(self.folder.name) / "rod"
        subprocess.run(["g++", "-O2", "-o", str(self.program), str(pathlib.Path(prototypes) / "rod" / "der.cpp")], check=True)

    def run(self, **numbers):
        """The rows that the program writes; None where the rod blew up."""
        fixed = dict(N=ELEMENTS, dt=TIME_STEP, vel=SPEED, be=STRETCH_DAMPING)
        words = [f"{name}={value}" for name, value in {**fixed, **numbers}.items()]
        done = subprocess.run([str(self.program), *words], capture_output=True, text=True, check=False, cwd=self.folder.name)
        if done.returncode != 0:
            return None
        return np.genfromtxt(done.stdout.splitlines(), delimiter=",", names=True)


class Surface:
    """Friction at the two sides, mu0 (1 + A cos(4 pi x/length + phase)) at the distance x from midspan.

    The length is that of the wave in S = 2 x.
    """

    def __init__(self, random):
        self.mean = random.uniform(0.15, 0.8)
        self.amplitude = random.choice([0, random.uniform(0.05, 0.3)])
        self.length = float(np.exp(random.uniform(np.log(0.03), np.log(0.15))))
        self.phases = random.uniform(0, 2 * np.pi, 2) if random.uniform() < 0.5 else np.repeat(random.uniform(0, 2 * np.pi), 2)

    def words(self):
        left, right = self.phases
        return dict(mu0=self.mean, A=self.amplitude, lam=self.length / 2, ph=left, phR=right)

    def slid_over(self, side, begin, end):
        """The integral of friction over the stretch that one side has drawn in."""
        x = 0.5 + np.linspace(begin, end, 2000)
        values = self.mean * (1 + self.amplitude * np.cos(4 * np.pi * x / self.length + self.phases[side]))
        return np.mean(values) * (end - begin)


def passes_of(stage):
    """The number of the pass of each row, and whether a row spans a turn."""
    direction = np.sign(np.diff(stage, prepend=0.0))
    turns = np.diff(direction, prepend=direction[0]) != 0
    return np.cumsum(turns), turns


def events_of(table, sliding_in):
    """Falls of the force within a row of the first loading in which the rod draws in three times the arc of the rows around it."""
    force, stage = table["F"][sliding_in], table["ws"][sliding_in]
    drawn_in = np.diff(table["S"][sliding_in], prepend=1.0)
    usual = np.array([np.median(drawn_in[max(i - 10, 0) : i + 11]) for i in range(len(drawn_in))])
    fall = -np.diff(force, prepend=0.0)
    return [Event(stage[i], fall[i], 0.0) for i in np.flatnonzero((fall > 0) & (drawn_in > 3 * usual))]


def path_of(table, row):
    """The rows as a path. A force is the mean over the step before its row: it belongs to the middle of the step."""
    passed, turns = passes_of(table["ws"])
    direction = 1 - 2 * (passed % 2)
    advance = np.diff(table["S"], prepend=1.0)
    usual = np.median(np.abs(advance))
    sliding = np.where(np.abs(advance) > 0.15 * usual, np.sign(advance), 0)
    friction = (np.abs(table["qL"]) + np.abs(table["qR"])) / 2
    shift = direction * row / 2
    columns = (table["ws"] - shift, table["S"], friction, table["w"], table["F"], np.ones(len(passed)), sliding, passed)
    events = [Event(event.stage - row / 2, event.slipped, 0.0) for event in events_of(table, passed == 0)]
    return Path(*(column[~turns] for column in columns), events)


def mean_friction(surface, table):
    """The mean over the arc that both sides drew in during the first loading, from where the deflection is .06 on."""
    passed, _ = passes_of(table["ws"])
    first = table[passed == 0]
    begin, end = int(np.argmax(first["w"] > 0.06)), len(first) - 1
    stretches = [(first[side][begin], first[side][end]) for side in ("XL", "XR")]
    total = sum(surface.slid_over(side, *stretch) for side, stretch in enumerate(stretches))
    return total / sum(end - begin for begin, end in stretches)


def turns_of(random, k):
    """Stage positions of the turns: the bottom lies at up to 55 % of the top."""
    w = random.uniform(0.15, 0.3)
    top = w + 7.5 * min(w / 0.2, 1) / k
    return [0.0, top, random.uniform(0.0, 0.55) * top, top]


def run(random, rods, surface, k, turns, row, excess=0.0):
    """A path of the rod and its mean friction; None where it blew up. The excess of static over kinetic friction is absolute."""
    programme = ",".join(f"{turn:.6f}" for turn in turns)
    mass, damping = random.uniform(0.5, 1.5), random.uniform(0.15, 0.5)
    table = rods.run(k=k, M=mass, zn=damping, prog=programme, out=row, exc=excess, **surface.words())
    if table is None:
        return None
    return path_of(table, row), mean_friction(surface, table)


def cycle(random, rods):
    """A path that is loaded again, its mean friction, its load train and whether its friction waves; None where the rod blew up."""
    surface = Surface(random)
    k = logarithmic(random, 20, 150)
    made = run(random, rods, surface, k, turns_of(random, k), ROW)
    return made and (*made, k, "wave" if surface.amplitude else "constant")


def loading(random, rods, waves, sticks):
    """The same of one loading, with friction that waves or not, and static friction above it or not."""
    surface = Surface(random)
    surface.amplitude = random.uniform(0.1, 0.4) if waves else 0.0
    k, w = logarithmic(random, 10, 400), random.uniform(0.08, 0.3)
    top = w + 7.5 * min(w / 0.2, 1) / k
    excess = surface.mean * logarithmic(random, 0.15, 1.0) if sticks else 0.0
    made = run(random, rods, surface, k, [0.0, top], top / random.uniform(80, 400), excess)
    return made and (*made, k, "wave" if waves else "stick_slip" if sticks else "constant")
