#!/usr/bin/python3
"""outside: every command and code block of the documentation runs as it stands, page by page, in a folder of its own; which do not, and why, is listed here.
A block of text directly below a block of commands is what they print, or its first lines and a line "…"; FLEXSLIP_FREEZE=1 writes it anew.

Of a page, all blocks run in their order in one folder (those of Python and Octave as one session, after the commands) with copies of examples/, docs/figures and the exports of the tests, and with what PREPARED adds. Blocks of TOML are cases
(those of case-files.md are tried in outside/docs; the Python of scripting.md is tried in python/guide) and are read by the program; a first line "# NAME" saves one under that name."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib
import unittest

from program import PROGRAM, SOURCE, InFolder, numbers, run

FENCE = re.compile(r"^( *)```(\w*)\n(.*?)^ *```$", re.MULTILINE | re.DOTALL)
OUTPUT = re.compile(r"^```sh\n((?:(?!```).*\n)+)```\n```text\n((?:(?!```).*\n)+)```$", re.MULTILINE)
PAGES = sorted(path for path in [SOURCE / "README.md", SOURCE / "CONTRIBUTING.md", *(SOURCE / "docs").glob("*.md")] if path.name != "case-files.md")
# A block is named by its page and the words that it begins with.
NOT_RUN = {
    ("sweeps.md", "sbatch"): "outside/slurm runs it on a Slurm of its own",
    ("sweeps.md", "awk"): "outside/slurm and outside/sweep run it on the parts that they have made",
    ("studio.md", "./run studio"): "opens a browser on a page that is built apart; outside/studio_command writes such pages",
    ("README.md", "tar xf"): "installs on this machine, as that of getting-started.md",
    ("getting-started.md", "tar xf"): "installs on this machine; tools/try-package does it in a tree of its own, and ./check --all runs it",
    ("getting-started.md", "cmake --preset release"): "outside/library does the same from the build that is tested",
    ("scripting.md", "cmake --preset release"): "python/guide runs the module of the build that is tested",
}
TRIED_IN_GUIDE = {("scripting.md", "python")}  # python/guide also compares what they print
NO_CODE = {"", "text", "csv", "json", "html"}  # output, data, formulas
WITHOUT = {"matlab": "octave-cli"}  # languages whose program may be missing


def blocks(page):
    return [(language, re.sub(rf"^{indent}", "", body, flags=re.MULTILINE)) for indent, language, body in FENCE.findall(page.read_text(encoding="utf-8"))]


def reason_not_to(page, body):
    return next((reason for (name, words), reason in NOT_RUN.items() if page.name == name and body.startswith(words)), None)


def prepare(page, folder):
    """What a page takes for granted."""
    example = SOURCE / "examples/simulated"
    if page.name == "campaign.md":
        shutil.rmtree(folder / "tests")
        shutil.copytree(SOURCE / "examples", folder / "tests")
    if page.name == "planning-a-test.md":
        shutil.copy(SOURCE / "examples/design.toml", folder / "case.toml")
    if page.name == "README.md":
        bar = self_made("17 mm", "2 mm", "900 N/mm")
        (folder / "export.csv").write_text("Extension (mm),Load (N)\n" + "".join(f"{1e3 * x:.6f},{force:.6f}\n" for x, force in bar), encoding="utf-8")
        shutil.copy(example / "test.csv", folder / "my-test.csv")
        shutil.copytree(SOURCE / "examples", folder / "my-tests")
    if page.name == "sweeps.md":  # the case of the page, which stands below its call; coarser, as the same answers take a minute
        case = next(body for language, body in blocks(page) if language == "toml" and "[rig]" in body)
        (folder / "map.toml").write_text(case.replace("points = 50", "points = 5").replace("points = 40", "points = 4"), encoding="utf-8")


def self_made(span, diameter, stiffness):
    """Stage [m] and force [N] of a simulated bar."""
    case = f"""[specimen]\ndiameter = "{diameter}"\nmodulus = "3 GPa"\n[rig]\nspan = "{span}"\nstiffness = "{stiffness}"
