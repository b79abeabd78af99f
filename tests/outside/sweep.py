#!/usr/bin/python3
"""outside: sweeps: a grid or a sample of designs in, one table out, the same bytes for any rows and threads, whole or not at all."""
import io
import os
import pathlib
import pty
import re
import signal
import subprocess
import time
import unittest

import numpy
import pandas

from program import PROGRAM, SOURCE, WAVY, InFolder, run


def grid(stiffnesses, wavelengths):
    return WAVY + f"""[sweep]
method = "grid"
[sweep.axes]
stiffness = {{ from = "1 N/m", to = "100 N/m", points = {stiffnesses}, spacing = "log" }}
wavelength = {{ from = "40 um", to = "100 um", points = {wavelengths} }}
"""


def mixed(x):
    """splitmix64."""
    x = (x + 0x9e3779b97f4a7c15) % 2**64
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9 % 2**64
    x = (x ^ x >> 27) * 0x94d049bb133111eb % 2**64
    return x ^ x >> 31


def hypercube_point(samples, seed, parameter, row):
    """Where a row of a Latin hypercube lies on the axis of a parameter, in [0, 1)."""
    key = mixed(seed ^ mixed(parameter))
    half = max(1, ((samples - 1).bit_length() + 1) // 2)
    stratum = row
    while True:
        left, right = stratum >> half, stratum % 2**half
        for i in range(6):
            left, right = right, left ^ mixed(right ^ mixed((key + i) % 2**64)) % 2**half
        stratum = left << half | right
        if stratum < samples:
            return (stratum + (mixed(mixed(key) ^ row) >> 11) / 2**53) / samples


class Sweep(InFolder):
    def table(self, case, *arguments):
        """What a sweep writes, as a data frame with the columns of its CSV."""
        return pandas.read_csv(io.StringIO(self.succeeds("sweep", case, "--quiet", *arguments)), float_precision="round_trip")

    def test_a_grid_has_its_axes_in_order_and_all_outcomes(self):
        found = self.table(self.file("map.toml", "# a map\n" + grid(5, 4)))
        stiffness, wavelength = (found[title].to_numpy().reshape(5, 4) for title in ("stiffness [N/m]", "wavelength [m]"))
        # Max error of a logarithmic axis: 30 ulp.
        numpy.testing.assert_allclose(stiffness, numpy.geomspace(1, 100, 5)[:, None] + numpy.zeros(4), rtol=30 * 2.3e-16)
        numpy.testing.assert_allclose(wavelength, numpy.linspace(40e-6, 100e-6, 4) + numpy.zeros((5, 1)), rtol=4 * 2.3e-16)
        self.assertEqual(list(found.columns[:4]), ["stiffness [N/m]", "wavelength [m]", "status", "stage_reached [m]"])
        self.assertEqual(set(found["status"]), {"ok"})
        told = set(re.findall(r"`([a-z_]+)`", (SOURCE / "docs/results.md").read_text(encoding="utf-8").split("## sweep")[1].split("\n## ")[0]))
        self.assertLessEqual({title.split(" ")[0] for title in found.columns}, told)

    def test_the_page_on_sweeps_is_true(self):
        page = (SOURCE / "docs/sweeps.md").read_text(encoding="utf-8")
        grid_case, sample = re.findall(r"^```toml\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
        sampled = self.table(self.file("sample.toml", grid_case.split("[sweep]")[0] + sample.replace("100000", "100")))
        phase = numpy.sort(sampled["phase [rad]"]) / (2 * numpy.pi) * 100
        self.assertEqual(list(numpy.floor(phase)), list(range(100)))  # one in each stratum
        # The parts of two calls, put together by the line of the page.
        case = self.file("map.toml", grid(5, 4))
        for part, rows in (1, "1:9"), (10, "10:99"):  # named so that an alphabet orders them otherwise than numbers
            self.succeeds("sweep", case, "--rows", rows, "--quiet", "--output", self.folder / f"part-{part}.csv")
        line, = re.findall(r"^awk .*$", page, re.MULTILINE)
        subprocess.run(["bash", "-c", line], cwd=self.folder, check=True)
        self.assertEqual((self.folder / "map.csv").read_text(), self.succeeds("sweep", case, "--quiet"))

    def test_a_sweep_changed_by_set_is_the_one_that_says_so_itself(self):
        case = self.file("map.toml", grid(5, 4))
        itself = grid(5, 4).split("[sweep]")[0].replace("mu0 = 0.5", "mu0 = 0.4") + '[sweep]\nmethod = "grid"\n[sweep.axes]\nstiffness = ["5 N/m", "50 N/m"]\n'
        axes = 'sweep.axes={ stiffness = ["5 N/m", "50 N/m"] }'
        changed = self.succeeds("sweep", case, "--set", "friction.mu0=0.4", "--set", axes, "--quiet")
        self.assertEqual(changed, self.succeeds("sweep", self.file("itself.toml", itself), "--quiet"))
        self.assertEqual(len(self.table(case, "--set", 'sweep.axes.stiffness=["5 N/m"]')), 4)
        # The axes of a file stay in its order, and one that is new is the last.
        backwards = self.file("backwards.toml", WAVY + '[sweep]\nmethod = "grid"\n[sweep.axes]\nwavelength = ["50 um", "60 um"]\nmu0 = [0.3, 0.4]\n')
        found = self.table(backwards, "--set", "specimen.modulus=31 GPa", "--set", "sweep.axes.amplitude=[0.1, 0.2]", "--set", "sweep.axes.mu0=[0.5]")
        self.assertEqual(list(found.columns[:3]), ["wavelength [m]", "mu0", "amplitude"])
        self.assertEqual(found["amplitude"].tolist(), [0.1, 0.2, 0.1, 0.2])
        self.refused("sweep", case, "--set", "rig.stiffness=90 um", says=["--set: rig.stiffness"])
        self.refused("sweep", case, "--set", "sweep.axes.stifness=[1]", says=["stifness", "stiffness"])

    def test_a_sample_is_that_of_the_same_arithmetic_in_python(self):
        # As the test of the C++ has it, whose rows are too many for a file.
        self.assertEqual((hypercube_point(10**12, 2021, 0, 0), hypercube_point(10**12, 2021, 1, 10**12 - 1)),
                         (0.53816883311213548, 0.23677890445156818))
        sweep = '[sweep]\nmethod = "latin hypercube"\nsamples = 200\nseed = 7\n[sweep.axes]\n'
        found = self.table(self.file("sample.toml", WAVY + sweep + "mu0 = { from = 0, to = 1 }\namplitude = { from = 0, to = 1 }\n"))
        for parameter, name in enumerate(("mu0", "amplitude")):
            self.assertEqual(found[name].tolist(), [hypercube_point(200, 7, parameter, row) for row in range(200)])

    def test_a_row_is_what_simulating_its_case_gives(self):
        found = self.table(self.file("map.toml", grid(3, 2)))
        self.assertEqual(len(found), 6)
        for _, row in found.iterrows():
            text = WAVY.replace('"90 N/m"', f'"{row["stiffness [N/m]"]!r} N/m"').replace('"40 um"', f'"{row["wavelength [m]"]!r} m"')
            snaps = self.json("simulate", self.file("one.toml", text.replace('step = "4 um"', 'step = "continuous"')))["snaps"]
            self.assertEqual(row["snaps"], len(snaps))
            if snaps:
                # Both find the fold to the rounding of its conditions, where G' = 0: half the digits.
                self.assertAlmostEqual(row["first_snap_deflection [m]"] / snaps[0]["deflection_before"], 1, delta=1e-7)
                self.assertAlmostEqual(row["first_snap_stage [m]"] / snaps[0]["stage"], 1, delta=1e-9)

    def test_the_same_bytes_for_any_threads_and_rows(self):
        case = self.file("map.toml", grid(30, 40))
        titles, *rows = self.succeeds("sweep", case, "--quiet", "--threads", 1).splitlines(keepends=True)
        self.assertEqual(len(rows), 1200)
        self.assertEqual(self.succeeds("sweep", case, "--quiet", "--threads", 2), titles + "".join(rows))
        for first, last, count in (1, 1, 1), (700, 1200, 501), (1199, 5000, 2):
            part = self.succeeds("sweep", case, "--quiet", "--threads", 2, "--rows", f"{first}:{last}")
            self.assertEqual(part, titles + "".join(rows[first - 1:last]))
            self.assertEqual(part.count("\n"), 1 + count)

    def test_how_many_designs_have_which_status_is_a_remark(self):
        case = self.file("map.toml", grid(5, 4) + 'diameter = ["30 um", "2 mm"]\n')
        result = run("sweep", case, "--output", self.folder / "map.csv")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", "flexslip: 40 designs: 20 ok, 20 impossible\n"))
        found = pandas.read_csv(self.folder / "map.csv")
        self.assertTrue(found[found["status"] == "impossible"]["drops"].isna().all())
        self.assertTrue(found[found["status"] == "ok"]["drops"].notna().all())

    def test_interrupted_it_leaves_nothing(self):
        case = self.file("map.toml", grid(300, 200))
        for request in signal.SIGINT, signal.SIGTERM:
            output = self.file("map.csv", "an older map")
            process = subprocess.Popen([PROGRAM, "sweep", str(case), "--output", str(output)], stdout=subprocess.PIPE,
                                       stderr=subprocess.PIPE, text=True)
            while not list(self.folder.glob("map.csv.*")) and process.poll() is None:
                time.sleep(0.001)
            process.send_signal(request)
            out, err = process.communicate()
            self.assertEqual((process.returncode, out, err), (130, "", f"flexslip: interrupted; {output} is not written\n"))
            self.assertEqual(output.read_text(), "an older map")
            self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["map.csv", "map.toml"])

    def test_progress_is_shown_on_a_terminal_and_erased(self):
        case = self.file("map.toml", grid(300, 200))
        try:
            terminal, end = pty.openpty()
        except OSError as error:
            self.skipTest(f"no terminal to be had: {error}")
        process = subprocess.Popen([PROGRAM, "sweep", str(case), "--output", str(self.folder / "map.csv")],
                                   stdout=subprocess.DEVNULL, stderr=end)
        os.close(end)
        said, shown = b"", False
        try:
            while chunk := os.read(terminal, 10000):
                said += chunk
                if b" left\r" in said and not shown:
                    process.send_signal(signal.SIGINT)
                    shown = True
        except OSError:  # its other end is closed
            pass
        process.wait()
        os.close(terminal)
        erase = r"\x1b\[K"
        self.assertRegex(said.decode(), rf"\A({erase}\d+ of 60000 designs, [^\r\n]+ left\r)+{erase}flexslip: interrupted")

    @unittest.skipUnless(pathlib.Path("/dev/full").exists(), "a disk that is always full")
    def test_a_disk_that_is_full_is_told(self):
        result = run("sweep", self.file("map.toml", grid(20, 20)), "--output", "/dev/full", "--quiet")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("/dev/full", result.stderr)

    def test_what_cannot_be_is_refused_before_it_starts(self):
        case = self.file("map.toml", grid(5, 4))
        for rows in ("0:3", "4:3", "1", "a:b", "1:3:4", "-1:3", "1:", ":9"):
            self.refused("sweep", case, f"--rows={rows}", "--output", self.folder / "map.csv", says=["--rows", "FIRST:LAST", rows])
        self.refused("sweep", case, "--rows", "21:30", "--output", self.folder / "map.csv", says=["--rows", "The first row is 21, but the sweep has 20"])
        self.refused("sweep", case, "--output", case, says=["--output", "map.toml"])
        self.refused("sweep", self.file("plain.toml", WAVY), says=["plain.toml", "[sweep]", "Add [sweep]"])
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["map.toml", "plain.toml"])


if __name__ == "__main__":
    unittest.main()
