#!/usr/bin/python3
"""outside: `flexslip read` on exports of machines, and the CSV and JSON that it writes."""
import json
import shlex
import unittest

from program import SOURCE, InFolder, numbers, run, table

FIXTURES = SOURCE / "tests/instruments/fixtures"
MEASURED = SOURCE / "../shared/data/instruments"
SCHEMA = {"format", "sheet", "sheets", "encoding", "byte_order_mark", "delimiter", "decimal", "thousands", "quoted", "columns", "rows", "specimens",
          "metadata", "test", "notes", "asks", "repeat_with"}


def measured():
    if not MEASURED.is_dir():
        raise unittest.SkipTest("skipped: no campaign data")
    return sorted(path for path in MEASURED.rglob("*") if path.is_file())


class Made(InFolder):
    def test_truth_csv_has_the_numbers_that_the_script_wrote(self):
        text = self.succeeds("read", "-o", "-", FIXTURES / "zwick.csv", "--quiet")
        rows = "".join(line for line in text.splitlines(keepends=True) if not line.startswith("#"))
        self.assertEqual(numbers(rows, "Prüfzeit [s]"), [i / 10 for i in range(40)])
        self.assertEqual(numbers(rows, "Standardkraft [N]"), [round(40 * i - i * i / 10, 3) for i in range(40)])
        self.assertEqual(numbers(rows, "Traversenweg [mm]"), [i / 50 for i in range(40)])
        self.assertIn("# Auflagerabstand: 64 mm\n", text)

    def test_schema(self):
        answer = self.json("read", FIXTURES / "zwick.csv")
        self.assertEqual(set(answer), SCHEMA)
        self.assertEqual((answer["format"], answer["encoding"], answer["delimiter"], answer["decimal"], answer["rows"]),
                         ("Zwick testXpert", "cp1252", ";", ",", 40))
        self.assertEqual([column["role"] for column in answer["columns"]], ["time", "force", "crosshead"])
        self.assertAlmostEqual(answer["test"]["span"], 0.064, delta=1e-17)  # one rounding

    def test_the_summary_goes_to_the_screen_and_the_table_where_output_says(self):
        path = FIXTURES / "bluehill_thousands.csv"
        alone, beside = run("read", path), run("read", path, "-o", "-")
        self.assertEqual((alone.stderr, alone.stdout), ("", beside.stderr))
        written = run("read", path, "-o", self.folder / "plain.csv")
        self.assertEqual((written.stderr, written.stdout), ("", beside.stderr))
        self.assertEqual((self.folder / "plain.csv").read_text(encoding="utf-8"), beside.stdout)
        self.assertEqual(run("read", path, "-o", self.folder / "plain.csv", "--quiet").stdout, "")
        said = beside.stderr
        self.assertTrue(said.startswith(f"{path}: Instron Bluehill, 40 rows. One question is open.\n\n"), said)
        for words in ("commas between cells", "commas between thousands", "\n  3  Load       N   force\n",
                      "\n                    --displacement crosshead, or --displacement deflection\n", "the same way again: --full"):
            self.assertIn(words, said)
        self.assertRegex(run("read", path, "--full").stdout, r"the same way again: flexslip read .*\n$")

    def test_identity_the_flags_that_it_prints_give_the_same(self):
        for path in sorted(FIXTURES.iterdir()):
            with self.subTest(file=path.name):
                first = run("read", "-o", "-", path, "--specimen", 1, "--quiet")
                if first.returncode == 2:
                    continue
                flags = shlex.split(self.json("read", path)["repeat_with"])
                self.assertEqual(self.succeeds("read", "-o", "-", path, "--specimen", 1, "--quiet", *flags), first.stdout)
                again = self.json("read", path, *flags)
                self.assertEqual(shlex.split(again["repeat_with"]), flags)

    def test_identity_canonical_form_is_its_own(self):
        first = self.succeeds("read", "-o", "-", FIXTURES / "utf16le.txt", "--quiet")
        self.assertEqual(self.succeeds("read", "-o", "-", "-", "--quiet", stdin=first), first)

    def test_several_specimens(self):
        path = FIXTURES / "shimadzu.csv"
        self.refused("read", "-o", "-", path, "--quiet", says=["2", "--specimen 1 to 2"])
        listed = self.succeeds("read", path)
        for words in (", 2 specimens. ", "'1 _ 1'", "'1 _ 2'", "Columns of specimen 1:"):
            self.assertIn(words, listed)
        self.refused("read", path, "--quiet", "--specimen", 3, says=["Specimen 3 is asked for, but the file holds 2"])
        second = self.succeeds("read", "-o", "-", path, "--quiet", "--specimen", 2)
        self.assertIn("# Specimen: 1 _ 2\n", second)
        self.assertEqual([each["name"] for each in self.json("read", path)["specimens"]], ["1 _ 1", "1 _ 2"])

    def test_volts_need_a_calibration(self):
        path = FIXTURES / "voltage.csv"
        self.refused("read", path, says=["V", "--force 3 --calibration"])
        self.refused("read", path, "--force", "Load", says=["--calibration"])
        text = self.succeeds("read", "-o", "-", path, "--calibration", "222 N/V", "--quiet")
        self.assertAlmostEqual(numbers(text, "Load [N]")[-1], 1407.9, delta=222 * 0.5e-6)  # the file's last decimal

    def test_what_cannot_be_known_is_refused_or_asked(self):
        self.refused("read", FIXTURES / "undecidable.txt", says=["--decimal"])
        decided = self.succeeds("read", "-o", "-", FIXTURES / "undecidable.txt", "--decimal", ",", "--quiet")
        self.assertEqual(table(decided)["column_1"][0], "1.1")
        self.assertIn("--force COLUMN", " ".join(self.json("read", FIXTURES / "no_header.csv")["asks"]))
        answer = self.json("read", FIXTURES / "no_header.csv", "--force", 3, "--force-unit", "N", "--deflection", 2,
                           "--displacement-unit", "mm")
        self.assertEqual(answer["asks"], [])

    def test_wrong_calls(self):
        path = FIXTURES / "zwick.csv"
        self.refused("read", path, "--force", "Standardkrat", says=["Did you mean 'Standardkraft'?"])
        self.refused("read", path, "--encoding", "latin9", says=["'cp1252'"])
        self.refused("read", path, "--decimal", ";", says=["--decimal"])
        self.refused("read", path, "--force-unit", "mm", says=["--force-unit", "'mm'"])
        self.refused("read", self.folder, says=["a directory"])
        self.refused("read", self.file("empty.csv", b"\xef\xbb\xbf"), says=["empty.csv", "byte order mark and nothing else"])


