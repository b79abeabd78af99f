#!/usr/bin/python3
"""outside: load-unload-reload tests in `flexslip fit`, against simulated truth and the authors' tests."""
import csv
import unittest

from program import SOURCE, InFolder, table

STIFFNESS = 2.1e-9  # N m^2
SPAN = 1278e-6  # m
MU0 = 0.35
UP_AND_DOWN = '["0 um", "500 um", "0 um"]'
TWO_LOOPS = '["0 um", "500 um", "100 um", "500 um", "0 um"]'
SIMULATED = """
[specimen]
bending_stiffness = "{stiffness} N m^2"
[rig]
span = "1278 um"
stiffness = "90.65 N/m"
[friction]
model = "sinusoid"
mu0 = 0.35
amplitude = 0.1
wavelength = "25 um"
phase = 1.0
[stage]
program = {program}
step = "1.5 um"
"""
FITTED = """
[specimen]
bending_stiffness = "fit"
[rig]
span = "1278 um"
stiffness = "{rig}"
[record]
file = "{file}"
{first} = "{first_title}"
force = "{force_title}"
"""
CYCLES = {"status", "bending_stiffness", "correlation", "loops", "loading_stiffness"}
LOOP = {"loading", "unloading", "mu_in", "mu_out", "energy", "replay_rms"}
LOADING = {"status", "ratio", "ratio_systematic", "verdict"}


class CyclicRecords(InFolder):
    def readings(self, program=TWO_LOOPS, stiffness=STIFFNESS, seed=1):
        """[(stage, force)] of a simulated test, its force read to 5 uN."""
        case = self.file("simulated.toml", SIMULATED.format(program=program, stiffness=stiffness))
        columns = table(self.succeeds("simulate", case, "--noise", "5 uN", "--seed", seed, "--quiet"))
        return [(float(stage), float(force)) for stage, force in zip(columns["w_s [m]"], columns["F [N]"])]

    def record(self, readings, titles=("stage [m]", "force [N]"), rig="90.65 N/m", head=""):
        rows = [",".join(titles), *(f"{a!r},{b!r}" for a, b in readings)]
        self.file("record.csv", "\n".join(rows) + "\n")
        first = "deflection" if titles[0].startswith("w") else "stage"
        return self.file("case.toml", head + FITTED.format(rig=rig, file="record.csv", first=first, first_title=titles[0],
                                                           force_title=titles[1]))


