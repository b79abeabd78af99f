"""How often the interval of EI holds the truth where EI is not stated, by how a record begins.

    /usr/bin/python3 bench/unstated_stiffness.py PROGRAM [COUNT] [SEED]

Records of the program's own mechanics (simulate) on rigs that are off what is stated of them: load train 2 %, span 0.5 %, gain 0.7 %, slow drift,
noise. They begin: rows (with rows before the contact), none (at the contact, to 0.05 % of the span), toe (a seat that gives way), tare (displacement
and force are zeroed when the specimen carries a load already).
"""

import concurrent.futures
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

BEGINNINGS = ("rows", "none", "toe", "tare")
SPAN = 20e-3  # m


def curve(program, folder, rng, k, EI):
    """Stage [m] and force [N] of a specimen with rough friction on a load train of k EI/L^3."""
    depth = rng.uniform(0.12, 0.3)
    deepest = depth + 48 * depth / k
    text = f"""[specimen]
bending_stiffness = "{EI:.9g} N m^2"
[rig]
span = "{SPAN} m"
stiffness = "{k * EI / SPAN**3:.9g} N/m"
supports = "edges"
[friction]
model = "rough"
mu0 = {rng.uniform(0.1, 0.7):.3f}
rms = {rng.uniform(0.02, 0.2):.3f}
correlation_length = "{rng.uniform(0.002, 0.02) * SPAN:.4g} m"
seed = {rng.randrange(10**6)}
[stage]
program = ["0 m", "{deepest * SPAN:.6g} m"]
step = "{deepest * SPAN / rng.randrange(200, 600):.6g} m"
"""
    case = folder / "truth.toml"
    case.write_text(text, encoding="utf-8")
    done = subprocess.run([program, "simulate", case, "--json"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return None
    path = json.loads(done.stdout)["path"]
    return [point["stage"] for point in path], [point["force"] for point in path]


def read(rng, beginning, stage, force):
    """What the rig records, and whether displacement and force have a zero of their own."""
    top, greatest = stage[-1], max(force)
    gain, noise = 1 + 0.007 * rng.gauss(0, 1), greatest * math.exp(rng.uniform(math.log(0.0005), math.log(0.005)))
    if beginning == "toe":
        depth, seat = SPAN * rng.uniform(0.002, 0.012), greatest * rng.uniform(0.01, 0.06)
        stage = [x + depth * (1 - math.exp(-f / seat)) for x, f in zip(stage, force)]
    if beginning == "tare":
        first = next(i for i, f in enumerate(force) if f >= greatest * rng.uniform(0.002, 0.02))
        stage = [x - stage[first] for x in stage[first:]]
        force = [f - force[first] for f in force[first:]]
    if beginning == "none":
        shift = 0.0005 * SPAN * rng.gauss(0, 1)
        stage = [x + shift for x in stage]
        stage, force = zip(*[(x, f) for x, f in zip(stage, force) if x >= 0])
    if beginning == "rows":
        step, ahead = stage[1] - stage[0], top * math.exp(rng.uniform(math.log(0.002), math.log(0.1)))
        count = max(int(ahead / step), 1)
        stage = [i * step for i in range(count)] + [x + count * step for x in stage]
        force = [0.0] * count + list(force)
    drift = 0.003 * rng.gauss(0, 1) * greatest
    rows = len(force)
    return stage, [gain * f + drift * i / rows + noise * rng.gauss(0, 1) for i, f in enumerate(force)]


def tried(program, beginning, number, seed):
    rng = random.Random(f"{beginning} {number} {seed}")
    k = math.exp(rng.uniform(math.log(20), math.log(1000)))
    EI = 1e-4
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        made = curve(program, folder, rng, k, EI)
        if made is None:
            return None
        stage, force = read(rng, beginning, *made)
        record = folder / "test.csv"
        record.write_text("stage [um],force [mN]\n" + "".join(f"{1e6 * x:.5f},{1e3 * f:.7g}\n" for x, f in zip(stage, force)), encoding="utf-8")
        span, train = SPAN * (1 + 0.005 * rng.gauss(0, 1)), k * EI / SPAN**3 * (1 + 0.02 * rng.gauss(0, 1))
        call = [program, "fit", record, "--bending-stiffness", "fit", "--span", f"{span} m", "--stiffness", f"{train} N/m", "--set", "rig.supports=edges",
                "--stage", "stage", "--force", "force", "--json", "--quiet"]
        done = subprocess.run(call, capture_output=True, text=True, check=False)
    if not done.stdout:
        return None
    fit = json.loads(done.stdout)
    EI_told = (fit.get("parameters") or {}).get("bending_stiffness")
    if fit["status"] != "ok" or not EI_told:
        return None
    low, high = EI_told["interval95"]
    prior = fit["nominal_bending_stiffness"]
    return {"k": k, "error": EI_told["value"] / EI - 1, "stated": EI_told["standard_error"] / EI, "covered": low <= EI <= high, "verdict": fit["verdict"]["code"],
            "source": fit["contact"]["source"] if "contact" in fit else "", "prior": prior["nominal"] / EI - 1 if isinstance(prior["nominal"], float) else math.nan,
            "prior_error": prior["relative_error"], "number": number}


def main():
    program, count, seed = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 50, int(sys.argv[3]) if len(sys.argv) > 3 else 1
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for beginning in BEGINNINGS:
            results = [each for each in pool.map(lambda number, b=beginning: tried(program, b, number, seed), range(count)) if each]
            z = [each["error"] / each["stated"] for each in results]
            covered = sum(each["covered"] for each in results)
            print(f"{beginning:5} {len(results):4} told, {covered} covered ({100 * covered / max(len(results), 1):.0f} %), error rms {100 * math.sqrt(sum(e['error']**2 for e in results) / max(len(results), 1)):.1f} %, "
                  f"mean {100 * sum(e['error'] for e in results) / max(len(results), 1):.1f} %, stated {100 * sum(e['stated'] for e in results) / max(len(results), 1):.1f} %, z rms {math.sqrt(sum(x * x for x in z) / max(len(z), 1)):.2f}", flush=True)
            if "--all" in sys.argv:
                for each in results:
                    print("   ", {key: round(value, 4) if isinstance(value, float) else value for key, value in each.items()})


if __name__ == "__main__":
    main()
