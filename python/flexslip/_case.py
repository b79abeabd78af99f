"""Cases from keywords, by the table of keys of which the reader of case files is made."""
from __future__ import annotations

import contextlib
import os
import re
import reprlib
import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, SupportsFloat, TypeGuard, TypeVar, cast

import numpy as np
import numpy.typing as npt

from . import _flexslip
from ._answers import Answer, Numbers, Quantity
from ._errors import ARRAYS, InputError, error_of, in_keywords, of_keywords, path_of, refused, warn, wrong, yes_no
from ._xls import readable
from ._frames import is_frame, is_series, record_of, unit_of_series

if TYPE_CHECKING:
    import pandas

    from ._flexslip import Key

Function = TypeVar("Function", bound=Callable[..., Any])
Sections = dict[str, dict[str, object]]
SECTIONS = ("specimen", "rig", "friction", "stage", "record")
KEYS = {(key["section"], key["name"]): key for key in _flexslip.keys()}
# Keys that may stand without their section: those of specimen and rig, and those of a record that have a flag.
FLAT: dict[str, Key] = {}
for (_section, _name), _key in KEYS.items():
    if _section in ("specimen", "rig") or (_section == "record" and _key["flag"]):
        FLAT[_name] = _key


def keys() -> list[Key]:
    """Every key of a case: its section, name, what it holds, an example, the unit of a bare number, and its meaning.

    Examples
    --------
    >>> import flexslip
    >>> [key["unit"] for key in flexslip.keys() if key["name"] == "span"]
    ['m']
    """
    return [key.copy() for key in KEYS.values()]


def unit_of_parameter(name: str) -> str:
    """What bare numbers of a design's parameter are in: SI, as its key has it."""
    key = FLAT.get(name) or next((key for (_, known), key in KEYS.items() if known == name), None)
    return "m" if name == "travel" else str(key["unit"]) if key else ""


def _in_quotes(text: str) -> str:
    out = '"'
    for character in text:
        if character in '"\\':
            out += "\\" + character
        elif ord(character) < 0x20 or ord(character) == 0x7F:
            out += f"\\u{ord(character):04x}"
        else:
            out += character
    return out + '"'


def _number(value: object, unit: str, reduced: bool) -> str:
    number = float(cast(SupportsFloat, value))
    if number == float("inf"):
        return '"inf"'
    if reduced or not unit:
        return repr(number)
    return _in_quotes(f"{number!r} {unit}")


def _is_number(value: object) -> TypeGuard[int | float]:
    return isinstance(value, (int, float, np.integer, np.floating)) and not isinstance(value, (bool, np.bool_))


def _described(key: Key, value: object) -> InputError:
    name = f"{key['section']}.{key['name']}" if key["section"] else key["name"]
    shown = f"[{key['section']}] {key['name']}" if key["section"] else key["name"]
    return wrong(in_keywords(shown), key["holds"], value, f"pass it as in {key['example']}" if key["example"] else None, key=name)


def _without_quantity(value: object, reduced: bool) -> object:
    """A quantity as text with its unit, which the reader of cases holds against the key; anything else as it is."""
    if not isinstance(value, Quantity):
        return value
    return float(value) if value.unit in ("", "1") or (reduced and "L" in value.unit) else f"{float(value)!r} {value.unit}"


def _part_of_estimate(key: Key, part: object, reduced: bool) -> str:
    part = _without_quantity(part, reduced)
    if isinstance(part, str):
        return _in_quotes(part)
    if not _is_number(part):
        raise _described(key, part)
    return _number(part, key["unit"], reduced)


