#!/usr/bin/python3
"""A sweep from outside, as jobs of a Slurm of one node, and of GNU parallel: the bytes of one run on one machine."""
import os
import re
import shlex
import shutil
import subprocess
import sys
import time
import unittest

from program import PROGRAM, SOURCE, InFolder, run

JOBS = 4


def parts_named_in(text):
    return set(re.findall(r"part-\d+", text))


class Sweep(InFolder):
    """A sweep of more chunks than jobs, and the bytes that one run makes of it."""

    def setUp(self):
        super().setUp()
        self.case = self.file("map.toml", """
[specimen]
bending_stiffness = "1e-9 N m^2"
[rig]
span = "1 mm"
stiffness = "90 N/m"
[friction]
model = "sinusoid"
mu0 = 0.4
amplitude = 0.2
wavelength = "20 um"
[stage]
program = ["0 um", "600 um"]
[sweep]
method = "latin hypercube"
samples = 600
seed = 5
[sweep.axes]
mu0 = { from = 0.2, to = 0.6 }
stiffness = { from = "10 N/m", to = "1 kN/m", spacing = "log" }
""")
        self.map = self.folder / "map.h5"
        self.parts = self.folder / "map.h5.parts"
        whole = self.folder / "whole.h5"
        self.succeeds("sweep", self.case, "--output", whole, "--quiet")
        self.whole = whole.read_bytes()

    def shell(self, command):
        result = subprocess.run(command, shell=True, cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout.strip()


@unittest.skipUnless(shutil.which("parallel"), "no GNU parallel")
class Parallel(Sweep):
    def test_shards_of_gnu_parallel_are_one_run(self):
        sweep = shlex.join([PROGRAM, "sweep", str(self.case), "--output", str(self.map), "--threads", "1", "--quiet"])
        self.shell(f"parallel --jobs 2 --halt now,fail=1 {sweep} --shard {{}}/{JOBS} ::: $(seq {JOBS})")
        self.assertFalse(self.map.exists())
        self.succeeds("merge", self.parts)
        self.assertEqual(self.map.read_bytes(), self.whole)


class Slurm(Sweep):
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

    def setUp(self):
        super().setUp()
        self.addCleanup(self.leave_no_job)
        self.script = self.folder / "map.slurm"
        self.succeeds("sweep", self.case, "--output", self.map, "--slurm", self.script, "--shards", JOBS, "--threads", 1, "--quiet")

    def wait_until(self, reached):
        while not reached():
            if not self.shell("squeue --noheader"):  # nobody is left who could reach it
                self.assertTrue(reached(), self.shell("cat *.log"))
                return
            time.sleep(0.2)

    def leave_no_job(self):
        self.shell("squeue --noheader --format=%A | xargs --no-run-if-empty scancel")
        self.wait_for_jobs()

    def wait_for_jobs(self):
        self.wait_until(lambda: not self.shell("squeue --noheader"))

    def start_with_a_hanging_job(self):
        """Submits the script; its second job hangs half done, the first time that it runs. Returns that job's name."""
        hung = self.folder / "hung"
        half = shlex.join([PROGRAM, "sweep", str(self.case), "--output", str(self.map), "--shard", f"2/{2 * JOBS}"])
        program = self.file("program", f"""#!/bin/sh
case " $* " in
  *" --shard 2/{JOBS} "*) [ -e {hung} ] || {{ {half} && touch {hung} && exec sleep infinity; }} ;;
esac
exec {shlex.quote(PROGRAM)} "$@"
""")
        program.chmod(0o755)
        script = self.script.read_text(encoding="utf-8")
        self.script.write_text(re.sub("^FLEXSLIP=.*", f"FLEXSLIP={program}", script, flags=re.MULTILINE), encoding="utf-8")
        self.shell("bash map.slurm")
        self.wait_until(hung.exists)
        name, = [job for job in self.shell("squeue --noheader --states=RUNNING --format=%i").split() if job.endswith("_2")]
        return name

    def files_of_parts(self):
        """Each part by its name, as what a file has that is written again."""
        return {path.name: (path.stat().st_ino, path.stat().st_mtime_ns) for path in self.parts.glob("part-*")}

    def test_an_array_of_jobs_and_its_merge_are_one_run(self):
        self.shell("bash map.slurm")
        self.wait_for_jobs()
        self.assertEqual(self.map.read_bytes(), self.whole)
        self.assertFalse(self.parts.exists())

    def test_a_job_that_slurm_puts_back_into_the_queue_is_waited_for(self):
        self.shell(f"scontrol requeue {self.start_with_a_hanging_job()}")  # as when its computer fails
        self.wait_for_jobs()
        self.assertEqual(self.map.read_bytes(), self.whole)

    def test_what_a_killed_job_left_out_and_a_damaged_part_are_named_and_only_they_are_run_again(self):
        self.shell(f"scancel {self.start_with_a_hanging_job()}")
        self.wait_for_jobs()
        self.assertFalse(self.map.exists())
        log = (self.folder / "map.h5.log").read_text(encoding="utf-8")
        left_out = parts_named_in(log[log.index("is not written"):])
        kept = self.files_of_parts()
        damaged = self.parts / max(kept)
        damaged.write_bytes(damaged.read_bytes()[:-1] + b"?")
        del kept[damaged.name]
        merge = run("merge", self.parts)
        self.assertEqual(merge.returncode, 1)
        self.assertRegex(merge.stderr, rf"{damaged.name}\b.*damaged")

        self.shell("sbatch map.slurm")  # the jobs without their merge, which would remove the parts
        self.wait_for_jobs()
        now = self.files_of_parts()
        self.assertEqual({name for name in now if now[name] != kept.get(name)}, parts_named_in(merge.stderr))
        self.assertEqual(left_out | {damaged.name}, parts_named_in(merge.stderr))
        self.succeeds("merge", self.parts)
        self.assertEqual(self.map.read_bytes(), self.whole)


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    skipped = sorted({f"skipped: {reason}" for _, reason in result.skipped})
    print(*skipped, sep="\n", file=sys.stderr)
    sys.exit(1 if not result.wasSuccessful() else 77 if skipped else 0)