class Simulated(CyclicRecords):
    def test_truth_of_bending_stiffness_and_friction(self):
        """Fixed draws, so this cannot flicker."""
        for seed in range(1, 6):
            cycles = self.json("fit", self.record(self.readings(seed=seed)))["cycles"]
            self.assertEqual(cycles["status"], "ok")
            low, high = cycles["bending_stiffness"]["interval95"]
            # Beside what the interval knows, cycles.h allows 1e-4 without noise.
            self.assertLess(low * (1 - 1e-4), STIFFNESS)
            self.assertGreater(high * (1 + 1e-4), STIFFNESS)
            for loop in cycles["loops"]:
                for mu in (loop["mu_in"], loop["mu_out"]):
                    # A wave of at least two periods, not a whole number of them, shifts the mean by at most A/(2 π).
                    self.assertAlmostEqual(mu["value"], MU0, delta=0.1 * MU0 / 6 + 3 * mu["standard_error"])
                self.assertLess(loop["replay_rms"], 0.01)  # noise is 5 uN of some 12 mN

    def test_truth_of_the_bumps(self):
        cycles = self.json("fit", self.record(self.readings()))["cycles"]
        self.assertGreater(cycles["correlation"]["low"], 0.9)  # the wave is the same both ways
        self.assertLessEqual(cycles["correlation"]["high"], 1)

    def test_schema(self):
        readings = self.readings()
        fit = self.json("fit", self.record(readings))
        cycles = fit["cycles"]
        self.assertEqual(set(cycles), CYCLES)
        self.assertEqual(len(cycles["loops"]), 2)
        for loop in cycles["loops"]:
            self.assertEqual(set(loop), LOOP)
            self.assertEqual(set(loop["energy"]), {"loading", "unloading", "lost", "friction"})
        for loading in cycles["loading_stiffness"]:
            self.assertEqual(set(loading), LOADING)
        self.assertEqual(fit["nominal_bending_stiffness"]["source"], "mirror_symmetry")

    def test_identity_rows_are_those_of_the_file(self):
        readings = self.readings()
        loops = self.json("fit", self.record(readings))["cycles"]["loops"]
        farthest = max(stage for stage, _ in readings)
        for loop in loops:
            self.assertEqual(loop["unloading"][0], loop["loading"][1] + 1)
            self.assertEqual(readings[loop["loading"][1] - 1][0], farthest)
        self.assertEqual((loops[0]["loading"][0], loops[-1]["unloading"][1]), (1, len(readings)))

    def test_identity_reduced_record_says_the_same(self):
        readings = self.readings()
        fit = self.json("fit", self.record(readings))["cycles"]
        unit = STIFFNESS / SPAN**2
        scaled = [(stage / SPAN, force / unit) for stage, force in readings]
        case = self.record(scaled, titles=("s", "F"))
        text = case.read_text(encoding="utf-8").replace('span = "1278 um"\n', "")
        case.write_text("reduced = true\n" + text.replace('"90.65 N/m"', repr(90.65 * SPAN**3 / STIFFNESS)), encoding="utf-8")
        reduced = self.json("fit", case)["cycles"]
        close = 1e-6  # the iteration ends where a step is smaller than that
        value = reduced["bending_stiffness"]["value"]
        self.assertAlmostEqual(value, fit["bending_stiffness"]["value"] / STIFFNESS, delta=close)
        for a, b in zip(reduced["loops"], fit["loops"]):
            self.assertAlmostEqual(a["mu_in"]["value"], b["mu_in"]["value"], delta=close)
            self.assertAlmostEqual(a["energy"]["lost"], b["energy"]["lost"] / (unit * SPAN), delta=close)

    def test_truth_damage_is_told_from_friction(self):
        first = self.readings(UP_AND_DOWN)
        for stiffness, verdict in ((STIFFNESS, "not_damaged"), (0.7 * STIFFNESS, "damaged")):
            again = self.readings(UP_AND_DOWN, stiffness, seed=2)[1:]
            loadings = self.json("fit", self.record(first + again))["cycles"]["loading_stiffness"]
            self.assertEqual([loading["verdict"] for loading in loadings], [None, verdict])
            error = (loadings[1]["ratio"]["standard_error"] ** 2 + loadings[1]["ratio_systematic"] ** 2) ** 0.5
            self.assertAlmostEqual(loadings[1]["ratio"]["value"], stiffness / STIFFNESS, delta=3 * error)  # three standard errors

    def test_a_record_that_begins_by_unloading_is_evaluated_from_its_loading_on(self):
        turned = self.readings(UP_AND_DOWN)
        peak = max(range(len(turned)), key=lambda i: turned[i][0])
        fit = self.json("fit", self.record(turned[peak:] + turned[1:peak]))
        self.assertEqual(fit["measurement"]["first_row"], len(turned) - peak + 1)
        self.refused("fit", self.record(turned[peak:]), says=["record.csv", "unloads", "a record that has a loading"])

    def test_text_and_report(self):
        case = self.record(self.readings())
        text = self.succeeds("fit", case, "--full", "--report", self.folder / "report")
        for words in ("2 loadings: friction", "\nLoad and unload\n", "\nWhere the work of this loading went\n"):
            self.assertIn(words, text)
        page = (self.folder / "report/report.html").read_text(encoding="utf-8")
        self.assertIn("<h2>Load and unload</h2>", page)
        for figure in ("loops", "boxes"):
            self.assertTrue((self.folder / f"report/figures/{figure}.gp").exists())


class OneLoading(InFolder):
    def test_has_no_cycles(self):
        self.assertIsNone(self.json("fit", SOURCE / "examples/simulated/case.toml")["cycles"])


class Measured(CyclicRecords):
    def test_authors_test_12(self):
        folder = SOURCE / "../shared/data/spicules/cyclic"
        if not folder.is_dir():
            self.skipTest("skipped: no campaign data")
        readings = []
        for cycle in range(1, 4):
            with open(folder / f"LU_test12_cycle{cycle}.csv", encoding="utf-8") as file:
                rows = [tuple(map(float, row)) for row in list(csv.reader(file))[1:]]
            readings += rows[1:] if readings else rows  # a cycle begins with the last row of the one before
        fit = self.json("fit", self.record(readings, titles=("w0_m [m]", "F_N [N]"), rig="119.0364 N/m"))
        self.assertEqual((fit["status"], fit["cycles"]["status"], len(fit["cycles"]["loops"])), ("ok", "ok", 3))


if __name__ == "__main__":
    unittest.main()
