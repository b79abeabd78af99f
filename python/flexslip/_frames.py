"""pandas frames as data. The program's own reader finds what their columns are."""
from __future__ import annotations

import csv
import os
import tempfile
from collections.abc import Mapping
from typing import TYPE_CHECKING, TypeGuard

from ._errors import InputError, error_of, one_of, refused, wrong
from ._read import read

if TYPE_CHECKING:
    import pandas

NAME = "frame"  # what such data are called
_ROLES = ("stage", "deflection", "force")  # that titles can say
_COLUMNS = (*_ROLES, "length")
_PAIRS = (("stage", "force"), ("deflection", "force"), ("stage", "deflection"))  # two tell the third


def is_frame(value: object) -> TypeGuard[pandas.DataFrame]:
    """Is it a pandas.DataFrame? Without importing pandas, which need not be there."""
    return hasattr(value, "iloc") and hasattr(value, "columns")


def whole_frame(frame: pandas.DataFrame) -> pandas.DataFrame:
    """With an index that has a name as a column, and titles as text."""
    if any(name is not None for name in frame.index.names):
        frame = frame.reset_index()
    return frame.set_axis([str(title) for title in frame.columns], axis=1)


def _titles(frame: pandas.DataFrame) -> dict[str, str]:
    """Titles as a file has them, with the units of `attrs["units"]`."""
    units = frame.attrs.get("units") or {}
    return {title: f"{title} [{units[title]}]" if units.get(title) not in (None, "", "1") else title for title in frame.columns}


def is_series(value: object) -> TypeGuard[pandas.Series]:
    """Is it a pandas.Series, whose name is a title?"""
    return hasattr(value, "iloc") and hasattr(value, "name")


