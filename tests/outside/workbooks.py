#!/usr/bin/python3
"""outside: workbooks (.xlsx) as openpyxl and libxlsxwriter write them, and as nobody should, wherever a table is read; oracle: openpyxl, CSV."""
import csv
import io
import json
import math
import random
import re
import shutil
import subprocess
import unittest
import zipfile

import openpyxl

from program import PROGRAM, SOURCE, WAVY, InFolder, numbers, run, table

EXAMPLE = SOURCE / "examples/simulated"
TITLES, *READINGS = [row for row in csv.reader((EXAMPLE / "test.csv").read_text(encoding="utf-8").splitlines()) if not row[0].startswith("#")]
READINGS = [[float(cell) for cell in row] for row in READINGS]
MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
OFFICE = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
PACKAGE = "http://schemas.openxmlformats.org/package/2006/relationships"
REMEDY_OF_OTHERS = "save it as .xlsx"


def raw(sheets, strings=None, doctype="", main="xl/workbook.xml", more=()):
    """A workbook to the letter: {name: XML inside of <sheetData>}."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        def write(part, text):
            archive.writestr(part, '<?xml version="1.0" encoding="UTF-8"?>\n' + text)
        write("_rels/.rels", f'<Relationships xmlns="{PACKAGE}"><Relationship Id="a" Type="{OFFICE}/officeDocument" Target="{main}"/></Relationships>')
        listed = "".join(f'<sheet name="{name}" sheetId="{i}" r:id="r{i}"/>' for i, name in enumerate(sheets, 1))
        write("xl/workbook.xml", f'<workbook xmlns="{MAIN}" xmlns:r="{OFFICE}"><sheets>{listed}</sheets></workbook>')
        relations = "".join(f'<Relationship Id="r{i}" Type="{OFFICE}/worksheet" Target="worksheets/s{i}.xml"/>' for i in range(1, len(sheets) + 1))
        if strings is not None:
            relations += f'<Relationship Id="s" Type="{OFFICE}/sharedStrings" Target="/xl/sharedStrings.xml"/>'
            write("xl/sharedStrings.xml", f'<sst xmlns="{MAIN}">{strings}</sst>')
        write("xl/_rels/workbook.xml.rels", f'<Relationships xmlns="{PACKAGE}">{relations}</Relationships>')
        for i, rows in enumerate(sheets.values(), 1):
            write(f"xl/worksheets/s{i}.xml", f'{doctype}<worksheet xmlns="{MAIN}"><sheetData>{rows}</sheetData></worksheet>')
        for part, content in more:
            archive.writestr(part, content)
    return packed.getvalue()


def rows_of(rows):
    """Rows as XML, numbers with the digits that they are given with, words inline."""
    def cell(value):
        if isinstance(value, str) and not value.replace(".", "").replace("-", "").replace("e", "").isdigit():
            return f'<c t="inlineStr"><is><t>{value}</t></is></c>'
        return f"<c><v>{value}</v></c>"
    return "".join(f"<row>{''.join(map(cell, row))}</row>" for row in rows)


NUMBERS = rows_of([["Extension (mm)", "Load (N)"], *([i / 10, i] for i in range(20))])


class Workbooks(InFolder):
    def workbook(self, sheets, name="test.xlsx"):
        book = openpyxl.Workbook()
        book.remove(book.active)
        for title, rows in sheets.items():
            sheet = book.create_sheet(title)
            for row in rows:
                sheet.append(row)
        book.save(self.folder / name)
        return self.folder / name

    def refused_as(self, content, *words, more=()):
        self.refused("read", self.file("a.xlsx", content), *more, says=["a.xlsx", *words])

    def test_a_fit_of_a_workbook_is_that_of_its_csv_to_the_last_bit(self):
        book = self.workbook({"Notes": [["made", "by hand"]], "Data": [TITLES, *READINGS]})
        held = [row for row in openpyxl.load_workbook(book)["Data"].iter_rows(values_only=True)]
        self.file("test.csv", "\n".join(",".join(map(str, row)) for row in held) + "\n")  # str of a float has all its bits
        case = (EXAMPLE / "case.toml").read_text(encoding="utf-8")
        fits = []
        for name in ("test.csv", "test.xlsx"):
            fits.append(self.json("fit", self.file("case.toml", case.replace("test.csv", name))))
        self.assertIn("the sheet is 'Data', the first of 'Notes' and 'Data' with a table of numbers", json.dumps(fits[1]["preparation"]))
        for fit in fits:
            del fit["provenance"], fit["preparation"]
        self.assertEqual(*fits)

    def test_the_workbook_of_a_fit_has_its_answer_its_parameters_and_its_curves(self):
        path, curves = self.folder / "fit.xlsx", self.folder / "curves.csv"
        fit = self.json("fit", EXAMPLE / "case.toml", "--xlsx", path, "--curves", curves)
        book = openpyxl.load_workbook(path)
        self.assertEqual(book.sheetnames, ["Answer", "Parameters", "Curves"])
        lines = dict(list(book["Answer"].values)[1:])
        self.assertEqual(lines, {"verdict": fit["verdict"]["sentence"], **{row["label"]: row["words"] for row in fit["answer"]}, "checks": fit["checks"], "next": fit["next"]})
        for name, *cells, unit in list(book["Parameters"].values)[1:]:
            parameter = fit["parameters"].pop(name)
            self.assertEqual(unit, parameter["unit"])
            for cell, value in zip(cells, (parameter["value"], parameter["standard_error"], *parameter["interval95"]), strict=True):
                self.assertAlmostEqual(cell, value, delta=1e-15 * abs(value))  # 16 digits
        self.assertEqual(fit["parameters"], {})
        titles, *rows = book["Curves"].values
        factors = {"m": 1, "mm": 1e-3, "µm": 1e-6, "nm": 1e-9, "N": 1, "mN": 1e-3, "µN": 1e-6, "nN": 1e-9}
        for i, title in enumerate(titles):
            name, _, unit = title.partition(" (")
            wanted = numbers(curves.read_text(encoding="utf-8"), name if not unit else f"{name} [{'m' if unit[:-1].endswith('m') else 'N'}]")
            for row, value in zip(rows, wanted, strict=True):
                if math.isnan(value):
                    self.assertIsNone(row[i])
                else:
                    self.assertAlmostEqual(row[i] * factors.get(unit[:-1], 1), value, delta=1e-14 * abs(value))

    def test_seventeen_digits_are_kept_to_the_last_bit(self):
        draw = random.Random(7)
        rows = [[draw.random() * 10.0 ** draw.randint(-12, 12), draw.uniform(-1, 1) * 10.0 ** draw.randint(-300, 300)] for _ in range(2000)]
        text = [["Extension (mm)", "Load (N)"], *([f"{value:.17g}" for value in row] for row in rows)]
        xml = "".join("<row>" + "".join(f"<c><v>{cell}</v></c>" for cell in row) + "</row>" for row in text[1:])
        path = self.file("digits.xlsx", raw({"a": rows_of(text[:1]) + xml}))
        out = run("read", "-o", "-", path, "--crosshead", "1").stdout
        self.assertEqual([list(pair) for pair in zip(numbers(out, "Extension [mm]"), numbers(out, "Load [N]"))], rows)

    def test_what_libxlsxwriter_writes_is_read(self):
        """outside: the workbook of a campaign, which libxlsxwriter writes, against its CSV."""
        folder = self.folder / "tests"
        shutil.copytree(EXAMPLE, folder / "one")
        out = self.folder / "out"
        done = run("campaign", folder, "--report", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        book = openpyxl.load_workbook(out / "campaign.xlsx")
        compared = 0
        for sheet in book.sheetnames:
            held = [cell for row in book[sheet].iter_rows(values_only=True) for cell in row if isinstance(cell, float)]
            said = run("read", "-o", "-", out / "campaign.xlsx", "--sheet", sheet)
            if said.returncode == 0 and held:
                read = {float(cell) for cells in table(said.stdout).values() for cell in cells if is_float(cell)}
                self.assertTrue(read & set(held), sheet)
                compared += 1
        self.assertGreater(compared, 0)

    def test_every_kind_of_cell(self):
        strings = ("<si><t>Extension&#10;(mm)</t></si><si><r><t>Lo</t></r><r><t xml:space=\"preserve\">ad, of the cell (N)</t></r>"
                   "<rPh sb=\"0\" eb=\"1\"><t>ロード</t></rPh></si><si><t>say \"hi\"; a, b_x000D_</t></si>")
        rows = ('<row r="3"><c r="A3" t="s"><v>0</v></c><c r="C3" t="s"><v>1</v></c><c r="D3" t="inlineStr"><is><t>note</t></is></c>'
                '<c r="E3" t="inlineStr"><is><t>day</t></is></c><c r="F3" t="inlineStr"><is><t>fine</t></is></c></row>')
        for i in range(4, 10):
            value = "<v>#DIV/0!</v>" if i == 7 else f"<v>{i}.5</v>"
            rows += (f'<row r="{2 * i}"><c r="A{2 * i}"><v>{i}E-1</v></c><c r="C{2 * i}"{" t=" + chr(34) + "e" + chr(34) if i == 7 else ""}><f>B{i}*2</f>{value}</c>'
                     f'<c r="D{2 * i}" t="s"><v>2</v></c><c r="E{2 * i}" s="1"><v>{45000 + i}</v></c><c r="F{2 * i}" t="b"><v>{i % 2}</v></c></row>')
        path = self.file("kinds.xlsx", raw({"a &amp; b": rows}, strings))
        said = self.json("read", path)
        self.assertEqual(said["sheet"], "a & b")
        self.assertEqual([(column["number"], column["name"], column["unit"]) for column in said["columns"]],
                         [(1, "Extension", "mm"), (3, "Load, of the cell", "N"), (4, "note", None), (5, "day", None), (6, "fine", None)])
        self.assertEqual((said["specimens"][0]["first_line"], said["specimens"][0]["last_line"]), (8, 18))
        out = table(run("read", "-o", "-", path).stdout)
        self.assertEqual(out["Extension [mm]"], ["0.4", "0.5", "0.6", "0.7", "0.8", "0.9"])
        self.assertEqual(out["Load, of the cell [N]"], ["4.5", "5.5", "6.5", "nan", "8.5", "9.5"])
        self.assertEqual(out["note"][0], 'say "hi"; a, b')
        self.assertEqual(out["day"][0], "45004")
        self.assertEqual(out["fine"][:2], ["FALSE", "TRUE"])
        self.assertIn("'#DIV/0!'", " ".join(said["notes"]))

    def test_header_rows_units_and_the_number_of_a_column(self):
        rows = [["Test:", "bending"], ["Support span", "17 mm"], [], ["Zeit", "Standardweg", "Standardkraft"], ["s", "mm", "N"],
                *([i, i / 50, i / 7] for i in range(30))]
        path = self.workbook({"Probe 1": rows})
        said = self.json("read", path)
        self.assertEqual((said["format"], said["test"]["span"]), ("Zwick testXpert", 0.017))
        self.assertEqual([column["role"] for column in said["columns"]], ["time", "crosshead", "force"])
        by_number = run("read", "-o", "-", path, "--crosshead", "2", "--force", "3")
        by_name = run("read", "-o", "-", path, "--crosshead", "Standardweg", "--force", "Standardkraft")
        self.assertEqual(by_number.stdout, by_name.stdout)
        text = self.file("text.csv", run("read", "-o", "-", path).stdout)
        self.assertEqual(run("read", "-o", "-", text).stdout, text.read_text(encoding="utf-8"))

    def test_rows_that_a_filter_hides_are_read_and_said(self):
        path = self.workbook({"a": [["Extension (mm)", "Load (N)"], *([i, 2 * i] for i in range(20))]})
        book = openpyxl.load_workbook(path)
        book["a"].auto_filter.ref = "A1:B21"
        for row in (5, 6, 7):
            book["a"].row_dimensions[row].hidden = True
        book.save(path)
        done = run("read", "-o", "-", path, "--crosshead", "1")
        self.assertEqual(len(numbers(done.stdout, "Load [N]")), 20)
        self.assertIn("3 rows are hidden by a filter, and read as all others are: lines 5 to 7", " ".join(done.stderr.split()))

    def test_a_sheet_is_chosen_by_name_or_number_and_the_decision_is_told(self):
        sheets = {f"Specimen {k}": [["Extension (mm)", "Load (N)"], *([i, k * i] for i in range(10))] for k in (1, 2, 3)}
        path = self.workbook({"Read me": [["nothing here"]], **sheets})
        first = run("read", "-o", "-", path, "--crosshead", "1")
        self.assertIn("the sheet is 'Specimen 1', the first of 'Read me', 'Specimen 1', 'Specimen 2' and 'Specimen 3' with a table of numbers", " ".join(first.stderr.split()))
        bar = ("--span", "20 mm", "--width", "2 mm", "--height", "1 mm")
        self.refused("modulus", path, *bar, says=["Which of the sheets 'Specimen 1', 'Specimen 2' and 'Specimen 3'", '--sheet "Specimen 1"'])
        self.refused("modulus", path, *bar, "--displacement", "deflection", says=["--sheet", "Each of the sheets 'Specimen 1', 'Specimen 2' and 'Specimen 3' holds a table of readings"])
        self.refused("modulus", path, *bar, "--deflection", "Extension", "--force", "Load", says=["--sheet", "Each of the sheets 'Specimen 1', 'Specimen 2' and 'Specimen 3' holds a table of readings"])
        for k in (1, 2, 3):
            for name in (f"Specimen {k}", str(k + 1)):
                said = run("read", "-o", "-", path, "--crosshead", "1", "--sheet", name, "--full")
                self.assertEqual(numbers(said.stdout, "Load [N]"), [float(k * i) for i in range(10)])
                again = said.stderr.split("the same way again: flexslip read ")[1].split(" --", 1)[1].strip()
                self.assertIn(f'sheet "Specimen {k}"', again)
        self.refused("read", path, "--sheet", "Specimen 4", says=["'Specimen 1', 'Specimen 2' and 'Specimen 3'", "Did you mean 'Specimen"])
        self.refused("read", self.file("a.csv", "Extension (mm),Load (N)\n1,2\n2,3\n"), "--sheet", "1", says=["--sheet", "a text file", "Leave it out"])
        self.refused("read", path, "--separator", ";", says=["--separator", "a workbook", "Leave out --separator"])
        case = self.file("case.toml", '[specimen]\ndiameter = "1 mm"\nmodulus = "fit"\n[rig]\nspan = "20 mm"\nstiffness = "inf"\n'
                                      '[record]\nfile = "test.xlsx"\nsheet = "Specimen 9"\ndisplacement = "crosshead"\n')
        self.refused("fit", case, says=["case.toml:9: [record] sheet", "'Specimen 9'"])

    def test_hidden_sheets_are_not_taken_unless_asked_for(self):
        book = openpyxl.Workbook()
        book.active.title = "calibration"
        book.active.append([1, 2])
        book.active.sheet_state = "hidden"
        for row in [["Extension (mm)", "Load (N)"], *([i, i] for i in range(5))]:
            sheet = book["shown"] if "shown" in book.sheetnames else book.create_sheet("shown")
            sheet.append(row)
        book.save(self.folder / "a.xlsx")
        self.assertEqual(self.json("read", self.folder / "a.xlsx")["sheet"], "shown")

    def test_wherever_a_table_is_read(self):
        def copy(name, text):
            self.file(name + ".csv", text)
            rows = [[float(cell) if is_float(cell) else cell for cell in row] for row in csv.reader(text.splitlines())]
            self.workbook({"a": rows}, name + ".xlsx")
        copy("stage", "w_s [um]\n0\n50\n100\n")
        copy("friction", "S [mm],mu\n0.9,0.3\n2,0.5\n")
        copy("states", "S,q\n1.05,0.2\n1.1,0.25\n")
        copy("points", "w,F\n0.1,4\n0.11,4.5\n")
        case = WAVY.split("[friction]")[0] + '[friction]\nmodel = "table"\nfile = "friction.csv"\nlength = "S [mm]"\nmu = "mu"\n[stage]\nfile = "stage.csv"\nstage = "w_s [um]"\n'
        calls = [["simulate", "case.toml"], ["state", "states.csv"], ["invert", "points.csv"]]
        tried = 0
        for command, *rest in calls:
            answers = []
            for ending in (".csv", ".xlsx"):
                self.file("case.toml", case.replace(".csv", ending))
                arguments = [str(self.folder / each.replace(".csv", ending)) if "." in each else each for each in rest]
                done = run(command, *arguments)
                self.assertEqual(done.returncode, 0, (command, done.stderr))
                answers.append(done.stdout.replace(ending, ""))
            self.assertEqual(without_digests(answers[0]), without_digests(answers[1]), command)
            tried += 1
        self.assertEqual(tried, 3)

    def test_a_campaign_of_workbooks(self):
        book = {f"Probe {k}": [TITLES, *READINGS[:: k]] for k in (1, 2)}
        self.workbook(book)
        rows = [["name", "file", "sheet", "diameter", "span [um]", "stiffness", "modulus"],
                *([f"t{k}", str(self.folder / "test.xlsx"), name, "34.8 um", 1278, "90.65 N/m", "29.6 GPa"] for k, name in ((1, "Probe 1"), (2, 2)))]
        self.workbook({"Tests": [[*row, *more] for row, more in zip(rows, [["stage", "force"], ["stage", "force"], ["stage", "force"]])]}, "tests.xlsx")
        tests = self.json("campaign", self.folder / "tests.xlsx")["tests"]
        self.assertEqual([(test["name"], test["status"]) for test in tests], [("t1", "ok"), ("t2", "ok")])
        alone = self.json("fit", EXAMPLE / "test.csv", "--diameter", "34.8 um", "--modulus", "29.6 GPa", "--span", "1278 um", "--stiffness", "90.65 N/m",
                          "--stage", "stage", "--force", "force")
        self.assertAlmostEqual(tests[0]["parameters"]["mu0"]["value"], alone["parameters"]["mu0"]["value"], delta=1e-9)  # openpyxl writes 16 digits

    def test_numbers_kept_as_words_and_a_text_file_opened_as_a_workbook(self):
        words = [["Extension (mm)", "Load (N)"], *([f"{i},25", f"{i},{i}1"] for i in range(12))]
        out = run("read", "-o", "-", self.workbook({"a": words}), "--crosshead", "1").stdout
        self.assertEqual(numbers(out, "Extension [mm]"), [i + 0.25 for i in range(12)])
        lines = [[";".join(row)] for row in words]
        again = run("read", "-o", "-", self.workbook({"a": lines}, "lines.xlsx"), "--crosshead", "1")
        self.assertEqual(again.stdout, out)
        self.assertIn("words in one column", again.stderr)

    def test_formulas_that_were_never_computed_are_told(self):
        path = self.workbook({"a": [["Extension (mm)", "Load (N)"], *([i, f"=A{i + 2}*2"] for i in range(8)), *([8 + i, i] for i in range(12))]})
        self.assertIn("8 formulas have no stored value", " ".join(run("read", "-o", "-", path, "--crosshead", "1").stderr.split()))

    def test_other_files_are_told_by_name_with_a_remedy(self):
        ods = io.BytesIO()
        with zipfile.ZipFile(ods, "w") as archive:
            archive.writestr("mimetype", "application/vnd.oasis.opendocument.spreadsheet")
            archive.writestr("content.xml", "<a/>")
        plain = io.BytesIO()
        with zipfile.ZipFile(plain, "w") as archive:
            archive.writestr("test.csv", "a,b\n1,2\n")
        old = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(600)
        self.refused_as(ods.getvalue(), "an OpenDocument (.ods)", REMEDY_OF_OTHERS)
        self.refused_as(old, "Excel 97 to 2003 (.xls)", "libreoffice --headless --convert-to xlsx")
        self.refused_as(old + "EncryptedPackage".encode("utf-16le") + bytes(64), "a workbook with a password", "Save it without a password")
        self.refused_as(raw({"a": NUMBERS}, main="xl/workbook.bin"), "a binary workbook (.xlsb)", REMEDY_OF_OTHERS)
        self.refused_as(plain.getvalue(), "an archive without a workbook", "Unpack it")
        self.refused_as(raw({"a": rows_of([["just", "words"]])}), "no rows of numbers on the sheet 'a'")
        self.refused_as(raw({"a": ""}), "no rows of numbers on the sheet 'a'")

    def test_broken_files_are_refused_in_a_sentence(self):
        good = raw({"a": NUMBERS})
        self.assertEqual(run("read", "-o", "-", self.file("a.xlsx", good)).returncode, 0)
        self.refused_as(good[: len(good) // 2], "The workbook is damaged", "cut off")
        encrypted = bytearray(good)
        for mark, at in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
            place = encrypted.find(mark)
            while place >= 0:
                encrypted[place + at] |= 1
                place = encrypted.find(mark, place + 4)
        self.refused_as(bytes(encrypted), "The workbook is encrypted", "without a password")
        for rows, words in (('<row r="2"><c r="A2"><v>1</v></c></row><row r="1"/>', "out of order"), ('<row r="1"><c r="B1"><v>1</v></c><c r="A1"/></row>', "out of order"),
                            ('<row r="9999999"><c><v>1</v></c></row>', "out of order"), ('<row><c r="ZZZZ1"><v>1</v></c></row>', "out of order"),
                            ("<row><c><v>1.5.2</v></c></row>", "'1.5.2'"), ('<row><c t="s"><v>7</v></c></row>', "but the workbook has"),
                            ("<row><c><v>1</v></row>", "its XML is broken"), ("<row><c><v>1</c></row>", "its XML is broken"), ("&bomb;", "its XML is broken")):
            self.refused_as(raw({"a": rows}), words)
        bomb = '<!DOCTYPE a [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;">]>'
        self.refused_as(raw({"a": NUMBERS}, doctype=bomb), "a document type")

    def test_a_damaged_workbook_never_gives_other_numbers(self):
        good = raw({"a": NUMBERS})
        right = run("read", "-o", "-", self.file("a.xlsx", good)).stdout
        draw = random.Random(3)
        for _ in range(60):
            bad = bytearray(good)
            for _ in range(draw.choice([1, 1, 3])):
                bad[draw.randrange(len(bad))] ^= 1 << draw.randrange(8)
            done = run("read", "-o", "-", self.file("a.xlsx", bytes(bad)))
            self.assertIn(done.returncode, (0, 2), done.stderr)
            if done.returncode == 0:
                self.assertEqual(done.stdout, right)

    def test_an_archive_made_to_fill_the_memory_is_refused(self):
        packed = io.BytesIO(raw({"a": NUMBERS}))
        out = io.BytesIO()
        with zipfile.ZipFile(packed) as old, zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as new:
            for part in old.namelist():
                if not part.endswith("s1.xml"):
                    new.writestr(part, old.read(part))
            with new.open("xl/worksheets/s1.xml", "w", force_zip64=True) as sheet:
                sheet.write(f'<worksheet xmlns="{MAIN}"><sheetData>'.encode())
                for _ in range(1 + (1 << 30) // (1 << 22)):
                    sheet.write(b" " * (1 << 22))
        self.refused_as(out.getvalue(), "more than 1024 MiB, unpacked", "Save the sheet with the measurement as CSV")
        wide = "".join(f'<row r="{i}"><c r="XFD{i}"><v>1</v></c></row>' for i in range(1, 60000))
        self.refused_as(raw({"a": wide}), "512 MiB")
        self.refused_as(raw({"a": "<a>" * 3_000_000}), "elements more than 100 deep")
        self.refused_as(raw({"a": '<row><c r="' + "A" * 40_000_000}), "an attribute in its XML without an end")
        many = b"".join(b'<Relationship Id="x%d" Type="a/b" Target="c"/>' % i for i in range(10_001))
        one_part = raw({"a": NUMBERS, "b": NUMBERS})
        with zipfile.ZipFile(io.BytesIO(one_part)) as old:
            parts = {name: old.read(name) for name in old.namelist()}
        relations = parts["xl/_rels/workbook.xml.rels"]
        for changed, words in ((relations.replace(b"s2.xml", b"s1.xml"), "two sheets of one part"), (relations.replace(b"</R", many + b"</R"), "more than 10000 relations")):
            out = io.BytesIO()
            with zipfile.ZipFile(out, "w") as new:
                for name, content in (parts | {"xl/_rels/workbook.xml.rels": changed}).items():
                    new.writestr(name, content)
            self.refused_as(out.getvalue(), words)

    def test_a_hundred_thousand_rows(self):
        """oracle: the numbers that were written; no assertion on time."""
        rows = "".join(f'<row r="{i + 2}"><c r="A{i + 2}"><v>{i / 100}</v></c><c r="B{i + 2}"><v>{math.sin(i / 1000)!r}</v></c></row>' for i in range(100_000))
        path = self.file("large.xlsx", raw({"a": rows_of([["Extension (mm)", "Load (N)"]]) .replace("<row>", '<row r="1">') + rows}))
        out = run("read", "-o", "-", path, "--crosshead", "1").stdout
        self.assertEqual(numbers(out, "Load [N]"), [math.sin(i / 1000) for i in range(100_000)])

    def test_from_standard_input(self):
        data = self.workbook({"a": [["Extension (mm)", "Load (N)"], *([i, i] for i in range(5))]}).read_bytes()
        done = subprocess.run([PROGRAM, "read", "-o", "-", "-", "--crosshead", "1"], input=data, capture_output=True, check=False)
        self.assertEqual(numbers(done.stdout.decode(), "Load [N]"), [0, 1, 2, 3, 4])


def is_float(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


def without_digests(text):
    return re.sub(r"[0-9a-f]{64}", "", text)


if __name__ == "__main__":
    unittest.main()
