"""The program as a user has it, for the tests beside this file."""
import csv
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["FLEXSLIP"]
SOURCE = pathlib.Path(os.environ["SOURCE_DIR"])

# A case that runs at once: friction that is a wave, a short way.
WAVY = """[specimen]
diameter = "30 um"
modulus = "30 GPa"
[rig]
span = "1 mm"
stiffness = "90 N/m"
[friction]
model = "sinusoid"
mu0 = 0.4
amplitude = 0.3
wavelength = "40 um"
phase = 1
[stage]
program = ["0 um", "200 um"]
step = "4 um"
"""


def run(*arguments, stdin=""):
    """What the program says: its exit code as .returncode, .stdout and .stderr."""
    return subprocess.run([PROGRAM, *map(str, arguments)], input=stdin, capture_output=True, text=True, check=False)


def table(text):
    """CSV as {title: [cells]}."""
    rows = list(csv.reader(text.splitlines()))
    return {title: list(cells) for title, *cells in zip(*rows)}


def against(fit):
    """The codes of what was found against an answer (fit --json)."""
    return [finding["code"] for finding in fit["findings"] if finding["severity"] in ("refusal", "suspicion", "doubt")]


def words_of(fit, label):
    """The words of a row of an answer; empty if it has no such row."""
    return next((row["words"] for row in fit["answer"] if row["label"] == label), "")


def numbers(text, title):
    return [float(cell) for cell in table(text)[title]]


class InFolder(unittest.TestCase):
    """Each test in an empty folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, content):
        path = self.folder / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content, encoding="utf-8")
        return path

    def succeeds(self, *arguments, stdin=""):
        result = run(*arguments, stdin=stdin)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout

    def json(self, *arguments):
        return json.loads(self.succeeds(*arguments, "--json"))

    def refused(self, *arguments, says, stdin=""):
        """Exit code 2, nothing on standard output, and on standard error one line, or a list of missing inputs, that says all of `says`."""
        result = run(*arguments, stdin=stdin)
        self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
        self.assertTrue(result.stderr.startswith("flexslip: "), result.stderr)
        complaint, *others = result.stderr.splitlines()
        list_of_inputs = [line for line in others if line.startswith("  ")]
        if list_of_inputs:
            self.assertTrue(complaint.endswith(":"), result.stderr)
            self.assertLessEqual(len(others) - len(list_of_inputs), 1, result.stderr)  # a remedy for all
        else:
            self.assertEqual(others, [], result.stderr)
        for words in says:
            self.assertIn(words, result.stderr)
