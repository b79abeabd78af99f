"""Answers as objects, made from what the program says of them: names, units and meanings are those of its JSON."""
from __future__ import annotations

import difflib
import html
import keyword
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Generic, SupportsFloat, SupportsIndex, TypeVar, cast, overload

import numpy as np
import numpy.typing as npt

from . import _flexslip
from ._errors import advice, arguments

# {"fit --json": {"what", "is_table", "entries"}}
ANSWERS = _flexslip.answers()
NAN = float("nan")
Numbers = npt.NDArray[np.float64]
Data = Mapping[str, object]  # of an answer, as its JSON has it
Row = TypeVar("Row", covariant=True)

if TYPE_CHECKING:
    import pandas

    from ._flexslip import Columns, Entry


class Quantity(float):
    """A number and its unit: a float with `.unit`.

    Examples
    --------
    >>> import flexslip
    >>> flexslip.Quantity(1.278e-3, "m")
    Quantity(0.001278, 'm')
    """

    unit: str

    def __new__(cls, value: float, unit: str) -> Quantity:
        new = super().__new__(cls, value)
        new.unit = unit
        return new

    def __reduce__(self) -> tuple[object, ...]:
        return Quantity, (float(self), self.unit)

    def __repr__(self) -> str:
        return f"Quantity({float(self)!r}, {self.unit!r})"

    def __str__(self) -> str:
        return readable(float(self), self.unit)


_PLAIN = ("1", "", "rad", "L", "1/L", "EI", "EI/L", "EI/L^2", "EI/L^3", "EI/L^4", "L^3/EI")  # units that have no larger or smaller ones


def readable(value: float, unit: str, stderr: float | None = None) -> str:
    """A number for people, in the unit that suits it; with a standard error, rounded by it."""
    known = "" if unit in _PLAIN else unit
    words = str(_flexslip.readable(value, known) if stderr is None else _flexslip.readable_estimate(value, stderr, known))
    return words if known or unit in ("1", "") else f"{words} {unit}"


