"""Measured tests: what friction they show."""
from __future__ import annotations

import os
import textwrap
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, cast

import numpy as np
import numpy.typing as npt

from . import _flexslip
from ._answers import ANSWERS, Data, same, table_of
from ._case import Case, case_of, in_words_of, with_keywords
from ._errors import Path, advice, one_of, path_of, positive
from ._fields import FitDraws, FitFields

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

    from ._fields import FitCurvesTable, Numbers
    from ._flexslip import Columns, Figure

_CURVES = ANSWERS["fit --curves"]["entries"]


class Fit(FitFields):
    """What a measured test shows, as :func:`fit` gives it.

    Every number of ``flexslip fit --json`` is an attribute; :meth:`describe` says what each is. Besides:

    Attributes
    ----------
    params : parameters
        ``fit.params["mu0"].value``, ``.stderr``, ``.ci95``, ``.unit``.
    success : bool
        Is there an answer? False for CHECK INPUT and NO ANSWER: `message` then says what to do, and no number is one to report.
    message : str
        The verdict's sentence; where there is no answer, what to do about it, too.
    case : Case
        What was fitted.
    curves : Table
        Point by point of the record: measured, fitted and replayed force, friction read. NumPy arrays.
    draws : Draws
        Profiles of friction that explain the record, for statistics of one's own.
    """

    _title = "Fit"

    def __init__(self, data: Data, case: Case, test: _flexslip.FittedTest | None = None, kept: Mapping[str, object] | None = None) -> None:
        super().__init__(data, case.reduced)
        self.case = case
        self._test = test
        self._kept: dict[str, object] = dict(kept or {})

    def _part(self, name: str) -> object:
        """What is made of the test when it is first asked for."""
        if name not in self._kept:
            self._kept[name] = getattr(self._test, name)()
        return self._kept[name]

    def __reduce__(self) -> tuple[object, ...]:
        for name in _KEPT if self._is_computed else _ALWAYS_KEPT:
            self._part(name)
        return _fit_again, (self._data, self.case, self._kept)

    @property
    def success(self) -> bool:
        """Is there an answer? If not, `message` says why, and what depends on it is None or NaN."""
        return self._is_computed and self.verdict.code not in ("check_input", "no_answer")

    @property
    def _is_computed(self) -> bool:
        return bool(self._data["status"] == "ok")

    @property
    def message(self) -> str:
        """The verdict's sentence; where there is no answer, what to do about it, too."""
        sentence = self.verdict.sentence
        return sentence if self.success or not self.next else f"{sentence} {self.next}"

    @property
    def curves(self) -> FitCurvesTable:
        """Point by point of the record that was evaluated: measured, fitted and replayed force, length and friction, as NumPy arrays. `row` is the row of the
        file, frame or arrays, from 1."""
        return cast("FitCurvesTable", table_of(cast("Columns", self._part("curves")), _CURVES, self._reduced))

    @property
    def residual(self) -> Numbers:
        """Measured less fitted force, point by point of `curves`, NaN where the fit does not reach. [N]

        Of every row, those as well that the fit leaves out, at small deflections and within drops: its root mean square is greater than `residual_rms`,
        mostly because a drop that the fit puts a row earlier or later makes a residual as large as the drop.
        """
        curves = self.curves
        return curves.force - curves.model_force

    def correlation(self) -> pandas.DataFrame:
        """How the errors of `params` go together, a row and a column for each parameter that is estimated; empty without an answer.

        Over all explanations of the record, or, where a wave is claimed, over those that have it. Of bending_stiffness, roughness and correlation_length
        it is the correlation of their logarithms.
        """
        import pandas

        pairs = {(pair.of, pair.with_): pair.correlation for pair in self.correlations}
        told = {name for pair in pairs for name in pair}
        names = [name for name in self.params.keys() if name in told]
        table = pandas.DataFrame(np.eye(len(names)), index=names, columns=names)
        for (one, other), value in pairs.items():
            table.loc[one, other] = table.loc[other, one] = value
        return table

    def covariance(self) -> pandas.DataFrame:
        """That of `params`, as :meth:`correlation` with their standard errors: in the products of their units, SI."""
        table = self.correlation()
        errors = np.array([self.params[name].stderr for name in table.index])
        return table * np.outer(errors, errors)

    @property
    def residual_rms(self) -> float:
        """Root mean square of measured less fitted force over the rows that the fit takes. [N]

        Those are the rows that are bent by more than 8 % of the span, or by half the greatest deflection if that is less, while the stage advances; rows
        within a drop, and rows that no friction from -1.5 to 2.2 explains, do not count. `residual` has them all.
        """
        return super().residual_rms

    def __eq__(self, other: object) -> bool:
        """Are the numbers and the verdict equal? Names, where the record was read from, how, and what to do next do not count."""
        if not isinstance(other, Fit):
            return NotImplemented
        return self._reduced == other._reduced and same(_concluded(self._data), _concluded(other._data))

    __hash__ = FitFields.__hash__

    @property
    def draws(self) -> Draws:
        """Profiles of friction that explain the record, drawn at random."""
        if not self._is_computed:
            raise ValueError(f"there is no fit to draw profiles from: {self.message}")
        return Draws(cast(Data, self._data["draws"]), cast("Columns", self._part("draws")), self._reduced)

    def summary(self, full: bool = False) -> str:
        """The answer in words, as the program prints it, with arguments instead of flags; `full`: every slip and table."""
        return advice(str(self._part("text" if full else "screen")))

    def to_frame(self) -> pandas.DataFrame:
        """A pandas.DataFrame with a row for each parameter."""
        return self.params.to_frame()

    def report(self, folder: Path) -> str:
        """Writes report.html and its figures into a folder, as ``flexslip fit --report`` does; gives the path of the former."""
        if self._test is None:
            raise ValueError("a fit that was pickled has no report: call fit(fit.case).report(folder)")
        path = path_of(folder, "folder", "the name of a folder")
        self._test.write_report(os.fsencode(path))
        return os.path.join(path, "report.html")

    def plot(self, figure: str | None = None, ax: Axes | npt.NDArray[np.object_] | None = None,
             unit: str | Sequence[str] | None = None) -> Axes | npt.NDArray[np.object_]:
        """A figure of the report, drawn with matplotlib.

        Parameters
        ----------
        figure : {"force", "profile", "wavelengths", "passes", "boxes", "record"}, optional
            Force against deflection, with residuals below; friction along the specimen; what a wave of each wavelength adds. Of a test that unloads:
            the force of all its passes; the friction of each against the length that slid. A test without friction has only the record. Unless stated:
            "force", or else "record".
        ax : matplotlib Axes, optional
            Where to draw: as many as the figure has panels ("force" has two), or one for the first of them. Letters are as they are set there
            (``legend.fontsize``).
        unit : str or (str, str), optional
            Of lengths, of forces, or of both: ``"mm"``, ``("mm", "N")``; those that suit the figure.

        Returns
        -------
        Axes, or an array of them
            To go on with.
        """
        from . import _plots

        figures = cast("list[Figure]", self._part("figures"))
        if figure == "record" and all(each["name"] != figure for each in figures) or not figures and figure is None:  # which the report draws without a fit only
            return _plots.record(self.curves.deflection, self.curves.force, self._reduced, ax)
        return _plots.plot(figures, figure, ax, unit)

    def _found(self) -> list[str]:
        """The doubts, each with its remedy, and the next step, in words of Python."""
        return [*(f"{doubt.sentence} {doubt.remedy}".strip() for doubt in self.doubts), *([self.next] if self.next else [])]

    def _parameters_hold(self) -> bool:
        return self._is_computed and self.verdict.code in ("slip", "undecided", "no_drops")

    def __repr__(self) -> str:
        lines = textwrap.wrap(f"{self.name}: {self.verdict.sentence}", _WIDTH, subsequent_indent="    ")
        for words in self._found():
            lines += textwrap.wrap(words, _WIDTH, initial_indent="  - ", subsequent_indent="    ")
        if self._parameters_hold():
            lines += [f"  {name:<20} {value}" for name, value, _ in self.params._shown()]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        import html

        found = "".join(f"<li>{html.escape(words)}</li>" for words in self._found())
        head = f"<p><b>{html.escape(f'{self.name}: {self.verdict.sentence}')}</b></p>" + (f"<ul>{found}</ul>" if found else "")
        return head + (self.params._repr_html_() if self._parameters_hold() else "")


