#!/usr/bin/python3
"""outside: no output replaces an input or another output of the same call, and a file is replaced by a whole one or not at all."""
import os
import pathlib
import re
import shutil
import stat
import subprocess
import sys
import unittest

from program import PROGRAM, SOURCE, WAVY, InFolder, run

EXAMPLE = SOURCE / "examples/simulated"
RECORD = '[record]\nfile = "test.csv"\nstage = "stage"\nforce = "force"\n'
SIMULATED = """[specimen]
bending_stiffness = "1e-9 N m^2"
[rig]
span = "1 mm"
stiffness = "90 N/m"
[friction]
model = "table"
file = "friction.csv"
length = "S [mm]"
mu = "mu"
[stage]
file = "stage.csv"
stage = "w_s [um]"
"""
AXES = '[sweep]\nmethod = "grid"\n[sweep.axes]\nmu0 = [0.3, 0.4]\n'


class NothingLost(InFolder):
    def setUp(self):
        super().setUp()
        for name in ("case.toml", "test.csv"):
            shutil.copy(EXAMPLE / name, self.folder / name)
        self.file("simulated.toml", SIMULATED)
        self.file("friction.csv", "S [mm],mu\n0.9,0.3\n2,0.5\n")
        self.file("stage.csv", "w_s [um]\n0\n50\n100\n")
        self.file("wavy.toml", WAVY)
        self.file("sweep.toml", WAVY + AXES)
        self.file("states.csv", "S,q\n1.05,0.2\n")
        self.file("points.csv", "w,F\n0.1,4\n")
        self.file("export.csv", "Displacement (mm),Force (N)\n0,0\n0.1,1\n0.2,2\n")

    def content(self):
        return {str(path.relative_to(self.folder)): path.read_bytes() for path in sorted(self.folder.rglob("*")) if path.is_file()}

    def nothing_is_written(self, *arguments, says, stdin=""):
        """Refused with all that is said, in one line, and every file is as it was."""
        before = self.content()
        result = subprocess.run([PROGRAM, *map(str, arguments)], input=stdin, capture_output=True, text=True, check=False,
                                cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (2, ""), (arguments, result.stderr))
        for words in (*says, "nothing has been written"):
            self.assertIn(words, result.stderr, arguments)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertEqual(self.content(), before, arguments)

    # Which outputs each command has, beside which inputs: held against what the program says of itself, below.
    def calls(self):
        """(command and inputs, the files it reads, its options that write)."""
        fit = ["case.toml", "test.csv"]
        simulate = ["simulated.toml", "friction.csv", "stage.csv"]
        return [
            (["fit", "case.toml"], fit, ["--output", "--profile", "--curves", "--draws", "--xlsx"]),
            (["modulus", "case.toml"], fit, ["--output"]),
            (["invert", "case.toml"], fit, ["--output"]),
            (["invert", "points.csv"], ["points.csv"], ["--output"]),
            (["state", "states.csv"], ["states.csv"], ["--output"]),
            (["read", "export.csv"], ["export.csv"], ["--output"]),
            (["simulate", "simulated.toml"], simulate, ["--output"]),
            (["design", "wavy.toml"], ["wavy.toml"], ["--output"]),
            (["equilibrium", "simulated.toml"], simulate, ["--output"]),
            (["sweep", "sweep.toml"], ["sweep.toml"], ["--output"]),
            (["campaign", "tests.csv", "--common", "common.toml"], ["tests.csv", "common.toml", "test.csv"], ["--output"]),
        ]

    def campaign(self):
        text = (EXAMPLE / "case.toml").read_text(encoding="utf-8")
        self.file("common.toml", text)
        self.file("tests.csv", "name,file\na,test.csv\n")

    def test_no_command_writes_over_what_it_reads(self):
        self.campaign()
        for call, inputs, options in self.calls():
            for name in inputs:
                for option in options:
                    with self.subTest(call=call, name=name, option=option):
                        self.nothing_is_written(*call, option, name, says=[option, name])

    def test_every_option_that_writes_is_tried(self):
        tried = {(call[0], option) for call, _, options in self.calls() for option in options}
        tried |= {("fit", "--report"), ("campaign", "--report")}  # below
        tried |= {(command, "--figure") for command in ("design", "simulate", "equilibrium")}  # below
        tried |= {("studio", "--output")}  # outside/studio_command
        tried |= {("completions", "--output"), ("keys", "--output"), ("results", "--output")}  # which read no file of the user's
        commands = re.findall(r"^  (\w+) ", run("--help").stdout.split("Commands:")[1], re.MULTILINE)
        self.assertGreaterEqual(len(commands), 12)
        reads = {"--common"}
        for command in commands:
            options = re.findall(r"^ .*?(--[\w-]+) (?:FILE|FOLDER|PICTURE)\b", run(command, "--help").stdout, re.MULTILINE)
            for option in set(options) - reads:
                self.assertIn((command, option), tried)
                tried.discard((command, option))
        self.assertEqual(tried, set())

    def test_nor_by_another_path_or_a_link(self):
        (self.folder / "below").mkdir()
        (self.folder / "symbolic.csv").symlink_to("test.csv")
        (self.folder / "chain.csv").symlink_to("below/../symbolic.csv")
        os.link(self.folder / "test.csv", self.folder / "hard.csv")
        (self.folder / "here").symlink_to(".")
        for name in ("./test.csv", "below/../test.csv", self.folder / "test.csv", "symbolic.csv", "chain.csv", "hard.csv",
                     "here/test.csv"):
            self.nothing_is_written("fit", "case.toml", "--curves", name, says=["--curves", str(name), "test.csv"])
        self.file("linked.toml", (self.folder / "case.toml").read_text().replace("test.csv", "chain.csv"))
        for name in ("test.csv", "symbolic.csv", "hard.csv"):
            self.nothing_is_written("fit", "linked.toml", "-o", name, says=["--output", name, "chain.csv"])

    def test_nor_over_another_output(self):
        for one, other in (("--curves", "--profile"), ("--curves", "--output"), ("--profile", "--output")):
            self.nothing_is_written("fit", "case.toml", one, "a.csv", other, "./a.csv", says=[one, other, "a.csv", "./a.csv"])
        (self.folder / "dangling").symlink_to("none yet.csv")
        self.nothing_is_written("fit", "case.toml", "--curves", "dangling", "--profile", "none yet.csv", says=["dangling", "none yet.csv"])
        self.nothing_is_written("fit", "case.toml", "--report", ".", "-o", "report.html", says=["--report", "--output", "report.html"])
        self.nothing_is_written("fit", "case.toml", "--report", "r", "-o", "r/figures/x.csv", says=["--report", "--output", "r/figures/x.csv"])
        for name in ("map.svg", "map.gp", "map-path.csv"):
            for order in (["-o", name, "--figure", "map.svg"], ["--figure", "map.svg", "-o", name]):
                self.nothing_is_written("simulate", "wavy.toml", *order, says=["--figure", "--output", name])

    def test_nor_what_lies_where_figures_go(self):
        figures = self.folder / "figures"
        figures.mkdir()
        shutil.move(self.folder / "test.csv", figures / "force-measured.csv")
        case = (self.folder / "case.toml").read_text()
        self.file("case.toml", case.replace("test.csv", "figures/force-measured.csv"))
        self.nothing_is_written("fit", "case.toml", "--report", ".", says=["--report", "figures/force-measured.csv"])
        # By a link that lies there, to a record that does not.
        shutil.move(figures / "force-measured.csv", self.folder / "test.csv")
        for link in (os.symlink, os.link):
            link(self.folder / "test.csv", figures / "force-measured.csv")
            self.file("case.toml", case)
            self.nothing_is_written("fit", "case.toml", "--report", ".", says=["--report", "figures/force-measured.csv", "test.csv"])
            (figures / "force-measured.csv").unlink()
        shutil.copy(self.folder / "wavy.toml", self.folder / "fig-case.csv")
        for command in ("simulate", "design", "equilibrium"):
            self.nothing_is_written(command, "fig-case.csv", "--figure", "fig.svg", says=["--figure", "fig-case.csv"])

    def test_nor_in_the_folder_of_a_campaigns_report(self):
        self.campaign()
        report = self.folder / "report"
        (report / "tests").mkdir(parents=True)
        self.nothing_is_written("campaign", "tests.csv", "--common", "common.toml", "--report", ".", says=["--report", "where no input may lie"])
        for name in ("tests.csv", "tests/a/fit.json", "figures/x"):
            self.nothing_is_written("campaign", "tests.csv", "--common", "common.toml", "--report", "report", "-o", f"report/{name}",
                                    says=["--report", "--output", name])
        os.link(self.folder / "test.csv", report / "campaign.json")
        self.nothing_is_written("campaign", "tests.csv", "--common", "common.toml", "--report", "report",
                                says=["--report", "report/campaign.json", "test.csv"])
        # A test that cannot be read is an input all the same.
        cases = self.folder / "cases"
        cases.mkdir()
        (cases / "broken.toml").write_text("[rig]\nspan = 3\n")
        self.nothing_is_written("campaign", "cases", "-o", "cases/broken.toml", says=["--output", "broken.toml"])

    def test_nor_where_the_shell_sends_standard_input_and_output(self):
        states = self.folder / "states.csv"
        before = states.read_bytes()
        with states.open("r", encoding="utf-8") as stdin:
            result = subprocess.run([PROGRAM, "state", "-", "-o", states], stdin=stdin, capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 2, result.stderr)
        with states.open("a", encoding="utf-8") as stdout:
            result = subprocess.run([PROGRAM, "state", states], stdout=stdout, stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("standard output", result.stderr)
        self.assertEqual(states.read_bytes(), before)

    def test_what_is_no_file_is_written_as_ever(self):
        expected = self.succeeds("state", self.folder / "states.csv")
        self.assertEqual(self.succeeds("state", self.folder / "states.csv", "-o", "/dev/stdout"), expected)
        self.assertEqual(self.succeeds("state", "/dev/stdin", "-o", "/dev/null", stdin="S,q\n1.05,0.2\n"), "")
        self.assertEqual(run("fit", self.folder / "case.toml", "--curves", "/dev/null", "--profile", "/dev/null", "-o", "/dev/null").returncode, 0)
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))
        for redirection in ("-o /dev/stdout > out", "-o >(cat > out)", "> out", "-o /dev/fd/3 3> out"):
            (self.folder / "out").unlink(missing_ok=True)
            subprocess.run(["bash", "-c", f'"$0" state states.csv {redirection}; wait $!; true', PROGRAM], cwd=self.folder, check=True)
            self.assertEqual((self.folder / "out").read_text(), expected, redirection)

    def test_a_file_is_replaced_with_its_permissions_and_through_its_link(self):
        old = self.file("old.csv", "old")
        old.chmod(0o640)
        (self.folder / "link.csv").symlink_to("old.csv")
        expected = self.succeeds("state", self.folder / "states.csv")
        self.succeeds("state", self.folder / "states.csv", "-o", self.folder / "link.csv")
        self.assertTrue((self.folder / "link.csv").is_symlink())
        self.assertEqual((old.read_text(), stat.S_IMODE(old.stat().st_mode)), (expected, 0o640))
        if os.geteuid() != 0:  # who may write anything
            old.chmod(0o440)
            self.refused("state", self.folder / "states.csv", "-o", old, says=["old.csv", "Permission denied"])

    def test_a_disk_that_is_full_leaves_the_old_file(self):
        """A disk of a few kilobytes, mounted where only this test sees it."""
        enter = ["unshare", "--user", "--map-root-user", "--mount"]
        if not shutil.which("unshare") or subprocess.run([*enter, "true"], capture_output=True, check=False).returncode != 0:
            self.skipTest("no namespaces of one's own")
        disk = self.folder / "disk"
        disk.mkdir()
        shutil.copytree(self.folder, self.folder / "all", ignore=lambda *_: ["all", "disk"])
        script = """
set -e
mount -t tmpfs -o size=8k none disk
echo old > disk/old
set +e
"$0" "$@" 2> message
echo $? > code
ls -A disk > names
cat disk/old > content
"""
        for call in (["simulate", "wavy.toml", "--energies", "-o", "disk/old"], ["simulate", "wavy.toml", "--json", "-o", "disk/old"],
                     ["fit", "case.toml", "--curves", "disk/old"], ["fit", "case.toml", "--profile", "disk/old"],
                     ["completions", "fish", "-o", "disk/old"], ["equilibrium", "wavy.toml", "-o", "disk/old"]):
            subprocess.run([*enter, "bash", "-c", script, PROGRAM, *call], cwd=self.folder, check=True, stdout=subprocess.DEVNULL)
            message = (self.folder / "message").read_text()
            self.assertIn("disk/old", message, call)
            self.assertEqual((self.folder / "code").read_text(), "2\n", (call, message))
            self.assertEqual((self.folder / "content").read_text(), "old\n", call)
            self.assertEqual((self.folder / "names").read_text(), "old\n", call)  # nothing half written stays behind


if __name__ == "__main__":
    if sys.platform != "linux" or not pathlib.Path("/dev/stdin").exists():
        print("skipped: no /dev/stdin")
        sys.exit(77)
    unittest.main()
