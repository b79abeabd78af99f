"""How often the interval of friction holds the truth where the specimen relaxes, by how much, with rests of the stage and without.

    /usr/bin/python3 bench/relaxation.py PROGRAM [COUNT] [SEED] [KEY=VALUE ...]

Records of the program's own mechanics (simulate). Their forces relax by a share during the test: as a standard linear solid or with the logarithm
of time, by Boltzmann's superposition. The stage rests: never, once, three times, never though the specimen is unloaded and loaded again, or at the
top before it is unloaded. Keys such as record.slow_force_error=5 % are set in every case. Printed are records, those with friction told, those whose interval holds it; its error, mean and rms; its
standard error, median and mean; how often relaxation is found and its median; quantiles (5, 50, 95 %) of what the loading loses over what is told.
"""

import concurrent.futures
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

COURSES = ("none", "one", "three", "reload", "reload at rest")
SHARES = (0.0, 0.02, 0.05, 0.13, 0.18)
SPAN, STIFFNESS = 20e-3, 2e-6  # [m], [N m^2]
FORCE = STIFFNESS / SPAN**2


def logarithmic(rng, low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def friction_of(rng):
    """Friction over S, and its greatest value."""
    mean, S = rng.uniform(0.1, 0.7), np.linspace(1, 2, 4001)
    size = mean * rng.uniform(0.02, 0.15) * math.sqrt(2 / 8)
    mu = mean + sum(size * np.cos(2 * math.pi * S / logarithmic(rng, 0.004, 0.2) + rng.uniform(0, 7)) for _ in range(8))
    return S, np.maximum(mu, 0.02)


def path_of(program, folder, rng, turns):
    """Deflection [L], force [EI/L^2] and motion of an elastic specimen, the load train's stiffness [EI/L^3], and mean friction."""
    k, depth = logarithmic(rng, 100, 3000), rng.uniform(0.12, 0.3)
    deepest = depth * (1 + 40 / k)
    S, mu = friction_of(rng)
    np.savetxt(folder / "mu.csv", np.c_[S, mu], delimiter=",", header="S,mu", comments="")
    program_of_stage = ", ".join(f"{deepest * turn:.9g}" for turn in turns)
    (folder / "truth.toml").write_text(f"""reduced = true
[rig]
stiffness = {k:.9g}
[friction]
model = "table"
file = "mu.csv"
length = "S"
mu = "mu"
[stage]
program = [{program_of_stage}]
step = {deepest / rng.integers(200, 500):.9g}
""", encoding="utf-8")
    done = subprocess.run([program, "simulate", folder / "truth.toml", "--json"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return None
    rows = json.loads(done.stdout)["path"]
    w, F, length = (np.array([row[name] for row in rows]) for name in ("deflection", "force", "length"))
    moves = np.abs(np.diff(w + F / k, prepend=-1)) > 1e-6  # the stage turns in two rows
    w, F = w[moves], F[moves]
    return w, F, k, float(np.mean(mu[S <= max(length.max(), S[1])]))


def rests_of(course, stage, rng):
    """Rows at which the stage rests, and for how many."""
    back = np.flatnonzero(np.diff(stage) < 0)
    top = int(back[0]) if len(back) else len(stage) - 1
    at = {"one": [rng.uniform(0.5, 0.95)], "three": np.sort(rng.uniform(0.3, 0.95, 3)), "reload at rest": [1.0]}.get(course, [])
    return {int(part * top): int(top * rng.uniform(0.05, 0.3)) for part in at}


def relaxed(F, share, rng):
    """The forces, one a moment, of a specimen that loses so much of a force that lasts as long as the record."""
    time = np.arange(len(F))
    if rng.random() < 0.5:
        scale = rng.uniform(0.05, 0.5) * len(F)
        lost = (1 - np.exp(-time / scale)) / (1 - math.exp(-len(F) / scale))
    else:
        scale = 0.01 * len(F)
        lost = np.log1p(time / scale) / math.log1p(len(F) / scale)
    return np.convolve(np.diff(F, prepend=0), 1 - share * lost)[: len(F)]


def record_of(program, folder, rng, course, share):
    """Stage [L], force [EI/L^2], stiffness of the load train, mean friction and the share of the force that the loading loses; None where the
    specimen slips through."""
    made = path_of(program, folder, rng, (0, 1, 0.1, 1.02) if course.startswith("reload") else (0, 1))
    if made is None:
        return None
    w, F, k, friction = made
    rests = rests_of(course, w + F / k, rng)
    rows = np.concatenate([np.full(1 + rests.get(i, 0), i) for i in range(len(w))])
    force = relaxed(F[rows], share, rng)
    stage = w[rows] + force / k
    back = np.flatnonzero(np.diff(w[rows] + F[rows] / k) < 0)
    top = np.searchsorted(rows, rows[back[0] if len(back) else -1])
    lost = 1 - force[top] / F[rows[top]]
    # While the stage rests the force falls and the load train bends the specimen farther: the first rows behind are passed then.
    kept, held = [], None
    for i in range(len(rows)):
        if i > 0 and rows[i] == rows[i - 1]:
            held = stage[i - 1] if held is None else held
            stage[i] = held
        elif held is not None and 0 < i < len(rows) - 1 and w[rows[i]] >= w[rows[i - 1]] and stage[i] <= held:
            continue
        else:
            held = None
        kept.append(i)
    return stage[kept], force[kept], k, friction, lost


def answer_of(program, seed, course, share, keys):
    rng = np.random.default_rng(seed)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        record = record_of(program, folder, rng, course, share)
        if record is None:
            return None
        stage, force, k, friction, lost = record
        force = force * (1 + 0.005 * rng.normal()) + 0.001 * force.max() * rng.normal(size=len(force))
        np.savetxt(folder / "test.csv", np.c_[stage * SPAN * (1 + 0.002 * rng.normal()), force * FORCE], delimiter=",", header="stage [m],force [N]", comments="", fmt="%.9g")
        (folder / "case.toml").write_text(f"""[specimen]
bending_stiffness = "{STIFFNESS * (1 + 0.02 * rng.normal()):.6g} N m^2 ± 2 %"
[rig]
span = "{SPAN} m ± 0.2 %"
stiffness = "{k * (1 + 0.01 * rng.normal()) * STIFFNESS / SPAN**3:.6g} N/m ± 1 %"
supports = "edges"
friction_at = "axis"
[record]
file = "test.csv"
stage = "stage"
force = "force"
contact = "0 m ± 1 um"
gain_error = "0.5 %"
preload_error = "0 m"
""", encoding="utf-8")
        sets = [word for key in keys for word in ("--set", key)]
        done = subprocess.run([program, "fit", folder / "case.toml", "--json", *sets], capture_output=True, text=True, check=False)
        if not done.stdout.strip():
            print(done.stderr, file=sys.stderr)
            return None
        return friction, lost, json.loads(done.stdout)


def over_loading(answer):
    numbers = [finding["numbers"] for finding in answer["findings"] if finding["code"] == "relaxes"]
    return next((number["value"] for number in numbers[0] if number["name"] == "over_loading"), None) if numbers else None


def line_of(course, share, answers):
    lost = [lost / over_loading(answer) for _, lost, answer in answers if over_loading(answer)]
    told = [(friction, answer["parameters"]["mu0"]) for friction, _, answer in answers if answer.get("parameters", {}).get("mu0")]
    usable = [(friction, mu0) for friction, mu0 in told if mu0["value"] is not None and mu0["standard_error"] is not None]
    covered = sum(mu0["interval95"][0] <= friction <= mu0["interval95"][1] for friction, mu0 in usable)
    errors = [mu0["value"] - friction for friction, mu0 in usable]
    widths = [mu0["standard_error"] for _, mu0 in usable]
    found = [answer["measurement"].get("relaxation") for _, _, answer in answers]
    found = [each["value"] if isinstance(each, dict) else each for each in found if each is not None]
    verdicts = [answer["verdict"]["code"] for _, _, answer in answers]
    most = ", ".join(f"{code} {verdicts.count(code)}" for code in sorted(set(verdicts)))
    return (f"{course:15} {100 * share:3.0f} % {len(answers):4} {len(usable):4} {covered:4} {np.mean(errors):+.3f} {np.sqrt(np.mean(np.square(errors))):.3f} "
            f"{np.median(widths):.4f} {np.mean(widths):.4f}  {len(found):3} {100 * np.median(found) if found else math.nan:5.1f} %  "
            f"{' '.join(f'{value:4.2f}' for value in np.quantile(lost or [math.nan], (0.05, 0.5, 0.95)))}  {most}")


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 40
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    print("course        share    n told held   mean   rms  median  mean error  found          lost/told       verdicts")
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for course in COURSES:
            for share in SHARES:
                jobs = [pool.submit(answer_of, program, 1000 * seed + i, course, share, sys.argv[4:]) for i in range(count)]
                answers = [job.result() for job in jobs]
                print(line_of(course, share, [each for each in answers if each]), flush=True)


if __name__ == "__main__":
    main()