class Estimate:
    """A number that was estimated.

    Attributes
    ----------
    value, stderr : float
        The estimate and its standard error, in `unit`.
    ci95 : tuple of float
        The interval that holds 95 %.
    unit : str
        ``"1"`` of plain numbers.

    It formats, rounds and compares by its value: ``f"{mu0:.3f}"``, ``round(mu0, 2)``, ``mu0 > 0.3``; without a format it is its value and error. Two
    estimates of different units are never equal and cannot be ordered. A plain number scales or shifts it, its interval as well: ``2 * mu0``, ``E / 1e9``.
    Two estimates cannot be added or multiplied, as nobody states how their errors go together: take their values.

    Examples
    --------
    >>> import flexslip
    >>> mu0 = flexslip.fit("examples/simulated/case.toml").params.mu0
    >>> half = mu0 / 2
    >>> (half.value, half.stderr, half.ci95[1]) == (mu0.value / 2, mu0.stderr / 2, mu0.ci95[1] / 2)
    True
    """

    def __init__(self, data: Data, entries: Sequence[Entry] = (), name: str = "", meaning: str = "") -> None:
        self._data = data
        self._entries = entries
        self.name, self.meaning = name, meaning
        self.value: float = _float(data.get("value"))
        self.stderr: float = _float(data.get("standard_error"))
        low, high = cast("Sequence[float | None] | None", data.get("interval95")) or (None, None)
        self.ci95: tuple[float, float] = (_float(low), _float(high))
        self.unit = str(data.get("unit") or "1")

    if not TYPE_CHECKING:  # what else stands beside an estimate is known to its class in _fields.pyi

        def __getattr__(self, name: str) -> object:
            for entry in self.__dict__.get("_entries", ()):
                if entry["name"] == name:
                    return _read(self._data.get(name), entry, {})
            raise AttributeError(f"no {name!r} in this estimate" + meant(name, dir(self)))

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(entry["name"] for entry in self._entries)]

    def __reduce__(self) -> tuple[object, ...]:
        return Estimate, (self._data, self._entries, self.name, self.meaning)

    def __float__(self) -> float:
        return self.value

    def __format__(self, spec: str) -> str:
        return format(self.value, spec) if spec else str(self)

    @overload
    def __round__(self, digits: None = None) -> int: ...
    @overload
    def __round__(self, digits: SupportsIndex) -> float: ...

    def __round__(self, digits: SupportsIndex | None = None) -> float:
        return round(self.value) if digits is None else round(self.value, digits)

    def _with(self, value: float, stderr: float, ends: tuple[float, float]) -> Estimate:
        """Another value of the same name and unit."""
        low, high = (_none_of(end) for end in sorted(ends))
        data = {"value": _none_of(value), "standard_error": _none_of(stderr), "interval95": [low, high], "unit": self.unit}
        if self._data.get("bound") and value * self.value >= 0:
            data["bound"] = True
        return Estimate(data, (), self.name, self.meaning)

    def _plain_number(self, other: object) -> float | None:
        """A number without an error and a unit of its own; None of what is no number."""
        if isinstance(other, Estimate):
            raise TypeError("two estimates cannot be combined: how their errors go together is unknown. Take their values, as in one.value + other.value")
        if getattr(other, "unit", "1") not in ("1", ""):
            raise TypeError(f"an estimate can be combined with plain numbers only, not with one in {getattr(other, 'unit')}. Take its value, as in float(other)")
        return float(cast(SupportsFloat, other)) if isinstance(other, _COMPARED) else None

    def _scaled(self, factor: float) -> Estimate:
        return self._with(factor * self.value, abs(factor) * self.stderr, (factor * self.ci95[0], factor * self.ci95[1]))

    def _shifted(self, by: float) -> Estimate:
        return self._with(self.value + by, self.stderr, (self.ci95[0] + by, self.ci95[1] + by))

    def __mul__(self, other: float) -> Estimate:
        factor = self._plain_number(other)
        if factor is None:
            return NotImplemented
        return self._scaled(factor)

    __rmul__ = __mul__

    def __truediv__(self, other: float) -> Estimate:
        divisor = self._plain_number(other)
        if divisor is None:
            return NotImplemented
        return self._scaled(1 / divisor)

    def __rtruediv__(self, other: float) -> Estimate:
        raise TypeError("a number cannot be divided by an estimate: its error would not be symmetric. Take its value and ends, as in 1 / estimate.value")

    def __add__(self, other: float) -> Estimate:
        by = self._plain_number(other)
        if by is None:
            return NotImplemented
        return self._shifted(by)

    __radd__ = __add__

    def __sub__(self, other: float) -> Estimate:
        by = self._plain_number(other)
        if by is None:
            return NotImplemented
        return self._shifted(-by)

    def __rsub__(self, other: float) -> Estimate:
        return (-self) + other

    def __neg__(self) -> Estimate:
        return self._scaled(-1.0)

    def __pos__(self) -> Estimate:
        return self._scaled(1.0)

    def __abs__(self) -> Estimate:
        return self._scaled(-1.0 if self.value < 0 else 1.0)

    def _is_of_unit(self, other: object) -> bool:
        """Does the other have the same unit, or none that it states?"""
        return getattr(other, "unit", self.unit) == self.unit

    def _beside(self, other: Estimate | float) -> float:
        """The value of what it is compared with."""
        if not self._is_of_unit(other):
            raise TypeError(f"a number in {self.unit} cannot be compared with one in {getattr(other, 'unit')}")
        return float(other)

    def __lt__(self, other: Estimate | float) -> bool:
        return self.value < self._beside(other) if isinstance(other, _COMPARED) else NotImplemented

    def __le__(self, other: Estimate | float) -> bool:
        return self.value <= self._beside(other) if isinstance(other, _COMPARED) else NotImplemented

    def __gt__(self, other: Estimate | float) -> bool:
        return self.value > self._beside(other) if isinstance(other, _COMPARED) else NotImplemented

    def __ge__(self, other: Estimate | float) -> bool:
        return self.value >= self._beside(other) if isinstance(other, _COMPARED) else NotImplemented

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, _COMPARED):
            return NotImplemented
        return self._is_of_unit(other) and self.value == float(other)

    def __hash__(self) -> int:
        return hash(self.value)

    def __str__(self) -> str:
        if self.value != self.value:
            return "unknown"
        if self._data.get("bound"):  # of what cannot be told from zero
            return f"at most {readable(float(f'{self.ci95[1]:.2g}'), self.unit)} (95 %)"
        return readable(self.value, self.unit, self.stderr or None)

    def __repr__(self) -> str:
        return f"<{self.name + ': ' if self.name else ''}{self}>"


