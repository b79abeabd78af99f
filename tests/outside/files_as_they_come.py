#!/usr/bin/python3
"""outside: exports that say something unexpected: made files, and, where they are there, the folders of ../shared/cases."""
import json
import pathlib
import unittest

from program import SOURCE, InFolder, run

CASES = (SOURCE / "../shared/cases").resolve()
BAR = ["--span", "64 mm", "--width", "10 mm", "--height", "4 mm", "--displacement", "crosshead", "--stiffness", "2 kN/mm"]
SECTION, SPAN, TRAIN = 10e-3 * 4e-3**2, 64e-3, 2e6


def bar(strains, modulus=2.7e9, yield_strain=None):
    """(time [s], crosshead [mm], force [N]) of a bar of ISO 178, which yields at a strain if one is given."""
    rows = []
    for i, strain in enumerate(strains):
        stress = modulus * (strain if yield_strain is None else min(strain, yield_strain + 0.001 * (strain - yield_strain)))
        force = stress * 2 * SECTION / (3 * SPAN)
        deflection = strain * SPAN**2 / (6 * 4e-3)
        rows.append((0.1 * i, 1e3 * (deflection + force / TRAIN), force))
    return rows


def steps(end, rows=240):
    return [end * i / (rows - 1) for i in range(rows)]


