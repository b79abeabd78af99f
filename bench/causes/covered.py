"""How well friction and EI of one loading are covered, by kind of record, by one program beside another.

    bench/causes/records.py OUT --of loadings --count 15 --seed SEED
    /usr/bin/python3 bench/causes/covered.py OUT --program build/release/flexslip [--before OTHER]

Records with a reload are left out. Three groups change the elastic records: `coarse` rounds the force to 1/60 of its greatest value,
`supports not stated` and `EI not stated` take these lines out of the case. A program covers a friction if its 95 % interval holds
the mean over the stretch that slid. SLIP and NO DROPS are
`without a doubt` where no finding is a doubt; one is wrong if its friction is not covered, or if cracks alone made the drops.
"""

import argparse
import collections
import concurrent.futures
import csv
import json
import math
import pathlib
import shutil
import statistics
import subprocess
import tempfile

GROUPS = {"stick_slip": "stick-slip", "rod_stick_slip": "stick-slip", "overshoot": "overshoot", "yields": "plastic", "settles": "plastic", "relaxes": "relaxing"}
CHANGES = ("coarse", "supports not stated", "EI not stated")
SERIOUS = ("refusal", "suspicion", "doubt")  # of findings: what leaves a doubt


def group_of(truth):
    if truth["kind"] in GROUPS:
        return GROUPS[truth["kind"]]
    return {"cracks": "cracked", "both": "both"}.get(truth["cause"], "elastic")


def changed(folder, into, change):
    """The case of a record that is changed, or None where there is nothing to change."""
    text = (folder / "case.toml").read_text(encoding="utf-8")
    key = {"supports not stated": "supports", "EI not stated": "bending_stiffness"}.get(change)
    kept = [line for line in text.splitlines() if key is None or not line.startswith(key)]
    if key and len(kept) == len(text.splitlines()):
        return None
    if key == "bending_stiffness":
        kept.insert(kept.index("[specimen]") + 1, 'bending_stiffness = "fit"')
    into.mkdir(parents=True)
    (into / "case.toml").write_text("\n".join(kept) + "\n", encoding="utf-8")
    if change != "coarse":
        shutil.copy(folder / "test.csv", into)
        return into / "case.toml"
    with (folder / "test.csv").open(encoding="utf-8") as file:
        head, *rows = list(csv.reader(file))
    column = next(i for i, title in enumerate(head) if title.startswith("force"))
    step = max(float(row[column]) for row in rows) / 60
    with (into / "test.csv").open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(head)
        for row in rows:
            row[column] = f"{step * round(float(row[column]) / step):.9g}"
            writer.writerow(row)
    return into / "case.toml"


def told(program, case, truth):
    """What a program says of friction and EI: estimate, its interval, and the truth."""
    done = subprocess.run([program, "fit", str(case), "--json", "--quiet"], capture_output=True, text=True, check=False)
    try:
        answer = json.loads(done.stdout)
    except json.JSONDecodeError:
        return {"code": "refused"}
    found = {"code": answer["verdict"]["code"], "without_a_doubt": not any(f["severity"] in SERIOUS for f in answer["findings"])}
    if found["code"] == "crack":
        return found
    for name, key, true in (("friction", "mu0", float(truth["mean_friction"])), ("EI", "bending_stiffness", float(truth["EI_true"]))):
        estimate = (answer.get("parameters") or {}).get(key) or {}
        if estimate.get("value") is None or not estimate.get("interval95"):
            continue
        low, high = estimate["interval95"]
        if low is None or high is None:
            continue
        found[name] = {"error": estimate["value"] - true, "half": (high - low) / 2, "covered": low <= true <= high, "true": true}
    return found


def line(name, answers, quantity):
    """Of a group: coverage, half width, bias and rms of the error over its deviation."""
    of = [answer[quantity] for answer in answers if quantity in answer]
    if not of:
        return [name, len(answers), 0, "", "", "", ""]
    scale = [1 if quantity == "friction" else each["true"] for each in of]
    z = [1.96 * each["error"] / each["half"] for each in of if each["half"] > 0]
    return [name, len(answers), len(of), f"{100 * sum(each['covered'] for each in of) / len(of):.0f} %",
            f"{statistics.median(each['half'] / s for each, s in zip(of, scale)):.3f}",
            f"{statistics.mean(each['error'] / s for each, s in zip(of, scale)):+.3f}",
            f"{math.sqrt(statistics.mean(x * x for x in z)):.2f}"]


def is_wrong(truth, answer):
    if answer["code"] == "slip" and truth["cause"] == "cracks":
        return True
    return "friction" in answer and not answer["friction"]["covered"]


def print_table(head, rows):
    print("| " + " | ".join(head) + " |\n|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join(str(cell) for cell in row) + " |")
    print()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--program", required=True)
    parser.add_argument("--before", help="another program, beside it")
    parser.add_argument("--every", type=int, default=1, help="take one record of so many")
    options = parser.parse_args()
    with (options.folder / "truth.csv").open(encoding="utf-8") as file:
        truths = [row for row in csv.DictReader(file) if row["reload"] == "0"][:: options.every]
    programs = {"now": options.program} | ({"before": options.before} if options.before else {})
    with tempfile.TemporaryDirectory() as temporary, concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = []
        for truth in truths:
            folder = options.folder / truth["name"]
            jobs.append((group_of(truth), truth, folder / "case.toml"))
            for change in CHANGES if group_of(truth) == "elastic" else ():
                case = changed(folder, pathlib.Path(temporary) / change.replace(" ", "_") / truth["name"], change)
                jobs += [(change, truth, case)] if case else []
        answers = {name: list(pool.map(lambda job: told(program, job[2], job[1]), jobs)) for name, program in programs.items()}
    for quantity in ("friction", "EI"):
        print(f"Half widths and biases of {'EI are shares of it' if quantity == 'EI' else 'friction'}:\n")
        rows = []
        for group in sorted({job[0] for job in jobs}):
            for name in programs:
                mine = [answer for job, answer in zip(jobs, answers[name]) if job[0] == group]
                rows.append(line(f"{group}, {name}" if options.before else group, mine, quantity))
        print_table([quantity, "records", "told", "covered", "half width, median", "bias", "rms z"], rows)
    rows = []
    for name in programs:
        of = [(job, answer) for job, answer in zip(jobs, answers[name]) if answer["code"] in ("slip", "no_drops")]
        sure = [(job, answer) for job, answer in of if answer["without_a_doubt"]]
        wrong = [job for job, answer in sure if is_wrong(job[1], answer)]
        counts = collections.Counter(job[0] for job in wrong)
        rows.append([name, len(of), len(sure), len(wrong), ", ".join(f"{count} {group}" for group, count in counts.items())])
    print_table(["SLIP and NO DROPS", "records", "without a doubt", "of these wrong", "which"], rows)


if __name__ == "__main__":
    main()
