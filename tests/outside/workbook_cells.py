#!/usr/bin/python3
"""outside: what people do to a sheet, as openpyxl writes it: dates for numbers, clock times, rows of statistics, decimal commas, merged titles,
specimens beside each other, sheets of settings; oracle: the same numbers without it."""
import datetime
import json
import statistics
import unittest

import openpyxl

from program import InFolder, numbers, run

CASE = """[specimen]
diameter = "34.8 um"
modulus = "29.6 GPa"
[rig]
span = "1278 um"
stiffness = "90.65 N/m"
[record]
file = "{file}"
stage = "stage"
force = "force"
{more}
"""
READINGS = [[i / 10, 3.0 * i - i * i / 80] for i in range(40)]
TITLES = ["Extension (mm)", "Load (N)"]
STAGED = [["stage [um]", "force [mN]"], *([2.0 * i, 0.02 * i] for i in range(40))]  # of which modulus tells a stiffness


class Cells(InFolder):
    def book(self, rows, name="test.xlsx", formats=(), merged=(), **others):
        """A workbook whose sheet Data has these rows; `formats` are {cell: format}."""
        book = openpyxl.Workbook()
        sheet = book.active
        sheet.title = "Data"
        for row in rows:
            sheet.append(row)
        for cell, code in dict(formats).items():
            sheet[cell].number_format = code
        for cells in merged:
            sheet.merge_cells(cells)
        for title, more in others.items():
            below = book.create_sheet(title)
            for row in more:
                below.append(row)
        book.save(self.folder / name)
        return self.folder / name

    def read(self, path, *flags):
        done = run("read", "-o", "-", path, "--full", *flags)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout, " ".join(done.stderr.split())

    # ---- dates and clock times

    def test_a_number_that_became_a_date_is_refused_by_its_cell_and_the_remedy_works(self):
        rows = [TITLES, *READINGS]
        for code, value, shown in (("d-mmm", 46054, "the date 2026-02-01"), ("[$-407]d. mmm yy;@", 46054.0, "the date 2026-02-01"), ("h:mm", 0.05, "the clock time 01:12:00")):
            changed = [list(row) for row in rows]
            changed[12][1] = value
            path = self.book(changed, formats={"B13": code})
            self.refused("read", path, "--crosshead", "1", says=["test.xlsx:13", "sheet 'Data', cell B13", "'Load'", shown, "Format the cell as a number and type it again"])
            self.refused("fit", self.file("case.toml", CASE.format(file="test.xlsx", more="").replace('"stage"', '"Extension [mm]"').replace('"force"', '"Load [N]"')),
                         says=["cell B13", shown])
        changed[12][1] = rows[12][1]
        out, _ = self.read(self.book(changed), "--crosshead", "1")  # typed again
        self.assertEqual(numbers(out, "Load [N]"), [force for _, force in READINGS])
        out, _ = self.read(self.book(rows[:12] + rows[13:]), "--crosshead", "1")  # or deleted
        self.assertEqual(len(numbers(out, "Load [N]")), len(READINGS) - 1)

    def test_a_date_as_openpyxl_writes_it(self):
        rows = [TITLES, *[list(row) for row in READINGS]]
        rows[-1][0] = datetime.datetime(2026, 2, 1)
        self.refused("read", self.book(rows), "--crosshead", "1", says=[f"cell A{len(rows)}", "2026-02-01"])

    def test_a_column_of_clock_times_is_a_time_in_seconds(self):
        for offset, first in ((0.0, 0.0), (0.5, 43200.0)):
            rows = [["Time [s]", *TITLES], *([offset + i * 0.5 / 86400, *row] for i, row in enumerate(READINGS))]
            formats = {f"A{i}": "hh:mm:ss.0" for i in range(2, len(rows) + 1)}
            out, said = self.read(self.book(rows, formats=formats), "--crosshead", "2")
            for i, value in enumerate(numbers(out, "Time [s]")):
                self.assertAlmostEqual(value, first + i / 2, delta=1e-9 * 86400)  # days have 17 digits
            self.assertIn("column 'Time' holds clock times, read in s", said)

    def test_times_with_a_date_count_from_midnight_and_a_stated_unit_is_kept(self):
        start = datetime.datetime(2026, 3, 1, 10, 0, 0)
        rows = [["Time (min)", *TITLES], *([start + datetime.timedelta(seconds=i), *row] for i, row in enumerate(READINGS))]
        out, said = self.read(self.book(rows), "--crosshead", "2")
        for i, value in enumerate(numbers(out, "Time [min]")):
            self.assertAlmostEqual(value, 600 + i / 60, delta=1e-7)  # 46082 days leave 1e-11 of them
        self.assertIn("from the midnight before the first", said)

    def test_a_time_of_which_some_cells_alone_are_clock_times_is_refused(self):
        rows = [["Time [s]", *TITLES], *([i, *row] for i, row in enumerate(READINGS))]
        rows[5][0] = datetime.time(0, 0, 4)
        self.refused("read", self.book(rows), "--crosshead", "2", says=["cell A6", "the clock time 00:00:04"])

    def test_dates_in_a_column_that_nobody_wants_are_words(self):
        rows = [["Day", *TITLES], *([datetime.date(2026, 2, 1 + i % 28), *row] for i, row in enumerate(READINGS))]
        out, said = self.read(self.book(rows), "--crosshead", "2")
        self.assertIn("2026-02-01", out)
        self.assertIn("column 'Day' holds dates or clock times and is kept as text", said)
        self.assertEqual(numbers(out, "Load [N]"), [force for _, force in READINGS])
        text = self.file("plain.csv", out)
        self.assertEqual(run("read", "-o", "-", text, "--crosshead", "2").stdout, out)

    def test_a_campaigns_table_with_a_date_for_a_number_is_refused(self):
        self.book([["name", "file", "span [um]"], ["a", "a.csv", datetime.date(2026, 2, 1)]], name="tests.xlsx")
        self.refused("campaign", self.folder / "tests.xlsx", says=["tests.xlsx:2", "cell C2", "2026-02-01"])

    def test_days_count_from_1904_where_the_workbook_says_so(self):
        book = openpyxl.Workbook()
        book.epoch = openpyxl.utils.datetime.CALENDAR_MAC_1904
        for row in [TITLES, *READINGS[:20], [2.0, datetime.date(2026, 2, 1)]]:
            book.active.append(row)
        book.save(self.folder / "mac.xlsx")
        self.refused("read", self.folder / "mac.xlsx", "--crosshead", "1", says=["2026-02-01"])

    def test_numbers_with_a_unit_in_their_format_are_numbers(self):
        formats = {f"{column}{i}": code for i in range(2, 42) for column, code in (("A", '0.00" mm"'), ("B", "0.000E+00"))}
        out, _ = self.read(self.book([TITLES, *READINGS], formats=formats), "--crosshead", "1")
        self.assertEqual(numbers(out, "Load [N]"), [force for _, force in READINGS])

    # ---- rows of statistics

    def summary(self, label=True):
        columns = list(zip(*READINGS))
        rows = [["Mean", *map(statistics.mean, columns)], ["Max", *map(max, columns)], ["Std. Dev.", *map(statistics.stdev, columns)]]
        return rows if label else [row[1:] for row in rows]

    def without_and_with(self, rows, *flags):
        """What is read of a table as a workbook and as CSV, and what is said."""
        self.file("test.csv", "\n".join(";".join("" if cell is None else str(cell) for cell in row) for row in rows) + "\n")
        return [self.read(path, *flags) for path in (self.book(rows), self.folder / "test.csv")]

    def test_labelled_rows_below_are_left_out_and_named(self):
        numbered = [["Time (s)", *TITLES], *([float(i), *row] for i, row in enumerate(READINGS))]
        beside = [["", *TITLES], *([None, *row] for row in READINGS)]
        for rows in (numbered + self.summary(), [*numbered, [], *self.summary()], beside + self.summary(), [*beside, [None, None, None], *self.summary()]):
            for out, said in self.without_and_with(rows, "--crosshead", "2", "--force", "3"):
                self.assertEqual(numbers(out, "Load [N]"), [force for _, force in READINGS], said)
                last = len(rows)
                self.assertIn(f"left out, as they hold statistics of the readings: lines {last - 2} to {last}", said)

    def test_without_labels_by_their_numbers(self):
        rows = [TITLES, *READINGS, [], *self.summary(label=False)]
        for out, said in self.without_and_with(rows, "--crosshead", "1"):
            self.assertEqual(len(numbers(out, "Load [N]")), len(READINGS), said)
            self.assertIn("left out, as they hold statistics", said)

    def test_what_stands_below_a_break_and_is_no_statistic_counts_and_is_told(self):
        rows = [TITLES, *READINGS, [], [4.2, 90.0], [4.3, 91.0]]
        for out, said in self.without_and_with(rows, "--crosshead", "1"):
            self.assertEqual(len(numbers(out, "Load [N]")), len(READINGS) + 2)
            self.assertIn(f"lines {len(READINGS) + 3} to {len(READINGS) + 4} are below a break and count as readings", said)

    def test_a_word_that_marks_a_reading_leaves_it_a_reading(self):
        rows = [[*TITLES, "Event"], *([*row, "Max" if row == READINGS[-5] else None] for row in READINGS)]
        for out, _ in self.without_and_with(rows, "--crosshead", "1"):
            self.assertEqual(len(numbers(out, "Load [N]")), len(READINGS))
        phases = [["Phase", *TITLES], *(["loading" if i < 30 else "max", *row] for i, row in enumerate(READINGS))]
        for out, _ in self.without_and_with(phases, "--crosshead", "2"):
            self.assertEqual(len(numbers(out, "Load [N]")), len(READINGS))

    def test_a_fit_leaves_them_out_too_and_says_so(self):
        example = [line.split(",") for line in (self.example() / "test.csv").read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
        readings = [[float(cell) for cell in row] for row in example[1:]]
        mean = [statistics.mean(column) for column in zip(*readings)]
        fits = []
        for name, rows in (("plain.csv", example), ("mean.csv", [["", *example[0]], *(["", *row] for row in example[1:]), ["Mean", *map(repr, mean)]])):
            self.file(name, "\n".join(",".join(row) for row in rows) + "\n")
            fits.append(self.json("fit", self.file("case.toml", CASE.format(file=name, more=""))))
        self.assertIn(f"left out, as it holds a statistic of the readings: line {len(example) + 1}", json.dumps(fits[1]["preparation"]))
        self.assertEqual(fits[0]["parameters"], fits[1]["parameters"])

    def example(self):
        from program import SOURCE
        return SOURCE / "examples/simulated"

    # ---- decimal commas

    def test_one_column_of_words_with_decimal_commas_beside_numbers(self):
        rows = [TITLES, *([extension, f"{force:.4f}".replace(".", ",")] for extension, force in READINGS)]
        out, said = self.read(self.book(rows), "--crosshead", "1")
        self.assertEqual(numbers(out, "Load [N]"), [round(force, 4) for _, force in READINGS])
        self.assertEqual(numbers(out, "Extension [mm]"), [extension for extension, _ in READINGS])
        again = said.split("the same way again: flexslip read ")[1].split(" --", 1)[1].strip()
        self.assertIn("--decimal ,", again)

    def test_decimal_commas_in_words_of_a_workbook_are_read(self):
        path = self.book([STAGED[0], *([stage, f"{force:.4f}".replace(".", ",")] for stage, force in STAGED[1:])])
        call = ["modulus", path, "--stage", "stage", "--force", "force", "--span", "1278 um", "--diameter", "34.8 um", "--stiffness", "90.65 N/m"]
        right = self.json("modulus", self.book(STAGED, "right.xlsx"), *call[2:])
        for mark in [], ["--decimal", ","]:
            self.assertEqual(self.json(*call, *mark)["stiffness"], right["stiffness"])

    def test_words_that_could_be_read_in_two_ways_are_asked_for(self):
        rows = [TITLES, *([extension, f"{1 + i},{234 + i}"] for i, (extension, _) in enumerate(READINGS))]
        path = self.book(rows)
        self.refused("read", path, "--crosshead", "1", says=["--decimal . or --decimal ,"])
        for mark, factor in ((",", 1), (".", 1000)):
            out, _ = self.read(path, "--crosshead", "1", "--decimal", mark)
            self.assertEqual(numbers(out, "Load [N]")[0], 1.234 * factor)

    # ---- sheets

    def test_a_sheet_of_settings_is_not_taken_for_the_measurement(self):
        book = openpyxl.Workbook()
        book.active.title = "Settings"
        for row in (["Span [mm]", 17], ["Speed", 2], ["Load cell", 10], ["Operator", "A. B."], ["Gauge", 3]):
            book.active.append(row)
        for row in [TITLES, *READINGS]:
            (book["Run"] if "Run" in book.sheetnames else book.create_sheet("Run")).append(row)
        book.save(self.folder / "a.xlsx")
        out, said = self.read(self.folder / "a.xlsx", "--crosshead", "1")
        self.assertEqual(len(numbers(out, "Load [N]")), len(READINGS))
        self.assertIn("the sheet is 'Run', the first of 'Settings' and 'Run' with a table of numbers", said)

    def test_a_fault_in_a_sheet_that_nobody_chose_names_the_others_and_its_remedy_works(self):
        first = [["Temperature", "Humidity"], *([20 + i, 50 - i] for i in range(12))]
        self.book(first, Run=[["stage [mm]", "force [mN]"], *READINGS])
        case = self.file("case.toml", CASE.format(file="test.xlsx", more=""))
        self.refused("fit", case, says=["column 'stage'", "This is the sheet 'Data'", "'Run'", '--sheet "Run"'])
        self.assertNotIn("none of this name", run("fit", case, "--sheet", "Run").stderr)
        self.assertEqual(run("invert", case, "--set", "record.sheet=Run").returncode, 0)

    def test_the_number_of_a_sheet_is_a_number_and_its_name_text(self):
        self.book(STAGED, **{"1": STAGED[:21]})
        rows = []
        for more in ("sheet = 1", 'sheet = "1"', "sheet = 2"):
            case = self.file("case.toml", CASE.format(file="test.xlsx", more=more))
            done = run("modulus", case, "--json")
            self.assertEqual(done.returncode, 0, done.stderr)
            rows.append(json.loads(done.stdout)["preparation"][0]["rows"][1])
        self.assertEqual(rows, [len(STAGED) - 1, 20, 20])
        self.refused("invert", self.file("case.toml", CASE.format(file="test.xlsx", more="sheet = 3")), says=["case.toml:", "[record] sheet", "There is no sheet 3"])

    # ---- titles

    def test_specimens_beside_each_other(self):
        rows = [["Probe A", None, None, "Probe B"], [*TITLES, None, *TITLES], *([*row, None, row[0], 2 * row[1]] for row in READINGS[:30]), *([None, None, None, row[0], 2 * row[1]] for row in READINGS[30:])]
        path = self.book(rows, merged=("A1:B1", "D1:E1"))
        said = self.json("read", path)
        self.assertEqual([(each["name"], each["rows"]) for each in said["specimens"]], [("Probe A", 30), ("Probe B", 40)])
        out, _ = self.read(path, "--specimen", "2", "--crosshead", "1")
        self.assertEqual(numbers(out.removeprefix("# Specimen: Probe B\n"), "Load [N]"), [2 * force for _, force in READINGS])
        out, _ = self.read(path, "--specimen", "2", "--crosshead", "4", "--force", "5")
        self.assertEqual(numbers(out.removeprefix("# Specimen: Probe B\n"), "Load [N]"), [2 * force for _, force in READINGS])
        case = self.file("case.toml", CASE.format(file="test.xlsx", more='displacement = "crosshead"').replace('stage = "stage"\n', "").replace('force = "force"\n', ""))
        self.refused("fit", case, says=["specimen = 1"])
        titled = self.file("case.toml", CASE.format(file="test.xlsx", more="").replace('"stage"', '"Extension [mm]"').replace('"force"', '"Load [N]"'))
        self.refused("fit", titled, says=["specimen = 1"])
        self.assertIn("yields by", run("invert", titled, "--set", "record.specimen=1").stderr)

    def test_titles_on_two_lines_with_merged_cells(self):
        rows = [["Time (s)", "Specimen", None], [None, "Crosshead (mm)", "Load (N)"], *([float(i), *row] for i, row in enumerate(READINGS))]
        path = self.book(rows, merged=("A1:A2", "B1:C1"))
        said = self.json("read", path)
        self.assertEqual([(each["name"], each["role"]) for each in said["columns"]], [("Time", "time"), ("Crosshead", "crosshead"), ("Load", "force")])


if __name__ == "__main__":
    unittest.main()