class Dimensions(InFolder):
    def export(self, preamble="", force="Load (N)", value=lambda F: F, extra="", more=lambda w, F: "", rows=None):
        lines = [preamble] if preamble else []
        lines.append(f"Time (s),Crosshead (mm),{force}{extra}")
        lines += [f"{t:.2f},{w:.6f},{value(F):.6f}{more(w, F)}" for t, w, F in rows or bar(steps(0.01))]
        return self.file("test.csv", "\n".join(lines) + "\n")

    def modulus(self, *arguments, code=0):
        answer = run("modulus", *arguments, "--json")
        self.assertEqual(answer.returncode, code, answer.stderr)
        return json.loads(answer.stdout)

    def test_truth_a_stress_under_the_title_of_a_force_becomes_a_force(self):
        for unit, size in ("MPa", 1e-6), ("kPa", 1e-3):
            path = self.export(force=f"Load ({unit})", value=lambda F, size=size: F * 3 * SPAN / (2 * SECTION) * size)
            answer = self.modulus(path, *BAR)
            self.assertAlmostEqual(answer["chord"]["modulus"]["value"], 2.7e9, delta=2e6)
            self.assertIn("holds a stress", answer["preparation"][0]["done"])
            relabelled = run("modulus", path, *BAR, "--force", "Load [N]")
            self.assertEqual(relabelled.returncode, 2)
            self.assertIn(f"The unit of 'Load' is '{unit}' in the file, not 'N'", relabelled.stderr)
            without = run("modulus", path, *BAR[6:])
            self.assertEqual(without.returncode, 2)
            for words in ("The column holds a stress", "--span", "--width", "--height"):
                self.assertIn(words, without.stderr)

    def test_truth_what_file_and_user_state_is_compared_and_a_column_of_stress_decides(self):
        stated = "Span,64,mm\nWidth,10,mm\nThickness,4,mm"
        stress = {"extra": ",Flexure stress (MPa)", "more": lambda w, F: f",{F * 3 * SPAN / (2 * SECTION) * 1e-6:.6f}"}
        for preamble, extra, flags, said in ((stated, {}, BAR, None), (stated, stress, BAR, None), ("", stress, BAR, None),
                                             (stated, {}, ["--span", "50 mm"], "The file states span 64 mm, not span 50 mm."),
                                             (stated, stress, ["--span", "50 mm"], "Its column 'Flexure stress' agrees with the file."),
                                             (stated.replace("64", "50"), stress, ["--span", "64 mm"], "agrees with the stated values."),
                                             ("", stress, ["--span", "50 mm"], "The file's column 'Flexure stress' is 1.28 times")):
            rest = BAR[6:] if flags != BAR and preamble else BAR[2:] if flags != BAR else []
            answer = run("modulus", self.export(preamble, **extra), *flags, *rest)
            self.assertEqual(answer.returncode, 0, answer.stderr)
            words = " ".join(answer.stdout.split())
            if said is None:
                self.assertNotIn("The file", words)
            else:
                self.assertIn(said, words)
        # A deflectometer measures less than the crosshead moves: its strain is no contradiction.
        other = {"extra": ",Flexure strain (mm/mm)", "more": lambda w, F: f",{1e-3 * 0.8 * w * 6 * 4e-3 / SPAN**2:.8f}"}
        self.assertNotIn("The file", run("modulus", self.export("", **other), *BAR).stdout)
        fitted = json.loads(run("fit", self.export(stated), "--span", "50 mm", *BAR[6:], "--json").stdout)
        self.assertIn("contradicts_file", [finding["code"] for finding in fitted["findings"]])

    def test_truth_a_height_that_is_stated_alone_takes_the_width_of_the_file(self):
        path = self.export("Span,64,mm\nWidth,10,mm\nThickness,5,mm")
        answer = self.modulus(path, "--height", "4 mm", *BAR[6:])
        self.assertAlmostEqual(answer["chord"]["modulus"]["value"], 2.7e9, delta=2e6)
        alone = run("modulus", self.export(), "--height", "4 mm", "--span", "64 mm", *BAR[6:])
        self.assertEqual(alone.returncode, 2)
        self.assertIn("--width", alone.stderr)

    def test_truth_time_and_speed_stand_for_a_displacement(self):
        rows = bar(steps(0.01))
        speed = rows[-1][1] / rows[-1][0]
        path = self.file("gauge.csv", "Time (s),Force (N)\n" + "".join(f"{w / speed:.6f},{F:.6f}\n" for _, w, F in rows))
        asked = run("modulus", path, *BAR[:6], "--stiffness", "2 kN/mm")
        self.assertEqual(asked.returncode, 2)
        self.assertIn("--speed", asked.stderr)
        answer = self.modulus(path, *BAR[:6], "--stiffness", "2 kN/mm", "--speed", f"{speed:.9f} mm/s")
        self.assertAlmostEqual(answer["chord"]["modulus"]["value"], 2.7e9, delta=2e6)
        both = run("modulus", self.export(), *BAR, "--speed", "1 mm/s")
        self.assertEqual(both.returncode, 2)
        self.assertIn("no speed is needed", both.stderr)

    def test_truth_the_stress_at_the_maximum_is_a_strength_only_of_a_specimen_that_breaks(self):
        for end, yield_strain, yields, rises, limit in ((0.02, None, False, True, False), (0.06, 0.03, True, False, True)):
            answer = self.modulus(self.export(rows=bar(steps(end), yield_strain=yield_strain)), *BAR)
            self.assertEqual((answer["yields"], answer["ends_rising"]), (yields, rises))
            self.assertEqual(answer["at_conventional_strain"] is not None, limit)
        self.assertAlmostEqual(answer["at_conventional_strain"]["stress"]["value"], 2.7e9 * 0.03, delta=1e6)

    def test_truth_a_stage_that_recoils_as_the_specimen_gives_way_ends_the_record(self):
        rows = bar(steps(0.02))
        last = rows[-1]
        recoiled = [(last[0] + 0.1 * i, last[1] - 0.02 * min(i, 3) + 0.01 * max(i - 3, 0), last[2] * (0.92 + 0.001 * i)) for i in range(1, 40)]
        answer = self.modulus(self.export(rows=rows + recoiled), *BAR)
        self.assertAlmostEqual(answer["greatest_force"]["value"], last[2], delta=1e-3)
        self.assertIsNotNone(answer["at_break"])
        self.assertIn("recoils", " ".join(step["done"] for step in answer["preparation"]))


