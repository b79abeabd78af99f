#!/usr/bin/python3
"""Writes tests/instruments/fixtures: small exports in the formats of machines of which no real file is at hand.

Each is written from a description of its format, which its function names. The curve is the same in all, so that a test
knows every number: time i/10 s, displacement i/50 mm, force 40 i - i^2/10 N (a row i), rounded to the file's decimals.
"""
import io
import pathlib
import zipfile

FOLDER = pathlib.Path(__file__).resolve().parent / "fixtures"
ROWS = range(40)


def curve(i, scale=1.0):
    return i / 10, i / 50, scale * (40 * i - i * i / 10)


def comma(value, decimals):
    return f"{value:.{decimals}f}".replace(".", ",")


def shimadzu():
    """Shimadzu Trapezium X, as the reader `snpl` takes it apart: Shift-JIS; blocks separated by blank rows: header, geometry
    (names, units, a row for each specimen), results, then for each specimen its name, names, units, rows; empty columns."""
    lines = ["試験モード,曲げ,", "試験速度,1.0,mm/min", "", "名前,厚さ,幅,", ",mm,mm,", "1 _ 1,2.0,10.0,", "1 _ 2,2.1,10.1,", "",
             "名前,最大_試験力,", ",N,", "1 _ 1,1407.9,", "1 _ 2,2815.8,"]
    for number in (1, 2):
        lines += ["", f"1 _ {number},,,", "時間,試験力,ストローク,", "s,N,mm,"]
        for i in ROWS:
            t, d, f = curve(i, number)
            lines.append(f"{t:.2f},{f:.4f},{d:.5f},")
    return "\r\n".join(lines).encode("shift_jis") + b"\r\n"


def zwick():
    """Zwick testXpert, as its German exports are described: CP1252, semicolons, decimal commas, the names somewhere in the
    first 80 lines, a row of units below them."""
    lines = ['"Prüfprotokoll"', '"Prüfer";"Müller"', '"Auflagerabstand";64,0;"mm"', '"Probendicke a0";4,02;"mm"',
             '"Probenbreite b0";10,05;"mm"', '"Prüfgeschwindigkeit";2;"mm/min"']
    lines += [f'"Bemerkung {i}";"über {i} °C"' for i in range(1, 61)]
    lines += ['"Prüfzeit";"Standardkraft";"Traversenweg"', '"s";"N";"mm"']
    for i in ROWS:
        t, d, f = curve(i)
        lines.append(";".join((comma(t, 2), comma(f, 3), comma(d, 4))))
    return "\r\n".join(lines).encode("cp1252") + b"\r\n"


def utf16(codec, mark):
    """A spreadsheet's "Unicode text": UTF-16 with tabs, with a byte order mark or, from some programs, without."""
    lines = ["Zeit [s]\tTraversenweg [mm]\tKraft [N]"]
    lines += ["\t".join((comma(t, 1), comma(d, 2), comma(f, 1))) for t, d, f in map(curve, ROWS)]
    return mark + ("\r\n".join(lines) + "\r\n").encode(codec)


def bluehill_universal():
    """Bluehill Universal: names with their units in one row, behind a marker `Raw Data`; compression is negative."""
    lines = ["Results Table 1", ",Maximum Force,Flexure stress at Maximum Force", ",(kN),(MPa)", "1,1.4079,52.1", "", "Raw Data",
             "Time (s),Displacement (mm),Force (kN)"]
    lines += [f"{t:.4f},{-d:.5f},{-f / 1000:.6f}" for t, d, f in map(curve, ROWS)]
    return ("\r\n".join(lines) + "\r\n").encode()


def bluehill_thousands():
    """Bluehill 2 in an English locale: every number quoted, with separators of thousands."""
    lines = ['"Time","Extension","Load"', '"(s)","(mm)","(N)"']
    lines += [f'"{t:.5f}","{d:.5f}","{f:,.5f}"' for t, d, f in map(curve, ROWS)]
    return ("\n".join(lines) + "\n").encode()


def mts_testsuite():
    """MTS TestSuite: a byte order mark, four lines of preamble, blanks, names with spaces behind them, a row of units,
    tabs; compression is negative."""
    lines = [r"File Path: C:\Tests\beam.txt", "Test: 3-point bend", "Test Run: beam 7", "Date: 10/26/2022 1:02:25 PM", "", "",
             "Running Time \tCrosshead \tLoad ", "sec\tmm\tkN"]
    lines += [f"{t:.10f}\t{-d:.13f}\t{-f / 1000:.13f}" for t, d, f in map(curve, ROWS)]
    return b"\xef\xbb\xbf" + ("\r\n".join(lines) + "\r\n").encode()


def mts_blocks():
    """MTS 793: a data header that is repeated above each block of a cyclic test."""
    lines = ["MTS793|BTW|ENU|1|0|.|/|:|1|0|0|A"]
    for number in (1, 2):
        lines += ["", f"Data Header:        Time:     {number}.5 Sec       28/01/2022 11:15:59", "Station Name: rig.cfg",
                  "Ch 1 Displacement Ch 1 Force Time", "mm        N        Sec"]
        lines += [f"{d:.6g} {f:.8g} {t:.8g}" for t, d, f in (curve(i, number) for i in ROWS)]
    return ("\r\n".join(lines) + "\r\n").encode()


def force_gauge():
    """A hand-held gauge: each line has its force with the unit; no names at all."""
    return "".join(f"{t:.1f} s,{f:.1f} N\n" for t, d, f in map(curve, ROWS)).encode()


def force_gauge_columns():
    """A Schmidt gauge's manual: lines `ffffff,uuu,dddd,rrr`, the unit in a column of its own."""
    return "".join(f"{f:06.1f},N,{d:.2f},{i}\n" for i, (t, d, f) in enumerate(map(curve, ROWS))).encode()