def toml_of(key: Key, value: object, reduced: bool) -> str:
    """A value of a key as a case file has it; bare numbers are in SI."""
    value = _without_quantity(value, reduced)
    if isinstance(value, int) and abs(value) > 2**1000:
        raise _described(key, f"{str(value)[:20]}…")
    if isinstance(value, str) and any(0xD800 <= ord(character) < 0xE000 for character in value):
        raise _described(key, value.encode("unicode_escape").decode())
    if isinstance(value, np.ndarray):
        value = value.tolist() if value.ndim else value.item()
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, str):
        return _in_quotes(value)
    holds, unit = key["is"], key["unit"]
    if _is_number(value):
        if holds in ("whole_number", "name_or_number") or (holds == "place" and isinstance(value, (int, np.integer))):
            return repr(int(value)) if float(value).is_integer() else repr(float(value))
        if holds == "place":
            if not reduced and float(value).is_integer() and value >= 1:  # a count that pandas made a float: no record is metres long
                raise wrong(key["name"], "a row, which is an int, or a stage position in m", repr(float(value)),
                            f"write {int(value)} for that row, or \"{int(value)} m\" for that position", key=f"record.{key['name']}")
            return _number(value, "m", reduced)
        if holds in ("quantity", "estimate", "share", "lengths") and value == value:
            return _number(value, unit, reduced)
        raise _described(key, value)
    if holds == "estimate" and isinstance(value, (tuple, list)) and len(value) == 2:
        value = {"value": value[0], "uncertainty": value[1]}
    if holds == "estimate" and isinstance(value, Mapping):
        return _table({name: _part_of_estimate(key, part, reduced) for name, part in value.items()})
    if holds == "place" and isinstance(value, Mapping):
        return _table({name: toml_of(key, part, reduced) for name, part in value.items()})
    if holds == "lengths" and isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml_of(key, part, reduced) for part in value) + "]"
    if holds == "tables" and isinstance(value, (list, tuple)):
        below = key["section"] if key["section"] == "friction" else f"{key['section']}.{key['name']}"
        return "[" + ", ".join(_table(_values(below, part, reduced)) for part in value) + "]"
    raise _described(key, value)


def cell_of(key: Key, value: object) -> object:
    """A value of a key in a table: numbers in SI get their unit, NaN is an empty cell. Whole numbers of a place are rows, as in every table."""
    value = _without_quantity(value, False)
    unit = "m" if key["is"] == "place" else key["unit"]
    if not _is_number(value) or value != value or not unit or key["is"] not in ("quantity", "estimate", "lengths", "place"):
        return value
    return value if key["is"] == "place" and float(value).is_integer() else _number(value, unit, False).strip('"')


def quantity_in_words(name: str, value: object, unit: str, holds: str, reduced: bool = False) -> str:
    """An option that is a quantity, as the program reads it: a string with its unit, or a float in SI."""
    value = _without_quantity(value, reduced)
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, str):
        return encodable(name, value, holds)
    if not _is_number(value) or (isinstance(value, int) and abs(value) > 2**1000):
        raise wrong(name, holds + (f', such as "1 {unit}", or a number in {unit}' if unit and not reduced else ""), value)
    return f"{float(value)!r}" + (f" {unit}" if unit and not reduced else "")


def encodable(name: str, text: str, holds: str = "text") -> str:
    """Text that UTF-8 has: no half of a character."""
    if any(0xD800 <= ord(character) < 0xE000 for character in text):
        raise wrong(name, holds, text.encode("unicode_escape").decode())
    return text


def _table(values: Mapping[str, str]) -> str:
    return "{ " + ", ".join(f"{name} = {value}" for name, value in values.items()) + " }"


def _values(section: str, given: object, reduced: bool) -> dict[str, str]:
    """The values of a section, as a case file has them."""
    if not isinstance(given, Mapping):
        raise wrong(f"[{section}]", "a dict of keys", given, key=section)
    values = {}
    for name, value in given.items():
        if value is None:
            continue
        if not isinstance(name, str) or not name.replace("_", "").isalnum():
            raise wrong(f"[{section}]", "a name of a key", name, key=section)
        values[name] = toml_of(_known(section, name), value, reduced)
    return values


_WITH_OTHERS = ("sweep", "sweep.axes", "friction.other")  # sections whose keys are not all known here


def _known(section: str, name: str) -> Key:
    """What is known of a key; of one that is unknown, which is left to the reader, that it holds a value."""
    unknown = {"is": "quantity", "unit": "", "holds": "a value", "example": "", "section": section, "name": name}
    return KEYS.get((section, name)) or cast("Key", unknown)



def _nearest(name: str, names: Iterable[str]) -> str:
    import difflib

    near = difflib.get_close_matches(name, names, 1)
    return f"did you mean {near[0]!r}?" if near else "flexslip.keys() lists the keys"


def _said_twice(section: str, name: str, first: object, second: str) -> InputError:
    return wrong(name, "one value", f"{section}={{{name!r}: {reprlib.repr(first)}}} and {second}", "leave one out", key=f"{section}.{name}")


def sections_of(keywords: Mapping[str, object]) -> Sections:
    """Keywords by section: a dict is a section, anything else the value of a key."""
    sections: Sections = {}
    flat: dict[str, object] = {}
    for name, value in keywords.items():
        if value is None:
            continue
        if name in SECTIONS and (isinstance(value, Mapping) or name not in FLAT):
            if not isinstance(value, Mapping):
                raise wrong(f"[{name}]", "a dict of keys", value, key=name)
            sections.setdefault(name, {}).update(value)
        elif name in FLAT:
            flat[name] = value
        else:
            raise TypeError(f"unexpected keyword argument {name!r}; " + _nearest(name, [*FLAT, *SECTIONS, *OPTIONS]))
    for name, value in flat.items():
        section = sections.setdefault(FLAT[name]["section"], {})
        if section.get(name) is not None:
            raise _said_twice(FLAT[name]["section"], name, section[name], f"{name}={reprlib.repr(value)}")
        section[name] = value
    return sections


