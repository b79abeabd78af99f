"""How well the program tells friction, stiffness and its loss from simulated cyclic records made by records.py.

    /usr/bin/python3 bench/causes/score.py OUT --program build/release/flexslip

Fits every record of OUT/truth.csv, prints a table by kind and in total, and writes OUT/results.csv with a row a record.
"""

import argparse
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys

ENOUGH_ROWS_OUT = 60  # rows sliding out from which the unloading should tell friction
LOST = 0.02  # true loss from which a record counts as cracked
# Verdicts that say what made the drops, and the causes of which each is wrong.
WRONG = {"slip": ("cracks",), "slip_and_damage": ("slips", "cracks"), "crack": ("slips",)}


# ---- one record


def fit(program, case):
    """The program's answer, None if it gave none, and the seconds of processor it took."""
    before = os.times()
    done = subprocess.run([program, "fit", str(case), "--json", "--quiet"], capture_output=True, text=True, check=False)
    after = os.times()
    seconds = after.children_user + after.children_system - before.children_user - before.children_system
    try:
        return json.loads(done.stdout), seconds
    except json.JSONDecodeError:
        return None, seconds


def value_at(answer, *keys):
    """The value under a chain of keys; None where a key is missing or the value is null."""
    for key in keys:
        if not isinstance(answer, dict):
            return None
        answer = answer.get(key)
    return answer


def true_cause(truth):
    """What made the drops, of a specimen that lost stiffness or not; none where nothing fell at once."""
    if truth["cause"] == "none" or float(truth["stiffness_lost"]) <= LOST:
        return "none" if truth["cause"] == "none" else "slips"
    return "both" if truth["cause"] == "slips" else truth["cause"]


def compare(truth, answer, seconds):
    """A row of the results: what the program told beside the truth."""
    friction = value_at(answer, "parameters", "mu0") or {}
    stiffness = value_at(answer, "parameters", "bending_stiffness") or {}
    low, high = friction.get("interval95") or (None, None)
    EI_low, EI_high = stiffness.get("interval95") or (None, None)
    return {
        "name": truth["name"],
        "kind": truth["kind"],
        "rows_out": truth["rows_out"],
        "k": truth["k"],
        "code": value_at(answer, "verdict", "code") or "no_json",
        "status": value_at(answer, "passes", "status") or "none",
        "loss_true": truth["stiffness_lost"],
        "loss": value_at(answer, "judgement", "stiffness_lost"),
        "loss_error": value_at(answer, "judgement", "stiffness_lost_error"),
        "friction_true": truth["mean_friction"],
        "friction": friction.get("value"),
        "friction_low": low,
        "friction_high": high,
        "EI_true": truth["EI_true"],
        "EI": stiffness.get("value"),
        "EI_low": EI_low,
        "EI_high": EI_high,
        "cause_true": true_cause(truth),
        "seconds": round(seconds, 3),
    }


# ---- many records


def root_mean_square(values):
    return math.sqrt(sum(v * v for v in values) / len(values)) if values else None


def share(flags):
    flags = list(flags)
    return sum(flags) / len(flags) if flags else None


def told(rows, key):
    return [row for row in rows if row[key] is not None]


def covered(row, key):
    low, high = row[key + "_low"], row[key + "_high"]
    return low is not None and high is not None and low <= float(row[key + "_true"]) <= high


def shown(value, digits=3):
    return "-" if value is None else f"{value:.{digits}f}"


def print_table(title, columns, lines):
    """A table of plain text: a line a group, its name on the left."""
    print(f"\n{title}")
    widths = [max(len(str(line[i])) for line in [columns] + lines) for i in range(len(columns))]
    for name, *cells in [columns] + lines:
        print("  ".join([str(name).ljust(widths[0])] + [str(cell).rjust(width) for cell, width in zip(cells, widths[1:])]))


