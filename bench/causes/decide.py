"""How often `fit` finds the true cause of drops after a second loading, against what `design --decide` says beforehand.

    /usr/bin/python3 bench/causes/decide.py --program build/release/flexslip --records 20

Each plan below is asked for its chances. Then as many specimens that only slip, and as many that only crack, are loaded, unloaded and loaded
again as it says, on rigs that are off by the usual errors, each drawn anew. A line for each plan and cause: the chance told, the share of
records with the right verdict, and what its binomial error is.
"""

import argparse
import concurrent.futures
import dataclasses
import json
import math
import os
import pathlib
import random
import subprocess
import tempfile

SPECIMEN = {"modulus": 29.6e9, "span": 1278e-6, "stiffness": 90.65}  # as stated
ERRORS = {"modulus": 0.03, "span": 0.005, "stiffness": 0.02}  # of what is stated, as RigErrors has them
GAIN, PRELOAD, SLOW_FORCE = 0.01, 0.005, 0.0065  # relative; [L]; [maximum force]
TEST = """[specimen]
diameter = "34.8 um"
modulus = "{modulus!r} Pa"
[rig]
span = "{span!r} m"
stiffness = "{stiffness!r} N/m"
supports = "edges"
"""
SINUSOID = """[friction]
model = "sinusoid"
mu0 = {mu0}
amplitude = {amplitude}
wavelength = "10.9 um"
phase = 1.0
"""
PLANS = {  # friction, travel [m], noise [N]
    "many drops": ({"mu0": 0.5, "amplitude": 0.15}, 525e-6, 12e-6),
    "slippery": ({"mu0": 0.3, "amplitude": 0.15}, 525e-6, 12e-6),
    "few drops": ({"mu0": 0.4, "amplitude": 0.15}, 420e-6, 12e-6),
    "noisy cell": ({"mu0": 0.4, "amplitude": 0.15}, 525e-6, 100e-6),
}


def run(program, command, case, *arguments):
    """What a command writes as JSON. `fit` exits with 1 where it has no verdict, and writes all the same."""
    found = subprocess.run([program, command, case, *arguments, "--json", "--quiet"], capture_output=True, text=True)
    if not found.stdout:
        raise RuntimeError(found.stderr)
    return json.loads(found.stdout)


def stage(positions):
    return f'[stage]\nprogram = [{", ".join(f"{chr(34)}{p!r} m{chr(34)}" for p in positions)}]\nstep = "2 um"\n'


def crack_deflections(path):
    """Deflections before the falls of the force in a loading without noise."""
    falls = [(a, b) for a, b in zip(path, path[1:]) if b["force"] < a["force"] - 0.003 * max(p["force"] for p in path)]
    return [a["deflection"] for a, b in falls]


@dataclasses.dataclass
class Cause:
    """Specimens whose drops have one cause."""

    name: str
    verdict: str  # that is right
    friction: str
    cracks: str = ""


def planned(program, folder, name, friction, travel, noise):
    """The plan for the travel, and the specimens that slip only and crack only with drops as it expects."""
    waves = SINUSOID.format(**friction)
    case = folder / f"{name}.toml"
    case.write_text(TEST.format(**SPECIMEN) + waves + stage([0.0, travel]), encoding="utf-8")
    plan = run(program, "design", case, "--decide", "--noise", f"{noise!r} N")["reload"]["planned"]
    deflections = crack_deflections(run(program, "simulate", case)["path"])
    each = 1 - (1 - plan["loss_needed"]) ** (1 / len(deflections))
    cracks = "".join(f'[[specimen.cracks]]\ndeflection = "{w!r} m"\nloss = {each!r}\n' for w in deflections)
    smooth = f'[friction]\nmodel = "constant"\nmu0 = {friction["mu0"]}\n'
    return plan, (Cause("slips", "slip", waves), Cause("cracks", "crack", smooth, cracks))


def verdict(program, folder, plan, cause, noise, seed):
    """The code of the verdict on one record."""
    name = cause.name
    draw = random.Random(f"{name} {plan['travel']!r} {seed}")
    true = {key: value * (1 + ERRORS[key] * draw.gauss(0, 1)) for key, value in SPECIMEN.items()}
    positions = [0.0, plan["travel"], plan["unload_to"], plan["travel"]]
    case = folder / f"{name}-{seed}-true.toml"
    case.write_text(TEST.format(**true).replace("[rig]", cause.cracks + "[rig]") + cause.friction + stage(positions), encoding="utf-8")
    path = run(program, "simulate", case, "--noise", f"{noise!r} N", "--seed", str(seed))["path"]
    begins = abs(draw.gauss(0, PRELOAD)) * true["span"]
    gain, slow = 1 + GAIN * draw.gauss(0, 1), SLOW_FORCE * draw.gauss(0, 1) * max(p["force"] for p in path)
    first = next(i for i, p in enumerate(path) if p["stage"] >= begins)
    rows = [(p["stage"] - path[first]["stage"], gain * (p["force"] - path[first]["force"]) + slow * i / len(path))
            for i, p in enumerate(path) if i >= first]
    record = folder / f"{name}-{seed}.csv"
    record.write_text("stage [m],force [N]\n" + "".join(f"{a!r},{b!r}\n" for a, b in rows), encoding="utf-8")
    stated = folder / f"{name}-{seed}.toml"
    stated.write_text(TEST.format(**SPECIMEN) + f'[record]\nfile = "{record.name}"\nstage = "stage"\nforce = "force"\n', encoding="utf-8")
    return run(program, "fit", stated)["verdict"]["code"]


def score(program, folder, name, friction, travel, noise, records):
    plan, causes = planned(program, folder, name, friction, travel, noise)
    print(f"{name}: {plan['drops']} drops, {plan['loss_needed']:.3f} needed, ± {plan['loss_error']:.3f}, "
          f"unloaded to {1e3 * plan['force']:.2f} mN", flush=True)
    for cause in causes:
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            codes = list(pool.map(lambda seed: verdict(program, folder, plan, cause, noise, seed), range(records)))
        told, share = plan[f"chance_if_{cause.name}"], codes.count(cause.verdict) / records
        error = math.sqrt(max(share * (1 - share), 0.25 / records) / records)
        others = {code: codes.count(code) for code in sorted(set(codes)) if code != cause.verdict}
        print(f"  {cause.name:7} told {told:.2f}, right {share:.2f} ± {error:.2f}, else {others}", flush=True)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--program", default="build/release/flexslip", type=pathlib.Path)
    arguments.add_argument("--records", default=20, type=int)
    given = arguments.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for name, (friction, travel, noise) in PLANS.items():
            score(given.program.resolve(), pathlib.Path(folder), name.replace(" ", "-"), friction, travel, noise, given.records)


if __name__ == "__main__":
    main()