_COMPARED = (Estimate, int, float, np.integer, np.floating)


def same(mine: object, theirs: object) -> bool:
    """Are two data equal, what is not there (NaN) as well?"""
    if isinstance(mine, np.ndarray) or isinstance(theirs, np.ndarray):
        if not (isinstance(mine, np.ndarray) and isinstance(theirs, np.ndarray)):
            return False
        return bool(np.array_equal(mine, theirs, equal_nan=mine.dtype.kind == "f" and theirs.dtype.kind == "f"))
    if isinstance(mine, Mapping) and isinstance(theirs, Mapping):
        return mine.keys() == theirs.keys() and all(same(value, theirs[name]) for name, value in mine.items())
    if isinstance(mine, (list, tuple)) and isinstance(theirs, (list, tuple)):
        return len(mine) == len(theirs) and all(map(same, mine, theirs))
    return bool(mine == theirs or (mine != mine and theirs != theirs))


def _float(value: object) -> float:
    return NAN if value is None else float(cast(SupportsFloat, value))


def meant(name: str, names: Iterable[str]) -> str:
    """The name that one who wrote another may have meant."""
    near = difflib.get_close_matches(name, [each for each in names if not each.startswith("_")], 1, 0.7)
    return f"; did you mean {near[0]!r}?" if near else ""


def _attribute(name: str) -> str:
    """The name of a field as an attribute: parameters are `params`, as in lmfit."""
    if name == "parameters":
        return "params"
    return name + "_" if keyword.iskeyword(name) else name


def unit_of(entry: Entry, reduced: bool) -> str:
    return entry["reduced_unit"] if reduced else entry["unit"]


_PROSE = ("sentence", "remedy", "words", "next", "done", "key", "reason", "remarks", "notes", "asks", "answer")  # sentences, in which a flag is an argument in Python


def _read(value: object, entry: Entry, classes: Mapping[str, type[Answer]], reduced: bool = False) -> object:
    """A value of an answer's data as what a user meets."""
    shape = entry["shape"]
    if shape == "number":
        return _float(value)
    if shape == "estimate":
        return Estimate(cast(Data, value) or {"unit": unit_of(entry, reduced)}, entry["entries"], entry["name"], entry["meaning"])
    if value is None:
        return None
    if shape == "quantity":
        quantity = cast(Data, value)
        return Quantity(_float(quantity["value"]), str(quantity["unit"]))
    if shape == "group":
        return classes[entry["name"]](cast(Data, value), reduced)
    if shape == "list":
        return Table(cast("Columns", value), classes[entry["name"]], reduced=reduced)
    if shape == "by_name":
        return {name: classes[entry["name"]](part, reduced) for name, part in cast(Mapping[str, Data], value).items()}
    if shape == "words" and isinstance(value, list):
        return tuple(advice(str(each)) if entry["name"] in _PROSE else each for each in value)
    if entry["name"] == "repeat_with":
        return arguments(str(value))
    if shape == "words" and entry["name"] in _PROSE:
        return advice(str(value))
    return value


