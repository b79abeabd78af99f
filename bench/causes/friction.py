"""Friction over the arc S between the supports, as functions of S, drawn at random. The span is 1."""

import dataclasses
import typing

import numpy as np

LEAST = 0.02  # friction is nowhere below
MOST = 1.95  # static friction is nowhere above


def logarithmic(random, low, high):
    return float(np.exp(random.uniform(np.log(low), np.log(high))))


def rough(random, rms, length, reach=0.8, step=2e-4):
    """A Gaussian process over S - 1 with a Matern 3/2 correlation, drawn exactly by circulant embedding."""
    points = 16384
    lag = np.minimum(np.arange(points), points - np.arange(points)) * step * np.sqrt(3) / length
    spectrum = np.sqrt(np.maximum(np.fft.fft((1 + lag) * np.exp(-lag)).real, 0))
    noise = random.normal(size=points) + 1j * random.normal(size=points)
    values = rms * np.fft.fft(spectrum * noise).real / np.sqrt(points)
    places = np.arange(int(reach / step)) * step
    values = values[: len(places)]
    return lambda S: np.interp(S - 1, places, values)


def slow(random, size, reach):
    """Friction that varies slowly: a slope, and a wave about as long as the stretch slid over."""
    slope, height, phase = random.uniform(-size, size), random.uniform(0, size / 2), random.uniform(0, 2 * np.pi)
    length = reach * random.uniform(0.7, 2)
    return lambda S: slope * ((S - 1) / reach - 0.5) + height * np.cos(2 * np.pi * (S - 1) / length + phase)


def wave(height, length, phase):
    return lambda S: height * np.cos(2 * np.pi * (S - 1) / length + phase)


@dataclasses.dataclass
class Friction:
    """Kinetic friction over S, and what of it a simulator must resolve."""

    name: str
    of: typing.Callable
    finest: float  # length over which it varies
    excess: float = 0.0  # of static over kinetic friction


# ---- details about a trend: each draws a function of S and the length over which it varies


def constant_detail(random, mean, reach):
    return lambda S: 0 * S, reach


def slow_detail(random, mean, reach):
    return slow(random, 0.2 * mean, reach), 0.5 * reach


def wave_detail(random, mean, reach):
    length = max(reach / logarithmic(random, 1.5, 120), 0.0004)
    return wave(mean * random.uniform(0.05, 0.4), length, random.uniform(0, 2 * np.pi)), length / 4


def two_waves_detail(random, mean, reach):
    (first, finest), (second, other) = wave_detail(random, 0.7 * mean, reach), wave_detail(random, 0.7 * mean, reach)
    return lambda S: first(S) + second(S), min(finest, other)


def roughness(random, rms, length, reach):
    return rough(random, rms, length, reach, min(length / 8, reach / 500)), length / 2


def rough_detail(random, mean, reach):
    return roughness(random, mean * random.uniform(0.03, 0.2), max(reach / logarithmic(random, 3, 150), 0.0004), reach)


def granular_detail(random, mean, reach):
    return roughness(random, random.uniform(0.03, 0.15), logarithmic(random, 0.0005, 0.003), reach)


DETAILS = {
    "constant": constant_detail,
    "slow": slow_detail,
    "wave": wave_detail,
    "two_waves": two_waves_detail,
    "rough": rough_detail,
    "granular": granular_detail,
}

# Friction at both ends of the stretch slid over.
TRENDS = {
    "level": lambda random: [random.uniform(0.05, 0.95)] * 2,
    "climbing": lambda random: [random.uniform(0.1, 0.5), random.uniform(0.8, 1.5)],
    "falling": lambda random: [random.uniform(0.6, 1.0), random.uniform(0.05, 0.4)],
}


def draw(random, details, trends, reach):
    """Friction with one of the details about one of the trends. Stick_slip is friction, constant or rough, that static friction
    exceeds by 10 to 100 %."""
    name, trend = str(random.choice(details)), str(random.choice(trends))
    begin, end = TRENDS[trend](random)
    shape = str(random.choice(["constant", "rough"])) if name == "stick_slip" else name
    detail, finest = DETAILS[shape](random, (begin + end) / 2, 1.5 * reach)
    of = lambda S: np.maximum(begin + (end - begin) * np.clip((S - 1) / reach, 0, 1) + detail(S), LEAST)
    excess = logarithmic(random, 0.1, 1.0) if name == "stick_slip" else 0.0
    highest = float(of(np.linspace(1, 1 + reach, 2000)).max())
    title = name if trend == "level" else f"{trend}_{name}"
    return Friction(title, of, min(finest, reach / 4), max(min(excess, MOST / highest - 1), 0.0))


def draw_of_cycles(random, damage, reach):
    """The name and the function of friction of a cyclic record."""
    mean = random.uniform(0.15, 0.9)
    choices = {"cracks": ["constant", "slow"], "both": ["wave", "rough"]}
    kind = random.choice(choices.get(damage, ["constant", "wave", "rough", "slow"]))
    trend = slow(random, 0.15, reach) if kind == "slow" or random.uniform() < 0.25 else lambda S: 0 * S
    if kind == "wave":
        height, length, phase = mean * random.uniform(0.05, 0.3), logarithmic(random, 0.008, 0.05), random.uniform(0, 2 * np.pi)
        detail = wave(height, length, phase)
    elif kind == "rough":
        detail = rough(random, random.uniform(0.03, 0.12), random.uniform(0.004, 0.015))
    else:
        detail = lambda S: 0 * S
    return str(kind), lambda S: np.maximum(mean + trend(S) + detail(S), LEAST)


def draw_levels(random, passes):
    """Friction of each pass over that of the first: in half of the records it wears."""
    levels = [1.0]
    wears = random.uniform() < 0.5
    for turn in range(1, passes):
        top = turn % 2 == 1
        levels.append(levels[-1] * (random.uniform(0.85 if top else 0.5, 1) if wears else 1.0))
    return levels
