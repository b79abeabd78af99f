#!/usr/bin/python3
"""What every command answers to the shipped examples is what stands in golden/, to the last bit.

An answer that is meant to change is frozen anew, in the commit that says why: `FLEXSLIP=… SOURCE_DIR=… tests/outside/golden.py --freeze`.
Long tables and arrays stand there by their first and last rows and a digest."""
import difflib
import hashlib
import json
import os
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

from program import SOURCE, WAVY, run

GOLDEN = pathlib.Path(__file__).resolve().parent / "golden"

ON_ROLLERS = """[specimen]
width = "10 mm"
height = "4 mm"
modulus = "3 GPa"
strain_at_break = "12 %"
[rig]
span = "64 mm"
stiffness = "50 N/mm"
roller_radius = "5 mm"
nose_radius = "5 mm"
[friction]
model = "sinusoid"
mu0 = 0.3
amplitude = 0.2
wavelength = "1 mm"
[stage]
program = ["0 mm", "20 mm", "2 mm"]
step = "0.5 mm"
"""
TWO_SUPPORTS = WAVY.replace("[rig]\n", '[rig]\nnose = "free"\n').replace("[stage]", '[friction.other]\nmodel = "constant"\nmu0 = 0.35\n[stage]').replace('"200 um"]', '"300 um", "50 um"]')
REDUCED = 'reduced = true\n[rig]\nstiffness = 30\n[friction]\nmodel = "rough"\nmu0 = 0.6\nrms = 0.1\ncorrelation_length = 0.01\nseed = 3\n[stage]\nprogram = [0, 0.5, 0.2]\nstep = "continuous"\n'
SWEEP = WAVY + '[sweep]\nmethod = "grid"\n[sweep.axes]\nmu0 = [0.3, 0.4]\nstiffness = { from = "10 N/m", to = "1 kN/m", points = 3, spacing = "log" }\n'
FILES = {"rollers.toml": ON_ROLLERS, "two.toml": TWO_SUPPORTS, "reduced.toml": REDUCED, "wavy.toml": WAVY, "sweep.toml": SWEEP,
         "states.csv": "S,q\n1.1,0.3\n1.3,0.5\n", "forces.csv": "w,F\n0.2,9\n0.25,10.5\n"}


EXAMPLES = pathlib.Path("examples")  # a copy beside the answer: where lines wrap must not hang on where the repository lies


def example(name):
    return EXAMPLES / name / "case.toml"


def answers():
    """Of each: its name, what is asked, and the files it writes."""
    for name in "simulated", "cracked", "cyclic":
        yield f"fit {name}", ["fit", example(name)], []
        yield f"fit {name} json", ["fit", example(name), "--json"], []
    yield "fit surface json", ["fit", example("surface"), "--json"], []
    yield "simulate surface", ["simulate", EXAMPLES / "surface/truth.toml", "--quiet"], []
    yield "fit files", ["fit", example("simulated"), "--profile", "p.csv", "--curves", "c.csv", "--draws", "d.csv", "--quiet"], ["p.csv", "c.csv", "d.csv"]
    for model in "constant", "sinusoid", "sinusoids":
        yield f"fit {model} json", ["fit", example("simulated"), "--model", model, "--json"], []
    for flags, name in (([], ""), (["--json"], " json")):
        yield f"invert{name}", ["invert", example("simulated"), *flags], []
        yield f"modulus{name}", ["modulus", example("simulated"), *flags], []
        yield f"simulate{name}", ["simulate", "wavy.toml", *flags], []
        yield f"simulate rollers{name}", ["simulate", "rollers.toml", *flags], []
        yield f"simulate two{name}", ["simulate", "two.toml", *flags], []
        yield f"simulate reduced{name}", ["simulate", "reduced.toml", "--energies", *flags], []
        yield f"equilibrium{name}", ["equilibrium", "wavy.toml", *flags], []
        yield f"equilibrium region{name}", ["equilibrium", "rollers.toml", "--region", "--points", "5", "--levels", "3", *flags], []
        yield f"design{name}", ["design", EXAMPLES / "design.toml", *flags], []
        yield f"design rollers{name}", ["design", "rollers.toml", *flags], []
        yield f"state{name}", ["state", "states.csv", *flags], []
    yield "invert rows", ["invert", "forces.csv"], []
    yield "state force", ["state", "--w", "0.2", "--q", "0.4", "--roller-radius", "0.05", "--thickness", "0.02"], []
    yield "design map", ["design", "wavy.toml", "--over", "stiffness=10 N/m:1 kN/m:4"], []
    yield "sweep", ["sweep", "sweep.toml"], []
    yield "campaign", ["campaign", EXAMPLES, "--report", "c", "--no-figures", "--quiet"], ["c/tests.csv", "c/categories.csv", "c/specimens.csv"]
    yield "campaign json", ["campaign", EXAMPLES, "--json", "--quiet"], []
    yield "read", ["read", EXAMPLES / "simulated" / "test.csv"], []
    yield "read json", ["read", EXAMPLES / "simulated" / "test.csv", "--json"], []


def digest(text):
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def short_array(values):
    """An array of many by its ends and a digest."""
    text = json.dumps(values, ensure_ascii=False)
    if len(values) <= 6 or len(text) < 400:
        return [shortened(value) for value in values]
    return {f"{len(values)} of them, {digest(text)}": [shortened(values[0]), shortened(values[-1])]}


