"""Do words hold where an input is wrong? Fits records with changed inputs and counts words that turn into their opposite.

    /usr/bin/python3 bench/causes/inputs.py OUT --program build/release/flexslip [--every 4]

OUT is a folder of records (records.py). SLIP and CRACK are opposites; a word that becomes UNDECIDED, or CHECK INPUT, is lost.
"""

import argparse
import concurrent.futures
import json
import pathlib
import re
import subprocess
import tempfile

CONTACT = 0.004  # of the span


def scaled(key, factor):
    def change(case, rows):
        return re.sub(rf'^({key} = ")([-\d.e+]+)', lambda match: f"{match[1]}{float(match[2]) * factor!r}", case, flags=re.M), rows

    return change


def scaled_stiffness(factor):
    def change(case, rows):
        for key in ("bending_stiffness", "modulus"):
            case, rows = scaled(key, factor)(case, rows)
        return case, rows

    return change


def shifted(share):
    def change(case, rows):
        span = float(re.search(r'^span = "([-\d.e+]+)', case, re.M)[1])
        cells = [row.split(",") for row in rows]
        return case, [f"{float(stage) + share * span!r},{force}" for stage, force in cells]

    return change


CHANGES = {
    "as stated": lambda case, rows: (case, rows),
    "load train halved": scaled("stiffness", 0.5),
    "load train doubled": scaled("stiffness", 2),
    "EI 15 % less": scaled_stiffness(0.85),
    "EI 15 % more": scaled_stiffness(1.15),
    "contact earlier": shifted(-CONTACT),
    "contact later": shifted(CONTACT),
    "a third of the rows": lambda case, rows: (case, rows[::3]),
}


def words_of(folder, program):
    case, (title, *rows) = (folder / "case.toml").read_text(), (folder / "test.csv").read_text().splitlines()
    words = []
    for change in CHANGES.values():
        with tempfile.TemporaryDirectory() as place:
            changed, readings = change(case, rows)
            (pathlib.Path(place) / "case.toml").write_text(changed)
            (pathlib.Path(place) / "test.csv").write_text("\n".join([title, *readings]) + "\n")
            run = subprocess.run([program, "fit", f"{place}/case.toml", "--json", "--quiet"], capture_output=True, text=True)
        words.append(json.loads(run.stdout)["verdict"]["code"] if run.stdout else "no_answer")
    return words


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--program", required=True)
    parser.add_argument("--every", type=int, default=1, help="fit one record in so many")
    options = parser.parse_args()
    folders = sorted(path.parent for path in options.folder.glob("*/case.toml"))[:: options.every]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        all_words = list(pool.map(lambda folder: words_of(folder, options.program), folders))
    slipped, lost = ("slip", "slip_and_damage"), ("crack", "slip_and_damage")
    print("| input | words kept | lost | gained | turned |\n|---|---|---|---|---|")
    for i, name in enumerate(CHANGES):
        pairs = [(words[0], words[i]) for words in all_words]
        had = [(a, b) for a, b in pairs if a in slipped + lost]
        turned = [folder.name for folder, (a, b) in zip(folders, pairs) if {a, b} == {"slip", "crack"}]
        kept = sum(b in slipped + lost for a, b in had) - len(turned)
        gained = sum(a not in slipped + lost and b in slipped + lost for a, b in pairs)
        print(f"| {name} | {kept} of {len(had)} | {len(had) - kept - len(turned)} | {gained} | {len(turned)} {' '.join(turned)} |")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
