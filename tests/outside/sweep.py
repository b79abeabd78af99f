#!/usr/bin/python3
"""Sweeps from outside: a grid of designs in, one HDF5 file out, the same bytes whatever happened on the way."""
import json
import os
import pathlib
import pty
import random
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest

from program import PROGRAM, SOURCE, WAVY, InFolder, run

try:
    import h5py
    import numpy
except ImportError:
    print("skipped: no python3-h5py")
    sys.exit(77)


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


def peak_memory(*arguments):
    """[bytes] of the program, run to its end."""
    process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    assert process.returncode == 0
    return 1024 * usage.ru_maxrss


def told(result):
    """What there is in an answer."""
    return {key: value for key, value in json.loads(result.stdout).items() if value is not None}


class Sweep(InFolder):
    def sweep(self, case, name, *arguments):
        """The bytes of the file that a sweep ends in."""
        output = self.folder / name
        self.succeeds("sweep", case, "--output", output, "--quiet", *arguments)
        self.assertFalse((self.folder / f"{name}.parts").exists())
        return output.read_bytes()

    def test_the_file_says_all_that_is_needed_to_read_it(self):
        case = self.file("map.toml", "# a map\n" + grid(5, 4))
        self.sweep(case, "map.h5")
        with h5py.File(self.folder / "map.h5") as file:
            self.assertEqual(file.attrs["case"], case.read_text())
            self.assertEqual((file.attrs["method"], list(file.attrs["axes"])), ("grid", ["stiffness", "wavelength"]))
            self.assertEqual((list(file.attrs["shape"]), file.attrs["rows"]), ([5, 4], 20))
            self.assertIn("FlexSlip", file.attrs["program"])
            stiffness, wavelength = (file["axes"][name][:] for name in file.attrs["axes"])
            # Max error of a logarithmic axis: 30 ulp.
            numpy.testing.assert_allclose(stiffness, numpy.geomspace(1, 100, 5), rtol=30 * 2.3e-16)
            numpy.testing.assert_allclose(wavelength, numpy.linspace(40e-6, 100e-6, 4), rtol=4 * 2.3e-16)
            inputs = file["inputs"]
            numpy.testing.assert_array_equal(inputs["stiffness"][:].reshape(5, 4), stiffness[:, None] + 0 * wavelength)
            numpy.testing.assert_array_equal(inputs["wavelength"][:].reshape(5, 4), wavelength + 0 * stiffness[:, None])
            for column in (*inputs.values(), *file["outcomes"].values()):
                self.assertEqual(column.shape, (20,))
                self.assertTrue(column.attrs["units"] and column.attrs["description"])
                self.assertEqual((column.compression, column.shuffle, column.fletcher32), ("gzip", True, True))
            self.assertEqual(file["outcomes/status"].attrs["meanings"][0], "ok")

    def test_the_page_on_sweeps_is_true(self):
        page = (SOURCE / "docs/sweeps.md").read_text(encoding="utf-8")
        grid_case, sample = re.findall(r"^```toml\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
        of_grid, of_sample = re.findall(r"^```python\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
        smaller = grid_case.replace("points = 50", "points = 5").replace("points = 40", "points = 4")
        self.sweep(self.file("map.toml", smaller), "map.h5")
        found = {}
        exec(of_grid.replace('"map.h5"', repr(str(self.folder / "map.h5"))), found)
        self.assertEqual((found["drops"].shape, found["stiffness"].shape, found["wavelength"].shape), ((5, 4, 3), (5,), (4,)))
        sampled = grid_case.split("[sweep]")[0] + sample.replace("100000", "100")
        self.sweep(self.file("sample.toml", sampled), "sample.h5")
        with h5py.File(self.folder / "sample.h5") as file:
            self.assertEqual((file.attrs["method"], file.attrs["seed"], file.attrs["rows"]), ("latin hypercube", 1, 100))
            phase = numpy.sort(file["inputs/phase"][:]) / (2 * numpy.pi) * 100
            self.assertEqual(list(numpy.floor(phase)), list(range(100)))  # one in each stratum
            names = {f"/{group}/{name}" for group in file for name in file[group]}
            soft = file["inputs/stiffness"][:] < 100
            expected = (file["outcomes/snaps"][:][soft] > 0).mean()
        exec(of_sample.replace('"sample.h5"', repr(str(self.folder / "sample.h5"))), found)
        self.assertEqual(found["share"], expected)
        told = set(re.findall(r"`/?(?:outcomes/)?([a-z_]+)`", page.split("## What it writes")[1].split("```")[0]))
        told |= set(re.findall(r"`([a-z_]+)`", (SOURCE / "docs/results.md").read_text(encoding="utf-8").split("## sweep, HDF5")[1].split("\n## ")[0]))
        self.assertLessEqual({name.split("/")[-1] for name in names if "outcomes" in name}, told)

    def test_a_sweep_changed_by_set_is_the_one_that_says_so_itself(self):
        case = self.file("map.toml", grid(5, 4))
        itself = grid(5, 4).split("[sweep]")[0].replace("mu0 = 0.5", "mu0 = 0.4") + '[sweep]\nmethod = "grid"\n[sweep.axes]\nstiffness = ["5 N/m", "50 N/m"]\n'
        axes = 'sweep.axes={ stiffness = ["5 N/m", "50 N/m"] }'
        self.sweep(case, "a.h5", "--set", "friction.mu0=0.4", "--set", axes)
        self.sweep(self.file("itself.toml", itself), "b.h5")
        with h5py.File(self.folder / "a.h5") as changed, h5py.File(self.folder / "b.h5") as said:
            self.assertEqual(list(changed.attrs["axes"]), ["stiffness"])
            self.assertEqual((changed.attrs["case"], list(changed.attrs["changes"])), (case.read_text(), ["friction.mu0=0.4", axes]))
            for group in "inputs", "outcomes":
                for column in said[group]:
                    numpy.testing.assert_array_equal(changed[group][column][:], said[group][column][:])
        self.sweep(case, "c.h5", "--set", 'sweep.axes.stiffness=["5 N/m"]')
        with h5py.File(self.folder / "c.h5") as changed:
            self.assertEqual(list(changed.attrs["shape"]), [1, 4])
        # The axes of a file stay in its order, and one that is new is the last.
        backwards = self.file("backwards.toml", WAVY + '[sweep]\nmethod = "grid"\n[sweep.axes]\nwavelength = ["50 um", "60 um"]\nmu0 = [0.3, 0.4]\n')
        self.sweep(backwards, "e.h5", "--set", "specimen.modulus=31 GPa", "--set", "sweep.axes.amplitude=[0.1, 0.2]", "--set", "sweep.axes.mu0=[0.5]")
        with h5py.File(self.folder / "e.h5") as changed:
            self.assertEqual((list(changed.attrs["axes"]), list(changed.attrs["shape"])), (["wavelength", "mu0", "amplitude"], [2, 1, 2]))
        self.refused("sweep", case, "--output", self.folder / "d.h5", "--set", "rig.stiffness=90 um", says=["--set: rig.stiffness"])
        self.refused("sweep", case, "--output", self.folder / "d.h5", "--set", "sweep.axes.stifness=[1]", says=["stifness", "stiffness"])

    def test_a_sample_is_that_of_the_same_arithmetic_in_python(self):
        # As the test of the C++ has it, whose rows are too many for a file.
        self.assertEqual((hypercube_point(10**12, 2021, 0, 0), hypercube_point(10**12, 2021, 1, 10**12 - 1)),
                         (0.53816883311213548, 0.23677890445156818))
        sweep = '[sweep]\nmethod = "latin hypercube"\nsamples = 200\nseed = 7\n[sweep.axes]\n'
        axes = "mu0 = { from = 0, to = 1 }\namplitude = { from = 0, to = 1 }\n"
        self.sweep(self.file("sample.toml", WAVY + sweep + axes), "sample.h5")
        with h5py.File(self.folder / "sample.h5") as file:
            for parameter, name in enumerate(("mu0", "amplitude")):
                self.assertEqual(list(file["inputs"][name]), [hypercube_point(200, 7, parameter, row) for row in range(200)])

    def test_a_row_is_what_simulating_its_case_gives(self):
        self.sweep(self.file("map.toml", grid(3, 2)), "map.h5")
        with h5py.File(self.folder / "map.h5") as file:
            rows = list(zip(file["inputs/stiffness"], file["inputs/wavelength"]))
            outcomes = {name: column[:] for name, column in file["outcomes"].items()}
        for i, (stiffness, wavelength) in enumerate(rows):
            text = WAVY.replace('"90 N/m"', f'"{float(stiffness)!r} N/m"').replace('"40 um"', f'"{float(wavelength)!r} m"')
            answer = self.json("simulate", self.file("one.toml", text.replace('step = "4 um"', 'step = "continuous"')))
            snaps = answer["snaps"]
            self.assertEqual(outcomes["snaps"][i], len(snaps))
            if snaps:
                # Both find the fold to the rounding of its conditions, where G' = 0: half the digits.
                self.assertAlmostEqual(outcomes["first_snap_deflection"][i] / snaps[0]["deflection_before"], 1, delta=1e-7)
                self.assertAlmostEqual(outcomes["first_snap_stage"][i] / snaps[0]["stage"], 1, delta=1e-9)

    def test_the_same_bytes_from_any_threads_and_shards(self):
        case = self.file("map.toml", grid(30, 40))
        one = self.sweep(case, "one.h5", "--threads", 1)
        self.assertEqual(self.sweep(case, "two.h5", "--threads", 2), one)
        seven = self.folder / "seven.h5"
        for shard in random.Random(7).sample(range(1, 8), 7):
            said = self.succeeds("sweep", case, "--output", seven, "--shard", f"{shard}/7", "--threads", 2, "--quiet")
            self.assertIn(f"shard {shard} of 7", said)
        self.assertFalse(seven.exists())
        self.assertIn("1200 designs", self.succeeds("merge", f"{seven}.parts"))
        self.assertEqual(seven.read_bytes(), one)
        self.assertIn(", the file of a sweep", run("merge", f"{seven}.parts").stderr)  # as a job that is run again would
        self.assertIn("complete already", run("sweep", case, "--output", seven).stderr)
        self.assertEqual(seven.read_bytes(), one)

    def test_shards_computed_apart_are_joined(self):
        case = self.file("map.toml", grid(20, 20))
        whole = self.sweep(case, "whole.h5")
        self.refused("sweep", case, "--output", self.folder / "place1/map.h5", says=["place1/map.h5.parts"])  # a folder misspelt is not made
        for i in (1, 2):
            (self.folder / f"place{i}").mkdir()
            self.succeeds("sweep", case, "--output", self.folder / f"place{i}/map.h5", "--shard", f"{i}/2")
        folders = [self.folder / f"place{i}/map.h5.parts" for i in (1, 2)]
        self.succeeds("merge", *folders, "--output", self.folder / "joined.h5", "--keep-parts")
        self.assertEqual((self.folder / "joined.h5").read_bytes(), whole)
        self.assertTrue(all(folder.exists() for folder in folders))

    def test_killed_at_twenty_random_moments_it_loses_nothing(self):
        case = self.file("map.toml", grid(60, 50))
        start = time.monotonic()
        whole = self.sweep(case, "whole.h5", "--threads", 2)
        duration = time.monotonic() - start
        output, parts = self.folder / "map.h5", self.folder / "map.h5.parts"
        call = ["sweep", case, "--output", output, "--threads", 2, "--quiet"]
        moments = random.Random(2021)
        done = set()
        kills = 0
        while kills < 20:
            if output.exists():  # done before it was killed often enough: once more
                output.unlink()
                done = set()
            process = subprocess.Popen([PROGRAM, *map(str, call)], stdout=subprocess.DEVNULL, start_new_session=True)
            try:
                process.wait(moments.uniform(0, 0.25 * duration))
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
                kills += 1
            kept = {path.name for path in parts.glob("part-??????")} if parts.exists() else set()
            self.assertTrue(output.exists() or kept >= done)
            done = kept
        self.succeeds(*call)
        self.assertEqual(output.read_bytes(), whole)
        self.assertFalse(parts.exists())

    def test_interrupted_it_says_how_to_go_on(self):
        case = self.file("map.toml", grid(300, 200))
        output = self.folder / "map.h5"
        process = subprocess.Popen([PROGRAM, "sweep", str(case), "--output", str(output)], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        while not any(self.folder.glob("map.h5.parts/part-??????")) and process.poll() is None:
            time.sleep(0.001)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate()
        self.assertEqual((process.returncode, out), (130, ""), err)
        self.assertIn("the same command continues from there", err)
        self.assertFalse(output.exists())
        self.assertTrue(list(self.folder.glob("map.h5.parts/part-??????")))

    def test_progress_is_shown_on_a_terminal_and_erased(self):
        case = self.file("map.toml", grid(300, 200))
        try:
            terminal, end = pty.openpty()
        except OSError as error:
            self.skipTest(f"no terminal to be had: {error}")
        process = subprocess.Popen([PROGRAM, "sweep", str(case), "--output", str(self.folder / "map.h5")],
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

    def test_parts_damaged_or_missing_are_named_and_they_alone_are_computed_again(self):
        case = self.file("map.toml", grid(20, 40))  # 13 parts of 64 rows
        output, parts = self.folder / "map.h5", self.folder / "map.h5.parts"
        whole = self.sweep(case, "whole.h5")
        self.succeeds("sweep", case, "--output", output, "--shard", "1/1")
        flipped, truncated, deleted = (parts / f"part-{number:06}" for number in (2, 5, 13))
        content = bytearray(flipped.read_bytes())
        content[len(content) // 2] ^= 16
        flipped.write_bytes(content)
        truncated.write_bytes(truncated.read_bytes()[:-100])
        deleted.unlink()
        before = {path: path.stat().st_mtime_ns for path in parts.iterdir()}

        result = run("merge", parts)
        self.assertEqual((result.returncode, result.stdout), (1, ""))
        for words in ("of 13 parts, 1 are missing and 2 are damaged", f"{flipped}, rows 65 to 128: damaged",
                      f"{truncated}, rows 257 to 320: damaged", f"{deleted}, rows 769 to 800: missing",
                      f"flexslip sweep {case} --output {output}"):
            self.assertIn(words, result.stderr)
        self.assertFalse(output.exists())
        faults = json.loads(run("merge", parts, "--json").stdout)["faults"]
        self.assertEqual([(fault["rows"], fault["state"]) for fault in faults],
                         [([65, 128], "damaged"), ([257, 320], "damaged"), ([769, 800], "missing")])

        result = run("sweep", case, "--output", output, "--shard", "1/1")
        self.assertEqual(result.returncode, 0)
        self.assertIn(f"{flipped} is damaged and is computed again", result.stderr)
        self.assertIn("640 of 800 designs were computed by an earlier run", result.stderr)
        changed = {path for path in parts.iterdir() if before.get(path) != path.stat().st_mtime_ns}
        self.assertEqual(changed, {flipped, truncated, deleted})
        self.succeeds("merge", parts)
        self.assertEqual(output.read_bytes(), whole)

    @unittest.skipUnless(pathlib.Path("/dev/full").exists(), "a disk that is always full")
    def test_a_disk_that_is_full_loses_nothing(self):
        case = self.file("map.toml", grid(20, 20))
        output = self.folder / "map.h5"
        whole = self.sweep(case, "whole.h5")
        (self.folder / "map.h5.unfinished").symlink_to("/dev/full")
        # HDF5 1.10 does not free all that it had to write to a file that cannot be written.
        result = subprocess.run([PROGRAM, "sweep", case, "--output", output], capture_output=True, text=True, check=False,
                                env={**os.environ, "ASAN_OPTIONS": "detect_leaks=0"})
        self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
        self.assertIn("map.h5.unfinished cannot be written: No space left on device", result.stderr)
        self.assertEqual(run("sweep", case, "--output", output).stdout, f"{output}: 400 designs (400 ok)\n")
        self.assertEqual(output.read_bytes(), whole)

    def test_two_merges_at_once_do_not_spoil_each_others_file(self):
        case = self.file("map.toml", grid(20, 20))
        whole = self.sweep(case, "whole.h5")
        output = self.folder / "map.h5"
        unfinished = self.folder / "map.h5.unfinished"
        self.succeeds("sweep", case, "--output", output, "--shard", "1/1")
        with h5py.File(unfinished, "w") as file:  # which locks it, as a merge does
            file["written"] = numpy.arange(1000)
            file.flush()
            before = unfinished.read_bytes()
            self.refused("merge", f"{output}.parts", says=["map.h5", "is being written by another program", "another --output"])
            self.assertEqual(unfinished.read_bytes(), before)
        # What is left of a merge that was killed is replaced; also where HDF5 is told to lock what is locked already.
        subprocess.run([PROGRAM, "merge", f"{output}.parts"], check=True, stdout=subprocess.DEVNULL,
                       env={**os.environ, "HDF5_USE_FILE_LOCKING": "TRUE"})
        self.assertEqual(output.read_bytes(), whole)
        self.assertFalse(unfinished.exists())

    def test_a_merge_replaces_the_file_of_its_sweep(self):
        case = self.file("map.toml", grid(20, 20))
        output = self.folder / "map.h5"
        self.succeeds("sweep", case, "--output", output, "--keep-parts")
        whole = output.read_bytes()
        run("merge", f"{output}.parts", "--keep-parts")
        self.assertEqual(output.read_bytes(), whole)
        # A whole set of parts is left where it is, whatever the file says: it may be the only good copy.
        result = run("sweep", case, "--output", output, "--json")
        self.assertEqual(told(result), {"status": "done", "file": str(output), "rows": 400, "faults": []})
        self.assertIn("its parts are still in", result.stderr)
        output.unlink()
        run("merge", f"{output}.parts/")
        self.assertEqual(output.read_bytes(), whole)
        self.assertEqual(told(run("merge", f"{output}.parts", "--json")), {"status": "done", "file": str(output), "faults": []})

    def test_nothing_that_is_read_is_written_over(self):
        case = self.file("map.toml", grid(5, 4))
        for option in ("--output", "--slurm"):
            self.refused("sweep", case, option, case, says=[option if option == "--slurm" else "map.toml"])
        self.refused("design", case, "--output", case, says=["--output", "an output other than"])
        self.assertEqual(case.read_text(encoding="utf-8"), grid(5, 4))
        self.succeeds("sweep", case, "--output", self.folder / "map.h5", "--shard", "1/1")
        self.refused("merge", self.folder / "map.h5.parts", "--output", self.folder / "map.h5.parts" / "part-result.h5",
                     says=["--output", "a file outside the folder of parts"])
        self.refused("sweep", case, "--output", "", says=["--output", "a file"])
        self.refused("sweep", case, "--output", "-", says=["--output", "a file"])

    def test_only_parts_are_removed(self):
        case = self.file("map.toml", grid(5, 4))
        self.succeeds("sweep", case, "--output", self.folder / "map.h5", "--shard", "1/1")
        notes = self.file("map.h5.parts/part-of-my-notes.txt", "kept")
        self.assertEqual(run("sweep", case, "--output", self.folder / "map.h5").returncode, 0)
        self.assertEqual([file.name for file in notes.parent.iterdir()], [notes.name])
        self.assertEqual(run("sweep", case, "--output", self.folder / "map.h5").returncode, 0)  # and once more

    def test_two_sweeps_at_once_end_with_the_file(self):
        case = self.file("map.toml", grid(100, 60))
        whole = self.sweep(case, "whole.h5")
        both = [subprocess.Popen([PROGRAM, "sweep", str(case), "--output", str(self.folder / "map.h5"), "--threads", "1"],
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) for _ in range(2)]
        codes = [process.wait() for process in both]
        self.assertIn(0, codes)
        self.assertEqual(run("sweep", case, "--output", self.folder / "map.h5").returncode, 0)  # whatever the slower one left
        self.assertEqual((self.folder / "map.h5").read_bytes(), whole)

    def test_a_damaged_label_is_told(self):
        case = self.file("map.toml", grid(5, 4))
        self.succeeds("sweep", case, "--output", self.folder / "map.h5", "--shard", "1/1")
        label = self.folder / "map.h5.parts" / "sweep.json"
        label.write_text(label.read_text(encoding="utf-8").replace("100 N/m", "200 N/m"), encoding="utf-8")
        self.refused("merge", self.folder / "map.h5.parts", says=["map.h5.parts", "a damaged sweep.json"])

    def test_a_foreign_file_is_no_sweep_whatever_it_says(self):
        case = self.file("map.toml", grid(5, 4))
        with h5py.File(self.folder / "map.h5", "w") as file:
            file.attrs["plan"] = ["not this one"] * 2000
        self.refused("sweep", case, "--output", self.folder / "map.h5", says=["map.h5", "another file"])

    def test_another_sweep_is_not_mixed_in(self):
        case, other = self.file("map.toml", grid(5, 4)), self.file("other.toml", grid(5, 5))
        output = self.folder / "map.h5"
        self.succeeds("sweep", case, "--output", output, "--shard", "1/1")
        self.refused("sweep", other, "--output", output, says=["map.h5.parts", "those of another one", "another --output"])
        self.succeeds("merge", f"{output}.parts")
        self.refused("sweep", other, "--output", output, says=["map.h5", "the file of another sweep", "another --output"])
        mine = self.file("mine.h5", "my notes")
        self.refused("sweep", case, "--output", mine, says=["mine.h5", "another file", "another --output"])
        self.assertEqual(mine.read_text(), "my notes")
        self.succeeds("sweep", case, "--output", self.folder / "a.h5", "--shard", "1/1")
        self.succeeds("sweep", other, "--output", self.folder / "b.h5", "--shard", "1/1")
        self.refused("merge", self.folder / "a.h5.parts", self.folder / "b.h5.parts", says=["b.h5.parts", "leave it out"])

    @unittest.skipUnless(shutil.which("parallel"), "skipped: no GNU parallel")
    def test_the_line_for_gnu_parallel_is_true(self):
        case = self.file("map.toml", grid(20, 20))
        line, = re.findall("^parallel flexslip .*$", (SOURCE / "docs/sweeps.md").read_text(encoding="utf-8"), re.MULTILINE)
        path = f"{pathlib.Path(PROGRAM).resolve().parent}:{os.environ['PATH']}"
        subprocess.run(["bash", "-c", line], cwd=self.folder, env={**os.environ, "PATH": path, "HOME": str(self.folder)}, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.assertEqual((self.folder / "map.h5").read_bytes(), self.sweep(case, "whole.h5"))

    def test_what_cannot_be_is_refused_before_it_starts(self):
        case = self.file("huge.toml", grid(1000000, 1000000))
        self.refused("sweep", case, "--output", self.folder / "map.h5",
                     says=["huge.toml:16: [sweep]", "1000000000000 designs", "TB", "free in", "take fewer points"])
        self.assertEqual(list(self.folder.iterdir()), [case])
        case = self.file("map.toml", grid(5, 4))
        for shard in ("0/3", "4/3", "1", "a/b", "1/3/4", "-1/3"):
            self.refused("sweep", case, f"--shard={shard}", "--output", self.folder / "map.h5", says=["--shard", "I/N"])
        self.refused("sweep", self.file("plain.toml", WAVY), says=["plain.toml", "[sweep]", "add [sweep]"])
        self.refused("sweep", "-", stdin=grid(5, 4), says=["--output"])
        self.refused("merge", self.folder / "none.parts", says=["none.parts", "no such folder"])
        self.refused("merge", self.folder, says=["--output"])
        self.refused("sweep", case, "--output", case / "map.h5", says=["map.h5.parts", "cannot be written"])

    @unittest.skipUnless(os.environ.get("FLEXSLIP_CONFIG", "Release") == "Release", "sanitizers keep memory")
    def test_memory_does_not_grow_with_the_designs(self):
        # Shorter paths: it is not they that are measured.
        short = WAVY.replace('"200 um"', '"20 um"').replace("0.3\n", "0.01\n")
        sweep = '[sweep]\nmethod = "latin hypercube"\nsamples = {}\nseed = 1\n[sweep.axes]\nmu0 = {{ from = 0.1, to = 0.9 }}\n'
        peaks = [peak_memory("sweep", self.file(f"{rows}.toml", short + sweep.format(rows)), "--quiet", "--output",
                             self.folder / f"{rows}.h5") for rows in (10_000, 100_000)]
        # The outcomes of the larger one alone are 12 MB; a chunk of each column in HDF5 takes 4 MB, where it is full.
        self.assertLess(peaks[1] - peaks[0], 8e6, peaks)

    def test_a_script_for_slurm_is_one_for_a_shell(self):
        case = self.file("my 'map'.toml", grid(50, 50))
        script = self.folder / "map.slurm"
        said = run("sweep", case, "--output", self.folder / "map.h5", "--slurm", script, "--shards", 3, "--threads", 2)
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertIn("jobs: 3", said.stderr)
        text = script.read_text()
        for line in ("#SBATCH --array=1-3", "#SBATCH --cpus-per-task=2"):
            self.assertIn(line + "\n", text)
        for name in ('a"b.h5', "a\nb.h5", "a\\b.h5"):
            self.refused("sweep", case, "--output", self.folder / name, "--slurm", script, "--shards", 3,
                         says=["--output", "double quotes", "pass another"])
        # An sbatch that keeps what it is told, and jobs that are run by hand.
        calls = self.folder / "calls"
        sbatch = self.file("sbatch", f'#!/bin/bash\nprintf "%s\\n" "$*" >> {calls}\necho 41\n')
        sbatch.chmod(0o755)
        environment = {**os.environ, "PATH": f"{self.folder}:{os.environ['PATH']}"}
        environment.pop("SLURM_ARRAY_TASK_ID", None)
        subprocess.run(["bash", script], env=environment, check=True, stdout=subprocess.DEVNULL)
        array, merge = calls.read_text().splitlines()
        self.assertEqual(array, f"--parsable {script}")
        self.assertIn("--dependency=afterany:41", merge)
        self.assertTrue(merge.endswith(f"{script} merge"), merge)  # with the account and partition of the script
        for task in (1, 2, 3):
            subprocess.run(["bash", script], check=True, stdout=subprocess.DEVNULL,
                           env={**environment, "SLURM_ARRAY_TASK_ID": str(task), "SLURM_CPUS_PER_TASK": "2"})
        subprocess.run(["bash", script, "merge"], check=True, stdout=subprocess.DEVNULL, env={**environment, "SLURM_ARRAY_TASK_ID": "0"})
        self.assertEqual((self.folder / "map.h5").read_bytes(), self.sweep(case, "again.h5"))


if __name__ == "__main__":
    unittest.main()
