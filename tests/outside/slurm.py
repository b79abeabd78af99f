#!/usr/bin/python3
"""A sweep from outside, as jobs of a Slurm of one node by the lines of docs/sweeps.md: the bytes of one run on one machine."""
import os
import pathlib
import re
import subprocess
import sys
import time
import unittest

from program import PROGRAM, SOURCE, InFolder


class Slurm(InFolder):
    @classmethod
    def setUpClass(cls):
        # `cat` waits for the end of its input: it ends with this test, however this test does, and Slurm with it.
        node = subprocess.Popen([SOURCE / "tools/slurm-one-node", "sh", "-c", "echo $SLURM_CONF; cat"],
                                stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        cls.addClassCleanup(node.communicate)
        conf = node.stdout.readline().strip()
        if not conf and node.wait() == 77:
            raise unittest.SkipTest("no Slurm")
        if not conf:
            raise RuntimeError("Slurm did not start")
        os.environ["SLURM_CONF"] = conf

    def shell(self, command):
        path = f"{pathlib.Path(PROGRAM).resolve().parent}:{os.environ['PATH']}"
        result = subprocess.run(["bash", "-c", command], cwd=self.folder, env={**os.environ, "PATH": path}, capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout.strip()

    def wait_for_jobs(self):
        while self.shell("squeue --noheader"):
            time.sleep(0.2)

    def setUp(self):
        super().setUp()
        self.page = (SOURCE / "docs/sweeps.md").read_text(encoding="utf-8")
        case = next(body for body in re.findall(r"^```toml\n(.*?)^```$", self.page, re.MULTILINE | re.DOTALL) if "[rig]" in body)
        self.whole = self.succeeds("sweep", self.file("map.toml", case), "--quiet")

    def line(self, program):
        """The line of the page that calls a program."""
        line, = re.findall(rf"^{program} .*$", self.page, re.MULTILINE)
        return line

    def test_the_jobs_of_the_page_put_together_are_one_run(self):
        self.shell(self.line("sbatch"))
        self.wait_for_jobs()
        self.assertEqual(len(list(self.folder.glob("part-*.csv"))), 6, self.shell("cat slurm-*.out"))
        self.shell(self.line("awk"))
        self.assertEqual((self.folder / "map.csv").read_text(encoding="utf-8"), self.whole)


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    skipped = sorted({f"skipped: {reason}" for _, reason in result.skipped})
    print(*skipped, sep="\n", file=sys.stderr)
    sys.exit(1 if not result.wasSuccessful() else 77 if skipped else 0)