def _named(name: object) -> tuple[str, str]:
    """The section and the key that a whole name in `set` has."""
    if not isinstance(name, str):
        raise wrong("set", "a name of a key", name)
    section, _, key = encodable("set", name, "a name of a key").rpartition(".")
    if (section, key) not in KEYS and section not in _WITH_OTHERS:
        names = [f"{of}.{known}" if of else known for of, known in KEYS]
        raise wrong("set", "a key of a case, as in \"rig.stiffness\"", name, _nearest(name, names), key=name, kind="unknown")
    return section, key


def set_of(given: object, reduced: bool) -> list[str]:
    """Keys that change, by their whole names."""
    if given is None:
        return []
    if not isinstance(given, Mapping):
        raise wrong("set", "a dict of keys, {\"rig.stiffness\": \"200 N/m\"}", given)
    changes = []
    for name, value in given.items():
        section, key = _named(name)
        changes.append(f"{name}={toml_of(_known(section, key), value, reduced)}")
    return changes


_COLUMNS = ("stage", "deflection", "force", "length")  # in the order in which a record has them
_MA: Any = np.ma  # whose functions have no types


def _is_array(value: object) -> bool:
    return not isinstance(value, (str, bytes, Mapping)) and (hasattr(value, "__array__") or isinstance(value, (list, tuple)))


def _unit_of_title(series: pandas.Series, reduced: bool) -> str | None:
    """The unit that a column of a frame states; None if it states none, or one of the reduced variables of a reduced case."""
    unit = unit_of_series(series)
    return None if unit in ("", "1") or (reduced and "L" in unit) else unit


def _values_of(given: object) -> tuple[object, str | None]:
    """A column without the unit that may stand beside it, and that unit."""
    if isinstance(given, tuple) and len(given) == 2 and isinstance(given[1], str):
        return given[0], given[1]
    return given, None


def _refused_cell(name: str, place: str, found: object, remedy: str) -> InputError:
    return wrong(place, "a finite number", found if isinstance(found, str) else repr(found), remedy, key=f"record.{name}")


def _text_in(name: str, column: pandas.Series, cells: Iterable[tuple[object, object]]) -> Exception:
    """What is wrong with a column that holds text: decimal commas, numbers as text, or a cell that is no number. `cells` are the text with its labels."""
    here = f"frame[{column.name!r}]"
    for label, cell in cells:
        if isinstance(cell, str) and re.fullmatch(r"\s*[-+]?\d+,\d+(?:[eE][-+]?\d+)?\s*", cell):
            return refused(f"column {column.name!r}", f"Its numbers are text with a decimal comma, {cell!r}",
                           f'pass numbers: {here} = {here}.str.replace(",", ".").astype(float)', key=f"record.{name}")
        try:
            float(cast(SupportsFloat, cell))
        except (TypeError, ValueError):
            return _refused_cell(name, f"column {column.name!r}, row {label!r}", repr(cell),
                                 f'make such cells NaN, which are left out: {here} = pandas.to_numeric({here}, errors="coerce")')
    return TypeError(f"column {column.name!r}: These must be real numbers, not text {next(iter(cells))[1]!r}. Convert them: {here} = {here}.astype(float)")


def _numbers_of(name: str, column: pandas.Series) -> object:
    """The cells of a column of a frame, NaN where one is missing."""
    if column.dtype.kind in "iuf":
        return column.to_numpy(dtype=np.float64, na_value=np.nan)
    if column.dtype.kind != "O":
        return np.asarray(column)
    missing = np.asarray(column.isna())
    text = [(label, cell) for label, cell, is_missing in zip(column.index, column, missing) if not is_missing and not _is_number(cell)]
    if text:
        raise _text_in(name, column, text)
    return column.mask(missing, np.nan).to_numpy(dtype=np.float64)