[friction]\nmodel = "rough"\nmu0 = 0.4\nrms = 0.1\ncorrelation_length = "30 um"\nseed = 1\n[stage]\nprogram = ["0 mm", "8 mm"]\nstep = "20 um"\n"""
    text = run("simulate", "-", stdin=case).stdout
    return list(zip(numbers(text, "w_s [m]"), numbers(text, "F [N]")))


class Snippets(InFolder):
    def page_folder(self, page):
        folder = self.folder / page.stem
        (folder / "tests/instruments").mkdir(parents=True)
        shutil.copytree(SOURCE / "examples", folder / "examples")
        shutil.copytree(SOURCE / "tests/instruments/fixtures", folder / "tests/instruments/fixtures")
        (folder / "docs").mkdir()
        shutil.copytree(SOURCE / "docs/figures", folder / "docs/figures")
        programs = self.folder / "programs"
        programs.mkdir(exist_ok=True)
        if not (programs / "flexslip").exists():
            (programs / "flexslip").symlink_to(PROGRAM)
            (programs / "python3").symlink_to("/usr/bin/python3")
        # ./run is the program, and without arguments a fit of the example: outside/example has the script itself.
        (folder / "run").write_text(f'#!/bin/sh\nif [ $# -eq 0 ]; then exec "{PROGRAM}" fit examples/simulated/case.toml --report flexslip-report; fi\nexec "{PROGRAM}" "$@"\n')
        (folder / "run").chmod(0o755)
        prepare(page, folder)
        return folder

    def ran(self, page, folder, language, body):
        """Runs a block; nothing if its program is missing."""
        if language == "toml":
            name = re.match(r"# (\S+\.toml)\n", body)
            case = tomllib.loads(body)
            if name:
                (folder / name.group(1)).write_text(body, encoding="utf-8")
            return
        scripts = {"sh": ["bash", "-euo", "pipefail", "-c", body], "bash": ["bash", "-euo", "pipefail", "-c", body], "python": ["/usr/bin/python3", "-c", body],
                   "matlab": ["octave-cli", "--quiet", "--no-init-file", "--eval", body]}
        self.assertIn(language, scripts, f"{page.name}: no way to run a block of {language}")
        environment = {**os.environ, "PATH": f"{self.folder / 'programs'}:{os.environ['PATH']}", "FLEXSLIP": PROGRAM, "MPLBACKEND": "Agg",
                       "PYTHONPATH": f"{pathlib.Path(PROGRAM).parent / 'python'}"}
        done = subprocess.run(scripts[language], cwd=folder, env=environment, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, f"{page.name}:\n{body}\n{done.stdout[-600:]}\n{done.stderr[-1500:]}")
        return done.stdout

    def test_every_block_runs(self):
        counted = {"run": 0, "not run": 0, "compared": 0}
        for page in PAGES:
            code = [(language, body) for language, body in blocks(page) if language not in NO_CODE]
            if not code:
                continue
            with self.subTest(page.name):
                folder = self.page_folder(page)
                sessions = {}  # of languages whose later blocks go on with what earlier ones made
                outputs = dict(OUTPUT.findall(page.read_text(encoding="utf-8")))
                for language, body in code:
                    if (page.name, language) in TRIED_IN_GUIDE:
                        continue
                    reason = reason_not_to(page, body)
                    if not reason and shutil.which(WITHOUT.get(language, "sh")) is None:
                        reason = f"there is no {WITHOUT[language]} here"
                    if reason:
                        print(f"not run: {page.name}: {body.splitlines()[0][:60]}: {reason}", file=sys.stderr)
                        counted["not run"] += 1
                        continue
                    counted["run"] += 1
                    if language in ("sh", "toml"):
                        printed = self.ran(page, folder, language, body)
                        if body in outputs:
                            counted["compared"] += 1
                            self.compare(page, outputs[body], printed)
                    else:
                        sessions[language] = sessions.get(language, "") + body
                for language, body in sessions.items():
                    self.ran(page, folder, language, body)
        print(counted, file=sys.stderr)
        self.assertGreater(counted["run"], 25)
        self.assertGreater(counted["compared"], 8)

    def compare(self, page, shown, printed):
        """That the page shows what is printed, or its first lines."""
        *lines, last = shown.splitlines()
        now = "\n".join([*printed.splitlines()[:len(lines)], last]) + "\n" if last == "…" else printed
        if os.environ.get("FLEXSLIP_FREEZE"):
            page.write_text(page.read_text(encoding="utf-8").replace(f"```text\n{shown}```", f"```text\n{now}```"), encoding="utf-8")
        else:
            self.assertEqual(shown, now, page.name)

    def test_what_is_not_run_is_there(self):
        for (name, words), _ in NOT_RUN.items():
            page = next((page for page in PAGES if page.name == name), None)
            if page is not None:
                self.assertTrue(any(body.startswith(words) for _, body in blocks(page)), (name, words))


if __name__ == "__main__":
    if os.environ.get("FLEXSLIP_CONFIG") not in (None, "Release"):
        sys.exit(77)
    unittest.main()
