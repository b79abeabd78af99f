#!/usr/bin/python3
"""outside: examples/octave as Octave runs it, against the program's JSON; skipped where there is no Octave."""
import os
import shutil
import subprocess
import sys
import unittest

from program import PROGRAM, SOURCE, InFolder, numbers

OCTAVE = shutil.which("octave-cli")


class Octave(InFolder):
    def said_by(self, script):
        environment = {**os.environ, "FLEXSLIP": PROGRAM, "DRAW": ""}
        done = subprocess.run([OCTAVE, "--quiet", "--no-init-file", SOURCE / "examples/octave" / script], cwd=self.folder, env=environment, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_a_fit_called_from_octave_has_the_numbers_of_its_json_and_table(self):
        said = self.said_by("fit_and_plot.m")
        fit = self.json("fit", SOURCE / "examples/simulated/case.toml")
        mu0 = fit["parameters"]["mu0"]
        self.assertIn("mu0 = {:.4f}, 95 % interval {:.4f} to {:.4f}".format(mu0["value"], *mu0["interval95"]), said)
        self.assertIn(f"{len(fit['drops'])} drops", said)
        curves = self.folder / "curves.csv"
        self.succeeds("fit", SOURCE / "examples/simulated/case.toml", "--quiet", "--curves", curves)
        force = numbers(curves.read_text(encoding="utf-8"), "F [N]")
        self.assertIn(f"{len(force)} rows, greatest force {1e3 * max(force):.3f} mN", said)


if __name__ == "__main__":
    if OCTAVE is None or os.environ.get("FLEXSLIP_CONFIG") not in (None, "Release"):
        print("skipped: no octave-cli" if OCTAVE is None else "skipped: tried on the release")
        sys.exit(77)
    unittest.main()