def _column(name: str, given: object, reduced: bool) -> Numbers:
    """A column of a record in memory, in SI. One of a frame is a pandas.Series, whose title has its unit, and whose labels say where a cell is; NaN in it are
    rows without a reading."""
    given, unit = _values_of(given)
    if is_series(given) and unit is None:
        unit = _unit_of_title(given, reduced)
    if _MA.is_masked(given):
        raise wrong(name, "numbers without a mask", "masked ones", key=f"record.{name}")
    try:
        array = np.asarray(_numbers_of(name, given) if is_series(given) else given)
    except ValueError as error:
        if isinstance(error, InputError):
            raise
        raise wrong(name, "an array of numbers", "rows of different lengths", key=f"record.{name}") from None

    def refuse_cell(at: int) -> InputError:
        if is_series(given):
            return _refused_cell(name, f"column {given.name!r}, row {given.index[at]!r}", array[at],
                                 f"leave such rows out, as in frame[numpy.isfinite(frame[{given.name!r}])]")
        return _refused_cell(name, f"{name}[{at}]", array[at], "leave such rows out: keep = numpy.isfinite(stage) & numpy.isfinite(force), then pass stage[keep], force[keep]")

    if array.dtype.kind == "O" and array.ndim == 1 and any(map(_is_number, array)):
        for at, cell in enumerate(array):
            if not _is_number(cell):
                raise refuse_cell(at)
        array = array.astype(np.float64)
    if array.dtype.kind not in "iuf":
        first = repr(array.ravel().tolist()[0]) if array.size and array.dtype.kind in "USOc" else ""
        is_text = array.dtype.kind == "U" or (array.dtype.kind == "O" and first[:1] in "'\"")
        units = f", and their unit beside them: {name}=(values, \"{'mN' if name == 'force' else 'um'}\")" if is_text else ""
        found = "text" if is_text else array.dtype.name
        raise TypeError(f"{name}: These must be real numbers{units}, not {found} {first}".rstrip() + ". Convert them, as in numpy.asarray(values, dtype=float).")
    if array.ndim != 1:
        raise wrong(name, "an array of one dimension", f"one of the shape {array.shape}", "pass one of its columns, as in values[:, 0]", key=f"record.{name}")
    if array.size == 0:
        raise wrong(name, "readings", "an empty array", key=f"record.{name}")
    values = np.ascontiguousarray(array, dtype=np.float64)
    wrong_cells = np.isinf(values) if is_series(given) else ~np.isfinite(values)
    if wrong_cells.any():
        array = values.astype(object)  # whose cells are floats of Python
        raise refuse_cell(int(np.argmax(wrong_cells)))
    if unit is None:
        return values
    if reduced:
        raise wrong(name, "numbers without a unit, as the case is reduced", unit, key=f"record.{name}")
    try:
        return _flexslip.in_si(values, unit, "force" if name == "force" else "length")
    except InputError as error:
        raise refused(name, error.problem or "", error.remedy, key=f"record.{name}") from None


def _pair_by_index(record: dict[str, object], names: list[str]) -> None:
    """Brings pandas Series of the same labels into the order of the first; refuses those whose labels differ, which pandas would not pair by position."""
    series = [(name, cast("pandas.Series", values)) for name in names if is_series(values := _values_of(record[name])[0])]
    for name, other in series[1:]:
        of, first = series[0]
        if other.index.equals(first.index):
            continue
        unique = first.index.is_unique and other.index.is_unique
        if unique and len(first) == len(other) and bool(other.index.isin(first.index).all()):
            ordered, unit = other.reindex(first.index), _values_of(record[name])[1]
            record[name] = (ordered, unit) if unit else ordered
            continue
        alone = int((~first.index.isin(other.index)).sum() + (~other.index.isin(first.index)).sum())
        why = f"{alone} label{'s stand' if alone > 1 else ' stands'} in one of them only" if alone else "their labels repeat"
        if len(first) == len(other):
            remedy = f"if their rows belong together as they stand, pass {of}.reset_index(drop=True) and {name}.reset_index(drop=True)"
        elif unique:
            remedy = f'pass the rows of both: {of}, {name} = {of}.align({name}, join="inner")'
        else:
            remedy = "pass two columns of one DataFrame"
        raise refused(name, f"The index of this Series differs from that of {of}: {why}", remedy, key=f"record.{name}")


def _note_missing_rows(columns: list[tuple[str, Numbers]], titles: Mapping[str, object]) -> None:
    """Warns of rows of a frame without a reading, which are left out as those of a file; refuses a record with too many of them."""
    gaps = np.any([np.isnan(values) for _, values in columns], axis=0)
    count, rows = int(gaps.sum()), len(gaps)
    if count == 0:
        return
    holed = [name for name, values in columns if np.isnan(values).any()]
    shown = [repr(titles[name]) for name in holed]
    where = f"column{'s' if len(holed) > 1 else ''} {' and '.join(shown)}"
    if count * _ROWS_PER_GAP > rows:
        remedy = "pass frame.dropna(subset=[" + ", ".join(shown) + "])" if count < rows else "check how the frame was made"
        raise refused(where, f"{count} of {rows} rows have no number (NaN); at most a tenth may", remedy, key=f"record.{holed[0]}")
    have, are = ("has", "is") if count == 1 else ("have", "are")
    warn(f"{where}: {count} of {rows} rows {have} no number (NaN) and {are} left out, the first at position {int(np.argmax(gaps))}")


