"""Planned tests."""
from __future__ import annotations

import contextlib
import importlib.util
import os
import reprlib
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, cast

import numpy as np
import numpy.typing as npt

from . import _flexslip
from ._answers import Answer, Data, Description, Table, table_of
from ._case import Case, _says_reduced, quantity_in_words, unit_of_parameter, with_keywords
from ._errors import InputError, advice, warn, whole, wrong
from ._fields import DesignFields

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

    from ._flexslip import Entry, Figure, Map


class _Kept:
    """What has figures that are made when they are first asked for."""

    _test: _flexslip.HasFigures | None
    _kept: dict[str, object]

    def _figures(self) -> list[Figure]:
        if "figures" not in self._kept:
            assert self._test is not None  # or it was pickled with its figures
            self._kept["figures"] = self._test.figures()
        return cast("list[Figure]", self._kept["figures"])

    def plot(self, ax: Axes | None = None) -> Axes:
        """The figure of ``flexslip design --figure``, drawn with matplotlib; gives the Axes."""
        from . import _plots

        return _plots.plot(self._figures(), None, ax)


class _Planned(Case):
    """The case of a design, whose friction may be open: it is read when it is planned."""

    def _read(self) -> None:
        pass

    @property
    def reduced(self) -> bool:
        """Is everything in the variables of the model?"""
        return _says_reduced(self._text)

    @contextlib.contextmanager
    def _asked(self) -> Iterator[tuple[str, bytes, list[str]]]:
        """What the module reads; its complaints are in the words in which the case was given."""
        try:
            yield self._text, os.fsencode(self._source), self._changes
        except InputError as error:
            raise self._in_own_words(error) from None

    def _with_friction(self, middle: str) -> Case:
        """The case; if its friction is open, that of the middle of the ranges, as the text of a case file."""
        try:
            return Case(self)
        except InputError:
            return Case.from_toml(middle)


def _planned(file: object, set: Mapping[str, object] | None, keywords: Mapping[str, Any]) -> _Planned:  # noqa: A002
    return _Planned(file, set=set, **keywords)


class Design(_Kept, DesignFields):
    """What a planned test will show, as :func:`design` gives it: every number of ``flexslip design --json``.

    Attributes
    ----------
    answer : str
        Whether the test shows a sawtooth, in a sentence.
    changes : Table
        Single changes with which it would be the other way.
    case : Case
        What was planned; if its friction is open, with the middle of the ranges.
    """

    _title = "Design"

    def __init__(self, data: Data, case: Case, test: _flexslip.DesignAnswer | None = None, kept: Mapping[str, object] | None = None) -> None:
        super().__init__(data, case.reduced)
        self.case, self._test, self._kept = case, test, dict(kept or {})
        if test is not None:
            self._kept["text"] = test.text()

    def __reduce__(self) -> tuple[object, ...]:
        self._figures()
        return _design_again, (self._data, self.case, self._kept)

    def summary(self) -> str:
        """The answer in words, as the program prints it, with arguments instead of flags."""
        return advice(str(self._kept["text"]))

    def __repr__(self) -> str:
        return f"<Design: {self.answer}>"


def _design_again(data: Data, case: Case, kept: Mapping[str, object]) -> Design:
    return Design(data, case, None, kept)


