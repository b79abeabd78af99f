#!/usr/bin/python3
"""outside: a height profile shows what FlexSlip 0.2 showed of it in C++ (surface_answers.json), and what it was made with."""
import functools
import json
import math
import pathlib
import pickle
import unittest

import flexslip
import numpy as np
from surface_traces import LOOKS, STEP, traces

ANSWERS = json.loads((pathlib.Path(__file__).resolve().parent / "surface_answers.json").read_text(encoding="utf-8"))
TRACES = traces()


@functools.cache
def seen(name):
    trace, options = LOOKS[name]
    return flexslip.surface(TRACES[trace], STEP, **options)


class SameNumbers(unittest.TestCase):
    """That program stopped an optimisation 1e-4 below the greatest ln likelihood, which is 0.02 of the errors of what was optimised."""

    def near(self, found, expected):
        """Within 0.002 of the standard error, and the error within 1e-4 of itself."""
        value, error, low, high = expected
        self.assertAlmostEqual(found.value, value, delta=2e-3 * error)
        self.assertAlmostEqual(found.stderr, error, delta=1e-4 * error)
        self.assertAlmostEqual(found.ci95[0], low, delta=2e-3 * error)
        self.assertAlmostEqual(found.ci95[1], high, delta=2e-3 * error)

    def test_oracle_every_number_of_every_trace(self):
        for name in LOOKS:
            with self.subTest(name):
                told, found = ANSWERS[name], seen(name)
                self.assertEqual(found.success, told["status"] == "ok")
                self.assertEqual(found.noise_found, told["noise_is"] == "found")
                self.assertAlmostEqual(found.noise, told["noise"], delta=1e-4 * told["noise"] + 2e-12)  # on a surface without noise its square is 1e-8 of a height's
                self.assertAlmostEqual(found.shortest, told["shortest"], delta=0.021 * told["shortest"])  # found in steps of 1 %
                self.assertAlmostEqual(found.longest, told["longest"], delta=1e-9 * told["longest"])
                for each in "rms_height", "rms_slope":
                    if told[each] is None:
                        self.assertTrue(math.isnan(getattr(found, each).value))
                    else:
                        self.near(getattr(found, each), told[each])
                self.assertEqual(len(found.waves), len(told["waves"]))
                for wave, expected in zip(found.waves, told["waves"]):
                    self.near(wave.wavelength, expected["wavelength"])
                    self.near(wave.amplitude, expected["amplitude"])
                    self.assertEqual(wave.coherent, expected["coherent"])
                    self.assertAlmostEqual(math.log(wave.p_value), math.log(expected["p_value"]), delta=5e-3 * abs(math.log(expected["p_value"])))
                    if wave.coherent:
                        self.assertAlmostEqual(wave.phase, expected["phase"], delta=1e-5)

    def test_oracle_the_spectrum_and_its_smooth_part(self):
        for name in LOOKS:
            with self.subTest(name):
                found = seen(name)
                greatest = max(density for _, density, _ in ANSWERS[name]["spectrum"])
                for frequency, density, background in ANSWERS[name]["spectrum"]:
                    j = int(round(frequency / found.frequency[0])) - 1
                    self.assertAlmostEqual(found.density[j], density, delta=1e-9 * density)
                    if density > 1e-5 * greatest:  # above what tapers leak; a likelihood is flat to half of the error of a single density, 1/√7
                        self.assertAlmostEqual(math.log(found.background[j] / background), 0, delta=0.18)

    def test_oracle_whether_a_wave_could_be_shown(self):
        for name in LOOKS:
            with self.subTest(name):
                found = seen(name).resolution
                self.assertEqual(len(found), len(ANSWERS[name]["resolution"]))
                for wave, expected in zip(found, ANSWERS[name]["resolution"]):
                    for each in "heights_a_wave", "waves_in_field", "pixel_wanted", "least_amplitude_by_pixels":
                        if expected[each] is None:
                            self.assertTrue(math.isnan(getattr(wave, each)))
                        else:
                            self.assertAlmostEqual(getattr(wave, each), expected[each], delta=1e-4 * expected[each])
                    least = expected["least_amplitude_by_spectrum"]
                    self.assertAlmostEqual(wave.least_amplitude_by_spectrum, least, delta=0.1 * least)  # the root of the smooth part


class Truth(unittest.TestCase):
    def test_outside_the_example_shows_what_it_was_made_with(self):
        """tools/make-surface: a wave of 0.11 µm every 10.9 µm, roughness 0.02 µm over 2 µm, noise 2 nm."""
        found = flexslip.surface(TRACES["example"], "0.1 um")
        highest = found.waves[0]
        self.assertTrue(highest.coherent)
        for estimate, truth in ((highest.wavelength, 10.9e-6), (highest.amplitude, 0.11e-6)):
            self.assertLess(abs(estimate.value - truth), 3 * estimate.stderr)
        self.assertAlmostEqual(found.noise, 2e-9, delta=0.1e-9)
        slope = math.hypot(2 * math.pi * 0.11 / 10.9 / math.sqrt(2), 0.02 * math.sqrt(2) / 2)
        self.assertTrue(found.rms_slope.ci95[0] < slope < found.rms_slope.ci95[1])

    def test_paper_its_images_do_not_resolve_the_wave_that_its_friction_wants(self):
        """Closing remark 2, section 5: 0.29 µm a pixel in a field of 450 µm; 0.11 µm high every 10.9 µm."""
        x = 0.29 * np.arange(1552)
        heights = 0.29 * np.round((0.11 * np.cos(2 * np.pi * x / 10.9) + 0.05 * x) / 0.29)
        (image,) = flexslip.surface(1e-6 * heights, "0.29 um", wavelength="10.9 um", amplitude="0.11 um", pixel="0.29 um").resolution
        self.assertAlmostEqual(image.least_amplitude_by_pixels, 1.45e-6, delta=1e-12)
        self.assertAlmostEqual(image.pixel_wanted, 0.022e-6, delta=1e-14)

    def test_limit_noise_alone_is_no_surface(self):
        found = seen("noise")
        self.assertFalse(found.success)
        self.assertIn("hides the surface", found.message)
        self.assertIn("hides the surface", repr(found))

    def test_identity_the_density_holds_the_mean_square_and_waves_scale(self):
        found, larger = seen("example"), flexslip.surface(3 * TRACES["example"], 2 * STEP)
        power = np.sum(found.density) * found.frequency[0]
        levelled = np.polyfit(np.arange(len(TRACES["example"])), TRACES["example"], 1, full=True)[1][0] / len(TRACES["example"])
        self.assertAlmostEqual(power, levelled, delta=0.06 * levelled)  # tapers weigh the ends less
        self.assertAlmostEqual(larger.waves[0].wavelength.value, 2 * found.waves[0].wavelength.value, delta=1e-11)
        self.assertAlmostEqual(larger.rms_slope.value, 1.5 * found.rms_slope.value, delta=1e-5)

    def test_identity_it_pickles_and_shows_itself(self):
        found = seen("example")
        again = pickle.loads(pickle.dumps(found))
        self.assertEqual(repr(again), repr(found))
        self.assertIn("wavelength 10.9003 ± 0.0086 µm", repr(found))


if __name__ == "__main__":
    unittest.main()
