#!/usr/bin/python3
"""outside: flexslip design against flexslip simulate, the paper's Fig. 8 and what a user may get wrong."""
import re
import sys
import unittest

from program import PROGRAM, SOURCE, InFolder, run

sys.path.insert(0, str(SOURCE / "bench" / "causes"))
import decide  # noqa: E402

CASE = """[specimen]
diameter = "34.8 um"
modulus = "29.6 GPa"
[rig]
span = "1278 um"
stiffness = "90.65 N/m"
[friction]
model = "sinusoid"
mu0 = 0.5
amplitude = 0.15
wavelength = "40 um"
phase = 1.0
[stage]
program = ["0 um", "700 um"]
step = "2 um"
"""
FIG_8 = SOURCE / "docs" / "figures" / "paper-fig8.toml"


class Design(InFolder):
    def test_all_that_is_missing_is_asked_for_at_once(self):
        case = self.file("case.toml", '[specimen]\ndiameter = "0.5 mm"\n')
        result = run("design", case)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 8, result.stderr)
        for key, words in ("[specimen] modulus", "GPa"), ("[rig] span", '"8 mm"'), ("[rig] stiffness", "N/m"), ("[stage] program", '"5 mm"'), \
                ("[friction] wavelength", 'from "5 um" to "50 um"'):
            self.assertTrue(any(key in line and words in line for line in lines), (key, lines))

    def test_friction_that_is_not_stated_is_a_range(self):
        stated = re.sub(r"\[friction\].*?(?=\[stage\])", "", CASE, flags=re.DOTALL).replace("[rig]\n", 'material = "glass"\n[rig]\nsupport_material = "steel"\n')
        case = self.file("case.toml", stated)
        found = self.json("design", case)["open"]
        self.assertEqual([each["parameter"] for each in found["ranges"]], ["mu0", "amplitude", "wavelength"])
        self.assertEqual((found["ranges"][0]["from"], found["ranges"][0]["to"]), (0.5, 0.721))
        self.assertLessEqual(found["snapping"], found["designs"])
        text = self.succeeds("design", case, "--figure", self.folder / "design.svg")
        self.assertIn("the ranges below", " ".join(text.split()))
        self.assertGreater(len((self.folder / "design-unknown.csv").read_text().splitlines()), 100)
        self.assertIsNone(self.json("design", self.file("stated.toml", CASE))["open"])

    def test_oracle_simulate(self):
        # 1e-5 of the work is what the header of bending_test/design.h promises
        case = self.file("case.toml", CASE)
        answer = self.json("design", case)
        simulated = self.json("simulate", case)
        energy = simulated["energy"]
        self.assertEqual(answer["snaps"], len(self.json("simulate", self.file("c.toml", CASE.replace('step = "2 um"', "")))["snaps"]))
        self.assertAlmostEqual(answer["first_snap_stage"], simulated["snaps"][0]["stage"], delta=1e-15)
        self.assertAlmostEqual(answer["work"], energy["work_of_fracture"], delta=1e-7 * answer["work"])
        self.assertAlmostEqual(answer["friction_heat"], energy["friction"], delta=1e-5 * answer["work"])
        forces = [row["force"] for row in simulated["path"]]
        falls = [b < a for a, b in zip(forces, forces[1:])]
        self.assertEqual(answer["drops"], sum(now and not before for before, now in zip([False] + falls, falls)))

    def test_paper_fig_8(self):
        answer = self.json("design", FIG_8)
        self.assertAlmostEqual(answer["first_snap_stage"], 0.588456, delta=5e-7)  # the digits printed
        self.assertEqual(answer["snaps"], 4)

    def test_identity_changes_hold(self):
        answer = self.json("design", self.file("case.toml", CASE))
        change = {c["parameter"]: c["to"] for c in reversed(answer["changes"])}  # of two of a parameter the first
        stiff = CASE.replace("90.65 N/m", f"{change['stiffness']!r} N/m")
        stiffer = self.json("design", self.file("stiff.toml", stiff))
        self.assertEqual(stiffer["snaps"], 0)
        self.assertEqual(answer["critical_stiffness"], change["stiffness"])  # one number, wherever it is told
        self.assertEqual(answer["critical_stiffness"], stiffer["critical_stiffness"])
        words = self.succeeds("design", self.file("stiff.toml", stiff))
        self.assertTrue(words.startswith("No sawtooth"), words)
        self.assertIn("softer load train", words)
        self.assertIn("softer load train", self.succeeds("design", self.file("inf.toml", CASE.replace("90.65 N/m", "inf"))))

    def test_oracle_simulate_where_the_specimen_is_bent_by_more_than_the_span(self):
        far = self.file("far.toml", CASE.replace("700 um", "1500 um").replace('step = "2 um"', ""))
        answer, simulated = self.json("design", far), self.json("simulate", far, "--points", "4")
        self.assertEqual((answer["status"], answer["snaps"]), (simulated["status"], len(simulated["snaps"])))

    def test_limit_hidden_between_readings(self):
        fine = CASE.replace("40 um", "10.9 um").replace("700 um", "466 um")
        self.assertIn("Yes: the specimen will snap, once", self.succeeds("design", self.file("fine.toml", fine)))
        coarse = self.file("coarse.toml", fine.replace('"2 um"', '"233 um"'))
        self.assertIn("will not show it", self.succeeds("design", coarse))

    def test_the_page_on_planning_is_true(self):
        page = (SOURCE / "docs/planning-a-test.md").read_text(encoding="utf-8")
        snippet, = re.findall(r"^```python\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
        output = self.folder / "map.csv"
        self.succeeds("design", self.file("case.toml", CASE), "--over", "stiffness=10 N/m:1000 N/m:9", "--over=mu0=0.1:0.9:5",
                      "--output", output)
        found = {}
        exec(snippet.replace('"map.csv"', repr(str(output))), found)
        self.assertEqual((len(found["rows"]), len(found["soft"])), (45, 20))
        self.assertTrue(0 < found["share"] < 1)
        told = set(re.findall(r"`([a-z_0-9]+)`", page + (SOURCE / "docs/results.md").read_text(encoding="utf-8")))
        self.assertLessEqual({title.split(" ")[0] for title in found["rows"][0]}, told)

    def test_identity_map_is_designs(self):
        case = self.file("case.toml", CASE)
        rows = self.succeeds("design", case, "--over", "stiffness=50 N/m:90.65 N/m:3").splitlines()
        self.assertEqual(len(rows), 4)
        last = dict(zip(rows[0].split(","), rows[-1].split(",")))
        answer = self.json("design", case)
        self.assertEqual(int(last["snaps"]), answer["snaps"])
        for name in ("stage_reached [m]", "first_snap_force_after [N]", "work [J]", "friction_heat [J]"):
            self.assertEqual(float(last[name]), answer[name.split()[0]])
        self.assertEqual(last["status"], answer["status"])
        two = self.succeeds("design", case, "--over", "stiffness=50 N/m:90.65 N/m:3", "--threads", 2).splitlines()
        self.assertEqual(two, rows)
        thick = self.json("design", case, "--over", "diameter=100 um:300 um:2")["designs"]
        self.assertEqual([row["status"] for row in thick], ["ok", "impossible"])
        designs = self.json("design", case, "--over", "mu0=0:0.5:2", "--over", "step=1 um:5 um:3")["designs"]
        self.assertEqual(len(designs), 6)

    def test_figures_are_drawn(self):
        case = self.file("case.toml", CASE)
        for name, over in (("a.svg", []), ("b.svg", ["mu0=0:0.6:5"]), ("c.svg", ["mu0=0:0.6:5", "stiffness=10 N/m:1 kN/m:5"])):
            ranges = [word for text in over for word in ("--over", text)]
            self.succeeds("design", case, "--figure", self.folder / name, *ranges)
            self.assertTrue((self.folder / name).exists())

    def test_glass_breaks_before_the_first_snap(self):
        brittle = CASE.replace('modulus = "29.6 GPa"', 'modulus = "29.6 GPa"\nstrain_at_break = "2 %"')
        answer = self.json("design", self.file("case.toml", brittle))
        self.assertEqual((answer["status"], answer["snaps"]), ("breaks", 0))
        self.assertAlmostEqual(answer["greatest_strain"], 0.02, delta=1e-12)
        self.assertAlmostEqual(answer["greatest_stress"], 0.02 * 29.6e9, delta=1)
        self.assertIn("will break at the stage position", answer["answer"])
        # Where the path of simulate has that strain.
        path = self.json("simulate", self.file("long.toml", CASE.replace('"2 um"', '"0.01 um"')))["path"]
        first = next(point for point in path if point["strain"] >= 0.02)
        self.assertAlmostEqual(first["stage"], answer["stage_reached"], delta=0.02e-6)
        strong = brittle.replace('strain_at_break = "2 %"', 'strength = "592 MPa"')
        same = self.json("design", self.file("case.toml", strong))
        self.assertAlmostEqual(same["stage_reached"], answer["stage_reached"], delta=1e-12)

    def test_waves_of_nanometres_are_answered_too(self):
        fine = self.json("design", self.file("case.toml", CASE.replace("40 um", "10 nm")))
        self.assertGreater(fine["snaps"], 1000)
        self.assertIsNone(fine["phases"])  # they move nothing that can be seen
        stop = next(change for change in fine["changes"] if change["parameter"] == "travel")
        self.assertLessEqual(stop["to"], fine["first_snap_stage"])

    def test_a_second_loading_is_planned(self):
        case = self.file("case.toml", CASE.replace("40 um", "10.9 um").replace("700 um", "560 um"))
        told = self.json("design", case, "--decide", "--noise", "12 uN")["reload"]
        self.assertEqual((told["noise"], told["noise_is_usual"], len(told["plans"])), (12e-6, False, 40))
        self.assertIn(told["planned"], told["plans"])
        self.assertIn(told["least"], told["plans"])
        words = self.succeeds("design", case, "--decide", "--noise", "12 uN")
        self.assertIn("A second loading will distinguish slips from cracks: load to the stage position", " ".join(words.split()))
        self.assertIsNone(self.json("design", case)["reload"])
        stiff = self.succeeds("design", case, "--decide", "--set", "rig.stiffness=inf", "--set", "friction.amplitude=0", "--set", 'stage.program=["0 um", "400 um"]')
        self.assertIn("there is nothing to decide", " ".join(stiff.split()))

    def test_oracle_fit_finds_the_causes_that_it_is_said_to_find(self):
        """Three specimens that slip and three that crack, each on a rig that is off; drawn by fixed seeds."""
        friction, travel, noise = decide.PLANS["many drops"]
        plan, causes = decide.planned(PROGRAM, self.folder, "plan", friction, travel, noise)
        for cause in causes:
            self.assertGreater(plan[f"chance_if_{cause.name}"], 0.99)
            for seed in range(3):
                self.assertEqual(decide.verdict(PROGRAM, self.folder, plan, cause, noise, seed), cause.verdict)

    def test_bad_input_is_located(self):
        for text, arguments, said in (
            (CASE.replace('"700 um"', '"700 um", "10 um", "900 um"'), [], "case.toml:14: [stage] program[3]"),
            (CASE.replace("phase = 1.0", "static_excess = 0.1"), [], "[friction] static_excess"),
            (CASE, ["--over", "stiffnes=1 N/m:2 N/m"], "Did you mean 'stiffness'?"),
            (CASE, ["--decide", "--over", "mu0=0:1"], "--decide: One planned test is decided on, but --over gives a range of them. Leave out one"),
            (CASE, ["--noise", "1 uN"], "--noise requires --decide"),
            (CASE, ["--decide", "--noise", "0 N"], "--noise: '0 N' is not a positive force"),
            (CASE, ["--over", "stiffness=1:2"], "--over: The number '1' has no unit, but a stiffness needs one"),
            (CASE, ["--over", "mu0=0:1", "--over", "mu0=0:1"], "The same parameter is given twice"),
            (CASE, ["--over", "mu0=0:1:2000", "--over", "span=1 mm:2 mm:2000"], "more than the limit of 1000000"),
            (CASE, ["--over", "mu0=0:1", "--over", "span=1 mm:2 mm", "--over", "step=1 um:2 um"], "flexslip sweep"),
        ):
            self.refused("design", self.file("case.toml", text), *arguments, says=[said])


if __name__ == "__main__":
    unittest.main()