class OtherFiles(InFolder):
    def test_refused_other_binaries_are_named_by_their_first_bytes(self):
        for name, content, says in (("a.xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(600), "libreoffice --headless --convert-to xlsx"),
                                    ("a.tdms", b"TDSm" + bytes(60), "LabVIEW"), ("a.mat", b"MATLAB 5.0 MAT-file" + bytes(60), "MATLAB"),
                                    ("a.h5", b"\x89HDF\r\n\x1a\n" + bytes(60), "HDF5"), ("a.zs2", b"\x1f\x8b" + bytes(60), "testXpert")):
            path = self.folder / name
            path.write_bytes(content)
            answer = run("read", path)
            self.assertEqual(answer.returncode, 2)
            self.assertIn(says, answer.stderr)

    def test_refused_a_line_of_very_many_cells(self):
        answer = run("read", self.file("long.csv", "1," * 300000 + "\n"))
        self.assertEqual(answer.returncode, 2)
        self.assertIn("at most 16384", answer.stderr)


@unittest.skipUnless(CASES.is_dir(), f"{CASES} is not there")
class Cases(unittest.TestCase):
    def case(self, path, command, *arguments, says=(), code=0, silent=()):
        answer = run(command, CASES / path, *arguments)
        self.assertEqual(answer.returncode, code, answer.stdout + answer.stderr)
        words = " ".join((answer.stdout + answer.stderr).split())
        for each in says:
            self.assertIn(each, words)
        for each in silent:
            self.assertNotIn(each, words)

    def test_outside_each_folder(self):
        bar40 = ["--displacement", "deflection", "--stiffness", "inf", "--span", "40 mm", "--width", "16 mm", "--height", "1.9 mm"]
        small = ["--displacement", "crosshead", "--stiffness", "0.5 kN/mm", "--span", "8 mm", "--diameter", "1.2 mm"]
        rod = ["--span", "50 mm", "--diameter", "1 mm", "--stiffness", "20 N/mm"]
        train = ["--displacement", "crosshead", "--stiffness", "500 N/mm"]
        self.case("units_tell_role/german_last.csv", "read", says=["No question is open", "Last kN force"])
        self.case("units_tell_role/polish.csv", "read", says=["One question is open", "N force"])
        self.case("flexure_words/flexure_load.csv", "read", says=["'Flexure extension' measured at the crosshead or", "Flexure load N force"])
        self.case("stress_as_force/zwick_stress.csv", "modulus", *bar40, says=["flexural modulus 26.0 GPa"])
        self.case("stress_as_force/zwick_stress.csv", "modulus", *bar40, "--force", "Standardkraft [N]", says=["is 'MPa' in the file"], code=2)
        self.case("flag_against_file/bluehill.csv", "modulus", *train, "--span", "80 mm", says=["states span 125 mm", "agrees with the file"])
        self.case("flag_against_file/bluehill.csv", "modulus", *train, says=["30.0"], silent=["states span"])
        self.case("flag_against_file/bluehill.csv", "read", says=["span 125 mm, width 12.8 mm, thickness 4.2 mm"])
        self.case("slow_fall/bone.csv", "fit", *small, "--displacement-column", "Stage [mm]", says=["CRACK"])
        self.case("stage_recoil/recoil_4um.csv", "modulus", *small, says=["flexural modulus 11.5"])
        self.case("chord_withheld/slight_toe.csv", "modulus", *bar40, says=["25.6 GPa", "ISO 178 chord"])
        self.case("broken_plateau/crushed.csv", "fit", *bar40[:2], "--stiffness", "5 kN/mm", *bar40[4:], says=["CRACK"])
        self.case("lvm_comment/comment_in_first_row.lvm", "read", says=["200 rows", "Dev2/ai0 Volts"])
        self.case("load_train_too_soft/drop_66N.csv", "fit", "--displacement", "deflection", "--stiffness", "1 kN/mm", "--span", "40 mm", "--width", "17.7 mm",
                  "--height", "2.26 mm", says=["CHECK INPUT", "stiffer than"], code=1)
        self.case("time_only/gauge.csv", "fit", *rod, says=["--speed"], code=2)
        self.case("time_only/gauge.csv", "fit", *rod, "--speed", "0.5 mm/s", says=["NO DROPS"])
        self.case("test_stopped/P_stopped.csv", "modulus", *train[:2], "--stiffness", "3 kN/mm", says=["still rising: not a strength"])
        self.case("test_stopped/plastic.csv", "modulus", *train[:2], "--stiffness", "3 kN/mm", says=["yielded", "3.5 % strain"])
        self.case("bad_cells/T13_broken.csv", "fit", *rod, says=["holds no numbers (row 1: 'abc')"], code=2)
        self.case("slow_to_read/far_cell.xlsx", "read", says=["1 row"])


if __name__ == "__main__":
    unittest.main()
