"""What a height profile shows of a surface: its spectrum, its waves, how high and steep it is, and which waves it could show at all.

The spectrum is the mean of several periodograms, each of the heights times a sine taper of its own (Riedel and Sidorenko, IEEE Trans. Signal Process. 43,
1995). A wave is coherent if the tapers agree on its amplitude and phase (Thomson, Proc. IEEE 70, 1982)."""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
import numpy.typing as npt

from . import _flexslip
from ._answers import NAN, Estimate
from ._case import quantity_in_words
from ._errors import whole, wrong

Numbers = npt.NDArray[np.float64]
Value = str | float
Frequencies = TypeVar("Frequencies", float, Numbers)

FEWEST_HEIGHTS = 64  # that tell a spectrum
MOST_DEGREE = 9  # of the polynomial to take off
FEWEST_TAPERS, MOST_TAPERS = 2, 30
MOST_WAVES = 8
STEPS_OF_SHORTEST = 5  # heights to the shortest wave, as in ISO 3274
PERIODS_WANTED, PIXELS_WANTED = 10, 10  # of an image, by section 5 of the paper: waves in the field, pixels from crest to trough
FALSE_ALARMS = 0.01  # of a wave, among all frequencies
SMALLEST, LARGEST = 1e-18, 1e6  # [m] what is beyond overflows
FLOOR = 1e-250  # [m³] of a background: what is below it underflows
LEAK = 1e-5  # of the highest density: what lies below it may have leaked from there through the tapers


@dataclass(frozen=True)
class SurfaceWave:
    """A wave that stands out from the spectrum.

    Attributes
    ----------
    wavelength, amplitude : Estimate
        Along the trace; half of the height from crest to trough [m].
    p_value : float
        Probability that a surface without waves shows a wave like this one at any frequency.
    coherent : bool
        The wave keeps one phase along the whole trace.
    phase : float
        Of a coherent wave, at the first height [rad]; NaN of others.
    """

    wavelength: Estimate
    amplitude: Estimate
    p_value: float
    coherent: bool
    phase: float


@dataclass(frozen=True)
class WaveResolution:
    """Whether a trace could show a wave of some length.

    Attributes
    ----------
    wavelength : float
        The length in question [m].
    heights_a_wave, waves_in_field : float
        A wave needs two heights; the paper asks for ten waves.
    least_amplitude_by_pixels : float
        Smallest amplitude that shows by the paper's rule of ten pixels from crest to trough [m]; NaN if no pixel is stated.
    least_amplitude_by_spectrum : float
        Smallest amplitude of a coherent wave that stands out from noise and roughness in 95 of 100 such traces [m].
    pixel_wanted : float
        Pixel that the paper's rule asks for, for a wave of the amplitude in question, or of the one found [m]; NaN without either.
    """

    wavelength: float
    heights_a_wave: float
    waves_in_field: float
    least_amplitude_by_pixels: float
    least_amplitude_by_spectrum: float
    pixel_wanted: float


@dataclass(frozen=True, repr=False, eq=False)
class Surface:
    """What a height profile shows of a surface, as :func:`surface` gives it. Lengths are in metres.

    Attributes
    ----------
    success : bool
        A surface is seen in the noise. If not, `message` says so, and `rms_height` and `rms_slope` are NaN.
    message : str
        Why no surface is seen; empty if one is.
    rms_height, rms_slope : Estimate
        Root mean square of height and slope between the wavelengths `shortest` and `longest`, without noise.
    shortest, longest : float
        These wavelengths.
    noise : float
        Standard deviation of the white noise of a height; 0 if none is found.
    noise_found : bool
        The noise was found from the floor of the spectrum; it was not stated.
    waves : tuple of SurfaceWave
        Waves that stand out from the spectrum, the highest first.
    resolution : tuple of WaveResolution
        Whether the trace could show the waves in question; unless some are stated, those found.
    frequency, density, background : ndarray
        Waves per metre; one-sided power spectral density of the heights [m³]; its smooth part, with the noise.
    density_factors : tuple of float
        Factors from a density to the ends of its 95 % interval.
    """

    success: bool
    message: str
    rms_height: Estimate
    rms_slope: Estimate
    shortest: float
    longest: float
    noise: float
    noise_found: bool
    waves: tuple[SurfaceWave, ...]
    resolution: tuple[WaveResolution, ...]
    frequency: Numbers
    density: Numbers
    background: Numbers
    density_factors: tuple[float, float]

    def __repr__(self) -> str:
        lines = ["<Surface>"]
        if self.success:
            lines += [f"  rms_height  {self.rms_height}", f"  rms_slope   {self.rms_slope}"]
        else:
            lines.append(f"  message     {self.message}")
        lines += [f"  wave        amplitude {wave.amplitude}, wavelength {wave.wavelength}" for wave in self.waves]
        return "\n".join(lines)