class Answer:
    """A part of an answer: its numbers are attributes, and stand under their names in brackets.

    A number or an estimate that does not exist is NaN; words, groups and lists that do not are None. :meth:`describe` says what each is.
    """

    _entries: Sequence[Entry] = ()
    _classes: Mapping[str, type[Answer]] = {}
    _title = ""
    _caption = ""  # in words

    def __init__(self, data: Data, reduced: bool = False) -> None:
        self._data = data
        self._reduced = reduced  # are its numbers in reduced variables?

    def __reduce__(self) -> tuple[object, ...]:
        if not type(self)._path:
            return _row_again, (self._data, type(self)._entries, self._reduced)
        return _made, (type(self)._path, self._data, self._reduced)

    _path: tuple[str, ...] = ()

    def __getitem__(self, name: str) -> Any:
        for entry in self._entries:
            if entry["name"] == name and (name in self._data):
                return _read(self._data[name], entry, self._classes, self._reduced)
        raise KeyError(self._has_no(name))

    def _has_no(self, name: str) -> str:
        for entry in self._entries:
            if entry["shape"] == "group" and any(below["name"] == name for below in entry["entries"]):
                return f"no {name!r}; did you mean {_attribute(entry['name'])}.{name}?"
        return f"no {name!r}" + (meant(name, dir(self)) or f"; there are {', '.join(self._data)}")

    if not TYPE_CHECKING:  # to which every name would be one

        def __getattr__(self, name: str) -> object:
            if name.startswith("_"):
                raise AttributeError(name)
            is_known = any(_attribute(entry["name"]) == name for entry in self._entries)
            raise AttributeError(f"this answer has no {name!r}; it has {', '.join(self._data)}" if is_known else self._has_no(name))

    def _of(self, entry: Entry) -> object:
        if entry["name"] not in self._data and entry["shape"] != "estimate":
            raise AttributeError(entry["name"])  # __getattr__ says it
        return _read(self._data.get(entry["name"]), entry, self._classes, self._reduced)

    def __contains__(self, name: object) -> bool:
        return name in self._data

    def __iter__(self) -> Iterator[str]:
        return iter(self._data)

    def __len__(self) -> int:
        return len(self._data)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Answer):
            return NotImplemented
        return type(self).__name__ == type(other).__name__ and self._reduced == other._reduced and same(self._data, other._data)

    def __hash__(self) -> int:
        return hash((type(self).__name__, *self._data))

    def keys(self) -> list[str]:
        """The names of what is there."""
        return list(self._data)

    def items(self) -> list[tuple[str, Any]]:
        """Name and value of what is there."""
        return [(name, self[name]) for name in self._data]

    def to_dict(self) -> dict[str, Any]:
        """As JSON has it: dicts, lists, numbers, None."""
        return {entry["name"]: _plain(self._data[entry["name"]], entry) for entry in self._in_order() }

    def _in_order(self) -> list[Entry]:
        entries = {entry["name"]: entry for entry in self._entries}
        return [entries[name] for name in self._data]

    def to_json(self) -> str:
        """As the program writes it with ``--json``, to the last byte."""
        return str(_flexslip.dumped(self.to_dict()))

    def describe(self) -> Description:
        """What each number is, line by line: name, unit, meaning."""
        return Description(self._entries, self._reduced)

    def to_frame(self) -> pandas.DataFrame:
        """A pandas.DataFrame with a row for each number or estimate; `attrs["units"]` has the units by their names."""
        import pandas as pd

        rows = []
        for entry in self._in_order():
            value = self[entry["name"]]
            if isinstance(value, Estimate):
                rows.append({"name": entry["name"], "value": value.value, "stderr": value.stderr, "low95": value.ci95[0],
                             "high95": value.ci95[1], "unit": value.unit, "meaning": entry["meaning"]})
            elif isinstance(value, (bool, int, float, str)):
                rows.append({"name": entry["name"], "value": value, "unit": getattr(value, "unit", unit_of(entry, self._reduced)),
                             "meaning": entry["meaning"]})
        frame = pd.DataFrame(rows).set_index("name") if rows else pd.DataFrame()
        frame.attrs["units"] = {row["name"]: row["unit"] for row in rows}
        return frame

    def _shown(self) -> list[tuple[str, str, str]]:
        rows = []
        for entry in self._in_order():
            value = self[entry["name"]]
            if value is not None and not (isinstance(value, (float, Estimate)) and float(value) != float(value)):
                rows.append((entry["name"], _in_short(value, unit_of(entry, self._reduced)), entry["meaning"]))
        return rows

    def __repr__(self) -> str:
        rows = self._shown()
        wide = max((len(name) for name, _, _ in rows), default=0)
        return f"<{self._title or type(self).__name__}>\n" + "\n".join(f"  {name:<{wide}}  {value}" for name, value, _ in rows)

    def _repr_html_(self) -> str:
        rows = "".join(
            f'<tr><td style="text-align:left">{html.escape(name)}</td><td style="text-align:left">{html.escape(value)}</td>'
            f'<td style="text-align:left">{html.escape(meaning)}</td></tr>' for name, value, meaning in self._shown())
        return f"<table><caption>{html.escape(self._caption or self._title)}</caption>{rows}</table>"