def loss_line(name, rows):
    with_loss = told(rows, "loss")
    errors = [row["loss"] - float(row["loss_true"]) for row in with_loss]
    stated = [row["loss_error"] for row in with_loss if row["loss_error"] is not None]
    within = [row["loss_error"] is not None and abs(error) <= 2 * row["loss_error"] for row, error in zip(with_loss, errors)]
    nulls = len(rows) - len(with_loss)
    told_share = shown(share(row["loss"] is not None for row in rows), 2)
    sizes = [shown(root_mean_square(errors), 4), shown(root_mean_square(stated), 4)]
    return [name, len(rows), nulls, told_share, shown(share(within), 2), *sizes]


def friction_line(name, rows):
    with_friction = told(rows, "friction")
    errors = [row["friction"] - float(row["friction_true"]) for row in with_friction]
    half = [(row["friction_high"] - row["friction_low"]) / 2 for row in with_friction if row["friction_low"] is not None]
    coverage = shown(share(covered(row, "friction") for row in with_friction), 2)
    width = shown(statistics.median(half) if half else None)
    return [name, len(rows), len(rows) - len(with_friction), shown(root_mean_square(errors)), coverage, width]


def stiffness_line(name, rows):
    with_EI = told(rows, "EI")
    errors = [100 * (row["EI"] / float(row["EI_true"]) - 1) for row in with_EI]
    coverage = shown(share(covered(row, "EI") for row in with_EI), 2)
    return [name, len(rows), len(rows) - len(with_EI), shown(root_mean_square(errors), 2), coverage]


def cause_line(name, rows):
    with_drops = [row for row in rows if row["cause_true"] != "none"]
    decided = [row for row in with_drops if row["code"] in WRONG]
    wrong = [row for row in decided if row["cause_true"] in WRONG[row["code"]]]
    return [name, len(with_drops), len(decided), len(wrong)]


def split_groups(rows):
    """Records that lost stiffness or not, with many rows sliding out or few."""
    groups = []
    for cracked in (False, True):
        for enough in (True, False):
            name = f"{'cracked' if cracked else 'not cracked'}, {'>=' if enough else '<'} {ENOUGH_ROWS_OUT} rows out"
            alike = lambda row: (float(row["loss_true"]) > LOST) == cracked and (int(row["rows_out"]) >= ENOUGH_ROWS_OUT) == enough
            groups.append((name, [row for row in rows if alike(row)]))
    return groups


def print_tables(rows):
    kinds = list(dict.fromkeys(row["kind"] for row in rows))
    groups = [(kind, [row for row in rows if row["kind"] == kind]) for kind in kinds] + [("all", rows)]
    split = split_groups(rows)
    loss = ["kind", "records", "null", "told", "within 2 errors", "rms", "error stated"]
    friction = ["kind", "records", "null", "rms", "covered", "half width (median)"]
    stiffness = ["kind", "records", "null", "rms %", "covered"]
    by_status = [(f"status {status}", [row for row in rows if row["status"] == status]) for status in sorted({row["status"] for row in rows})]
    print_table("Stiffness lost", loss, [loss_line(*group) for group in groups + split + by_status])
    print_table("Friction", friction, [friction_line(*group) for group in groups + split])
    print_table("Bending stiffness", stiffness, [stiffness_line(*group) for group in groups + split])
    print_table("Cause of the drops", ["kind", "with drops", "decided", "wrong"], [cause_line(*group) for group in groups])
    codes = sorted({row["code"] for row in rows})
    counts = [[name] + [sum(row["code"] == code for row in members) for code in codes] for name, members in groups]
    print_table("Verdicts", ["kind"] + codes, counts)
    print(f"\n{sum(row['seconds'] for row in rows) / len(rows):.2f} s of processor a record")


def write_results(folder, rows):
    with open(folder / "results.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--program", required=True)
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    with open(options.out / "truth.csv", encoding="utf-8") as file:
        truths = list(csv.DictReader(file))
    cases = [options.out / truth["name"] / "case.toml" for truth in truths]
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        answers = list(pool.map(fit, [options.program] * len(cases), cases))
    rows = [compare(truth, *answer) for truth, answer in zip(truths, answers)]
    write_results(options.out, rows)
    print_tables(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
