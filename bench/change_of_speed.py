"""Whether a change of the stage's speed by ten shows that a specimen relaxes: the step of its force there, and the change of its slope.

    /usr/bin/python3 bench/change_of_speed.py [COUNT]

Forces of smooth loadings with noise of 0.1 %, relaxed as in relaxation.py, that vary along the way by a share (rms) as friction makes them vary.
"""

import sys

import numpy as np

ROWS, BESIDE = 200, 15  # before and behind the change; looked at on either side
NOISE = 0.001  # [maximum force]


def change(rng, law, share, varies):
    """Relative change of the slope, and the step of the force [maximum force]."""
    w = np.r_[np.linspace(0, 0.6, ROWS)[:-1], np.linspace(0.6, 1, ROWS)]
    time = np.r_[np.linspace(0, 1, ROWS)[:-1], 1 + np.linspace(0, 0.0667, ROWS)]
    lengths = np.exp(rng.uniform(np.log(0.01), np.log(0.2), 8))
    elastic = w * (1 - 0.4 * w**2) * (1 + varies * sum(np.cos(2 * np.pi * w / length + rng.uniform(0, 7)) for length in lengths) / 2)
    since, whole = np.maximum(time[:, None] - time[None, :], 0), time[-1]
    scale = rng.uniform(0.05, 0.5) * whole
    solid = (1 - np.exp(-since / scale)) / (1 - np.exp(-whole / scale))
    lost = solid if law == "solid" else np.log1p(since / (0.01 * whole)) / np.log(101)
    force = np.tril(1 - share * lost) @ np.diff(elastic, prepend=0)
    force += NOISE * force.max() * rng.normal(size=len(force))
    at = ROWS - 1
    before, behind = (np.polyfit(w[part] - w[at], force[part], 1) for part in (slice(at - BESIDE, at), slice(at + 1, at + 1 + BESIDE)))
    return behind[0] / before[0] - 1, (behind[1] - before[1]) / force.max()


def main():
    count, rng = int(sys.argv[1]) if len(sys.argv) > 1 else 200, np.random.default_rng(1)
    print("varies  law    share  slope: median, half of the middle 68 %   step: likewise")
    for varies in (0, 0.005):
        for law in ("solid", "log"):
            for share in (0, 0.05, 0.13, 0.18):
                changes = np.array([change(rng, law, share, varies) for _ in range(count)])
                low, middle, high = np.quantile(changes, (0.16, 0.5, 0.84), axis=0)
                slope, step = zip(middle, (high - low) / 2)
                print(f"{100 * varies:4.1f} %  {law:5} {100 * share:4.0f} %  {slope[0]:+.3f} {slope[1]:.3f}   {step[0]:+.4f} {step[1]:.4f}")


if __name__ == "__main__":
    main()
