"""Loading, unloading and reloading of a dynamic discrete elastic rod: der.cpp of the prototypes, another mechanics than passes.py.

The rod slides, sticks and snaps over two supports by itself, with a nose that has a mass. Where the supports see different friction,
one side may slide alone. Nothing is lost and nothing wears.
"""

import pathlib
import subprocess
import tempfile

import numpy as np

from passes import Path

ROW = 0.0025  # of the stage, between two rows
ELEMENTS, TIME_STEP, SPEED, STRETCH_DAMPING = 80, 9e-5, 0.004, 1e-5  # 80 and 128 elements differ by less than .1 % of the force


class Rods:
    """The program, compiled into a folder that lives as long as this object."""

    def __init__(self, prototypes):
        self.folder = tempfile.TemporaryDirectory()
        self.program = pathlib.Path(self.folder.name) / "rod"
        subprocess.run(["g++", "-O2", "-o", str(self.program), str(pathlib.Path(prototypes) / "rod" / "der.cpp")], check=True)

    def run(self, **numbers):
        """The rows that the program writes; None where the rod blew up."""
        fixed = dict(N=ELEMENTS, dt=TIME_STEP, vel=SPEED, be=STRETCH_DAMPING, out=ROW)
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


def path_of(table):
    """The rows as a path. A force is the mean over the step before its row: it belongs to the middle of the step."""
    passed, turns = passes_of(table["ws"])
    direction = 1 - 2 * (passed % 2)
    advance = np.diff(table["S"], prepend=1.0)
    usual = np.median(np.abs(advance))
    sliding = np.where(np.abs(advance) > 0.15 * usual, np.sign(advance), 0)
    friction = (np.abs(table["qL"]) + np.abs(table["qR"])) / 2
    columns = (table["ws"] - direction * ROW / 2, table["S"], friction, table["w"], table["F"], np.ones(len(passed)), sliding, passed)
    return Path(*(column[~turns] for column in columns))


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


def simulate(random, rods):
    """A path of the rod, its mean friction, its load train, its turns and whether its friction waves; None where it blew up."""
    surface = Surface(random)
    k = float(np.exp(random.uniform(np.log(20), np.log(150))))
    turns = turns_of(random, k)
    programme = ",".join(f"{turn:.6f}" for turn in turns)
    table = rods.run(k=k, M=random.uniform(0.5, 1.5), zn=random.uniform(0.15, 0.5), prog=programme, **surface.words())
    if table is None:
        return None
    return path_of(table), mean_friction(surface, table), k, turns, "wave" if surface.amplitude else "constant"
