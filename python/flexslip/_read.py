"""Exports of testing machines."""
from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from . import _flexslip
from ._answers import Data, Numbers, html_of
from ._errors import Path, one_of, path_of, whole, wrong
from ._xls import readable
from ._fields import ExportFields

if TYPE_CHECKING:
    import pandas

    from ._flexslip import ExportColumn

_ROLES = ("time", "displacement", "crosshead", "deflection", "force")


class Export(ExportFields):
    """What an export of a testing machine holds, as :func:`read` gives it: every answer of ``flexslip read --json``, and the numbers.

    Attributes
    ----------
    data : dict
        Columns by name, in the units of the file: NumPy arrays, NaN where a cell holds no number.
    """

    _title = "Export"

    def __init__(self, data: Data, columns: list[ExportColumn], in_si: Mapping[str, Numbers | ValueError]) -> None:
        super().__init__(data)
        self._columns, self._in_si = columns, in_si

    def __reduce__(self) -> tuple[object, ...]:
        return Export, (self._data, self._columns, self._in_si)

    @property
    def data(self) -> dict[str, npt.NDArray[np.float64] | list[str]]:
        """Columns by name, in the units of the file: NumPy arrays, NaN where a cell holds no number."""
        return {column["name"]: column["values"] for column in self._columns}

    def si(self, role: str) -> Numbers:
        """The column with a role in SI: "time", "displacement", "crosshead", "deflection" or "force".

        Raises
        ------
        InputError
            If no column has it, or several; for a unit that is missing or of another kind.
        """
        one_of("role", role, _ROLES)
        values = self._in_si[role]
        if isinstance(values, Exception):
            raise values
        return values

    def to_frame(self) -> pandas.DataFrame:
        """A pandas.DataFrame of its columns, in the units of the file, which `attrs["units"]` has."""
        import pandas as pd

        frame = pd.DataFrame(self.data)
        frame.attrs["units"] = {column["name"]: column["unit"] for column in self._columns}
        return frame

    def _shown(self) -> list[tuple[str, str, str]]:
        return [row for row in super()._shown() if row[0] != "columns" and row[1]]

    def _repr_html_(self) -> str:
        return html_of(self.columns._cells(), f"{self.rows} rows of numbers") + super()._repr_html_()

    def __repr__(self) -> str:
        names = ", ".join(f"{column['name']}{' [' + column['unit'] + ']' if column['unit'] else ''}: {column['role']}" for column in self._columns)
        return f"<Export, {self.format}, {self.rows} rows: {names}>"


def read(file: Path, *, specimen: int | None = None, sheet: str | int | None = None, encoding: str | None = None, separator: str | None = None, decimal: str | None = None,
         thousands: str | None = None, time: str | int | None = None, crosshead: str | int | None = None, deflection: str | int | None = None,
         force: str | int | None = None, displacement: str | None = None, time_unit: str | None = None, displacement_unit: str | None = None,
         force_unit: str | None = None, calibration: str | None = None) -> Export:
    """Any testing machine's export: its numbers, and what was decided about it.

    Parameters
    ----------
    file : path
    specimen : int, optional
        Which of several specimens, counted from 1; the first.
    sheet : str or int, optional
        Of a workbook (.xlsx; .xls where xlrd is installed): its name as a string, its number as an int; the first with a table of numbers.
    encoding, separator, decimal, thousands : str, optional
        Found, unless they are given: ``"cp1252"``, ``";"``, ``","``, ``"."``.
    time, crosshead, deflection, force : str or int, optional
        Name or number of a column, if it is not found.
    displacement : {"crosshead", "deflection"}, optional
        What a displacement is, if its name does not say.
    time_unit, displacement_unit, force_unit : str, optional
        Units, where the file states none.
    calibration : str, optional
        Of a force in volts, ``"222 N/V"``.

    Raises
    ------
    InputError
        For a file without numbers, or columns that cannot be told apart; a FileNotFoundError as well if it is not there.

    Examples
    --------
    >>> import flexslip
    >>> export = flexslip.read("examples/simulated/test.csv")
    >>> export.rows, export.data["force"].dtype
    (426, dtype('float64'))
    """
    path, sheet = readable(path_of(file), sheet)
    given = {"sheet": sheet, "encoding": encoding, "separator": separator, "decimal": decimal, "thousands": thousands, "time": time, "crosshead": crosshead,
             "deflection": deflection, "force": force, "displacement": displacement, "time_unit": time_unit,
             "displacement_unit": displacement_unit, "force_unit": force_unit, "calibration": calibration}
    words: dict[str, str | int] = {}
    for name, value in given.items():
        if value is None:
            continue
        if name == "sheet" and isinstance(value, (int, np.integer)) and not isinstance(value, bool):
            words["sheet_number"] = whole("sheet", value, 1, 2**31)
            continue
        if name in (*_ROLES[:1], *_ROLES[2:]) and isinstance(value, (int, np.integer)) and not isinstance(value, bool):
            value = str(int(value))
        if not isinstance(value, str):
            raise wrong(name, "text", value)
        words[name] = value
    if displacement is not None:
        one_of("displacement", displacement, ("crosshead", "deflection"))
    if force_unit is not None and calibration is not None:
        raise wrong("calibration", "either a unit of the force or its calibration", "both")
    export = _flexslip.read(os.fsencode(path), words)
    chosen = 0 if specimen is None else whole("specimen", specimen, 1, export.specimens) - 1
    in_si: dict[str, Numbers | ValueError] = {}
    for role in _ROLES:
        try:
            in_si[role] = export.in_si(chosen, role)
        except ValueError as error:
            in_si[role] = error
    return Export(export.answer(chosen), export.columns(chosen), in_si)
