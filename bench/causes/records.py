"""Simulated records of bending tests, of one loading and of several, by three simulators, with the truth of each.

    /usr/bin/python3 bench/causes/records.py OUT --kinds wave cracks_few --count 20 --seed 1 --program build/release/flexslip

Writes OUT/NAME/case.toml and OUT/NAME/test.csv for each record, and OUT/truth.csv. The simulators are the program's own mechanics
(own), the maps of a foreign mechanics (map), and a dynamic rod (rod). The latter two are those of the prototypes (--prototypes,
../shared/prototypes unless given), which are no part of the repository. --list prints the kinds.
"""

import argparse
import concurrent.futures
import csv
import functools
import pathlib
import shutil
import sys

import cycles
import loadings
import own
import rod
from passes import Maps
from record import truth_of
from rig import read, write_record

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
GROUPS = {"cycles": cycles.KINDS, "loadings": loadings.KINDS}
KINDS = [kind for group in GROUPS.values() for kind in group]


class Workshop:
    """The simulators, each made when it is first needed."""

    def __init__(self, prototypes, program):
        self.prototypes, self.program = prototypes, program

    @functools.cached_property
    def maps(self):
        return Maps(self.prototypes / "realrig")

    @functools.cached_property
    def rods(self):
        return rod.Rods(self.prototypes)

    @functools.cached_property
    def simulator(self):
        return own.Simulator(self.program, self.maps.get())


def simulator_of(kind):
    if kind in loadings.KINDS:
        return loadings.KINDS[kind].simulator
    return "rod" if kind == "rod" else "map"


def list_kinds():
    for kind in KINDS:
        cause = loadings.KINDS[kind].cause if kind in loadings.KINDS else cycles.KINDS[kind][0]
        print(f"{kind:28}{simulator_of(kind):5}{cause}")


def make_record(kind, number, seed, workshop, folder):
    """Draws until a record can be made, and writes it. Returns its truth."""
    name = f"{kind}-{number:03d}"
    for attempt in range(200):
        if kind in loadings.KINDS:
            made = loadings.make(kind, number, seed, attempt, workshop)
        else:
            made = cycles.make(kind, name, number, seed, attempt, workshop)
        if made is not None:
            record, random = made
            write_record(folder, name, record.rig, *read(random, record.rig, record.path))
            return truth_of(name, record)
    raise RuntimeError(f"{name}: no plan of two hundred comes to rest")


def make_kind(kind, options):
    workshop = Workshop(options.prototypes, options.program)
    numbers = range(options.first, options.first + options.count)
    return [make_record(kind, number, options.seed, workshop, options.out) for number in numbers]


def write_truth(folder, truths):
    """Writes the truths into truth.csv, beside those of other records that are there already."""
    file = folder / "truth.csv"
    new = {truth["name"] for truth in truths}
    kept = [line for line in csv.DictReader(file.open(encoding="utf-8")) if line["name"] not in new] if file.exists() else []
    with file.open("w", newline="", encoding="utf-8") as target:
        writer = csv.DictWriter(target, fieldnames=list(truths[0]))
        writer.writeheader()
        writer.writerows(kept + truths)


def missing(options):
    """Why no records can be made; None if they can."""
    needed = {simulator_of(kind) for kind in options.kinds}
    files = [options.prototypes / "realrig" / "mech3.py", options.prototypes / "rod" / "der.cpp"]
    if not all(file.exists() for file in files):
        return f"the prototypes are not in {options.prototypes}; say where they are with --prototypes"
    if "rod" in needed and shutil.which("g++") is None:
        return "rods need g++, which is not installed"
    if "own" in needed and not options.program.exists():
        return f"the program is not {options.program}; say where it is with --program"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out", type=pathlib.Path, nargs="?")
    parser.add_argument("--kinds", nargs="+", choices=KINDS, help="rods only if they are named")
    parser.add_argument("--of", nargs="+", default=list(GROUPS), choices=GROUPS, help="where no kinds are named: what is loaded and unloaded, what is judged by its drops, or both")
    parser.add_argument("--count", type=int, default=20, help="records of each kind; a rod takes some seconds")
    parser.add_argument("--first", type=int, default=0, help="number of the first record of each kind")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1, help="kinds made at once")
    parser.add_argument("--program", type=pathlib.Path, default=REPOSITORY / "build" / "release" / "flexslip")
    parser.add_argument("--prototypes", type=pathlib.Path, default=REPOSITORY.parent / "shared" / "prototypes")
    parser.add_argument("--list", action="store_true", help="print the kinds, their simulators and what acts in them")
    options = parser.parse_args()
    options.kinds = options.kinds or [kind for group in options.of for kind in GROUPS[group] if simulator_of(kind) != "rod"]
    if options.list:
        list_kinds()
        return 0
    if options.out is None:
        parser.error("say into which folder: OUT")
    obstacle = missing(options)
    if obstacle:
        print(f"No records made: {obstacle}.")
        return 0
    options.out.mkdir(parents=True, exist_ok=True)
    number = 0
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        for truths in pool.map(make_kind, options.kinds, [options] * len(options.kinds)):
            write_truth(options.out, truths)
            number += len(truths)
    print(f"{number} records in {options.out}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
