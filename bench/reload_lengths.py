#!/usr/bin/python3
"""bench/reload_lengths.py PACKAGE [N] [SEED]: wavelengths of simulated tests with a reload, against the truth.

PACKAGE is the folder of the Python package, such as build/check/python. Prints for each kind of test, of N, how many 95 % intervals hold the
wavelength, and the errors in standard errors. The rig is exact; each test has its own friction and noise.
"""
import multiprocessing
import sys

import numpy as np

sys.path.insert(0, sys.argv[1])
import flexslip

FIBRE = {"specimen": {"diameter": "34.8 um", "modulus": "29.6 GPa"}, "rig": {"span": "1278 um", "stiffness": "90.65 N/m", "supports": "edges"}}
ROD = {"specimen": {"diameter": "1 mm", "modulus": "70 GPa"}, "rig": {"span": "20 mm", "stiffness": "20 N/mm", "supports": "edges"}}
KINDS = {  # test, wavelength [µm], positions of the stage [µm], step [µm], noise
    "fibre, no reload": (FIBRE, 10.9, (0, 900), 2, "10 uN"),
    "fibre, 450-100-900": (FIBRE, 10.9, (0, 450, 100, 900), 2, "10 uN"),
    "fibre, 600-100-900": (FIBRE, 10.9, (0, 600, 100, 900), 2, "10 uN"),
    "fibre, 800-300-850": (FIBRE, 10.9, (0, 800, 300, 850), 2, "10 uN"),
    "fibre, 500-300-900": (FIBRE, 14.0, (0, 500, 300, 900), 2, "10 uN"),
    "rod, 7800-4000-8200": (ROD, 60.0, (0, 7800, 4000, 8200), 10, "0.03 N"),
}


def one(job):
    kind, seed = job
    test, wavelength, stages, step, noise = KINDS[kind]
    random = np.random.default_rng(seed)
    friction = {"model": "sinusoid", "mu0": float(random.uniform(0.3, 0.6)), "amplitude": float(random.uniform(0.12, 0.22)),
                "wavelength": f"{wavelength} um", "phase": float(random.uniform(0, 2 * np.pi))}
    simulated = flexslip.simulate(**test, friction=friction, stage={"program": [f"{stage} um" for stage in stages], "step": f"{step} um"}, noise=noise, seed=seed)
    found = flexslip.fit(simulated.path.stage, simulated.path.force, **test).params.wavelength
    low, high = found.ci95
    return kind, 1e6 * found.value / wavelength - 1, 1e6 * found.stderr / wavelength, 1e6 * low <= wavelength <= 1e6 * high


def main():
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 16
    first = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    jobs = [(kind, seed) for kind in KINDS for seed in range(first, first + count)]
    with multiprocessing.Pool() as pool:
        results = [result for result in pool.map(one, jobs) if np.isfinite(result[1])]
    for kind in KINDS:
        errors, deviations, covered = (np.array(each) for each in zip(*(result[1:] for result in results if result[0] == kind)))
        print(f"{kind:22} {covered.sum()} of {len(covered)} cover; bias {100 * errors.mean():.2f} %, median error {100 * np.median(deviations):.2f} %, "
              f"rms {np.sqrt(np.mean((errors / deviations) ** 2)):.2f} standard errors")


if __name__ == "__main__":
    main()
