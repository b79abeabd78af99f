#!/usr/bin/python3
"""outside: surfaces, from a trace to its friction and back."""
import csv
import json
import math
import unittest

from program import SOURCE, InFolder, numbers, run, table

EXAMPLE = SOURCE / "examples/surface"
TRACE = EXAMPLE / "trace.csv"
CASE = """[specimen]
bending_stiffness = "2.1e-12 N m^2"
[rig]
span = "1278 um"
stiffness = "{stiffness}"
[friction]
model = "surface"
mu0 = 0.5
trace = "wave.csv"
{more}[stage]
program = ["0 um", "400 um"{back}]
step = "2 um"
"""


def wave(height, wavelength, step=0.1, count=2000, noise=0):
    """A trace of a cosine, in µm."""
    return "x [um],z [um]\n" + "".join(f"{step * i:.3f},{height * math.cos(2 * math.pi * step * i / wavelength):.9f}\n" for i in range(count))


class Surface(InFolder):
    def case(self, more="", back="", stiffness="5 kN/m"):
        return self.file("case.toml", CASE.format(more=more, back=back, stiffness=stiffness))

    def test_the_example_tells_what_it_was_made_with(self):
        """tools/make-surface: a wave of 0.11 µm every 10.9 µm, roughness 0.02 µm over 2 µm, noise 2 nm."""
        told = self.json("surface", TRACE)
        highest = told["waves"][0]
        self.assertTrue(highest["coherent"])
        for name, truth in (("wavelength", 10.9e-6), ("amplitude", 0.11e-6)):
            self.assertLess(abs(highest[name]["value"] - truth), 3 * highest[name]["standard_error"])
        self.assertEqual(told["noise_is"], "found")
        self.assertAlmostEqual(told["noise"], 2e-9, delta=0.1e-9)
        slope = math.hypot(2 * math.pi * 0.11 / 10.9 / math.sqrt(2), 0.02 * math.sqrt(2) / 2)
        low, high = told["rms_slope"]["interval95"]
        self.assertTrue(low < slope < high, (low, slope, high))

    def test_the_papers_images_do_not_resolve_the_wave_that_its_friction_wants(self):
        """Closing remark 2, section 5: 0.29 µm a pixel in a field of 450 µm; 0.11 µm high every 10.9 µm."""
        pixels = "x [um],z [um]\n" + "".join(f"{0.29 * i:.2f},{0.29 * round((0.11 * math.cos(2 * math.pi * 0.29 * i / 10.9) + 0.013 * i) / 0.29):.2f}\n" for i in range(1552))
        told = self.json("surface", self.file("edge.csv", pixels), "--wavelength", "10.9 um", "--amplitude", "0.11 um")
        self.assertAlmostEqual(told["pixel"], 0.29e-6, delta=1e-12)
        seen = told["resolution"][0]
        self.assertAlmostEqual(seen["least_amplitude_by_pixels"], 1.45e-6, delta=1e-11)
        self.assertAlmostEqual(seen["pixel_wanted"], 0.022e-6, delta=1e-12)

    def test_a_wave_of_height_is_a_wave_of_friction(self):
        """tan(atan μ + α) at the middles of a fine trace."""
        self.file("wave.csv", wave(0.11, 10.9))
        curve = table(self.succeeds("equilibrium", self.case(), "--longest", "1600 um", "--points", "400"))
        for S, mu in zip(map(float, curve["S [m]"]), map(float, curve["mu"])):
            x = 1e6 * S / 2 - 639
            if not 0.2 < x < 199:
                continue
            slope = -2 * math.pi * 0.11 / 10.9 * math.sin(2 * math.pi * x / 10.9)
            self.assertAlmostEqual(mu, math.tan(math.atan(0.5) + math.atan(slope)), delta=3e-4)  # slopes over 0.1 µm, and monotone pieces

    def test_a_surface_shows_the_other_friction_on_the_way_out(self):
        self.file("wave.csv", wave(0.11, 40, count=1500))
        path = self.json("simulate", self.case(back=', "100 um"'), "--quiet")["path"]
        out = [point for point in path if point["motion"] == "slip_out"]
        self.assertGreater(len(out), 20)
        for point in out:
            x = 1e6 * point["length"] / 2 - 639
            if not 0.2 < x < 149:
                continue
            slope = -2 * math.pi * 0.11 / 40 * math.sin(2 * math.pi * x / 40)
            self.assertAlmostEqual(point["q"], -math.tan(math.atan(0.5) - math.atan(slope)), delta=3e-4)

    def test_a_table_of_its_friction_is_the_same_test(self):
        """`surface --profile` as [friction] model = "table"."""
        trace = self.file("wave.csv", wave(0.11, 10.9))
        profile = table(self.succeeds("surface", trace, "--friction", "0.5", "--quiet", "--profile", "-", "--output", "/dev/null"))
        step = 0.1e-6
        rows = [(2 * (639e-6 + float(s) + 0.5 * step), mu) for s, mu in zip(profile["position [m]"], profile["mu"]) if mu != "nan"]
        ends = [(2 * (639e-6 - 0.5 * step), "0.5"), *rows, (rows[-1][0] + 2 * step, "0.5")]
        self.file("friction.csv", "S [m],mu\n" + "".join(f"{S!r},{mu}\n" for S, mu in ends))
        by_surface = numbers(self.succeeds("simulate", self.case(), "--quiet"), "F [N]")
        text = (self.folder / "case.toml").read_text()
        start, end = text.index("model ="), text.index("[stage]")
        self.file("table.toml", text[:start] + 'model = "table"\nfile = "friction.csv"\nlength = "S [m]"\nmu = "mu"\n' + text[end:])
        by_table = numbers(self.succeeds("simulate", self.folder / "table.toml", "--quiet"), "F [N]")
        for one, other in zip(by_surface, by_table):
            self.assertAlmostEqual(one, other, delta=1e-9 * max(by_table))

    def test_from_a_surface_to_its_friction_and_back(self):
        """The shipped example: the wave of the surface is found in the fit, and its place along the trace."""
        fit = self.json("fit", EXAMPLE / "case.toml", "--surface", TRACE)
        told = fit["surface"]
        height = told["wave_height"]
        self.assertLess(abs(height["value"] - 0.106e-6), 3 * height["standard_error"])  # as `surface` finds it in this piece
        self.assertAlmostEqual(fit["wave"]["wavelength"]["value"], 10.9e-6, delta=0.2e-6)
        self.assertAlmostEqual(told["pixel_wanted"], height["value"] / 5, delta=1e-15)
        held = told["against_trace"]
        self.assertEqual(held["p_value"], 0.001)
        self.assertGreater(held["correlation"], 0.8)
        self.assertAlmostEqual(held["begin"], 0, delta=1e-6)
        self.assertFalse(held["turned"])

    def test_what_has_nothing_to_do_with_a_trace_fits_nowhere(self):
        other = wave(0.11, 3.7)
        held = self.json("fit", EXAMPLE / "case.toml", "--surface", self.file("other.csv", other))["surface"]["against_trace"]
        self.assertGreater(held["p_value"], 0.05)

    def test_two_waves_of_one_length_have_no_place(self):
        """The other example has a wave of the same length, and was not made with this trace."""
        held = self.json("fit", SOURCE / "examples/simulated/case.toml", "--surface", TRACE)["surface"]["against_trace"]
        self.assertGreater(held["correlation"], 0.9)
        self.assertGreater(held["p_value"], 0.05)

    def test_bad_input_is_refused_with_place_and_remedy(self):
        self.file("wave.csv", wave(0.11, 10.9))
        self.refused("surface", self.folder / "wave.csv", "--shortest", "0.1 um", says=["--shortest", "twice the distance between heights, 200 nm"])
        self.refused("surface", self.folder / "wave.csv", "--longest", "1 mm", says=["--longest", "at most the field of 200 µm"])
        self.refused("surface", self.folder / "wave.csv", "--cutoff", "3 N", says=["--cutoff"])
        self.refused("surface", self.folder / "wave.csv", "--friction", "0.01", says=["wave.csv", "slides by itself", "at the position"])
        self.refused("surface", self.folder / "wave.csv", "--position", "y", says=["--position", "'x' and 'z'"])
        self.refused("surface", self.folder / "none.csv", says=["none.csv"])
        flat = self.file("flat.csv", "x [um],z [um]\n" + "".join(f"{i},{2 * i}\n" for i in range(100)))
        self.refused("surface", flat, says=["flat.csv", "heights that differ once the trace is levelled"])
        self.refused("simulate", self.case(more='level = 12\n'), says=["[friction] level", "at most 9"])
        self.refused("simulate", self.case(more='height = "q"\n'), says=["wave.csv", "'x' and 'z'"])
        self.refused("simulate", self.case(more='direction = "up"\n'), says=["direction", "outwards"])
        self.refused("simulate", self.case(more='trace_begin = "1 um"\n'), says=["trace_begin", "beyond the support"])
        self.refused("simulate", self.case(more='file = "wave.csv"\n'), says=["file", "no meaning here"])
        self.refused("simulate", self.case(more='edge_radius = "-1 um"\n'), says=["edge_radius"])
        self.refused("fit", EXAMPLE / "case.toml", "--model", "constant", "--surface", TRACE, says=["friction varies"])
        self.refused("fit", self.case(), "--quiet", says=["[record]"])

    def test_noise_alone_is_no_surface(self):
        """Standard error says so, and the exit code is 1."""
        state, rows = 1, []
        for i in range(500):
            state = (1103515245 * state + 12345) % 2**31
            rows.append(f"{i},{state / 2**31}\n")
        noise = self.file("noise.csv", "x [um],z [um]\n" + "".join(rows))
        result = run("surface", noise, "--json")
        self.assertEqual(result.returncode, 1)
        self.assertIn("hides the surface", result.stderr)
        self.assertEqual(json.loads(result.stdout)["status"], "noise")

    def test_an_edge_that_rolls_is_less_steep(self):
        rough = EXAMPLE / "trace.csv"
        slopes = [self.json("surface", rough, "--edge-radius", f"{radius} um")["rms_slope_of_edge"] for radius in (0.5, 2, 10)]
        self.assertEqual(slopes, sorted(slopes, reverse=True))

    def test_tables_have_what_is_written_of_them(self):
        profile, spectrum = self.folder / "p.csv", self.folder / "s.csv"
        self.succeeds("surface", TRACE, "--profile", profile, "--spectrum", spectrum, "--quiet", "-o", "/dev/null")
        with open(profile, encoding="utf-8") as file:
            self.assertEqual(next(csv.reader(file)), ["position [m]", "height [m]", "envelope [m]", "edge [m]", "slope", "mu"])
        power = table(spectrum.read_text())
        step = float(power["frequency [1/m]"][1]) - float(power["frequency [1/m]"][0])
        rms = math.sqrt(sum(map(float, power["density"])) * step)
        self.assertAlmostEqual(rms, self.json("surface", TRACE)["rms_height_of_trace"], delta=0.03 * rms)  # tapers weigh the ends less


if __name__ == "__main__":
    unittest.main()