def shortened(value):
    if isinstance(value, dict):
        return {key: shortened(each) for key, each in value.items()}
    return short_array(value) if isinstance(value, list) else value


def frozen(text, folder):
    """An answer as it is kept: without what differs from one machine to the next, long parts by their digest."""
    text = text.replace(str(folder), "FOLDER")
    text = re.sub(r'"(version|time|date|duration|seconds)": "?[^",}]*"?', r'"\1": "…"', text)
    text = re.sub(r"\d+(\.\d+)? s\b", "… s", text)
    try:
        return json.dumps(shortened(json.loads(text)), indent=1, ensure_ascii=False) + "\n"
    except json.JSONDecodeError:
        lines = text.splitlines()
        is_table = len(lines) > 12 and len({line.count(",") for line in lines if line and not line.startswith("#")}) == 1
        if is_table and "," in lines[-1]:
            return "\n".join([*lines[:3], f"… {len(lines)} lines, {digest(text)}", lines[-1]]) + "\n"
        return text


def paths_of(value, above=""):
    """The keys of an answer, as docs/results.md writes them."""
    if isinstance(value, list):
        for each in value:
            yield from paths_of(each, above + "[]")
    elif isinstance(value, dict):
        for key, each in value.items():
            yield (below := f"{above}.{key}".lstrip("."))
            yield from paths_of(each, below)


class Described:
    """What `flexslip results` tells of the answers of a command."""
    PARTS = {"estimate": (".value", ".standard_error", ".interval95", ".unit"), "quantity": (".value", ".unit")}

    def __init__(self, told):
        keys = [(line["key"], line["holds"]) for answer in told for line in answer["lines"]]
        plain = {key + part for key, holds in keys for part in ("", *self.PARTS.get(holds, ()))}
        self.exact = {key for key in plain if "*" not in key} | {f"{key}{part}" for key, holds in keys if holds == "estimate" for part in ("_standard_error", "_low", "_high")}
        named = [key for key in plain if "*" in key] + [f"{key}.*" for key, holds in keys if holds in ("words by name", "group by name")]
        self.pattern = re.compile("|".join(re.escape(key).replace(r"\*", ".+") for key in named) or "$.")

    def misses(self, path):
        return path not in self.exact and not self.pattern.fullmatch(path) and not re.fullmatch(r"draw_\d+", path)


def written_keys(result, files):
    """The keys and the titles of columns in what a command wrote."""
    texts = [result.stdout, *(pathlib.Path(file).read_text(encoding="utf-8") for file in files if file.endswith(".csv"))]
    for text in texts:
        try:
            yield from (re.sub(r"^\[\]\.", "", path) for path in paths_of(json.loads(text)) if path)
        except json.JSONDecodeError:
            first = text.split("\n", 1)[0]
            if re.fullmatch(r"[\w \[\]^/,]+", first) and "," in first:
                yield from (re.sub(r" \[.*\]$", "", title) for title in first.split(","))


asked = []
undescribed = {}  # keys that stand in no description, by the answer that has them


def note_undescribed(arguments, result, files):
    command = str(arguments[0])
    asked.append(command)
    described = Described([answer for answer in DESCRIBED if re.match(rf"{command}\b|.*, {command} ", answer["command"])])
    for key in written_keys(result, files):
        if described.misses(key) and not ("--over" in arguments and key.split(".")[-1] in ("stiffness",)):
            undescribed.setdefault(" ".join(map(str, arguments)), set()).add(key)


DESCRIBED = json.loads(run("results", "--json").stdout)


def answer(arguments, files):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shutil.copytree(SOURCE / EXAMPLES, folder / EXAMPLES)
        for file, content in FILES.items():
            (folder / file).write_text(content, encoding="utf-8")
        here = pathlib.Path.cwd()
        os.chdir(folder)
        try:
            result = run(*arguments)
            note_undescribed(arguments, result, files)
            parts = [f"exit code {result.returncode}\n"]
            for title, text in (("standard error", result.stderr), ("standard output", result.stdout),
                                *((file, pathlib.Path(file).read_text(encoding="utf-8")) for file in files)):
                if text:
                    parts.append(f"== {title}\n{frozen(text, folder)}")
        finally:
            os.chdir(here)
    return "".join(parts)


def place_of(name):
    return GOLDEN / f"{name.replace(' ', '-')}.txt"


class Golden(unittest.TestCase):
    maxDiff = None

    def test_every_answer_is_the_frozen_one(self):
        for name, arguments, files in answers():
            with self.subTest(name):
                is_now, was = answer(arguments, files), place_of(name).read_text(encoding="utf-8")
                changed = difflib.unified_diff(was.splitlines(), is_now.splitlines(), "frozen", "now", lineterm="", n=0)
                self.assertTrue(is_now == was, "\n".join(list(changed)[:60]))

    def test_every_key_and_column_is_described(self):
        if not asked:
            for _, arguments, files in answers():
                answer(arguments, files)
        self.assertEqual(undescribed, {})

    def test_nothing_is_frozen_that_is_no_longer_asked(self):
        self.assertEqual({place_of(name) for name, _, _ in answers()}, set(GOLDEN.glob("*.txt")))


if __name__ == "__main__":
    if "--freeze" not in sys.argv:
        unittest.main()
    for old in GOLDEN.glob("*.txt"):
        old.unlink()
    GOLDEN.mkdir(exist_ok=True)
    for name, arguments, files in answers():
        place_of(name).write_text(answer(arguments, files), encoding="utf-8")