def texture_analyser():
    """A laboratory's own script: five lines about the test, names with units behind a space, blanks between."""
    lines = ["Beam test", "Operator: someone", "Span: 17 mm", "Rate: 0.5 mm/min", "", "Time sec   Deflection mm   Load N"]
    lines += [f"{t:8.3f} {d:12.5f} {f:12.4f}" for t, d, f in map(curve, ROWS)]
    return ("\n".join(lines) + "\n").encode()


def wintest():
    """TA (Bose) WinTest: the name of the file, which ends with a NUL; channels and units of all sensors, the waveform and the settings of
    the acquisition; the titles of what was recorded in quotes, a row of units, and a separator behind each row."""
    bar = "_" * 40
    lines = ["C:\\WinTest\\TestData\\beam_tdf.CSV\0", "", "Created ,01/02/2024,10:00:00", "", "Channels", "Disp,Load,Axial cmd,Axial err,", "",
             "Units", "mm,N,V,%,", "", "Movers", "Axial,", "", bar, "****Data Acquisition Setup****", "",
             "Axial,Step:1,Scan Time: 1,Scan Points: 10,Number of Scans: 4,Time Between Scans: 1,", bar, "",
             '"Points","Elapsed Time","Disp","Load","Axial cmd",', '"","Sec","mm","N","V",']
    for i in ROWS:
        t, d, f = curve(i)
        lines.append(f"{i + 1},{t:.4f},{d:.3f},{f:.3f},{d / 10:.4f},")
    return "\r\n".join(lines).encode() + b"\r\n"


def no_header():
    """Numbers and nothing else."""
    return "".join(f"{t:.3f},{d:.5f},{f:.4f}\n" for t, d, f in map(curve, ROWS)).encode()


def undecidable():
    """Each number has three digits behind its only comma: thousands, or decimals?"""
    return "".join(f"{1 + i},{100 + i:03d}\t{2 + i},{200 + i:03d}\n" for i in ROWS).encode()


def voltage():
    """A recorder beside a machine: the load cell's voltage, and no force."""
    lines = ["Time [s],Stroke [mm],Load [V]"]
    lines += [f"{t:.2f},{d:.4f},{f / 222:.6f}" for t, d, f in map(curve, ROWS)]
    return ("\n".join(lines) + "\n").encode()


def two_specimens():
    """A workbook by hand: what was noted, and a sheet for each of two specimens."""
    main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
    office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
    package = "http://schemas.openxmlformats.org/package/2006/relationships"

    def sheet(rows):
        cells = lambda row: "".join(f'<c t="inlineStr"><is><t>{each}</t></is></c>' if isinstance(each, str) else f"<c><v>{each!r}</v></c>" for each in row)
        return f'<worksheet xmlns="{main}"><sheetData>{"".join(f"<row>{cells(row)}</row>" for row in rows)}</sheetData></worksheet>'

    titles = ["Time (s)", "Crosshead (mm)", "Force (N)"]
    sheets = {"Notes": [["Beam test"], ["Operator", "someone"]],
              **{f"Specimen {k}": [["Support span", "17 mm"], [], titles, *([t, d, f / k] for t, d, f in map(curve, ROWS))] for k in (1, 2)}}
    related = lambda kind, target, name: f'<Relationship Id="{name}" Type="{office}/{kind}" Target="{target}"/>'
    relations = "".join(related("worksheet", f"worksheets/{i}.xml", f"r{i}") for i in range(len(sheets)))
    listed = "".join(f'<sheet name="{name}" sheetId="{i + 1}" r:id="r{i}"/>' for i, name in enumerate(sheets))
    parts = {"_rels/.rels": f'<Relationships xmlns="{package}">{related("officeDocument", "xl/workbook.xml", "r")}</Relationships>',
             "xl/workbook.xml": f'<workbook xmlns="{main}" xmlns:r="{office}"><sheets>{listed}</sheets></workbook>',
             "xl/_rels/workbook.xml.rels": f'<Relationships xmlns="{package}">{relations}</Relationships>',
             **{f"xl/worksheets/{i}.xml": sheet(rows) for i, rows in enumerate(sheets.values())}}
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as archive:
        for name, text in parts.items():
            archive.writestr(zipfile.ZipInfo(name), text)  # of 1980, whenever it is made; not packed, as zlib's versions differ
    return packed.getvalue()


FIXTURES = {
    "shimadzu.csv": shimadzu(),
    "zwick.csv": zwick(),
    "utf16le.txt": utf16("utf-16-le", b"\xff\xfe"),
    "utf16be.txt": utf16("utf-16-be", b"\xfe\xff"),
    "utf16le_without_mark.txt": utf16("utf-16-le", b""),
    "utf16be_without_mark.txt": utf16("utf-16-be", b""),
    "bluehill_universal.csv": bluehill_universal(),
    "bluehill_thousands.csv": bluehill_thousands(),
    "mts_testsuite.txt": mts_testsuite(),
    "mts_blocks.dat": mts_blocks(),
    "force_gauge.csv": force_gauge(),
    "force_gauge_columns.csv": force_gauge_columns(),
    "texture_analyser.txt": texture_analyser(),
    "wintest.csv": wintest(),
    "no_header.csv": no_header(),
    "undecidable.txt": undecidable(),
    "voltage.csv": voltage(),
    "two_specimens.xlsx": two_specimens(),
}

if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    for name, content in FIXTURES.items():
        (FOLDER / name).write_bytes(content)
    print(f"{len(FIXTURES)} files, {sum(map(len, FIXTURES.values()))} bytes")
