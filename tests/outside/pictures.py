#!/usr/bin/python3
"""outside: no answer is lost for a picture, whatever becomes of gnuplot."""
import json
import os
import shutil
import unittest

from program import SOURCE, WAVY, InFolder, run

CASE = SOURCE / "examples/simulated/case.toml"


class Pictures(InFolder):
    def sets(self, **variables):
        before = {name: os.environ.get(name) for name in variables}
        self.addCleanup(lambda: [os.environ.__setitem__(name, value) if value is not None else os.environ.pop(name, None) for name, value in before.items()])
        os.environ.update({name: str(value) for name, value in variables.items()})

    def gnuplot_is(self, script):
        """A gnuplot before all others on PATH; none at all without a script."""
        folder = self.folder / "programs"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        if script:
            (folder / "gnuplot").write_text(script, encoding="utf-8")
            (folder / "gnuplot").chmod(0o755)
        self.sets(PATH=folder)

    def answers_without_pictures(self, why):
        result = run("fit", CASE, "--report", self.folder / "report", "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(json.loads(result.stdout)["status"], "ok")
        self.assertIn(why, result.stderr)
        self.assertIn("pictures are missing from the report", result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1)
        page = (self.folder / "report/report.html").read_text(encoding="utf-8")
        self.assertIn(f"Not drawn: {why}", page)
        self.assertNotIn("<svg role", page)
        self.assertTrue((self.folder / "report/figures/force.gp").is_file())
        self.assertTrue((self.folder / "report/figures/force-measured.csv").is_file())
        self.assertEqual(list((self.folder / "report/figures").glob("*.svg")), [])

    def test_a_fit_is_told_and_its_report_is_there(self):
        for script, why in (
            ("", "gnuplot is not installed"),
            ("#!/bin/sh\necho 'first words' >&2\necho 'the font is broken' >&2\nexit 1\n", "gnuplot could not draw"),
            ("#!/bin/sh\nkill -SEGV $$\n", "gnuplot could not draw"),
            ("#!/bin/sh\nexit 0\n", "gnuplot wrote no svg of"),
            ("#!/no/such/interpreter\n", "gnuplot is not installed"),
        ):
            with self.subTest(script):
                self.gnuplot_is(script)
                self.answers_without_pictures(why)

    def test_gnuplot_says_why(self):
        self.gnuplot_is("#!/bin/sh\necho 'first words' >&2\necho 'the font is broken' >&2\nexit 1\n")
        result = run("fit", CASE, "--report", self.folder / "report")
        self.assertRegex(result.stderr, r"^flexslip: gnuplot could not draw \S+\.gp \(exit code 1\): the font is broken: .*\n$")
        self.assertIn("friction", result.stdout)

    def test_a_folder_for_temporary_files_that_is_not_there(self):
        self.sets(TMPDIR=self.folder / "nowhere")
        self.answers_without_pictures("gnuplot could not be run: ")

    @unittest.skipUnless(shutil.which("gnuplot"), "no gnuplot")
    def test_settings_of_the_user_change_no_picture(self):
        picture = self.folder / "plain.svg"
        self.succeeds("simulate", self.file("case.toml", WAVY), "--figure", picture)
        home = self.folder / "home"
        (home / ".config/gnuplot").mkdir(parents=True)
        for settings in (home / ".gnuplot", home / ".config/gnuplot/gnuplotrc"):
            settings.write_text("exit error 'read'\n", encoding="utf-8")
        self.sets(HOME=home, GNUTERM="nonsense")
        again = self.folder / "again/plain.svg"
        again.parent.mkdir()
        self.succeeds("simulate", self.folder / "case.toml", "--figure", again)
        self.assertEqual(again.read_bytes(), picture.read_bytes())

    def test_every_command_that_draws(self):
        case = self.file("case.toml", WAVY)
        calls = [
            ["simulate", case],
            ["equilibrium", case],
            ["design", case],
            ["design", case, "--over", "span=0.9mm:1mm:2"],
        ]
        answers = [self.succeeds(*call) for call in calls]
        self.gnuplot_is("#!/bin/sh\necho no >&2\nexit 3\n")
        for number, (call, answer) in enumerate(zip(calls, answers)):
            with self.subTest(call):
                result = run(*call, "--figure", self.folder / f"{number}.svg")
                self.assertEqual((result.returncode, result.stdout), (0, answer), result.stderr)
                self.assertIn(f"gnuplot could not draw {number}.gp (exit code 3): no: ", result.stderr)
                self.assertTrue((self.folder / f"{number}.gp").is_file())

    def test_a_campaign(self):
        tests = self.folder / "tests"
        tests.mkdir()
        for name in ("case.toml", "test.csv"):
            shutil.copy(CASE.parent / name, tests)
        self.gnuplot_is("#!/bin/sh\nexit 3\n")
        result = run("campaign", tests, "--report", self.folder / "report", "--test-reports", "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(json.loads(result.stdout)["tests"][0]["status"], "ok")
        self.assertIn("gnuplot could not draw", result.stderr)
        for page in "report/report.html", next((self.folder / "report/tests").glob("*/report.html")):
            self.assertIn("Not drawn: gnuplot could not draw", (self.folder / page).read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