def unit_of_series(series: pandas.Series) -> str:
    """The unit in the title of a column, or in its `attrs["units"]`; empty if there is none. The program's own reader finds it."""
    title = str(series.name)
    if unit := (series.attrs.get("units") or {}).get(series.name):
        return str(unit)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "column.csv")
        with open(path, "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([[title, "other"], *([row, row] for row in range(9))])
        try:
            return str(read(path)._columns[0]["unit"])
        except InputError:
            return ""  # no title of a file


def written(frame: pandas.DataFrame, path: str) -> None:
    """A frame as a file that the program reads, its numbers to the last bit."""
    frame = whole_frame(frame)
    frame.rename(columns=_titles(frame)).to_csv(path, index=False)


def _with_numbers(frame: pandas.DataFrame) -> pandas.DataFrame:
    """A frame whose columns of numbers as text are numbers, so that the reader finds what its columns are; whether their text is right is told later."""
    import pandas as pd

    def numbers(column: pandas.Series) -> pandas.Series:
        if column.dtype.kind != "O":
            return column
        read = pd.to_numeric(column.astype(str).str.replace(",", ".", regex=False), errors="coerce")
        return read if 2 * read.notna().sum() > len(read) else column

    out = pd.concat([numbers(frame.iloc[:, at]) for at in range(frame.shape[1])], axis=1) if frame.shape[1] else frame
    out.attrs = frame.attrs
    return out


def _given(frame: pandas.DataFrame, record: Mapping[str, object]) -> dict[str, tuple[str, str | None]]:
    """The title of each column that the call names, and the unit beside it: force="Load", force=("Load", "kN")."""
    given: dict[str, tuple[str, str | None]] = {}
    for role in _COLUMNS:
        named = record.get(role)
        if isinstance(named, str):
            named = named, None
        if not (isinstance(named, tuple) and len(named) == 2 and isinstance(named[0], str)):
            continue
        title, unit = named
        if title not in frame.columns:
            raise wrong(role, f"one of the columns {', '.join(frame.columns)}", title, key=f"record.{role}")
        given[role] = title, unit
    return given


def record_of(frame: pandas.DataFrame, record: Mapping[str, object]) -> dict[str, object]:
    """What a call says of a record, with the columns of a frame as arrays: those that it names, or else those whose titles say what they are."""
    frame = whole_frame(frame)
    own = next((pair for pair in _PAIRS if all(name in frame.columns for name in pair)), ())  # as the package's own frames have them
    given = _given(frame, record) or ({} if record.get("displacement") else {name: (name, None) for name in own})
    titled, units = _read(frame, record.get("displacement"), len(given) < 2)
    out = {name: value for name, value in record.items() if name not in (*_COLUMNS, "displacement")}
    columns = {role: (title, None) for role, title in titled.items()} | given
    if all(role in columns for role in _ROLES) and not all(role in given for role in _ROLES):  # one too many: as of a file, a deflectometer comes first
        stated = {"crosshead": {"stage"}, "deflection": {"deflection"}}.get(str(record.get("displacement")), set())
        pair = next(pair for pair in (("deflection", "force"), *_PAIRS) if stated | ({*given} & {*_ROLES}) <= {*pair})
        columns = {role: named for role, named in columns.items() if role in (*pair, "length")}
    for role, (title, unit) in columns.items():
        unit = unit or units.get(title)
        if not unit and role not in given:
            raise wrong(f"column {title!r}", "titled with a unit", "without one", f"name it as in {title + (' [N]' if role == 'force' else ' [mm]')!r}, or say {role}=({title!r}, \"{'N' if role == 'force' else 'mm'}\")",
                        key=f"record.{role}")
        out[role] = (frame[title], unit) if unit else frame[title]
    return out


def _read(frame: pandas.DataFrame, displacement: object, by_titles: bool) -> tuple[dict[str, str], dict[str, str]]:
    """The titles of stage, deflection and force, as far as they say so, and the units of all columns."""
    said = None if displacement is None else one_of("displacement", displacement, ("crosshead", "deflection"))
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "frame.csv")
        written(_with_numbers(frame.head(1000)), path)
        try:
            export = read(path)
            if said and not {"crosshead", "deflection"} <= {column["role"] for column in export._columns}:
                export = read(path, displacement=said)
            columns = list(zip(frame.columns, export._columns))
        except InputError as error:
            raise in_words_of_frame(error, path) from None
    roles = {column["role"]: title for title, column in columns}
    found = {role: roles[name] for role, name in (("stage", "crosshead"), ("deflection", "deflection"), ("force", "force")) if name in roles}
    if by_titles and "displacement" in roles and len(found) == ("force" in found):
        raise wrong(f"column {roles['displacement']!r}", "a title that says whether it is of the stage or at midspan", "one that does not",
                    "say displacement=\"crosshead\" or displacement=\"deflection\"", key="record.displacement")
    empty = [repr(title) for at, title in enumerate(frame.columns) if bool(frame.iloc[:, at].isna().all())]
    if by_titles and len(found) < 2 and empty:
        raise refused(f"column{'s' if len(empty) > 1 else ''} {' and '.join(empty)}", f"None of the {len(frame)} rows has a number (NaN)", "check how the frame was made",
                      key="record.force" if "force" not in found else "record.stage")
    if by_titles and len(found) < 2:
        raise wrong("DataFrame", "titles that say which columns are displacement and force", ", ".join(map(repr, frame.columns)),
                    "say which they are, as in stage=(\"x\", \"mm\"), force=(\"F\", \"N\")", key="record.force" if "force" not in found else "record.stage")
    return found if by_titles else {}, {title: column["unit"] for title, column in columns if column["unit"]} | {title: unit for title, unit in (frame.attrs.get("units") or {}).items() if unit}


def in_words_of_frame(error: InputError, path: str) -> InputError:
    """A complaint about a file that nobody wrote, in words of the frame that it holds."""
    parts = {name: getattr(error, name) for name in ("field", "key", "kind", "limit", "problem", "remedy")}
    return error_of(str(error).replace(path, NAME), **parts)