class DesignMap(_Kept):
    """Planned tests over one parameter, or two: what ``flexslip design --over`` gives.

    Attributes
    ----------
    designs : Table
        One for each combination of values, the last parameter fastest.
    case : Case
    """

    def __init__(self, data: Map, case: Case, entries: list[Entry], test: _flexslip.DesignMap | None = None, kept: Mapping[str, object] | None = None) -> None:
        self._data, self.case, self._entries, self._test, self._kept = data, case, entries, test, dict(kept or {})

    def __reduce__(self) -> tuple[object, ...]:
        self._figures()
        return _map_again, (self._data, self.case, self._entries, self._kept)

    @property
    def designs(self) -> Table[Answer]:
        """One for each combination of values, the last parameter fastest."""
        return table_of(self._data["designs"], next(e for e in self._entries if e["name"] == "designs")["entries"], self.case.reduced)

    def to_dict(self) -> dict[str, object]:
        """As JSON has it."""
        return {"units": dict(self._data["units"]), "designs": self.designs.to_dicts()}

    def to_json(self) -> str:
        """As the program writes it with ``--json``, to the last byte."""
        return str(_flexslip.dumped(self.to_dict()))

    def to_frame(self) -> pandas.DataFrame:
        """The designs as a pandas.DataFrame."""
        return self.designs.to_frame()

    def describe(self) -> Description:
        """What each column is."""
        return self.designs.describe()

    def _figures(self) -> list[Figure]:
        """Of one parameter: drops only where the specimen snaps, as elsewhere the force falls smoothly, and where that is."""
        return [_where_it_snaps(figure) if not figure["panels"][0]["colour"] else figure for figure in super()._figures()]

    def __len__(self) -> int:
        return len(self.designs)

    def __repr__(self) -> str:
        return f"<DesignMap of {len(self)} designs>"

    def _repr_html_(self) -> str:
        return str(self.designs._shown(self._columns())._repr_html_()) + self._picture()

    def _columns(self) -> list[str]:
        """The parameters, which come before the status, and what a test of each design shows."""
        names = self.designs.keys()
        return [*names[:names.index("status")], "snaps", "drops", "largest_drop", "greatest_force"]

    def _picture(self) -> str:
        if importlib.util.find_spec("matplotlib") is None:
            return ""
        from . import _plots

        return _plots.picture(self.plot())


# what each is a share of
_OF = {"Largest drop": "Largest drop, of force", "Mean drop": "Mean drop, of force", "Friction and snaps": "Friction and snaps, of work"}


def _where_it_snaps(figure: Figure) -> Figure:
    """The figure of designs over one parameter without the drops of those that do not snap."""
    from ._plots import changed

    first, *second = figure["panels"]
    parameter, name = first["marks"][0]["columns"][0], first["marks"][0]["table"]
    table = figure["data"][name]
    snaps = np.isfinite(table[second[0]["marks"][0]["columns"][1]]) if second else np.zeros(len(table[parameter]), dtype=bool)  # only then has it a second panel
    drops = {mark["columns"][1] for mark in first["marks"] if "drop" in mark["columns"][1]}
    shown = {column: np.where(snaps, values, np.nan) if column in drops else values for column, values in table.items()}
    values, unit = table[parameter][snaps], parameter[parameter.rfind("["):].strip("[]") if "[" in parameter else ""
    where = f"Snaps from {values.min():.3g} to {values.max():.3g} {unit}".rstrip() + f", {len(values)} of {len(snaps)}" if len(values) else "No snaps"
    panels = [changed(first, key_width=1.4 * first["key_width"], marks=[changed(mark, title=_OF.get(mark["title"], mark["title"])) for mark in first["marks"]]), *(changed(panel) for panel in second)]
    panels[-1]["title"] = f"{panels[-1]['title']}   {where}".lstrip()
    return cast("Figure", changed(figure, panels=panels, data={**figure["data"], name: shown}))


def _map_again(data: Map, case: Case, entries: list[Entry], kept: Mapping[str, object]) -> DesignMap:
    return DesignMap(data, case, entries, None, kept)


_OVER = "a range, (from, to) or (from, to, points), or a list of values"


def _range(name: str, given: object, reduced: bool) -> str:
    field = f"over[{name!r}]"
    if isinstance(given, str):
        return f"{name}={given}"
    if isinstance(given, (list, range)) or hasattr(given, "__array__"):
        given = _range_of(field, list(cast("Iterable[object]", given)) if np.ndim(cast("npt.ArrayLike", given)) == 1 else [])
    if not isinstance(given, tuple) or len(given) not in (2, 3):
        raise wrong(field, _OVER, given)
    ends = [quantity_in_words(field, end, unit_of_parameter(name), "an end of a range", reduced) for end in given[:2]]
    return f"{name}={':'.join([*ends, *(str(whole('points', n, 2, 10000)) for n in given[2:])])}"