_ROWS_PER_GAP = 10  # as of files (instruments/export.cpp): with more gaps the record is unknown


def _is_data(value: object) -> bool:
    return is_frame(value) or (_is_array(value) and not isinstance(value, os.PathLike))


def _no_data(data: tuple[object, ...]) -> TypeError:
    """What is no data of a test, with what to pass instead."""
    first = data[0]
    name = type(first).__name__
    instead = "fit(stage, force)"
    if isinstance(first, Answer) and name in ("Export", "Simulation", "Fit"):
        instead = "fit.case" if name == "Fit" else f"fit({name.lower()}.to_frame())"
    elif len(data) == 1 and _is_array(first) and np.ndim(cast("npt.ArrayLike", first)) == 2:
        name = f"one array of the shape {np.shape(cast('npt.ArrayLike', first))}"
        instead = "fit(data[:, 0], data[:, 1]), with its columns"
    elif len(data) > 1 or _is_array(first):
        name = ", ".join("an array" if _is_array(each) and not is_frame(each) else type(each).__name__ for each in data)
    return TypeError(f"The data must be a file, a DataFrame, or two arrays, of the stage and of the force, not {name}. Write {instead}.")


def _record_of(data: tuple[object, ...], record: Mapping[str, object]) -> dict[str, object]:
    """The record that a call begins with: a frame, or stage and force."""
    if is_frame(data[0]) and len(data) == 1:
        return record_of(data[0], record)
    if len(data) != 2 or not all(_is_array(each) and not is_frame(each) for each in data):
        raise _no_data(data)
    for name in ("stage", "force"):
        if name in record:
            raise TypeError(f"{name} is given twice")
    return {**record, "stage": data[0], "force": data[1]}


def _arrays_of(sections: Sections, reduced: bool) -> list[tuple[str, Numbers]]:
    """The columns of a record that a call has in memory; their titles take their place."""
    record = sections.get("record", {})
    names = [name for name in _COLUMNS if _is_array(record.get(name))]
    if not names:
        return []
    for name in _COLUMNS:
        if isinstance(record.get(name), str):
            raise wrong(name, f"an array, as {names[0]} is one", record[name], key=f"record.{name}")
    if "file" in record:
        raise wrong("file", "either a file or arrays of a record", "both", key="record.file")
    if {"stage", "deflection", "force"} <= {*names}:
        raise wrong("deflection", "two of stage, deflection and force", "all three", "leave one out, such as deflection: it follows from the stiffness of the rig",
                    key="record.deflection")
    _pair_by_index(record, names)
    columns = [(name, _column(name, record[name], reduced)) for name in names]
    for name, values in columns:
        if len(values) != len(columns[0][1]):
            raise wrong(name, f"as many readings as {names[0]} has, {len(columns[0][1])}", str(len(values)), key=f"record.{name}")
    _note_missing_rows(columns, {name: getattr(_values_of(record[name])[0], "name", None) or name for name in names})
    for name in names:
        record[name] = name if reduced else f"{name} [{'N' if name == 'force' else 'm'}]"
    record["file"] = ARRAYS
    return columns


def text_of(sections: Mapping[str, Mapping[str, object]], reduced: bool) -> str:
    """Sections as the text of a case file."""
    text = "reduced = true\n" if reduced else ""
    later = ""
    for section, given in sections.items():
        own = dict(given)
        other = own.pop("other", None) if section == "friction" else None
        text += f"[{section}]\n" + "".join(f"{name} = {value}\n" for name, value in _values(section, own, reduced).items())
        if other is not None:
            later += "[friction.other]\n" + "".join(
                f"{name} = {value}\n" for name, value in _values("friction", other, reduced).items())
    return text + later


def _changes_of(sections: Mapping[str, Mapping[str, object]], reduced: bool) -> list[str]:
    return [f"{section}.{name}={value}" for section, given in sections.items()
            for name, value in _values(section, given, reduced).items()]