_FEW = 4  # numbers that a line shows


def _in_short(value: object, unit: str) -> str:
    if isinstance(value, Table):
        return f"{len(value)} row{'s' if len(value) != 1 else ''}: {', '.join(value.keys())}"
    if isinstance(value, Answer):
        return "; ".join(f"{name} {words}" for name, words, _ in value._shown())
    if isinstance(value, np.ndarray):
        if value.ndim == 1 and 0 < len(value) <= _FEW and value.dtype.kind in "iuf":
            return ", ".join(readable(each, unit) if each == each else "unknown" for each in value.tolist())
        return f"{len(value)} numbers" + _in_brackets(unit)
    if isinstance(value, dict):
        return "; ".join(f"{name}: {_in_short(part, '')}" for name, part in value.items())
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, tuple):
        return ", ".join(value)
    if isinstance(value, float) and not isinstance(value, Quantity):
        return readable(value, unit)
    return str(value)


def _in_brackets(unit: str) -> str:
    return f" [{unit}]" if unit not in ("1", "") else ""


def _none_of(value: object) -> object:
    return None if isinstance(value, float) and value != value else value


def _plain(value: object, entry: Entry) -> object:
    shape = entry["shape"]
    if value is None:
        return None
    if isinstance(value, np.ndarray):
        return [_none_of(each) for each in value.tolist()]
    if shape == "list":
        return Table(cast("Columns", value), Answer, entry["entries"]).to_dicts()
    if shape == "group":
        entries = {each["name"]: each for each in entry["entries"]}
        return {name: _plain(part, entries[name]) for name, part in cast(Data, value).items()}
    if shape == "by_name":
        entries = {each["name"]: each for each in entry["entries"]}
        return {key: {name: _plain(part, entries[name]) for name, part in group.items()} for key, group in cast(Mapping[str, Data], value).items()}
    return _none_of(value)