def _range_of(field: str, values: list[object]) -> tuple[object, ...]:
    """The range that has these values: a map is drawn over even ones, in the logarithm where the ends are ten times apart or more."""
    remedy = f"pass a range, (from, to, points), or take flexslip.sweep(case, axes={{{field[5:-1]}: [...]}}), which takes any values"
    if len(values) < 2:
        raise wrong(field, "two values or more", values, remedy)
    if len(values) > 2:
        if not all(isinstance(value, (int, float, np.number)) for value in values):
            raise wrong(field, "numbers in SI in a list of three values and more", values, remedy)
        numbers = np.array(values, dtype=float)
        first, last = float(numbers[0]), float(numbers[-1])
        in_logarithm = first > 0 and last > 0 and max(first / last, last / first) >= 10
        even = np.geomspace(first, last, len(values)) if in_logarithm else np.linspace(first, last, len(values))
        if not np.allclose(numbers, even, rtol=1e-9, atol=0):  # values that a user computed round otherwise
            raise wrong(field, "values of even " + ("ratios, as the ends are ten times apart or more" if in_logarithm else "steps"), reprlib.repr(values), remedy)
    return values[0], values[-1], len(values)


@with_keywords("specimen", "rig", "friction", "stage")
def design(file: object = None, *, over: Mapping[str, object] | None = None, decide: bool = False, noise: str | float | None = None,
           threads: int | None = None, set: Mapping[str, object] | None = None, **keywords: object) -> Design | DesignMap:  # noqa: A002
    """Before a test: will it show a sawtooth, and what would change that?

    Parameters
    ----------
    file : path or Case, optional
        A case as for :func:`simulate`: its farthest stage position is the travel of one loading. Friction may be left out, or its mean, amplitude or
        wavelength: the answer is then for ranges that fit the specimen, which are in ``open``.
    over : mapping, optional
        One parameter, or two, and their ranges: ``{"stiffness": ("10 N/m", "1000 N/m", 41)}``; the number of points may be left out. Steps are even, in
        the logarithm where the ends are ten times apart or more. A list or an array is the values, which have to be even likewise; :func:`sweep` takes any.
    decide : bool
        Also say, as ``reload``, how far to load and unload for a second loading to tell whether the drops are slips or cracks. Not with `over`.
    noise : quantity, optional
        With `decide`: standard deviation of the force readings, "10 uN"; 0.1 % of the maximum force if it is left out.
    threads : int, optional
        Tests computed at the same time; all cores.
    set, **keywords
        As of :class:`Case`.

    Returns
    -------
    Design, or a DesignMap with `over`

    Raises
    ------
    InputError
        For a case or a range that is wrong.

    Examples
    --------
    >>> import flexslip
    >>> flexslip.design("examples/design.toml").snaps > 10
    True
    >>> flexslip.design("examples/design.toml", decide=True).reload.planned.drops > 3
    True
    >>> len(flexslip.design("examples/design.toml", over={"stiffness": (50.0, "200 N/m", 3)}))
    3
    """
    planned = _planned(file, set, keywords)
    reduced = planned.reduced
    count = _flexslip.threads if threads is None else whole("threads", threads, 1, 1024)
    if noise is not None and not decide:
        raise wrong("noise", "left out without decide=True", noise)
    if over is None:
        text = "" if noise is None else quantity_in_words("noise", noise, "N", "a force", reduced)
        with planned._asked() as asked:
            answer = _flexslip.design_with_reload(*asked, text, count) if decide else _flexslip.design(*asked, count)
        return Design(answer.answer(), planned._with_friction(answer.toml()), answer)
    if decide:
        raise wrong("decide", "one planned test", "a range of them, over", "leave out one of the two, or set a value of the range")
    if not isinstance(over, Mapping) or not over:
        raise wrong("over", "a dict of ranges, {\"stiffness\": (\"10 N/m\", \"1000 N/m\")}", over)
    texts = [_range(str(name), given, reduced) for name, given in over.items()]
    with planned._asked() as asked:
        found = _flexslip.design_map(*asked, texts, count)
    for sentence in found.values_taken():
        warn(sentence)
    return DesignMap(found.answer(), planned._with_friction(found.toml()), found.entries(), found)
