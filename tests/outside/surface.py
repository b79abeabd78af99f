#!/usr/bin/python3
"""outside: the friction of a height profile that a support climbs."""
import math
import unittest

import numpy as np

from program import SOURCE, InFolder, numbers, table

EXAMPLE = SOURCE / "examples/surface"
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
        """The trace levelled and climbed here, as [friction] model = "table"."""
        self.file("wave.csv", wave(0.11, 10.9))
        step, z = 0.1e-6, 1e-6 * np.round(0.11 * np.cos(2 * np.pi * 0.1 * np.arange(2000) / 10.9), 9)
        x = np.arange(len(z))
        slope = np.diff(z - np.polyval(np.polyfit(x, z, 1), x)) / step
        rows = [(2 * (639e-6 + step * (i + 0.5)), repr(float((0.5 + each) / (1 - 0.5 * each)))) for i, each in enumerate(slope)]
        ends = [(2 * (639e-6 - 0.5 * step), "0.5"), *rows, (rows[-1][0] + 2 * step, "0.5")]
        self.file("friction.csv", "S [m],mu\n" + "".join(f"{S!r},{mu}\n" for S, mu in ends))
        by_surface = numbers(self.succeeds("simulate", self.case(), "--quiet"), "F [N]")
        text = (self.folder / "case.toml").read_text()
        start, end = text.index("model ="), text.index("[stage]")
        self.file("table.toml", text[:start] + 'model = "table"\nfile = "friction.csv"\nlength = "S [m]"\nmu = "mu"\n' + text[end:])
        by_table = numbers(self.succeeds("simulate", self.folder / "table.toml", "--quiet"), "F [N]")
        for one, other in zip(by_surface, by_table):
            self.assertAlmostEqual(one, other, delta=1e-9 * max(by_table))

    def test_the_wave_of_a_surface_is_found_in_its_friction(self):
        """The shipped example: by h = A μ λ/(2π (1 + μ²)) its wave of friction is one of height as high as that of the trace (tools/make-surface)."""
        fit = self.json("fit", EXAMPLE / "case.toml")
        A, length, mu0 = fit["parameters"]["amplitude"], fit["parameters"]["wavelength"], fit["parameters"]["mu0"]["value"]
        self.assertAlmostEqual(length["value"], 10.9e-6, delta=0.2e-6)
        height = mu0 * length["value"] / (2 * math.pi * (1 + mu0**2))
        self.assertLess(abs(A["value"] * height - 0.11e-6), 3 * A["standard_error"] * height)

    def test_short_waves_are_left_out_by_a_filter_and_by_an_edge(self):
        """Roughness of 4 µm below a wave of 40 µm: a filter of 12 µm leaves it 1e-3 of its slopes, an edge of 200 µm rolls over its crests."""
        rough = [0.3 * math.cos(2 * math.pi * 0.1 * i / 40) + 0.05 * math.cos(2 * math.pi * 0.1 * i / 4) for i in range(2000)]
        self.file("wave.csv", "x [um],z [um]\n" + "".join(f"{0.1 * i:.3f},{z:.9f}\n" for i, z in enumerate(rough)))
        spread = {}
        for name, more in ("plain", ""), ("filtered", 'cutoff = "12 um"\n'), ("rolled", 'edge_radius = "200 um"\n'):
            curve = table(self.succeeds("equilibrium", self.case(more=more), "--longest", "1600 um", "--points", "600"))
            inside = [float(mu) for S, mu in zip(curve["S [m]"], curve["mu"]) if 10 < 1e6 * float(S) / 2 - 639 < 150]
            spread[name] = max(inside) - min(inside)
        long_wave = 2 * 0.3 * 2 * math.pi / 40 * 1.25  # crest to trough, to first order
        self.assertGreater(spread["plain"], 2 * long_wave)
        self.assertAlmostEqual(spread["filtered"], long_wave, delta=0.1 * long_wave)
        self.assertLess(spread["rolled"], 0.8 * spread["plain"])

    def test_bad_input_is_refused_with_place_and_remedy(self):
        self.file("wave.csv", wave(0.11, 10.9))
        self.refused("simulate", self.file("steep.toml", CASE.format(more="", back="", stiffness="5 kN/m").replace("mu0 = 0.5", "mu0 = 0.01")),
                     says=["wave.csv", "would slide unaided", "at the position"])
        self.refused("simulate", self.case(more='level = 12\n'), says=["[friction] level", "above the limit of 9"])
        self.refused("simulate", self.case(more='height = "q"\n'), says=["wave.csv", "'x' and 'z'"])
        self.refused("simulate", self.case(more='direction = "up"\n'), says=["direction", "outwards"])
        self.refused("simulate", self.case(more='trace_begin = "1 um"\n'), says=["trace_begin", "before the support"])
        self.refused("simulate", self.case(more='file = "wave.csv"\n'), says=["file", "no meaning here"])
        self.refused("simulate", self.case(more='edge_radius = "-1 um"\n'), says=["edge_radius"])
        self.refused("simulate", self.case(more="wear = 0.9\n", back=', "100 um"'), says=["[friction] wear", "let the stage only load"])
        self.refused("surface", EXAMPLE / "trace.csv", says=["surface"])


if __name__ == "__main__":
    unittest.main()
