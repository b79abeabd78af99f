"""Height traces with known waves, roughness and noise, and how each is looked at. Lengths are in metres."""
import pathlib

import numpy as np

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "examples/surface/trace.csv"
MICROMETRE = 1e-6
STEP = 0.1 * MICROMETRE


def smooth_noise(random: np.random.RandomState, count: int, rms: float, correlation_length: float) -> np.ndarray:
    """White noise smoothed to a Gaussian correlation exp(-(s/ℓ)²)."""
    x = np.arange(-4 * correlation_length, 4 * correlation_length + STEP, STEP)
    kernel = np.exp(-2 * (x / correlation_length) ** 2)
    heights = np.convolve(random.normal(size=count + len(x) - 1), kernel, mode="valid")
    return rms * heights / np.sqrt(np.sum(kernel**2))


def fading_noise(random: np.random.RandomState, count: int, rms: float, correlation_length: float) -> np.ndarray:
    """An autoregression of order one, whose correlation is exp(-s/ℓ)."""
    kept = np.exp(-STEP / correlation_length)
    heights = random.normal(size=count)
    for i in range(1, count):
        heights[i] = kept * heights[i - 1] + np.sqrt(1 - kept**2) * heights[i]
    return rms * heights


def wave(count: int, amplitude: float, wavelength: float, phase: float = 0.0) -> np.ndarray:
    return amplitude * np.cos(2 * np.pi * STEP * np.arange(count) / wavelength + phase)


def traces() -> dict[str, np.ndarray]:
    """Heights at a distance of STEP, by name. RandomState gives the same numbers in every version of NumPy."""
    um = MICROMETRE
    nm = 1e-9
    tilt = 0.02 * STEP * np.arange(2048)
    return {
        "example": np.loadtxt(EXAMPLE, delimiter=",", skiprows=2)[:, 1] * um,
        "smooth": smooth_noise(np.random.RandomState(1), 2048, 0.06 * um, 1 * um) + tilt,
        "fading": fading_noise(np.random.RandomState(2), 2048, 0.03 * um, 2 * um) + np.random.RandomState(3).normal(0, 2 * nm, 2048),
        "two waves": wave(2048, 0.11 * um, 10.9 * um, 1.0) + wave(2048, 0.05 * um, 4.3 * um) + np.random.RandomState(4).normal(0, 20 * nm, 2048),
        "broad wave": (1 + smooth_noise(np.random.RandomState(5), 2048, 0.7, 15 * um)) * wave(2048, 0.1 * um, 6 * um) + np.random.RandomState(6).normal(0, 5 * nm, 2048),
        "noise": np.random.RandomState(7).normal(0, 50 * nm, 1024),
        "wave in noise": wave(1024, 0.1 * um, 8 * um) + np.random.RandomState(8).normal(0, 50 * nm, 1024),
        "short": fading_noise(np.random.RandomState(9), 100, 0.05 * um, 1 * um),
    }


# How each trace is looked at: keywords of flexslip.surface.
LOOKS: dict[str, tuple[str, dict[str, float]]] = {
    "example": ("example", {}),
    "example, level 2": ("example", {"level": 2, "tapers": 5, "wavelength": 10.9e-6, "amplitude": 0.11e-6, "pixel": 0.29e-6}),
    "example, band": ("example", {"shortest": 3e-6, "longest": 50e-6, "noise": 2e-9}),
    "smooth": ("smooth", {}),
    "fading": ("fading", {"wavelength": 20e-6}),
    "fading, mean": ("fading", {"level": 0, "tapers": 12}),
    "two waves": ("two waves", {}),
    "broad wave": ("broad wave", {}),
    "noise": ("noise", {}),
    "wave in noise": ("wave in noise", {}),
    "short": ("short", {}),
}