def _estimate(value: float, error: float, low: float, high: float, unit: str) -> Estimate:
    return Estimate({"value": value, "standard_error": error, "interval95": [low, high], "unit": unit})


def _normal(value: float, error: float, unit: str) -> Estimate:
    return _estimate(value, error, value - 1.96 * error, value + 1.96 * error, unit)


# ---- The spectrum


@dataclass(frozen=True)
class _Spectrum:
    tapers: int
    width: float  # [m] of the field
    step: float  # [1/m] between frequencies, at most half of 1/width
    half_bandwidth: float  # [1/m]
    inflation: float  # [1] by how much more a sum over it varies than over n even heights, for tapers leave out the ends
    frequency: Numbers  # [1/m]
    density: Numbers  # [m³]
    tapered: npt.NDArray[np.complex128]  # transforms of the tapered heights, taper by taper

    def at(self, f: float) -> int:
        return int(min(max(round(f / self.step), 0), len(self.density) - 1))

    @property
    def independent(self) -> float:
        """So many independent frequencies."""
        return self.width * float(self.frequency[-1])


def _taper(k: int, n: int) -> Numbers:
    angle: Numbers = np.pi * k * np.arange(1, n + 1) / (n + 1)
    return np.asarray(math.sqrt(2 / (n + 1)) * np.sin(angle))