class Remedies(InFolder):
    """What a message says works, with the command that said it."""

    def record(self, titles):
        rows = "".join(f"{0.5 * i:.1f},{0.05 * i:.3f},{0.02 * i:.3f}\n" for i in range(40))
        return self.file("record.csv", titles + "\n" + rows)

    def test_the_unit_that_is_meant_is_named_and_may_be_stated_by_each_command(self):
        path = self.record("Time (s),Deflection (mm),Force (KN)")
        bar = ["--span", "64 mm", "--width", "10 mm", "--height", "4 mm", "--stiffness", "inf"]
        for command in ("modulus", "fit"):
            self.refused(command, path, *bar, says=["'KN'", "If kN is meant", '--force "Force [kN]"'])
        self.assertIn('modulus', self.succeeds("modulus", path, *bar, "--force", "Force [kN]"))
        self.assertRegex(self.succeeds("read", path), r"which says 'KN': kN\?\n +--force-unit kN\n")
        self.assertIn("No question is open.", self.succeeds("read", path, "--force-unit", "kN"))

    def test_all_open_questions_come_at_once(self):
        path = self.record("Time,Extension,Load")
        self.refused("modulus", path, "--span", "64 mm", "--stiffness", "inf", says=["3 more inputs are needed", "Was 'Extension' measured at the crosshead", "What is the unit of 'Extension'",
                                                              "What is the unit of 'Load'"])
        self.refused("fit", path, says=["5 more inputs are needed", "How stiff is the load train?", '--stiffness "', "How far are the supports apart?", '--span "'])
        case = self.file("case.toml", f'[record]\nfile = "{path}"\n')
        self.refused("fit", case, says=['write displacement = "crosshead|deflection" into [record]', 'write stiffness = "', 'write span = "'])
        self.assertNotIn("--", run("fit", case).stderr)
        self.succeeds("modulus", path, "--span", "64 mm", "--width", "10 mm", "--height", "4 mm", "--displacement", "deflection",
                      "--displacement-column", "Extension [mm]", "--force", "Load [N]")


class Measured(InFolder):
    def test_every_published_file_is_read_or_refused_for_the_right_reason(self):
        for path in measured():
            with self.subTest(file=path.name):
                if path.parent.name == "mts_testsuite_empty":
                    self.refused("read", path, says=["a byte order mark and nothing else" if "BOM_ONLY" in path.name else "The file is empty"])
                elif path.parent.name == "bluehill_decimal_comma":
                    self.refused("read", path, says=[":5998:", "A number has several decimal commas", "without opening it in a spreadsheet"])
                elif path.parent.name == "mts_testsuite_femur":
                    self.refused("read", path, says=["'Aux Input 5' in V", "--calibration"])
                    self.succeeds("read", "-o", "-", path, "--force", 4, "--calibration", "73.1 N/V", "--quiet")
                else:
                    first = self.succeeds("read", "-o", "-", path, "--quiet")
                    self.assertEqual(self.succeeds("read", "-o", "-", "-", "--quiet", stdin=first), first)
                    flags = shlex.split(json.loads(run("read", path, "--json").stdout)["repeat_with"])
                    self.assertEqual(self.succeeds("read", "-o", "-", path, "--quiet", *flags), first)


if __name__ == "__main__":
    unittest.main()
