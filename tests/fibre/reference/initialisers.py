#!/usr/bin/python3
"""tests/fibre/reference/initialisers.py FOLDER: writes each reference table as rows of C++ initialisers, NAME.inc.

A value of 40 digits becomes {hi, lo}, two doubles whose sum is good to 32 digits. Inputs stay exact doubles.
"""
import csv
import pathlib
import sys
from fractions import Fraction

HERE = pathlib.Path(__file__).resolve().parent


def hexadecimal(number):
    return number.hex() if number else "0"


def pair(digits):
    if digits == "inf":
        return "{inf, 0}"
    hi = float(digits)
    return "{%s, %s}" % (hexadecimal(hi), hexadecimal(float(Fraction(digits) - Fraction(hi))))


def initialisers(table):
    with open(table, encoding="utf-8", newline="") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        inputs = [title for title in rows.fieldnames if title.endswith("_hex")]
        outputs = rows.fieldnames[1 + 2 * len(inputs):]
        for row in rows:
            numbers = [hexadecimal(float.fromhex(row[title])) for title in inputs] + [pair(row[title]) for title in outputs]
            yield '{"%s", %s},\n' % (row["group"], ", ".join(numbers))


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("states", "ends", "poles", "shapes", "elliptic"):
        (folder / f"{name}.inc").write_text("".join(initialisers(HERE / f"{name}.csv")), encoding="utf-8")


if __name__ == "__main__":
    main()