class Table(Sequence[Row], Generic[Row]):
    """Rows of one kind: a column is an attribute, a NumPy array where it holds numbers; a row is an answer.

    Examples
    --------
    >>> import flexslip
    >>> fit = flexslip.fit("examples/simulated/case.toml")
    >>> fit.profile.mu.shape == fit.profile.length.shape == (len(fit.profile),)
    True
    >>> fit.profile[0].mu == fit.profile.mu[0]
    True
    """

    def __init__(self, data: Columns, of: type[Answer], entries: Sequence[Entry] | None = None, reduced: bool = False) -> None:
        self._data = data
        self._reduced = reduced
        self._of = of
        self._entries = of._entries if entries is None else entries

    def __reduce__(self) -> tuple[object, ...]:
        if not self._of._path:
            return table_of, (self._data, self._entries, self._reduced)
        return _table_of, (self._data, self._of._path, self._reduced)

    def keys(self) -> list[str]:
        """The names of its columns."""
        return list(self._data["columns"])

    def column(self, name: str) -> npt.NDArray[Any]:
        """A column: a NumPy array of numbers, or of objects."""
        if name not in self._data["columns"]:
            raise KeyError(f"no column {name!r}; there are {', '.join(self.keys())}")
        values = self._data["columns"][name]
        if isinstance(values, np.ndarray):
            return values
        entry = self._entry(name)
        out = np.empty(len(values), dtype=object)
        for i, value in enumerate(values):
            out[i] = _read(value, entry, self._of._classes, self._reduced)
        return out

    def _entry(self, name: str) -> Entry:
        for entry in self._entries:
            if entry["name"] == name:
                return entry
        raise KeyError(name)

    def __getattr__(self, name: str) -> npt.NDArray[Any]:
        columns = self.__dict__.get("_data", {}).get("columns", {})
        if name in columns:
            return self.column(name)
        if name.endswith("_") and name[:-1] in columns:
            return self.column(name[:-1])
        raise AttributeError(f"no column {name!r}; there are {', '.join(columns)}")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(_attribute(name) for name in self.keys())]

    def __len__(self) -> int:
        return int(self._data["rows"])

    def _row(self, i: int) -> dict[str, object]:
        absent = self._data["absent"]
        row = {}
        for name, values in self._data["columns"].items():
            if i in absent.get(name, ()):
                continue
            value = values[i]
            row[name] = value.item() if isinstance(value, np.generic) else value
        return row

    @overload
    def __getitem__(self, at: int) -> Row: ...
    @overload
    def __getitem__(self, at: slice) -> list[Row]: ...
    @overload
    def __getitem__(self, at: str) -> npt.NDArray[Any]: ...

    def __getitem__(self, at: int | slice | str) -> Row | list[Row] | npt.NDArray[Any]:
        if isinstance(at, str):
            return self.column(at)
        if isinstance(at, slice):
            return [self[i] for i in range(*at.indices(len(self)))]
        i = range(len(self))[at]
        return cast(Row, self._of({name: _none_of(value) for name, value in self._row(i).items()}, self._reduced))

    def to_dicts(self) -> list[dict[str, Any]]:
        """The rows as JSON has them."""
        plain = {}
        for name, values in self._data["columns"].items():
            if isinstance(values, np.ndarray):
                plain[name] = [_none_of(value) for value in values.tolist()]
            else:
                entry = self._entry(name)
                plain[name] = [_plain(value, entry) for value in values]
        absent = {name: set(rows) for name, rows in self._data["absent"].items()}
        return [{name: values[i] for name, values in plain.items() if i not in absent.get(name, ())} for i in range(len(self))]

    def describe(self) -> Description:
        """What each column is, line by line: name, unit, meaning."""
        return Description(self._entries, self._reduced)

    def to_frame(self) -> pandas.DataFrame:
        """A pandas.DataFrame: an estimate takes four columns, NAME, NAME_standard_error, NAME_low and NAME_high; `attrs["units"]` has the units."""
        import pandas as pd

        columns: dict[str, npt.NDArray[Any]] = {}
        units: dict[str, str] = {}
        for name, values in self._data["columns"].items():
            entry = self._entry(name)
            if entry["shape"] == "estimate":
                data = cast("list[Data | None]", values)
                read = [Estimate(value or {}) for value in data]
                parts = [(e.value, e.stderr, *e.ci95) for e in read]
                for k, suffix in enumerate(("", "_standard_error", "_low", "_high")):
                    columns[name + suffix] = np.array([part[k] for part in parts])
                    units[name + suffix] = next((str(value["unit"]) for value in data if value), "")
                continue
            columns[name] = values if isinstance(values, np.ndarray) else self.column(name)
            if entry["unit"]:
                units[name] = unit_of(entry, self._reduced)
        frame = pd.DataFrame(columns, index=pd.RangeIndex(len(self)))
        frame.attrs["units"] = units
        return frame

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Table):
            return NotImplemented
        return same(self._data, other._data)

    def __hash__(self) -> int:
        return hash((len(self), *self.keys()))

    def __repr__(self) -> str:
        if 0 < len(self) <= _SHORT:
            return _laid_out(self._cells())
        units = {entry["name"]: _in_brackets(unit_of(entry, self._reduced)) for entry in self._entries}
        return f"<{len(self)} rows: {', '.join(name + units[name] for name in self.keys())}>"

    def _repr_html_(self) -> str:
        return str(self._shown()._repr_html_())

    def _shown(self, names: Iterable[str] | None = None) -> pandas.DataFrame:
        """As people read it, all columns or some."""
        import pandas as pd

        return pd.DataFrame(self._cells(names))

    def _cells(self, names: Iterable[str] | None = None) -> dict[str, list[str]]:
        """Columns as text by their headings: one of numbers in the unit that suits its largest, which stands in its heading."""
        columns = {}
        for name in self.keys() if names is None else names:
            entry, values = self._entry(name), self.column(name)
            unit = unit_of(entry, self._reduced)
            if entry["shape"] == "number" and values.dtype.kind == "f":
                unit, cells = _in_one_unit(values, unit)
            else:
                cells = ["" if value is None else _in_short(value, unit) for value in values.tolist()]
                unit = "" if entry["shape"] == "estimate" else unit
            columns[name + _in_brackets(unit)] = cells
        return columns


