#!/usr/bin/python3
"""outside: flexslip studio writes the page with tests inside, from wherever the page is, and says how to build it where there is none."""
import base64
import json
import os
import pathlib
import re
import shutil
import subprocess
import unittest

from program import PROGRAM, SOURCE, WAVY, InFolder

EXAMPLE = SOURCE / "examples/simulated"
# What the command needs of the page, whatever else is in it.
VERSION = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True).stdout.split()[1]
PAGE = f'<!DOCTYPE html>\n<title>The studio</title>\n<script type="application/json" id="given" data-version="{VERSION}">[]</script>\n<p>&amp; more</p>\n'
NAME = "flexslip-studio.html"


class Studio(InFolder):
    def setUp(self):
        super().setUp()
        (self.folder / "bin").mkdir()
        (self.folder / "work").mkdir()
        self.program = self.folder / "bin/flexslip"
        shutil.copy(PROGRAM, self.program)

    def studio(self, *arguments, path=None):
        env = {**os.environ, "PATH": path} if path is not None else None
        return subprocess.run([self.program, "studio", *map(str, arguments)], cwd=self.folder / "work", env=env, capture_output=True, text=True, check=False)

    def written(self, *arguments):
        result = self.studio(*arguments, "--no-open")
        self.assertEqual((result.returncode, result.stderr), (0, ""), arguments)
        return (self.folder / "work" / NAME).read_text(encoding="utf-8")

    def given(self, page):
        before, _, after = PAGE.partition("[]")
        self.assertTrue(page.startswith(before) and page.endswith(after))
        text = page[len(before):len(page) - len(after)]
        self.assertNotIn("<", text)
        return [(test["open"], {file["name"]: base64.b64decode(file["data"], validate=True) for file in test["files"]}) for test in json.loads(text)]

    def test_without_a_page_it_says_how_to_come_by_one(self):
        result = self.studio("--no-open")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("tools/build-studio", result.stderr)
        self.assertEqual(list((self.folder / "work").iterdir()), [])

    def test_the_page_is_found_beside_the_program_installed_and_in_the_build_folder(self):
        for place in ("bin", "share/flexslip", "studio"):
            with self.subTest(place):
                (self.folder / place).mkdir(parents=True, exist_ok=True)
                (self.folder / place / NAME).write_text(PAGE, encoding="utf-8")
                self.assertEqual(self.written(), PAGE)
                (self.folder / place / NAME).unlink()

    def test_a_page_of_another_version_is_none(self):
        (self.folder / "bin" / NAME).write_text(PAGE.replace(VERSION, "0.0.1"), encoding="utf-8")
        result = self.studio("--no-open")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn(f"of version {VERSION}", result.stderr)
        (self.folder / "share/flexslip").mkdir(parents=True)
        (self.folder / "share/flexslip" / NAME).write_text(PAGE, encoding="utf-8")
        self.assertEqual(self.written(), PAGE)

    def test_a_case_takes_its_files_along_as_they_are(self):
        (self.folder / "bin" / NAME).write_text(PAGE, encoding="utf-8")
        [(name, files)] = self.given(self.written(EXAMPLE / "case.toml"))
        self.assertEqual(name, "simulated/case.toml")
        self.assertEqual(files, {f"simulated/{file}": (EXAMPLE / file).read_bytes() for file in ("case.toml", "test.csv")})

    def test_a_case_whose_files_lie_elsewhere_is_written_anew_and_gives_the_same_answer(self):
        (self.folder / "bin" / NAME).write_text(PAGE, encoding="utf-8")
        (self.folder / "data").mkdir()
        shutil.copy(EXAMPLE / "test.csv", self.folder / "data/case.toml")  # a name that the case has in the page
        case = (EXAMPLE / "case.toml").read_text(encoding="utf-8").replace('"test.csv"', '"../data/case.toml"')
        self.file("work/mine.toml", case)
        [(name, files)] = self.given(self.written("mine.toml"))
        self.assertEqual(sorted(files), ["mine/case-2.toml", "mine/case.toml"])
        for file, data in files.items():
            (self.folder / "page" / file).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / "page" / file).write_bytes(data)
        answers = [subprocess.run([PROGRAM, "invert", self.folder / "page" / name], capture_output=True, check=True).stdout,
                   subprocess.run([PROGRAM, "invert", EXAMPLE / "case.toml"], capture_output=True, check=True).stdout]
        self.assertEqual(*answers)

    def test_several_files_and_hostile_names_stand_in_it_as_data(self):
        (self.folder / "bin" / NAME).write_text(PAGE, encoding="utf-8")
        hostile = "</script><img src=x>\".csv".replace("/", "\u2215")
        for name, data in ((hostile, b"\xff\x00<"), ("b.csv", b""), ("c.csv", b"ab")):
            (self.folder / "work" / name).write_bytes(data)
        tests = self.given(self.written(hostile, "b.csv", "c.csv"))
        self.assertEqual(tests, [(hostile, {hostile: b"\xff\x00<"}), ("b.csv", {"b.csv": b""}), ("c.csv", {"c.csv": b"ab"})])

    def test_nothing_is_lost(self):
        (self.folder / "work" / NAME).write_text(PAGE, encoding="utf-8")
        self.file("work/wavy.toml", WAVY)
        for output in ("wavy.toml", self.folder / "bin" / NAME):
            (self.folder / "bin" / NAME).write_text(PAGE, encoding="utf-8")
            result = self.studio("wavy.toml", "--no-open", "--output", output)
            self.assertEqual((result.returncode, result.stdout), (2, ""), output)
            self.assertIn("nothing has been written", result.stderr)
            self.assertEqual((self.folder / "bin" / NAME).read_text(encoding="utf-8"), PAGE)
            self.assertEqual((self.folder / "work/wavy.toml").read_text(encoding="utf-8"), WAVY)

    def test_what_is_no_page_and_what_cannot_be_read_are_refused(self):
        (self.folder / "bin" / NAME).write_text("<p>another page</p>", encoding="utf-8")
        self.assertIn("is neither in the folder of the program nor in share/flexslip", self.studio("--no-open").stderr)
        (self.folder / "bin" / NAME).write_text(PAGE, encoding="utf-8")
        for arguments, words in ((["none.csv"], "none.csv"), (["none.toml"], "none.toml"), (["-"], "Standard input cannot be put into the page")):
            result = self.studio(*arguments, "--no-open")
            self.assertEqual(result.returncode, 2, arguments)
            self.assertIn(words, result.stderr)

    def test_a_report_has_a_link_to_a_page_with_its_case_inside(self):
        (self.folder / "bin" / NAME).write_text(PAGE, encoding="utf-8")
        call = [self.program, "fit", EXAMPLE / "test.csv", "--span", "1278 um", "--stiffness", "90.65 N/m", "--diameter", "34.8 um", "--modulus", "29.6 GPa",
                "--stage", "stage", "--force", "force", "--report", self.folder / "report", "--quiet"]
        subprocess.run(call, check=True, capture_output=True)
        self.assertTrue('<a href="studio.html">' in (self.folder / "report/report.html").read_text(encoding="utf-8"))
        [(name, files)] = self.given((self.folder / "report/studio.html").read_text(encoding="utf-8"))
        self.assertEqual((name, sorted(files)), ("test/case.toml", ["test/case.toml", "test/test.csv"]))
        self.assertEqual(files["test/test.csv"], (EXAMPLE / "test.csv").read_bytes())
        (self.folder / "bin" / NAME).unlink()
        shutil.rmtree(self.folder / "report")
        subprocess.run(call, check=True, capture_output=True)
        self.assertFalse("studio.html" in (self.folder / "report/report.html").read_text(encoding="utf-8"))

    def test_it_opens_the_page_by_what_the_computer_has(self):
        (self.folder / "bin" / NAME).write_text(PAGE, encoding="utf-8")
        (self.folder / "tools").mkdir()
        opener = self.folder / "tools/xdg-open"
        opener.write_text(f'#!/bin/sh\necho "$1" > {self.folder}/opened\n', encoding="utf-8")
        opener.chmod(0o755)
        result = self.studio(path=str(self.folder / "tools"))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual((self.folder / "opened").read_text(encoding="utf-8").strip(), str(self.folder / "work" / NAME))
        opener.unlink()
        result = self.studio(path=str(self.folder / "tools"))
        self.assertEqual(result.returncode, 0)
        self.assertIn("open the page in one", result.stderr)
        self.assertTrue(re.search(rf"{NAME}$", result.stdout.strip()))


if __name__ == "__main__":
    unittest.main()