def _without_key(text: str, name: str) -> str:
    """The text of a case file without a key or a section; the other lines stay where they are."""
    *above, key = name.split(".")
    try:
        section = wanted = tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return text  # the reader says it with its words
    for part in above:
        section = section.get(part, {})
    if not isinstance(section, dict) or key not in section:
        return text
    del section[key]
    lines = text.split("\n")
    begins = re.compile(rf"""[\s\["']*(?:{'.'.join(above)}["'\s]*\.["'\s]*)?{key}\b""")
    for start in (at for at, line in enumerate(lines) if begins.match(line)):
        for end in range(start + 1, len(lines) + 1):
            shorter = "\n".join([*lines[:start], *[""] * (end - start), *lines[end:]])
            with contextlib.suppress(tomllib.TOMLDecodeError):
                if tomllib.loads(shorter) == wanted:
                    return shorter
    raise wrong(name, "a key on lines of its own", "one beside others", "take it out of the case file", key=name)


def _stated(values: Mapping[str, object], above: str = "") -> list[str]:
    """The whole names of keys."""
    return [name for key, value in values.items() for name in (_stated(value, f"{above}{key}.") if isinstance(value, dict) and key in SECTIONS else [above + key])]


class Case:
    """What is known of a test: its specimen, its rig, its friction, how the stage moves, and its record.

    Parameters
    ----------
    file : path, DataFrame or array, optional
        A case file (``.toml``), which the other arguments change; or a file of data, which they describe. Or the data themselves: a pandas.DataFrame, whose
        titles or ``attrs["units"]`` have the units; or two arrays, of the stage and of the force.
    name : str, optional
        What to call a test whose record is in memory; "arrays".
    set : mapping, optional
        Keys that change, ``{"rig.stiffness": "200 N/m"}``; one that is None is taken out.
    reduced : bool
        Are all numbers in reduced variables? Of a case without a case file.
    **keywords
        A section as a dict, ``rig={"span": "1278 um"}``, or a key of a section by its own name, ``span="1278 um"``: those of specimen, rig and
        record, see :func:`keys`. Quantities are strings with a unit, or floats in SI. A record may be arrays, `stage`, `deflection`, `force`, two of
        the three, in SI or with their unit: ``force=(values, "mN")``. A key that is None in a section is taken out of the case that changes, and friction
        of another model replaces the whole section.

    Raises
    ------
    InputError
        For a value, unit or key that is wrong, with what is wrong; a FileNotFoundError as well if a file is not there.
    TypeError
        For a keyword that is none.

    Examples
    --------
    >>> import flexslip
    >>> case = flexslip.Case(diameter="34.8 um", modulus="29.6 GPa", span=1278e-6, stiffness="90.65 N/m")
    >>> case["rig.span"]
    '1.278 mm'
    >>> case.replace(span="1 mm")["rig.span"]
    '1 mm'
    """

    _text: str
    _source: str
    _changes: list[str]
    _given: list[tuple[str, Numbers]]
    _name = ARRAYS  # of the record in memory
    _is_written = False  # as the text of a case file, not as keywords

    def __init__(self, file: object = None, *arrays: object, name: str | None = None, set: Mapping[str, object] | None = None, reduced: bool = False,  # noqa: A002
                 **keywords: object) -> None:
        reduced = yes_no("reduced", reduced)
        sections = sections_of(keywords)
        for key, value in set.items() if isinstance(set, Mapping) else ():
            section, _, last = str(key).rpartition(".")
            if sections.get(section, {}).get(last) is not None:
                raise _said_twice(section, last, sections[section][last], f"set={{{key!r}: {reprlib.repr(value)}}}")
        if _is_data(file) or arrays:
            sections["record"] = _record_of((file, *arrays), sections.get("record", {}))
            file = None
        self._given = []
        if isinstance(file, Case):
            self._text, self._source, self._changes = file._text, file._source, list(file._changes)
            self._given, self._name, self._is_written = file._given, file._name, file._is_written
            reduced = file.reduced
            self._make_room_for(sections)
        elif file is not None and not isinstance(file, (str, bytes, os.PathLike)):
            raise _no_data((file,))
        elif file is not None and (path := path_of(file)).endswith(".toml"):
            if reduced:
                raise wrong("reduced", "stated by the case file alone", "here as well")
            self._text, self._source, self._changes = _decoded(path), path, []
            reduced = _says_reduced(self._text)
            self._make_room_for(sections)
        else:
            if file is not None:
                record = sections.setdefault("record", {})
                record["file"], sheet = readable(path_of(file), cast("str | int | None", record.pop("sheet", None)))
                if sheet is not None:
                    record["sheet"] = sheet
            self._given = _arrays_of(sections, reduced)
            self._text, self._source, self._changes = text_of(sections, reduced), "", []
            sections = {}
        self._given = _arrays_of(sections, reduced) or self._given
        if isinstance(set, Mapping):
            self._take_out(".".join(_named(key)) for key, value in set.items() if value is None)
            set = {key: value for key, value in set.items() if value is not None}  # noqa: A001
        self._changes += _changes_of(sections, reduced)
        self._changes += set_of(set, reduced)
        if name is not None:
            self._name = _name_of_record(name, bool(self._given))
        self._read()

    def _read(self) -> None:
        try:
            self._case = _flexslip.read_case(self._text, os.fsencode(self._source), self._changes)
            if self._given:
                self._case = _flexslip.with_record(self._case, self._given, self._name)
        except InputError as error:
            raise self._in_own_words(error) from None

    def _make_room_for(self, sections: Mapping[str, Mapping[str, object]]) -> None:
        """Takes out the keys that are None, and those of a friction whose model another replaces."""
        gone = [f"{section}.{key}" for section, given in sections.items() for key, value in given.items() if value is None]
        if model := sections.get("friction", {}).get("model"):
            stated = tomllib.loads(_flexslip.read_case(self._text, os.fsencode(self._source), self._changes).toml()).get("friction", {})
            if model != stated.get("model"):
                gone += [f"friction.{key}" for key in stated]
        self._take_out(gone)

    def _take_out(self, names: Iterable[str]) -> None:
        for name in names:
            self._changes = [change for change in self._changes if not change.startswith((f"{name}=", f"{name}."))]
            self._text = _without_key(self._text, name)

    def _in_own_words(self, error: InputError) -> InputError:
        if self._source or self._is_written:
            return error
        key = KEYS.get((error.key or "").rpartition(".")[::2])
        if key and key["unit"] and key["example"] and not error.remedy and error.kind == "wrong" and error.problem:
            parts = {name: getattr(error, name) for name in ("file", "line", "field", "key", "kind", "limit", "problem")}
            remedy = f"Write a positive number and its unit, as in {key['example']}."
            error = error_of(f"{error} {remedy}", **parts, remedy=remedy)
        return of_keywords(error, self._name)

    @classmethod
    def from_toml(cls, text: str, source: str = "") -> Case:
        """A case from the text of a case file. `source` is the file whose folder its paths are relative to.

        Examples
        --------
        >>> import flexslip
        >>> flexslip.Case.from_toml('[rig]\\nspan = "1 mm"').toml
        '[rig]\\nspan = "1 mm"\\n'
        """
        case = cls.__new__(cls)
        case._text, case._source, case._changes, case._given, case._is_written = text, os.fsdecode(source), [], [], True
        case._case = _flexslip.read_case(text, os.fsencode(case._source), [])
        return case

    @property
    def toml(self) -> str:
        """The case as the text of a case file, which gives the same case back, to the last bit."""
        return str(self._case.toml())

    @property
    def source(self) -> str:
        """The case file as it was named; empty if there is none."""
        return self._source

    @property
    def reduced(self) -> bool:
        """Are all numbers in the model's reduced variables?"""
        return bool(self._case.reduced)

    def to_dict(self) -> dict[str, Any]:
        """The case as dicts of its sections, quantities as strings with units."""
        return tomllib.loads(self.toml)

    def __getitem__(self, key: str) -> Any:
        value: object = self.to_dict()
        for part in key.split("."):
            if not isinstance(value, dict) or part not in value:
                raise KeyError(f"the case does not state {key!r}; it states {', '.join(_stated(self.to_dict()))}")
            value = value[part]
        return value

    def replace(self, *, set: Mapping[str, object] | None = None, **keywords: object) -> Case:  # noqa: A002
        """The same case with other values, given as to :class:`Case`; None takes a key out.

        Examples
        --------
        >>> import flexslip
        >>> case = flexslip.Case("examples/design.toml")
        >>> case.replace(friction={"model": "constant", "mu0": 0.4})["friction"]
        {'model': 'constant', 'mu0': 0.4}
        >>> "phase" in case.replace(set={"friction.phase": None})["friction"]
        False
        """
        case = Case.__new__(Case)
        case.__dict__.update(self.__dict__)
        case._take_out(_whole_name(name) for name, value in keywords.items() if value is None)
        changed: dict[str, Any] = {name: value for name, value in keywords.items() if value is not None}
        return Case(case, set=set, **changed)

    def __reduce__(self) -> tuple[object, ...]:
        return _read_again, (self._text, self._source, list(self._changes), self._given, self._is_written, self._name)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Case) or (self.toml, self.source) != (other.toml, other.source):
            return False
        return len(self._given) == len(other._given) and all(
            np.array_equal(mine, theirs, equal_nan=True) for (_, mine), (_, theirs) in zip(self._given, other._given))

    def __hash__(self) -> int:
        return hash((self.toml, self.source))

    def __repr__(self) -> str:
        return f"<flexslip.Case{' ' + self._source if self._source else ''}>\n{self.toml.strip()}"

    def _repr_html_(self) -> str:
        import html

        return f"<pre>{html.escape(self.toml)}</pre>"


