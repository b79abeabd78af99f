#!/usr/bin/python3
"""The documentation says what is there: names, headings and links exist, and the program takes every case shown."""
import csv
import io
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

ROOT = pathlib.Path(os.environ["SOURCE_DIR"])
FLEXSLIP = os.environ["FLEXSLIP"]
THEORY = ROOT / "docs/theory.md"
CASES = ROOT / "docs/case-files.md"
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md")])
CODE = sorted(
    path for folder in ("src", "tests") for path in (ROOT / folder).rglob("*")
    if path.suffix in {".h", ".cpp", ".py"} and path != pathlib.Path(__file__).resolve()
)
UNITS = {"m": 1, "mm": 1e3, "N": 1, "mN": 1e3, "": 1}  # of columns, what an SI value is multiplied by
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)

faults = []


def text_of(path):
    return path.read_text(encoding="utf-8")


def prose_of(path):
    return FENCE.sub("", text_of(path))


def fault(path, what):
    faults.append(f"{path.relative_to(ROOT)}: {what}")


def headings_of(path):
    return [heading.strip() for heading in re.findall(r"^#+ (.*)$", prose_of(path), re.MULTILINE)]


def anchor_of(heading):
    """As GitHub makes it."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def check_names():
    words = set()
    for path in CODE:
        words.update(re.findall(r"\w+", text_of(path)))
    for name in sorted(set(re.findall(r"`([^`]+)`", prose_of(THEORY)))):
        if "/" in name:
            if not any((folder / name).exists() for folder in (ROOT, ROOT / "src")):
                fault(THEORY, f"there is no file '{name}'")
        elif not re.fullmatch(r"\w+(::\w+)*", name):
            fault(THEORY, f"'{name}' is no name")
        elif not set(name.split("::")) <= words:
            fault(THEORY, f"'{name}' is not in the code")
    for page in PAGES:
        for name in re.findall(r"`((?:src|tests|tools|cmake|docs|bench|fuzz)/[\w./-]*)`", prose_of(page)):
            if not (ROOT / name).exists() and not name.startswith("build/"):
                fault(page, f"there is no file '{name}'")


def check_equations():
    table = text_of(THEORY).split("## The paper's equations")[1]
    wanted = ["(1.1)", *(f"(3.{i}" for i in range(1, 8)), *(f"(4.{i}" for i in range(1, 33)), "Algorithm 1", "Algorithm 2"]
    for equation in wanted:
        if not re.search(rf"^\| .*{re.escape(equation)}(?!\d)", table, re.MULTILINE):
            fault(THEORY, f"equation {equation} is not accounted for")


def check_headings():
    """What comments in the code refer to by title."""
    for path in CODE:
        comments = re.sub(r"\n\s*(//|#)\s*", " ", text_of(path))
        for page, heading in re.findall(r'(theory|design|case-files|numerics)\.md, "([^"]+)"', comments):
            if heading not in headings_of(ROOT / f"docs/{page}.md"):
                fault(path, f"docs/{page}.md has no heading \"{heading}\"")


def check_links():
    for page in PAGES:
        for target in re.findall(r"\]\(([^)\s]+)\)", prose_of(page)):
            if re.match(r"\w+:", target):
                continue
            name, _, anchor = target.partition("#")
            file = (page.parent / name).resolve() if name else page
            if not file.exists():
                fault(page, f"the link {target} leads nowhere")
            elif anchor and anchor not in map(anchor_of, headings_of(file)):
                fault(page, f"{name or 'the page'} has no heading for #{anchor}")


def check_messages():
    """The messages that troubleshooting.md quotes are those of the program: each quotation, apart from its numbers, its names and what "…" stands for, is in the sources."""
    page = ROOT / "docs/troubleshooting.md"
    said = " ".join(re.sub(r'"\s*\n\s*"', "", text_of(path)) for path in (ROOT / "src").rglob("*.cpp"))
    said = re.sub(r"\\\"", '"', said)
    quotations = re.findall(r'^\| "(.+?)" \|', text_of(page), re.MULTILINE)
    if len(quotations) < 40:
        fault(page, f"only {len(quotations)} quotations: is it the pattern that finds them?")
    for quotation in quotations:
        for part in re.split(r"…|[+]?\b\d+(?:\.\d+)?(?: %)?|'[^']*'\?", quotation):
            part = part.strip(" ,;?")
            if len(part) > 3 and part not in said and part[0].lower() + part[1:] not in said:
                fault(page, f"the program nowhere says \"{part}\"")


def run(*arguments):
    return subprocess.run([FLEXSLIP, *map(str, arguments)], capture_output=True, text=True, check=False)


def completed(snippet, simulated, evaluated):
    """A snippet of one section or two, in place of those of the example that it belongs to."""
    case = tomllib.loads(snippet)
    if case.get("reduced") or len(case) >= 3:
        return snippet
    friction = case.get("friction", {})
    to_fit = "record" in case or (friction and not {"mu0", "file"} & set(friction))
    for section in re.split(r"^(?=\[)", evaluated if to_fit else simulated, flags=re.MULTILINE)[1:]:
        if section[1:section.index("]")] not in case:
            snippet += "\n" + section
    return snippet


def write_record(path, record, curves):
    """A simulated test in the columns of a record: what the instrument of that snippet would have written."""
    comma = record.get("decimal") == ","
    columns = []
    for name, quantity in (("stage", "w_s"), ("deflection", "w"), ("force", "F")):
        if name in record:
            unit = "".join(re.findall(r"\[(.*)\]", record[name]))
            columns.append([record[name], *(f"{value * UNITS.get(unit, 1):.12g}" for value in curves[quantity])])
    lines = [(";" if comma else ",").join(row) for row in zip(*columns)]
    path.write_text("\n".join(line.replace(".", ",") if comma else line for line in lines) + "\n", encoding="utf-8")


def write_export(path, record, curves):
    """A simulated test as a testing machine's program exports it: a preamble, quoted numbers, words for columns."""
    displacement = curves["w_s" if record["displacement"] == "crosshead" else "w"]
    lines = ['Test : Rate 1,"1.00000",mm/min', "", "Extension,Load", "(mm),(N)"]
    lines += [f'"{1e3 * x:.9f}","{force:.9f}"' for x, force in zip(displacement, curves["F"])]
    path.write_text("\r\n".join(lines) + "\r\n", encoding="utf-8")


