#!/usr/bin/python3
"""outside: twelve exports of machines: the right columns, and the modulus with which they were made."""
import json
import tempfile
import unittest

import machine_exports
from program import run

DEFLECTION = ["--displacement", "deflection"]
# file, how its maker states the test, modulus [GPa], columns of force and displacement, rows
EXPORTS = [
    ("bluehill_us.csv", DEFLECTION, 205, ("Flexure load", "Flexure extension"), 606),
    ("mts_specimen.dat", ["--span", "160 mm", "--width", "15 mm", "--height", "10 mm", *DEFLECTION], 38, ("Axial Force", "Axial Displacement"), 540),
    ("zwick_testxpert3.xlsx", ["--sheet", "Probe 1", "--span", "64 mm", "--width", "10 mm", "--height", "4 mm"], 18.4, ("Standardkraft", "Verformung"), 505),
    ("shimadzu_ja.csv", ["--specimen", "2", "--span", "48 mm", "--width", "10 mm", "--height", "3 mm", "--stiffness", "inf"], 3.32, ("試験力", "ストローク"), 655),
    ("texture_exponent.tab", ["--span", "40 mm", "--diameter", "1.75 mm", "--force", "Force [gf]", *DEFLECTION], 2.9, ("Force", "Distance"), 900),
    ("hysitron_bridge.txt", ["--span", "60 um", "--width", "10 um", "--height", "2 um", *DEFLECTION], 250, ("Load", "Depth"), 1500),
    ("femtotools.txt", ["--span", "1500 um", "--diameter", "50 um", *DEFLECTION], 38, ("Force A", "Displacement"), 1800),
    ("labview_holz.lvm", ["--span", "280 mm", "--width", "20 mm", "--height", "20 mm", *DEFLECTION], 11.2, ("Kraft", "Weg"), 600),
    ("dma_q800.txt", ["--span", "20 mm", "--width", "5.12 mm", "--height", "1.03 mm", *DEFLECTION, "--displacement-column", "3"], 5.6, ("Static Force", "Displacement"), 420),
    ("student_rods.xlsx", ["--specimen", "3", "--span", "120 mm", "--diameter", "6 mm", *DEFLECTION], 42.3, ("Force", "Displacement"), 395),
    ("sheets_fr.csv", [], 9.8, ("Charge", "Flèche"), 520),
    ("arduino_hx711.txt", ["--span", "80 mm", "--diameter", "3 mm", "--force", "load [gf]", *DEFLECTION], 14, ("load", "pos"), 640),
]


class TwelveExports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        machine_exports.make(cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_truth_each_export_gives_its_modulus(self):
        for name, flags, modulus, (force, displacement), _ in EXPORTS:
            with self.subTest(name):
                answer = run("modulus", f"{self.folder.name}/{name}", *flags, "--json")
                self.assertEqual(answer.returncode, 0, answer.stderr)
                found = json.loads(answer.stdout)
                self.assertAlmostEqual(found["modulus"]["value"] / 1e9, modulus, delta=0.02 * modulus)
                columns = found["preparation"][0]["done"]
                self.assertIn(f"the displacement is the column '{displacement}'", columns)
                self.assertIn(f"the force is the column '{force}'", columns)

    def test_truth_the_rows_of_each_export(self):
        for name, _, _, _, rows in EXPORTS:
            with self.subTest(name):
                read = json.loads(run("read", f"{self.folder.name}/{name}", "--json").stdout)
                counts = [specimen["rows"] for specimen in read.get("specimens", [read])]
                self.assertIn(rows, counts, read)

    def test_truth_a_deflection_and_the_crosshead_tell_each_other_and_the_load_train(self):
        path = f"{self.folder.name}/zwick_testxpert3.xlsx"
        read = run("read", path).stdout
        self.assertIn("column 'Verformung' is the deflection, and 'Traversenweg' the crosshead's", " ".join(read.split()))
        fitted = json.loads(run("fit", path, "--sheet", "Probe 1", "--span", "64 mm", "--width", "10 mm", "--height", "4 mm", "--json").stdout)
        train = next(step for step in fitted["preparation"] if step["done"].startswith("the load train is"))
        self.assertAlmostEqual(train["value"], 4.2e6, delta=0.01 * 4.2e6)

    def test_refused_a_force_in_grams_is_no_force_in_newtons(self):
        for name, column in (("texture_exponent.tab", "Force"), ("arduino_hx711.txt", "load")):
            for unit, code in (("N", 2), ("gf", 0)):
                answer = run("modulus", f"{self.folder.name}/{name}", "--span", "80 mm", "--diameter", "3 mm", *DEFLECTION,
                             "--force", f"{column} [{unit}]")
                self.assertEqual(answer.returncode, code, answer.stderr)
                if code:
                    self.assertIn("If gf is meant, write gf", answer.stderr)


if __name__ == "__main__":
    unittest.main()