def _read_again(text: str, source: str, changes: list[str], given: list[tuple[str, Numbers]], is_written: bool, name: str) -> Case:
    case = Case.__new__(Case)
    case._text, case._source, case._changes, case._given, case._is_written, case._name = text, source, changes, given, is_written, name
    case._read()
    return case


def _whole_name(name: str) -> str:
    """Of a key as a keyword, "span" or "rig.span"; of a section its own."""
    if name in FLAT and name not in SECTIONS:
        return f"{FLAT[name]['section']}.{name}"
    if name not in SECTIONS and tuple(name.rpartition(".")[::2]) not in KEYS:
        raise TypeError(f"unexpected keyword argument {name!r}; " + _nearest(name, [*FLAT, *SECTIONS]))
    return name


def _name_of_record(name: object, is_in_memory: bool) -> str:
    """The name of a record in memory, as the program takes names off files: up to the last point."""
    if not is_in_memory:
        raise wrong("name", "a record in memory, a DataFrame or arrays", "a file, after which its test is called")
    if not isinstance(name, str) or not name or "/" in name or "\0" in name:
        raise wrong("name", "a name without a slash", name)
    return encodable("name", f"{name}." if "." in name else name)


def _decoded(path: str) -> str:
    text: bytes = _flexslip.case_text(os.fsencode(path))
    try:
        return text.decode("utf-8")
    except UnicodeDecodeError as error:
        raise error_of(f"{path}: The file is not in UTF-8 ({error.reason} at byte {error.start}).", file=path,
                       problem=f"The file is not in UTF-8 ({error.reason} at byte {error.start})", kind="wrong") from None