def simulated_curves(path):
    rows = list(csv.reader(io.StringIO(run("simulate", path).stdout)))
    titles = [title.split(" ")[0] for title in rows[0]] if rows else ["w_s", "w", "F"]
    return {title: [float(row[i]) for row in rows[1:]] for i, title in enumerate(titles) if title != "motion"}


def check_cases():
    page = text_of(CASES)
    snippets = [text for language, text in FENCE.findall(page) if language == "toml"]
    simulated, evaluated = snippets[:2]
    can_fit = run("fit", "--help").returncode == 0
    if not can_fit:
        print("flexslip has no command fit: cases are tried with invert only")
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for name, text in re.findall(r"^File `([^`]+)`:\n\n```csv\n(.*?)^```$", page, re.MULTILINE | re.DOTALL):
            (folder / name).write_text(text, encoding="utf-8")
        if can_fit:
            run("fit", ROOT / "examples/simulated/case.toml", "--draws", folder / "draws.csv")
        curves = {}
        for snippet in snippets:
            case = tomllib.loads(snippet)
            if {"stage", "friction"} <= set(case) and case.get("reduced", False) not in curves:
                path = folder / "case.toml"
                path.write_text(snippet.replace('"continuous"', "0.002"), encoding="utf-8")
                curves[case.get("reduced", False)] = simulated_curves(path)
        for number, snippet in enumerate(snippets, 1):
            text = completed(snippet, simulated, evaluated)
            case = tomllib.loads(text)
            path = folder / f"case{number}.toml"
            path.write_text(text, encoding="utf-8")
            commands = []
            if "record" in case:
                write = write_export if "displacement" in case["record"] else write_record
                write(folder / case["record"]["file"], case["record"], curves[case.get("reduced", False)])
                commands = ["invert", "fit"] if can_fit else ["invert"]
            elif "stage" in case:
                commands = ["simulate", "equilibrium"]
            elif "friction" in case:
                commands = ["equilibrium"]
            if not commands:
                fault(CASES, f"no command for snippet {number}:\n{snippet}")
            for command in commands:
                done = run(command, path)
                if done.returncode != 0 or not done.stdout:
                    fault(CASES, f"flexslip {command} refuses snippet {number}: {done.stderr.strip()}\n{snippet}")
    print(f"{len(snippets)} cases")


def check_steps():
    """What ./check, ./run and CI call is there."""
    for name in ("check", "run", ".ci/run"):
        for path in sorted(set(re.findall(r"(?<![\w./-])(?:\$root/)?((?:tools|tests|studio|python)/[\w./-]+)", text_of(ROOT / name)))):
            if not (ROOT / path).exists():
                fault(ROOT / name, f"there is no {path}")


def check_promises():
    """docs/stability.md lists the verdicts and the exit codes that the program states."""
    page = ROOT / "docs/stability.md"
    promised = dict(re.findall(r"^\| ([\w ]+) \| (.*?) \|", text_of(page), re.MULTILINE))
    verdicts = re.search(r"verdict\.code +(.*)", run("results", "fit").stdout).group(1)
    exits = re.findall(r"^  (\d+)  ", run("--help").stdout.split("Exit status:")[1], re.MULTILINE)
    if re.findall(r"`(\w+)`", promised["verdicts"]) != re.split(", | or ", verdicts):
        fault(page, f"the verdicts are {verdicts}")
    if f"exit codes {', '.join(exits)}" not in promised["commands"]:
        fault(page, f"the exit codes are {', '.join(exits)}")


def main():
    check_promises()
    check_steps()
    check_names()
    check_equations()
    check_headings()
    check_links()
    check_messages()
    check_cases()
    for found in faults:
        print(found)
    print(f"{len(PAGES)} pages, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