def _concluded(data: Data) -> dict[str, object]:
    """What is measured and concluded, without where and how the record was read, and without remedies, which are in words of the door."""
    left = {name: value for name, value in data.items() if name not in ("name", "provenance", "preparation", "next", "doubts")}
    findings = cast("Columns", left["findings"])
    concluded = {name: values for name, values in findings["columns"].items() if name != "remedy"}
    left["findings"] = {"rows": findings["rows"], "absent": findings["absent"], "columns": concluded}
    return left


_WIDTH = 100  # of what is printed
_ALWAYS_KEPT = ("curves", "text", "figures", "screen")
_KEPT = (*_ALWAYS_KEPT, "draws")


def _fit_again(data: Data, case: Case, kept: Mapping[str, object]) -> Fit:
    return Fit(data, case, None, kept)


class Draws(FitDraws):
    """Profiles of friction that explain a record, on lengths between the contacts that rise.

    Attributes
    ----------
    length : array, shape (n,)
        Lengths between the contacts, in m, or in spans of a reduced test.
    mu, deviation : array, shape (n,)
        The mean of the fit, and its standard deviation.
    profiles : array, shape (20, n)
        Drawn at random, the same at every run.
    bending_stiffness : array, shape (20,)
        EI that goes with each, in the unit of ``fit.params["bending_stiffness"]``.
    """

    length: Numbers
    mu: Numbers
    deviation: Numbers
    profiles: Numbers
    _title = "Draws"

    def __init__(self, data: Data, table: Columns, reduced: bool) -> None:
        import numpy as np

        super().__init__(data, reduced)
        self._table = table
        columns = table["columns"]
        self.length, self.mu, self.deviation = (cast("Numbers", columns[name]) for name in ("length", "mu", "deviation"))
        self.profiles = np.array([values for name, values in columns.items() if name.startswith("draw_")])

    def __reduce__(self) -> tuple[object, ...]:
        return Draws, (self._data, self._table, self._reduced)

    def to_frame(self) -> pandas.DataFrame:
        """A pandas.DataFrame as ``flexslip fit --draws`` writes it; `attrs["units"]` has the units."""
        import pandas as pd

        columns = {"length": self.length, "mu": self.mu, "deviation": self.deviation}
        columns |= {f"draw_{k}": profile for k, profile in enumerate(self.profiles, 1)}
        frame = pd.DataFrame(columns)
        frame.attrs["units"] = {name: ("L" if self._reduced else "m") if name == "length" else "1" for name in columns}
        return frame

    def __repr__(self) -> str:
        return f"<{len(self.profiles)} profiles at {len(self.length)} lengths>"


