"""Fits the probabilities of what made the drops of a record that was loaded again, and judges them on kinds left out.

    /usr/bin/python3 bench/causes/calibrate.py OUT... --program build/release/flexslip [--write]

OUT are folders of records with their truth (records.py). --write writes src/inference/cause_coefficients.h.
"""

import argparse
import collections
import concurrent.futures
import csv
import json
import math
import pathlib
import subprocess
import sys

import numpy as np
from scipy.optimize import minimize
from scipy.special import logsumexp

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
CAUSES = ("slips", "cracks", "both")
USUAL_DIFFERENCE = 0.02  # of two passes of a sound specimen, as in judgement.cpp
OF_NEEDED = 0.12  # of what the drops need, by which that is uncertain, likewise
SURELY = 0.95
SUREST = 0.98  # one loading is no surer


def cause_of(truth):
    """What made the drops of a record; None where that cannot be said of them."""
    lost = float(truth["stiffness_lost"]) > 0.02
    by_slips, by_cracks = int(truth["drops_by_slips"]), int(truth["drops_by_cracks"])
    if not lost:
        return "slips"
    if by_slips:
        return "both"
    return "cracks" if by_cracks else None


def features_of(answer):
    """What causes_of reads of a record; None where the record has no drops or was not compared with a reload."""
    judgement, passes = answer.get("judgement"), answer.get("passes")
    if not judgement or not passes or passes["status"] != "ok" or judgement["causes"]["slips"] is None:
        return None
    loss = judgement["stiffness_lost"]
    log_loss = -math.log(1 - loss)
    error = math.hypot(judgement["stiffness_lost_error"] / (1 - loss), USUAL_DIFFERENCE)
    needed = -math.log(1 - passes["loss_needed"])
    z, c = log_loss / error, (needed - log_loss) / math.hypot(error, OF_NEEDED * needed)
    rises = (answer.get("slip_or_crack") or {}).get("cracks_alone")
    bounded = min(max(rises, 1 - SUREST), SUREST) if rises is not None else 0.5
    odds = math.log(bounded / (1 - bounded))
    return [1, math.tanh(z / 3), math.tanh(z / 8), math.tanh(c / 3), math.tanh(c / 8), math.tanh((z * z - c * c) / 12), odds]


def fit_of(program, case):
    run = subprocess.run([program, "fit", case, "--json"], capture_output=True, text=True)
    try:
        return json.loads(run.stdout)
    except json.JSONDecodeError:
        return {}


def read(folder, program, jobs):
    truths = list(csv.DictReader((folder / "truth.csv").open(encoding="utf-8")))
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        answers = list(pool.map(lambda truth: fit_of(program, str(folder / truth["name"] / "case.toml")), truths))
    for truth, answer in zip(truths, answers):
        cause, features = cause_of(truth), features_of(answer)
        if cause and features:
            yield truth["kind"], CAUSES.index(cause), features


def log_odds(coefficients, inputs):
    """Of each cause, slips being 0."""
    return np.column_stack([np.zeros(len(inputs)), inputs @ coefficients.reshape(2, -1).T])


def fitted(inputs, causes, ridge=0.1):
    """Coefficients of cracks and of both; every cause weighs as much as another."""
    weight = 1 / np.bincount(causes, minlength=3)[causes]
    weight *= len(causes) / weight.sum()

    def cost(coefficients):
        odds = log_odds(coefficients, inputs)
        own = odds[np.arange(len(causes)), causes]
        return float(np.sum(weight * (logsumexp(odds, axis=1) - own)) + ridge * np.sum(coefficients**2))

    return minimize(cost, np.zeros(2 * inputs.shape[1]), method="BFGS").x


def probabilities(coefficients, inputs):
    odds = log_odds(coefficients, inputs)
    return np.exp(odds - logsumexp(odds, axis=1, keepdims=True))


def words(p):
    """By the rule of the program. A word is wrong if it names a cause that did not act, or denies one that did."""
    slipped, lost = p[:, 1] < 1 - SURELY, p[:, 0] < 1 - SURELY
    return np.select([slipped & lost, lost, slipped], ["slip_and_damage", "crack", "slip"], "undecided")


WRONG = {"slip_and_damage": ("slips", "cracks"), "crack": ("slips",), "slip": ("cracks",), "undecided": ()}


def tell(title, p, causes):
    given = words(p)
    decided = given != "undecided"
    wrong = sum(CAUSES[cause] in WRONG[word] for word, cause in zip(given, causes))
    print(f"{title}: {len(causes)} records, decided {np.mean(decided):.2f}, wrong of these {wrong / max(decided.sum(), 1):.3f}")


def header(coefficients, number):
    rows = [", ".join(f"{value:.3f}" for value in row) for row in coefficients.reshape(2, -1)]
    return f"""// What makes probabilities of the causes of drops: causes_of (judgement.h). Written by bench/causes/calibrate.py of {number} simulated records, not by hand.
#pragma once

#include <array>

namespace flexslip::cause_coefficients {{

// Of the log odds of cracks, and of both, over slips: by 1, tanh(z/3), tanh(z/8), tanh(c/3), tanh(c/8), tanh((z² - c²)/12) and the log odds of one loading.
inline constexpr std::array cracks{{{rows[0]}}};
inline constexpr std::array both{{{rows[1]}}};

}}  // namespace flexslip::cause_coefficients
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--program", required=True)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    rows = [row for folder in options.folders for row in read(folder, options.program, options.jobs)]
    kinds, causes, inputs = np.array([row[0] for row in rows]), np.array([row[1] for row in rows]), np.array([row[2] for row in rows])
    print(dict(collections.Counter(CAUSES[cause] for cause in causes)))
    left_out = np.empty((len(rows), 3))
    for kind in sorted(set(kinds)):
        own = kinds == kind
        left_out[own] = probabilities(fitted(inputs[~own], causes[~own]), inputs[own])
        tell(f"  {kind}", left_out[own], causes[own])
    tell("Each kind predicted from the others", left_out, causes)
    coefficients = fitted(inputs, causes)
    if options.write:
        (REPOSITORY / "src/inference/cause_coefficients.h").write_text(header(coefficients, len(rows)), encoding="utf-8")
    else:
        print(coefficients.round(3))
    return 0


if __name__ == "__main__":
    sys.exit(main())