def _spectrum(z: Numbers, step: float, tapers: int) -> _Spectrum:
    n = len(z)
    padded = 1 << (2 * n - 1).bit_length()
    windows = np.array([_taper(k, n) for k in range(1, tapers + 1)])
    tapered = np.fft.rfft(windows * z, padded)
    sides = np.full(padded // 2 + 1, 2.0)
    sides[[0, -1]] = 1
    frequency_step = 1 / (step * padded)
    return _Spectrum(tapers, step * n, frequency_step, 0.5 * (tapers + 1) / (step * (n + 1)), float(n * np.sum(np.mean(windows**2, axis=0) ** 2)),
                     frequency_step * np.arange(padded // 2 + 1), sides * step * np.mean(np.abs(tapered) ** 2, axis=0), tapered)


def _coherence(tapered: npt.NDArray[np.complex128], n: int) -> tuple[npt.NDArray[np.complex128], Numbers]:
    """By the F test, for transforms taper by taper: the wave that all tapers share, as half its amplitude with its phase, and its p value at one frequency."""
    k = np.arange(1, len(tapered) + 1)
    sums = np.where(k % 2 == 1, math.sqrt(2 / (n + 1)) / np.tan(0.5 * np.pi * k / (n + 1)), 0.0)  # of each taper over the heights
    square = float(np.sum(sums**2))
    wave = np.tensordot(sums, tapered, 1) / square
    explained = square * np.abs(wave) ** 2
    left = np.maximum(np.sum(np.abs(tapered) ** 2, axis=0) - explained, 1e-300)
    return wave, (1 + explained / left) ** -(len(tapered) - 1.0)


# ---- The smooth part of the spectrum: a surface without waves, and white noise


@dataclass(frozen=True)
class _Background:
    """level (1 + (f/knee)²)^-power exp(-f²/cut²) + noise: of an exponential correlation power is 1, of a Gaussian one only the cut is there."""

    level: float
    knee: float  # [1/m]
    power: float
    decay: float  # 1/cut² [m²]
    noise: float  # [m³]
    folding: float  # [1/m] the rate of sampling: what is finer is folded back
    noise_found: bool = False
    noise_error: float = 0.0  # relative

    def _unfolded(self, f: Frequencies) -> Frequencies:
        density: Frequencies = self.level * np.exp(-self.power * np.log1p((f / self.knee) ** 2) - self.decay * f**2)
        return density

    def surface(self, f: Frequencies) -> Frequencies:
        folds = 4
        total = self._unfolded(f)
        for m in range(1, folds + 1):
            total = total + self._unfolded(m * self.folding - f) + self._unfolded(m * self.folding + f)
        if self.power > 0.55:  # a power law goes on beyond, on both sides
            beyond = (folds + 0.5) * self.folding
            total = total + 2 * self._unfolded(beyond) * beyond / ((2 * self.power - 1) * self.folding)
        return total

    def __call__(self, f: Frequencies) -> Frequencies:
        return self.surface(f) + self.noise


def _bins(spectrum: _Spectrum, without: Sequence[tuple[float, float]]) -> tuple[Numbers, Numbers, Numbers]:
    """Frequency, density and weight, in independent ordinates, of bins of at most a twelfth of an octave; without some frequencies, if enough are left."""
    fewest = 6
    least, end = 1 / spectrum.width, 0.0
    bins: list[list[int]] = []
    for j in range(1, len(spectrum.density) - 1):
        f = float(spectrum.frequency[j])
        if f < 0.75 * least or any(low <= f <= high for low, high in without):
            continue
        if f >= end:
            bins.append([])
            end = max(f * 2 ** (1 / 12), f + least)
        bins[-1].append(j)
    if without and len(bins) < fewest:
        return _bins(spectrum, [])
    frequency = np.array([np.mean(spectrum.frequency[one]) for one in bins])
    density = np.array([np.mean(spectrum.density[one]) for one in bins])
    weight = np.array([len(one) for one in bins]) * spectrum.step * spectrum.width / spectrum.inflation
    return frequency, density, weight


class _Whittle:
    """The likelihood of a background, and its greatest value. The parameters are ln level, ln knee, power, ln decay and, unless noise is stated, ln noise."""

    def __init__(self, bins: tuple[Numbers, Numbers, Numbers], folding: float, noise: float | None) -> None:
        self.frequency, self.density, self.weight = bins
        self.folding, self.noise = folding, noise
        first, last, most = self.frequency[0], self.frequency[-1], math.log(self.density.max())
        # Heights fall with a power of 4 at most, and no knee is finer than what is seen.
        self.bounds = [(most - 30, most + 15), (math.log(0.3 * first), math.log(2 * last)), (0, 4), (math.log(1e-3 / last**2), math.log(10 / first**2)),
                       (math.log(max(self.density.min(), 1e-300)) - 10, most)][:5 if noise is None else 4]

    def background(self, at: Numbers) -> _Background:
        noise = math.exp(at[4]) if self.noise is None else self.noise
        return _Background(math.exp(at[0]), math.exp(at[1]), float(at[2]), math.exp(at[3]), noise, self.folding)

    def slopes(self, at: Numbers) -> tuple[Numbers, Numbers]:
        """The background in the bins, and how its logarithm changes with each parameter."""
        small = 1e-4
        expected = np.maximum(self.background(at)(self.frequency), FLOOR)
        slopes = []
        for i in range(len(at)):
            beside = np.zeros(len(at))
            beside[i] = small
            slopes.append((self.background(at + beside)(self.frequency) - self.background(at - beside)(self.frequency)) / (2 * small * expected))
        return expected, np.array(slopes)

    def likelihood(self, at: Numbers) -> float:
        """Its logarithm, less that of a background that goes through every bin."""
        ratio = self.density / np.maximum(self.background(at)(self.frequency), FLOOR)
        return -float(np.sum(self.weight * (ratio - np.log(np.maximum(ratio, FLOOR)) - 1)))

    def climb(self, start: Numbers) -> tuple[Numbers, float]:
        """Damped scoring: the parameters that it comes to, and their likelihood."""
        low, high = np.array(self.bounds).T
        at = np.clip(start[:len(low)], low, high)
        reached, damping = self.likelihood(at), 1e-3
        for _ in range(100):
            expected, slopes = self.slopes(at)
            information = (slopes * self.weight) @ slopes.T
            gradient = slopes @ (self.weight * (self.density / expected - 1))
            there, likelihood = at, reached
            while not likelihood > reached and damping < 1e8:
                damped = information + np.diag(damping * np.diag(information) + 1e-9)
                there = np.clip(at + np.linalg.solve(damped, gradient), low, high)
                likelihood = self.likelihood(there)
                damping *= 1 / 8 if likelihood > reached else 8
            gained = likelihood - reached
            if not gained > 0:
                break
            at, reached, damping = there, likelihood, max(damping, 1e-9)
            if gained < 1e-6:
                break
        return at, reached

    def fit(self) -> tuple[Numbers, float]:
        """The likeliest parameters, and their likelihood."""
        first, last = math.log(self.frequency[0]), math.log(self.frequency[-1])
        few = max(len(self.density) // 8, 1)
        level, floor = math.log(max(self.density[:few].mean(), 0.3 * self.density.max())), math.log(0.7 * self.density[-few:].mean())
        found = []
        for share in (0.1, 0.35, 0.6):  # where the knee lies between the first frequency and the last
            knee = first + share * (last - first)
            for power, decay in ((1.0, -2 * math.log(10) - 2 * last), (0.1, -2 * math.log(2) - 2 * knee)):
                found.append(self.climb(np.array([level, knee, power, decay, floor])))
        return max(found, key=lambda each: each[1])

    def noise_error(self, at: Numbers) -> float:
        _, slopes = self.slopes(at)
        information = (slopes * self.weight) @ slopes.T + 1e-9 * np.eye(len(at))
        return math.sqrt(max(float(np.linalg.inv(information)[4, 4]), 0.0))


def _background(spectrum: _Spectrum, without: Sequence[tuple[float, float]], noise: float | None) -> _Background:
    """White noise is found where it gains 3 in the likelihood's logarithm and is half of what is there at the highest frequency; the whole spectrum is
    noise unless a surface gains 5, for its three parameters. The density of noise that is stated stays."""
    bins = _bins(spectrum, without)
    frequency, density, weight = bins
    folding = 2 * float(spectrum.frequency[-1])
    without_noise = _Whittle(bins, folding, noise or 0.0)
    at, likelihood = without_noise.fit()
    if noise is not None:
        return without_noise.background(at)
    floor = float(np.sum(weight * density) / np.sum(weight))
    of_floor = -float(np.sum(weight * (density / floor - np.log(density / floor) - 1)))
    if likelihood - of_floor < 5:
        return _Background(0.0, folding, 0.0, 0.0, floor, folding, True, 1 / math.sqrt(np.sum(weight)))
    with_noise = _Whittle(bins, folding, None)
    noisy_at, noisy_likelihood = with_noise.fit()
    noisy = with_noise.background(noisy_at)
    if noisy_likelihood - likelihood > 3 and noisy.noise > 0.5 * noisy(frequency[-1]):
        return _Background(noisy.level, noisy.knee, noisy.power, noisy.decay, noisy.noise, folding, True, with_noise.noise_error(noisy_at))
    return without_noise.background(at)


# ---- Waves


def _density_about(spectrum: _Spectrum, f: float) -> float | None:
    """The density of a frequency's neighbours beyond the bandwidth [m³]; None where there are none below."""
    band = 2 * spectrum.half_bandwidth
    least = 1 / spectrum.width
    if f - 2 * band < least:
        return None
    freedoms = 2 * spectrum.tapers
    mean_over_median = (1 - 2 / (9 * freedoms)) ** -3  # of chi squared, by Wilson and Hilferty

    def usual(low: float, high: float) -> float:
        some = np.sort(spectrum.density[spectrum.at(max(low, least)):spectrum.at(high) + 1])
        return float(some[len(some) // 2]) * mean_over_median

    below, above = usual(f - 3 * band, f - band), usual(f + band, f + 3 * band)
    return max(math.sqrt(below * above), above)


class _Demodulator:
    """Amplitude and phase of a wave by weighted least squares; the weights are those of the first taper."""

    def __init__(self, z: Numbers, step: float) -> None:
        self.z, self.step = z, step
        n = len(z)
        self.weight = np.sin(np.pi * np.arange(1, n + 1) / (n + 1))
        self.x = step * (np.arange(n) - 0.5 * (n - 1))

    def wave(self, f: float) -> complex:
        return complex(2 * np.sum(self.weight * self.z * np.exp(-2j * np.pi * f * self.x)) / np.sum(self.weight))

    def refined(self, f: float, half_range: float) -> float:
        from scipy.optimize import minimize_scalar

        greatest = minimize_scalar(lambda shift: -abs(self.wave(f + shift)) ** 2, bounds=(-half_range, half_range), method="bounded", options={"xatol": 1e-9 * f})
        return f + float(greatest.x)

    def errors(self, density: float, amplitude: float) -> tuple[float, float]:
        """Standard errors of amplitude and frequency beside noise of a density."""
        noise = math.sqrt(density / self.step)
        of_amplitude = noise * math.sqrt(np.sum(self.weight**2)) / np.sum(self.weight)
        weights = self.weight * self.x**2
        return float(of_amplitude), float(noise * math.sqrt(np.sum((self.weight * self.x) ** 2)) / (amplitude * np.sum(weights) * 2 * np.pi))


def _coherent_wave(z: Numbers, step: float, spectrum: _Spectrum) -> SurfaceWave | None:
    """The highest coherent wave; None where the F test finds none at 1 % over all frequencies."""
    n = len(z)
    waves, p_values = _coherence(spectrum.tapered, n)
    first, last = spectrum.at(1.5 * spectrum.half_bandwidth), spectrum.at(float(spectrum.frequency[-1]) - spectrum.half_bandwidth)
    least = LEAK * spectrum.density.max()
    candidates = []
    for j in range(first, last + 1):
        if spectrum.density[j] > least and p_values[j] < 1e-3:  # the grid may miss the wave's frequency by a quarter of 1/width
            about = _density_about(spectrum, float(spectrum.frequency[j]))
            if about is not None and spectrum.density[j] > 3 * about:
                candidates.append((-abs(waves[j]), j))
    demodulator = _Demodulator(z, step)
    for _, j in sorted(candidates)[:10]:
        f = demodulator.refined(float(spectrum.frequency[j]), 1.5 * spectrum.step)
        turned = z * np.exp(-2j * np.pi * f * step * np.arange(n))
        sums = np.array([np.sum(_taper(k, n) * turned) for k in range(1, spectrum.tapers + 1)])
        p_value = float(2 * spectrum.independent * _coherence(sums, n)[1])  # the grid looks twice at each independent frequency
        density = _density_about(spectrum, f)
        if p_value >= FALSE_ALARMS or density is None:
            continue
        wave = demodulator.wave(f)
        of_amplitude, of_frequency = demodulator.errors(density, abs(wave))
        phase = math.remainder(float(np.angle(wave)) - 2 * math.pi * f * 0.5 * step * (n - 1), 2 * math.pi)
        return SurfaceWave(_normal(1 / f, of_frequency / f**2, "m"), _normal(abs(wave), of_amplitude, "m"), p_value, True, phase)
    return None


def _peaks(spectrum: _Spectrum, background: _Background, longest: float) -> list[tuple[SurfaceWave, tuple[float, float]]]:
    """Waves that are not coherent, and their frequencies: they stand out from the background, and from their neighbours, at 1 % over all frequencies."""
    from scipy.special import chdtrc

    density, frequency, band = spectrum.density, spectrum.frequency, spectrum.half_bandwidth
    smooth = background(frequency)
    freedoms = 2 * spectrum.tapers
    least = LEAK * density.max()
    peaks = []
    for j in range(max(spectrum.at(1 / longest), 1), len(density) - 1):
        if not (density[j] > density[j - 1] and density[j] >= density[j + 1] and density[j] > least):
            continue
        about = _density_about(spectrum, float(frequency[j]))
        if about is None:
            continue
        p_value = float(spectrum.independent * chdtrc(freedoms, freedoms * density[j] / max(about, smooth[j])))
        if p_value >= FALSE_ALARMS:
            continue
        stands_out = density > 0.5 * (density[j] + smooth[j])
        first, last = j, j
        while first > 1 and stands_out[first - 1]:
            first -= 1
        while last + 1 < len(density) and stands_out[last + 1]:
            last += 1
        low, high = float(frequency[first]) - 0.5 * band, float(frequency[last]) + 0.5 * band
        inside = slice(spectrum.at(max(low, spectrum.step)), spectrum.at(high) + 1)
        f, more = frequency[inside], np.maximum(density[inside] - smooth[inside], 0) * spectrum.step
        power = float(np.sum(more))
        middle = float(np.sum(more * f)) / power
        wide = math.sqrt(max(float(np.sum(more * f**2)) / power - middle**2, 0.0))
        amplitude = math.sqrt(2 * power)
        error = math.sqrt(float(np.sum(density[inside] ** 2)) * spectrum.step / spectrum.width) / amplitude
        peaks.append((SurfaceWave(_normal(1 / middle, wide / middle**2, "m"), _normal(amplitude, error, "m"), p_value, False, NAN), (low, high)))
    peaks.sort(key=lambda peak: -peak[0].amplitude.value)
    apart: list[tuple[SurfaceWave, tuple[float, float]]] = []
    for peak in peaks:  # of peaks that overlap the highest
        if all(peak[1][1] <= other[1][0] or other[1][1] <= peak[1][0] for other in apart):
            apart.append(peak)
    return apart


# ---- Height and slope within a band of wavelengths


def _rms(rest: _Spectrum, background: _Background, coherent: Sequence[SurfaceWave], band: tuple[float, float], has_rest: bool, order: int,
         unit: str) -> Estimate:
    """Of the derivative of an order, without noise; of the coherent waves, and unless noise hides it of the rest, which they were taken off."""
    from scipy.special import chdtri

    f = rest.frequency[1:]
    inside = np.clip((np.minimum(f + 0.5 * rest.step, band[1]) - np.maximum(f - 0.5 * rest.step, band[0])) / rest.step, 0, 1)
    weight = (2 * np.pi * f) ** (2 * order) * inside * rest.step * has_rest
    square = float(np.sum(weight * (rest.density[1:] - background.noise)))
    of_noise = float(np.sum(weight)) * background.noise
    unbiased = 1 + 1 / rest.tapers  # of the square of a density
    variance = float(np.sum((weight * rest.density[1:]) ** 2)) * rest.inflation / (unbiased * rest.step * rest.width) + (background.noise_error * of_noise) ** 2
    for wave in coherent:
        at = 1 / wave.wavelength.value
        if band[0] <= at <= band[1]:
            part = 0.5 * (2 * math.pi * at) ** (2 * order) * wave.amplitude.value**2
            square += part
            variance += (2 * part * wave.amplitude.stderr / wave.amplitude.value) ** 2
    square = max(square, 0.0)
    freedoms = min(max(2 * square**2 / max(variance, 1e-300), 1.0), 1e7)
    value = math.sqrt(square)
    low, high = (value * math.sqrt(freedoms / float(chdtri(freedoms, beyond))) for beyond in (0.025, 0.975))
    return _estimate(value, value / math.sqrt(2 * freedoms), low, high, unit)


def _drowned_at(background: _Background, greatest: float, least: float) -> float:
    """The wavelength from which on the surface is greater than the noise; 0 without noise."""
    if background.noise == 0:
        return 0.0
    f = greatest
    while f > least and background.surface(f) < background.noise:
        f /= 1.01
    return 1 / max(f, least)


# ---- What could be seen


def _least_amplitude(density: float, width: float, heights: int) -> float:
    """Of a coherent wave that shows in 95 of 100 traces, where one of 20 traces without a wave would show one [m]."""
    one_in_twenty_missed = 1.6448536269514722 / math.sqrt(2)
    return math.sqrt(2 * density / width) * (math.sqrt(math.log(max(heights // 2, 1) / 0.05)) + one_in_twenty_missed)


def _length(name: str, value: object) -> float:
    length = float(_flexslip.length(name, quantity_in_words(name, value, "m", "a length"), name == "noise"))
    if not (SMALLEST <= length <= LARGEST or length == 0):
        raise wrong(name, f"a length from {SMALLEST} to {LARGEST} m", value, "check its unit")
    return length


def _heights(heights: npt.ArrayLike) -> Numbers:
    try:
        z = np.array(heights, dtype=np.float64)
    except (TypeError, ValueError):
        raise wrong("heights", "an array of numbers", heights) from None
    if z.ndim != 1 or len(z) < FEWEST_HEIGHTS:
        raise wrong("heights", f"{FEWEST_HEIGHTS} heights or more, one after the other", f"an array of the shape {z.shape}")
    if not np.isfinite(z).all():
        raise wrong("heights", "finite numbers", f"{z[~np.isfinite(z)][0]} at the index {int(np.flatnonzero(~np.isfinite(z))[0])}")
    if not SMALLEST <= np.abs(z).max() <= LARGEST:
        raise wrong("heights", f"heights from {SMALLEST} to {LARGEST} m", f"{np.abs(z).max()} m at most", "check their unit")
    return z


def _levelled(z: Numbers, degree: int) -> Numbers:
    powers = np.vander(np.linspace(-1, 1, len(z)), degree + 1)
    levelled: Numbers = z - powers @ np.linalg.lstsq(powers, z, rcond=None)[0]
    if math.sqrt(np.mean(levelled**2)) <= 1e-12 * np.abs(z).max():
        raise wrong("heights", "heights that differ once they are levelled", "a straight line, or one height", "check the heights, or level")
    return levelled


def _in_nanometres(length: float) -> str:
    return str(_flexslip.readable(length, "m"))


def surface(heights: npt.ArrayLike, step: Value, *, level: int = 1, wavelength: Value | Sequence[Value] | Numbers | None = None,
            amplitude: Value | None = None, pixel: Value | None = None, noise: Value | None = None, shortest: Value | None = None,
            longest: Value | None = None, tapers: int = 7) -> Surface:
    """What a height profile shows of a surface: height and slope, waves, and which waves it could show at all.

    Parameters
    ----------
    heights : array_like
        Heights at even distances along a line [m].
    step : str or float
        Distance between them [m].
    level : int
        Degree of the polynomial to subtract first: 0 a mean, 1 a tilt, 2 a bow; up to 9.
    wavelength : str, float, or sequence of them, optional
        Could the trace show waves of this length [m]? Without it, of those found; else of a tenth of the field.
    amplitude : str or float, optional
        Amplitude of the waves in question, half of the height from crest to trough [m].
    pixel : str or float, optional
        Smallest difference of heights that the instrument tells, such as a pixel of an image [m].
    noise : str or float, optional
        Standard deviation of the noise of a height [m]; found from the floor of the spectrum unless stated.
    shortest, longest : str or float, optional
        Wavelengths that height and slope include [m]. Unless stated: from five steps, or where noise equals the surface, to a quarter of the field.
    tapers : int
        Of the spectrum, 2 to 30: more make it smoother and coarser.

    Returns
    -------
    Surface
        Where noise hides the surface at all wavelengths, its `success` is False.

    Raises
    ------
    InputError
        For heights that are not numbers, too few or all alike, and for wavelengths that the trace does not have.

    Examples
    --------
    >>> import flexslip, numpy as np
    >>> x = 1e-7 * np.arange(2000)
    >>> heights = 1e-7 * np.cos(2 * np.pi * x / 1e-5) + np.random.RandomState(1).normal(0, 1e-8, len(x))
    >>> seen = flexslip.surface(heights, step="0.1 um", wavelength="5 um")
    >>> len(seen.waves), round(1e6 * seen.waves[0].wavelength.value, 2), seen.resolution[0].least_amplitude_by_spectrum < 2e-9
    (1, 10.0, True)
    """
    z = _heights(heights)
    distance = _length("step", step)
    tapers = whole("tapers", tapers, FEWEST_TAPERS, MOST_TAPERS)
    z = _levelled(z, whole("level", level, 0, MOST_DEGREE))
    several = wavelength if isinstance(wavelength, (list, tuple, np.ndarray)) and np.ndim(wavelength) else [] if wavelength is None else [wavelength]
    asked = [_length("wavelength", each) for each in several]
    return _seen(z, distance, tapers, asked, *(None if value is None else _length(name, value) for name, value in (
        ("amplitude", amplitude), ("pixel", pixel), ("noise", noise), ("shortest", shortest), ("longest", longest))))


def _require_band(step: float, field: float, shortest: float | None, longest: float | None) -> None:
    rounding = 1e-9
    if shortest is not None and not (1 - rounding) * 2 * step <= shortest < (longest or 0.25 * field):
        raise wrong("shortest", f"at least twice the step, {_in_nanometres(2 * step)}, and less than longest, {_in_nanometres(longest or 0.25 * field)}",
                    _in_nanometres(shortest))
    if longest is not None and not (shortest or 2 * step) < longest <= (1 + rounding) * field:
        raise wrong("longest", f"more than {_in_nanometres(shortest or 2 * step)} and at most the field, {_in_nanometres(field)}", _in_nanometres(longest))


def _seen(z: Numbers, step: float, tapers: int, asked: list[float], amplitude: float | None, pixel: float | None, noise: float | None,
          shortest: float | None, longest: float | None) -> Surface:
    from scipy.special import chdtri

    field = step * len(z)
    _require_band(step, field, shortest, longest)
    whole_spectrum = rest = _spectrum(z, step, tapers)
    coherent: list[SurfaceWave] = []
    left = z
    while len(coherent) < MOST_WAVES and (wave := _coherent_wave(left, step, rest)):
        coherent.append(wave)
        left = left - wave.amplitude.value * np.cos(2 * np.pi * step * np.arange(len(z)) / wave.wavelength.value + wave.phase)
        rest = _spectrum(left, step, tapers)

    density_of_noise = None if noise is None else 2 * noise**2 * step
    background = _background(rest, [], density_of_noise)
    peaks = _peaks(rest, background, field / 3)
    if peaks:
        background = _background(rest, [among for _, among in peaks], density_of_noise)
        peaks = _peaks(rest, background, field / 3)
    waves = sorted([*coherent, *(wave for wave, _ in peaks)], key=lambda wave: -wave.amplitude.value)

    last = longest or 0.25 * field
    usual = STEPS_OF_SHORTEST * step
    first = shortest or max(usual, _drowned_at(background, float(rest.frequency[-1]), 1 / last))
    has_rest = first < last
    if not has_rest:
        first = min(usual, 0.5 * last)  # coherent waves alone tell
    seen = has_rest or bool(coherent)
    band = (1 / last, 1 / first)
    found_noise = math.sqrt(background.noise / (2 * step))
    nothing = _estimate(NAN, NAN, NAN, NAN, "m"), _estimate(NAN, NAN, NAN, NAN, "1")
    height, slope = (_rms(rest, background, coherent, band, has_rest, order, unit) for order, unit in enumerate(("m", "1"))) if seen else nothing
    message = "" if seen else (f"noise of {_in_nanometres(found_noise)} per height hides the surface at all wavelengths from "
                               f"{_in_nanometres(2 * step)} to {_in_nanometres(last)}")

    resolution = []
    for length in asked or [wave.wavelength.value for wave in waves] or [field / PERIODS_WANTED]:
        found = next((wave.amplitude.value for wave in waves if wave.wavelength.value == length), NAN)
        resolution.append(WaveResolution(length, length / step, field / length, NAN if pixel is None else 0.5 * PIXELS_WANTED * pixel,
                                         _least_amplitude(float(background(1 / length)), field, len(z)),
                                         2 * (found if amplitude is None else amplitude) / PIXELS_WANTED))
    freedoms = 2 * tapers
    factors = freedoms / float(chdtri(freedoms, 0.025)), freedoms / float(chdtri(freedoms, 0.975))
    frequency = whole_spectrum.frequency[1:]
    return Surface(seen, message, height, slope, first, last, found_noise, background.noise_found, tuple(waves), tuple(resolution), frequency,
                   whole_spectrum.density[1:], np.asarray(background(frequency)), factors)
