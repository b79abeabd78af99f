"""Workbooks of Excel 97 to 2003 (.xls), which the program does not read: through xlrd, where that is installed."""
from __future__ import annotations

import atexit
import csv
import pathlib
import shutil
import tempfile
from typing import TYPE_CHECKING

from ._errors import refused

if TYPE_CHECKING:
    import xlrd

_MARK = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"


def readable(path: str, sheet: str | int | None) -> tuple[str, str | int | None]:
    """A file and a sheet that the program reads: of a .xls, the sheet as CSV in a temporary folder; of any other, both as they are.

    Without a sheet, that with the most cells that hold numbers.
    """
    try:
        with open(path, "rb") as file:
            if file.read(len(_MARK)) != _MARK:
                return path, sheet
    except OSError:
        return path, sheet  # the program says what is wrong
    try:
        import xlrd
    except ImportError:
        raise refused("file", f"{path} is a workbook of Excel 97 to 2003 (.xls)", "install xlrd, or convert it: libreoffice --headless --convert-to xlsx FILE",
                      file=path) from None
    try:
        book = xlrd.open_workbook(path)
    except xlrd.XLRDError as error:
        raise refused("file", f"{path} is no workbook that xlrd reads: {error}", "save it as .xlsx", file=path) from None
    folder = pathlib.Path(tempfile.mkdtemp(prefix="flexslip-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    plain = folder / (pathlib.Path(path).stem + ".csv")
    chosen = _chosen(book, path, sheet)
    with open(plain, "w", newline="", encoding="utf-8") as out:
        writer = csv.writer(out)
        for row in range(chosen.nrows):
            writer.writerow([repr(cell.value) if cell.ctype == xlrd.XL_CELL_NUMBER else str(cell.value) for cell in chosen.row(row)])
    return str(plain), None


def _chosen(book: xlrd.Book, path: str, sheet: str | int | None) -> xlrd.sheet.Sheet:
    import xlrd

    if sheet is None:
        def numbers(each: xlrd.sheet.Sheet) -> int:
            return sum(cell.ctype == xlrd.XL_CELL_NUMBER for row in range(each.nrows) for cell in each.row(row))
        return max(book.sheets(), key=numbers)
    for number, each in enumerate(book.sheets(), 1):
        if sheet in (each.name, number):
            return each
    raise refused("sheet", f"{path} has the sheets {', '.join(map(repr, book.sheet_names()))}, not {sheet!r}", file=path)