@with_keywords("specimen", "rig", "record")
def fit(file: object = None, *arrays: object, model: str | None = None, false_alarms: float | None = None, suspect_limit: float | None = None,
        name: str | None = None, set: Mapping[str, object] | None = None,  # noqa: A002
        **keywords: object) -> Fit:
    """What friction a measured test shows, where along the specimen, and how certainly.

    Parameters
    ----------
    file : path, Case, DataFrame or array
        A case file (``.toml``), the data of a test, which the keywords describe, or a :class:`Case`. Data may be a file, a pandas.DataFrame, or two arrays,
        ``(stage, force)``, in SI.
    model : {"roughness", "constant", "drift", "sinusoid", "sinusoids"}, optional
        The model of friction; as the case says, or roughness.
    false_alarms : float, optional
        Drops expected on average in a test of this length without slips.
    suspect_limit : float, optional
        Friction above this is implausible.
    name : str, optional
        What to call a test whose record is a DataFrame or arrays; "arrays". One of a file is called after it.
    set, **keywords
        As of :class:`Case`: ``span="1278 um"``, ``rig={"stiffness": 90.65}``.

    Returns
    -------
    Fit
        Where there is no answer, its `success` is False and its `message` says why.

    Raises
    ------
    InputError
        For a case or a record that is wrong, with file, line and remedy.
    FileNotFoundError
        For a file that is not there; it is an InputError, too.

    Examples
    --------
    >>> import flexslip
    >>> fit = flexslip.fit("examples/simulated/case.toml")
    >>> fit.success, fit.model
    (True, 'roughness')
    >>> mu0 = fit.params["mu0"]
    >>> mu0.ci95[0] < mu0.value < mu0.ci95[1], mu0.unit
    (True, '1')
    """
    if model is not None:
        one_of("model", model, _flexslip.model_names)
    case = case_of(file, arrays, set, keywords, name)
    alarms = _flexslip.false_alarms if false_alarms is None else positive("false_alarms", false_alarms)
    limit = _flexslip.suspect_limit if suspect_limit is None else positive("suspect_limit", suspect_limit)
    with in_words_of(case) as given:
        test = _flexslip.fit(given, model or "", alarms, limit)
    return Fit(test.answer(), case, test)