_SHORT = 12  # rows of a table that are printed


def html_of(columns: Mapping[str, Sequence[str]], caption: str) -> str:
    """Columns of text below their headings, as a table of a page."""
    heading = "".join(f"<th>{html.escape(name)}</th>" for name in columns)
    rows = "".join(f"<tr>{''.join(f'<td>{html.escape(cell)}</td>' for cell in row)}</tr>" for row in zip(*columns.values()))
    return f"<table><caption>{html.escape(caption)}</caption><tr>{heading}</tr>{rows}</table>"


def _laid_out(columns: Mapping[str, Sequence[str]]) -> str:
    """Columns of text below their headings; a table of one row has a line for each of them."""
    rows: list[tuple[str, ...]] = [tuple(columns), *zip(*columns.values())]
    if len(rows) == 2:
        rows = list(zip(*rows))
    widths = [max(map(len, cells)) for cells in zip(*rows)]
    return "\n".join("  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths)).rstrip() for row in rows)


def suiting(values: Numbers, unit: str) -> tuple[str, float]:
    """The unit that suits the largest of some numbers, and the factor to it."""
    largest = float(np.abs(values[np.isfinite(values)]).max(initial=0))
    if unit not in _PLAIN and largest > 0:
        number, _, suits = readable(largest, unit).partition(" ")
        if suits:
            return suits, 10.0 ** round(math.log10(float(number) / largest))  # units differ by powers of ten
    return unit, 1.0


def _in_one_unit(values: Numbers, unit: str) -> tuple[str, list[str]]:
    """Numbers as text, in the unit that suits the largest of them, and that unit."""
    unit, scale = suiting(values, unit)
    return unit, ["" if value != value else readable(value, "") for value in (values * scale).tolist()]


Line = tuple[str, str, str, str]  # name, shape, unit, meaning


class Description(Sequence[Line]):
    """What an answer holds: a line for each number, its name, unit and meaning."""

    def __init__(self, entries: Sequence[Entry], reduced: bool = False, above: str = "") -> None:
        self._lines: list[Line] = []
        for entry in entries:
            name = above + entry["name"]
            self._lines.append((name, entry["shape"], unit_of(entry, reduced), entry["meaning"]))
            below = {"list": "[].", "by_name": ".*."}.get(entry["shape"], ".")
            self._lines += Description(entry["entries"], reduced, name + below)._lines

    def __len__(self) -> int:
        return len(self._lines)

    @overload
    def __getitem__(self, at: int) -> Line: ...
    @overload
    def __getitem__(self, at: slice) -> list[Line]: ...

    def __getitem__(self, at: int | slice) -> Line | list[Line]:
        return self._lines[at]

    def to_frame(self) -> pandas.DataFrame:
        """A pandas.DataFrame of name, shape, unit and meaning."""
        import pandas as pd

        return pd.DataFrame(self._lines, columns=["name", "shape", "unit", "meaning"]).set_index("name")

    def __repr__(self) -> str:
        wide = max((len(line[0]) for line in self._lines), default=0)
        units = max((len(line[2]) for line in self._lines), default=0)
        return "\n".join(f"{name:<{wide}}  {unit:<{units}}  {meaning}" for name, _, unit, meaning in self._lines)

    def _repr_html_(self) -> str:
        return str(self.to_frame()._repr_html_())


# Classes are made from what describes the answers, so that help() and completion know every number.
_MADE: dict[tuple[str, ...], type[Answer]] = {}


def _camel(name: str) -> str:
    return "".join(part.capitalize() for part in name.split("_"))


def _doc_of(entry: Entry) -> str:
    unit, meaning = str(entry["unit"]), str(entry["meaning"])
    return meaning + (f" [{unit}]" if unit else "")


def _property_of(entry: Entry) -> property:
    def get(self: Answer) -> object:
        return self._of(entry)

    return property(get, doc=_doc_of(entry))


def make_class(path: tuple[str, ...], entries: Sequence[Entry], name: str, what: str) -> type[Answer]:
    """The class of an answer, and those of its groups and lists."""
    classes = {}
    for entry in entries:
        if entry["shape"] in ("group", "list", "by_name"):
            classes[entry["name"]] = make_class((*path, entry["name"]), entry["entries"], name.removesuffix("Fields") + _camel(entry["name"]), entry["meaning"])
    caption = what[:1].upper() + what[1:]
    members: dict[str, object] = {"_entries": entries, "_classes": classes, "_path": path, "_title": name, "_caption": caption, "__doc__": what, "__module__": "flexslip"}
    for entry in entries:
        attribute = _attribute(entry["name"])
        if hasattr(Answer, attribute):
            raise TypeError(f"{name}.{attribute} is a method of every answer")  # a field needs another name in Python
        members[attribute] = _property_of(entry)
    made = cast(type[Answer], type(name, (Answer,), members))
    _MADE[path] = made
    return made


def made_classes() -> list[type[Answer]]:
    """All of them."""
    return list(_MADE.values())


def _made(path: tuple[str, ...], data: Data, reduced: bool) -> Answer:
    return _MADE[path](data, reduced)


def _table_of(data: Columns, path: tuple[str, ...], reduced: bool) -> Table[Answer]:
    return Table(data, _MADE[path], reduced=reduced)


def table_of(data: Columns, entries: Sequence[Entry], reduced: bool = False) -> Table[Answer]:
    """A table of an answer that is one itself; _fields.pyi has the types of those whose columns are known."""
    return Table(data, _row_class(entries), reduced=reduced)


def _row_class(entries: Sequence[Entry]) -> type[Answer]:
    """The class of a row of such a table."""
    row = cast(type[Answer], type("Row", (Answer,), {"_entries": entries, "_title": "Row"}))
    for entry in entries:
        setattr(row, _attribute(entry["name"]), _property_of(entry))
    return row


def _row_again(data: Data, entries: Sequence[Entry], reduced: bool) -> Answer:
    return _row_class(entries)(data, reduced)