def _says_reduced(text: str) -> bool:
    try:
        return tomllib.loads(text).get("reduced") is True
    except tomllib.TOMLDecodeError:
        return False  # which the reader says with its words


OPTIONS: dict[str, None] = {}  # keywords of the functions that are no keys
KEYWORDS: dict[str, list[str]] = {}  # that the functions can use, by their names


def with_keywords(*sections: str) -> Callable[[Function], Function]:
    """Gives a function the keys of some sections as keywords: its signature, for completion, and what they mean."""
    import inspect

    flat = {name: key for name, key in FLAT.items() if key["section"] in sections and (name != "cracks" or "stage" in sections)}

    def with_them(function: Function) -> Function:
        names = KEYWORDS[function.__name__] = [*sections, *(name for name in flat if name not in sections)]
        signature = inspect.signature(function)
        kept = [each for each in signature.parameters.values() if each.kind is not inspect.Parameter.VAR_KEYWORD]
        OPTIONS.update((each.name, None) for each in kept if each.kind is inspect.Parameter.KEYWORD_ONLY)
        added = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None) for name in names]
        setattr(function, "__signature__", signature.replace(parameters=[*kept, *added]))  # noqa: B010
        lines = [_of_section(section) for section in sections if section not in flat] + [_of_key(name, key) for name, key in flat.items()]
        function.__doc__ = (function.__doc__ or "").rstrip() + "\n\n    Other Parameters\n    ----------------\n" + "\n".join(lines) + "\n    "
        return function

    return with_them


def _of_section(section: str) -> str:
    return f"    {section} : dict\n        Keys of this section: {', '.join(name for of, name in KEYS if of == section)}."


def _of_key(name: str, key: Key) -> str:
    unit = f" [{key['unit']}]" if key["unit"] else ""
    meaning = key["meaning"][:1].upper() + key["meaning"][1:]
    if key["is"] == "title":
        return f"    {name} : an array{unit}, an array and its unit, or {key['holds']}\n        {meaning}; or its readings."
    holds = key["holds"] if name not in SECTIONS else f"{key['holds']}, or a dict of the section"
    return f"    {name} : {holds}{unit}\n        {meaning}."


@contextlib.contextmanager
def in_words_of(case: Case) -> Iterator[_flexslip.Case]:
    """What the module calls the case; its complaints are in the words in which the case was given."""
    try:
        yield case._case
    except InputError as error:
        raise case._in_own_words(error) from None


def case_of(file: Any, arrays: tuple[object, ...], set: Mapping[str, object] | None, keywords: Mapping[str, Any], name: str | None = None) -> Case:  # noqa: A002
    """The case that a call describes."""
    if isinstance(file, Case) and not (arrays or set or keywords or name is not None):
        return file
    return Case(file, *arrays, name=name, set=set, **keywords)
