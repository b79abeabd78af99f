"""Many tests."""
from __future__ import annotations

import contextlib
import csv
import importlib.util
import os
import re
import shutil
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeGuard, cast

import numpy as np
import numpy.typing as npt

from . import _flexslip
from ._answers import ANSWERS, Answer, Data, Table, readable, table_of
from ._case import KEYS, Case, Sections, cell_of, sections_of, set_of, text_of, with_keywords
from ._errors import ARRAYS, InputError, Path, advice, error_of, in_keywords, in_python, one_of, path_of, positive, whole, wrong
from ._fields import CampaignFields
from ._fit import Fit
from ._frames import NAME, in_words_of_frame, is_frame, whole_frame, written

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

    from ._fields import CampaignFailures
    from ._flexslip import Columns, Entry, Figure, Key

_SHOWN = (  # title, column of the value, column of its standard error
    ("friction μ₀", "mu0", "mu0_standard_error"), ("wavelength", "wavelength", "wavelength_standard_error"),
    ("friction's share of the work", "friction_share", "friction_share_error"), ("stiffness lost", "stiffness_lost", "stiffness_lost_error"),
    ("modulus", "modulus", "modulus_standard_error"),
)


class Campaign(CampaignFields):
    """What many tests show, as :func:`campaign` gives it: every number of ``flexslip campaign --json``.

    Attributes
    ----------
    tests : Table
        A row a test; ``tests.name``, ``tests[0].params["mu0"].value``.
    success : bool
        Could a test be evaluated?
    message : str
        The first lines of the answer; the first cause of the tests that could not be evaluated, and how many are alike.
    """

    _title = "Campaign"

    def __init__(self, data: Data, campaign: _flexslip.Campaign | None = None, kept: Mapping[str, object] | None = None) -> None:
        super().__init__(data)
        self._campaign = campaign
        self._kept: dict[str, object] = dict(kept or {})

    def _part(self, name: str) -> object:
        if name not in self._kept:
            self._kept[name] = getattr(self._campaign, name)()
        return self._kept[name]

    def __reduce__(self) -> tuple[object, ...]:
        for name in ("test_table", "figures", "text"):
            self._part(name)
        return _campaign_again, (self._data, self._kept)

    def _table(self) -> Table[Answer]:
        columns = [column for entry in ANSWERS["campaign: tests.csv"]["entries"] for column in _split(entry, entry["title"] or entry["name"])]
        return table_of(cast("Columns", self._part("test_table")), columns)

    def to_frame(self) -> pandas.DataFrame:
        """A pandas.DataFrame with a row for each test: the columns of tests.csv, in SI."""
        return self._table().to_frame().set_index("test")

    def summary(self) -> str:
        """The answer in words, as the program prints it, with arguments instead of flags."""
        return advice(str(self._part("text")))

    def plot(self, figure: str | None = None, ax: Axes | npt.NDArray[np.object_] | None = None) -> Axes | npt.NDArray[np.object_]:
        """The distributions of wavelength and friction, the losses of stiffness, or a page of the atlas of force curves; gives the Axes.

        `figure` is "distributions", "losses", or "atlas-clear-1", ...
        """
        from . import _plots

        return _plots.plot(cast("list[Figure]", self._part("figures")), figure, ax)

    @property
    def success(self) -> bool:
        """Could a test be evaluated? If none could, `message` says why."""
        return len(self.failures) < len(self._table())

    @property
    def message(self) -> str:
        """The first lines of the answer; the first cause of the tests that could not be evaluated, and how many are alike."""
        verdicts, _, rest = self.summary().partition("\n\n")
        rows = rest.split("\n\n")[0] if rest.startswith("  ") and not rest.startswith("   ") else ""  # a table is indented farther
        answer = f"{verdicts}\n\n{rows}".strip()
        if not len(self.failures):
            return answer
        first = self.failures[0]
        alike = sum(_kind_of_cause(each) == _kind_of_cause(first) for each in self.failures)
        return f"{answer}\n{first.name}: {_cause(first)}" + (f" (alike in {alike} tests)" if alike > 1 else "")

    def __repr__(self) -> str:
        return "\n".join([self.message, *self.notes])

    def _repr_html_(self) -> str:
        import html

        notes = [f"<p>{html.escape(note)}</p>" for note in self.notes]
        return "".join([f"<pre>{html.escape(self.message)}</pre>", *notes, str(self._shown_tests()._repr_html_()), self._picture()])

    def _picture(self) -> str:
        if not self._part("figures") or importlib.util.find_spec("matplotlib") is None:
            return ""
        from . import _plots

        return _plots.picture(self.plot())

    def _shown_tests(self) -> pandas.DataFrame:
        """What each test shows, in a few columns; :meth:`to_frame` has all."""
        import pandas as pd

        tests = self._table()
        units = {line[0]: line[2] for line in tests.describe()}
        columns = {"test": tests.test, "verdict": tests.verdict, "drops": ["" if drops is None or drops != drops else f"{drops:.0f}" for drops in tests.drops]}
        for title, name, error in _SHOWN:
            cells = ["" if value != value else readable(value, units[name], spread if spread > 0 else None) for value, spread in zip(tests[name], tests[error])]
            if any(cells):
                columns[title] = cells
        return pd.DataFrame(columns).set_index("test")


def _kind_of_cause(failure: CampaignFailures) -> str:
    """A cause without the names and numbers of its test."""
    return re.sub(r"'[^']*'|[0-9.]+", "", _cause(failure))


def _cause(failure: CampaignFailures) -> str:
    """Why a test could not be evaluated, without the row or the line where it is said."""
    return in_python(re.sub(r"^(row ('[^']*'|\d+)|\S*:\d+): ", "", str(failure.reason)))


def _split(entry: Entry, name: str) -> list[Entry]:
    """The columns of a field in a table, those of an estimate one by one."""
    if entry["shape"] == "group":
        return [column for below in entry["entries"] for column in _split(below, f"{name}_{below['title'] or below['name']}")]
    if entry["shape"] != "estimate":
        return [_changed(entry, name=name)]
    columns = [_changed(entry, name=name + suffix, shape="number", meaning=entry["meaning"] + words, entries=[])
               for suffix, words in (("", ""), ("_standard_error", ", its standard error"), ("_low", ", lower end of its 95 % interval"),
                                     ("_high", ", upper end of its 95 % interval"))]
    return columns + [column for below in entry["entries"] for column in _split(below, f"{name}_{below['name']}")]


def _changed(entry: Entry, **parts: object) -> Entry:
    return cast("Entry", {**cast(Mapping[str, object], entry), **parts})


def _campaign_again(data: Data, kept: Mapping[str, object]) -> Campaign:
    return Campaign(data, None, kept)


def _key_named(title: str) -> Key | None:
    """The key that a title without a unit names, or whose uncertainty it names."""
    section, _, name = re.sub("[ _.]uncertainty$", "", title).rpartition(".")
    return next((KEYS[each, name] for each in ([section] if section else ["record", "specimen", "rig"]) if (each, name) in KEYS), None)


def _with_names(frame: pandas.DataFrame) -> pandas.DataFrame:
    """A frame of tests as a table of text: named by its index, unless a column names them; bare numbers in SI."""
    titles = [str(name) for name in frame.index.names if name is not None]
    labels = list(frame.index)
    if any(title == "name" or _key_named(title) for title in titles):
        frame = frame.reset_index()
    elif "name" not in frame.columns and labels != list(range(len(labels))):
        frame = frame.assign(name=[" ".join(map(str, label)) if isinstance(label, tuple) else str(label) for label in labels])
    units = frame.attrs.get("units") or {}
    frame = whole_frame(frame.reset_index(drop=True))
    frame = frame[[title for title in frame.columns if not title.startswith("#")]].copy()  # the others are not meant for FlexSlip
    for title in frame.columns:
        key = None if units.get(title) else _key_named(title)
        if key:
            frame[title] = [cell_of(key, value) for value in frame[title]]
    return frame


def _names_of_rows(frame: pandas.DataFrame) -> list[str]:
    names = frame["name"] if "name" in frame.columns else range(len(frame))
    return [f"row {name!r}" for name in names]


@contextlib.contextmanager
def _table_of_tests(frame: pandas.DataFrame, report: str | None) -> Iterator[tuple[str, Callable[[Any], Any]]]:
    """The tests of a frame as a file, in the folder of its report, where a later call finds it again, or in one that goes; and what tells of that file in
    words of the frame."""
    frame = _with_names(frame)
    rows = files = _names_of_rows(frame)
    if "file" in frame.columns:
        files = [os.fsdecode(file) if isinstance(file, (str, os.PathLike)) else row for row, file in zip(rows, frame["file"])]
        frame["file"] = [os.path.abspath(os.fsdecode(file)) if isinstance(file, (str, os.PathLike)) else file for file in frame["file"]]
    with tempfile.TemporaryDirectory() as folder:
        if report is not None:
            os.makedirs(report, exist_ok=True)
        path = os.path.join(folder if report is None else report, "frame.csv")
        written(frame, path)
        line = re.compile(re.escape(path) + r":(\d+)\b")

        def told_at(found: re.Match[str], told: list[str]) -> str:
            at = int(found[1]) - 2  # below the titles
            return told[at] if 0 <= at < len(told) else f"{NAME}:{found[1]}"

        def in_words(data: Any) -> Any:
            if isinstance(data, str):
                if whole := line.fullmatch(data):
                    return told_at(whole, files)
                return in_python(line.sub(lambda found: told_at(found, rows), data).replace(path, NAME))
            if isinstance(data, dict):
                return {name: in_words(value) for name, value in data.items()}
            return [in_words(value) for value in data] if isinstance(data, list) else data

        yield path, in_words


def _is_path(value: object) -> TypeGuard[Path]:
    return isinstance(value, (str, bytes, os.PathLike))


def _in_common(common: object, keywords: Mapping[str, object]) -> Sections:
    """The sections that all tests have in common, of a case and of keywords."""
    if common is None:
        return sections_of(keywords)
    if not _is_path(common) and not isinstance(common, Case):
        raise wrong("common", "a case file or a Case", type(common).__name__, "pass a dict of its sections as keywords: campaign(tests, **common)")
    case = Case(common, **cast("dict[str, Any]", keywords))
    sections = {name: section for name, section in case.to_dict().items() if isinstance(section, dict)}
    for name in ("file", "stage", "deflection", "force", "length") if case._given else ():
        sections["record"].pop(name, None)
    return sections


@contextlib.contextmanager
def _shared_case(common: object, keywords: Mapping[str, object], report: str | None) -> Iterator[str | None]:
    """A case file of what tests in files have in common: the one that is named, or one that holds a case and keywords."""
    given = any(value is not None for value in keywords.values())
    if not given and (common is None or _is_path(common)):
        yield None if common is None else path_of(common, "common")
        return
    with _folder_of(report) as folder:
        path = os.path.join(folder, "common.toml")
        sections = _in_common(common, keywords)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text_of({name: _with_whole_paths(name, section) for name, section in sections.items()}, False))
        yield path


def _with_whole_paths(section: str, values: Mapping[str, object]) -> dict[str, object]:
    def is_file(name: str, value: object) -> bool:
        return KEYS[section, name]["is"] == "file" and isinstance(value, (str, os.PathLike)) if (section, name) in KEYS else False

    return {name: os.path.abspath(cast(str, value)) if is_file(name, value) else value for name, value in values.items()}


def _case_of_test(name: str, test: object, common: Sections) -> Case:
    """One of the tests of a campaign: a fit, a case, a file, a DataFrame or two arrays."""
    try:
        if isinstance(test, (Fit, Case)):
            case = test.case if isinstance(test, Fit) else test
            return Case(case, **cast("dict[str, Any]", common)) if common else case
        data = test if isinstance(test, tuple) else (test,)
        return Case(*data, **cast("dict[str, Any]", common))
    except InputError as error:
        parts = {part: getattr(error, part) for part in ("file", "line", "field", "key", "kind", "limit", "problem", "remedy")}
        raise error_of(f"{name}: {error}", **parts) from None
    except TypeError as error:
        raise TypeError(f"{name}: {error}") from None


def _named(tests: Mapping[str, object] | Sequence[object]) -> dict[str, object]:
    """Tests by their names: those of a mapping, or of what a list holds."""
    if isinstance(tests, Mapping):
        return {str(name): test for name, test in tests.items()}
    named: dict[str, object] = {}
    for number, test in enumerate(tests, 1):
        name = test.name if isinstance(test, Fit) else os.path.splitext(os.path.basename(os.fsdecode(test)))[0] if _is_path(test) else ""
        named[name if name and name not in named and name != ARRAYS else f"{name or 'test'} {number}"] = test
    return named


def _written_case(name: str, case: Case, folder: str) -> None:
    """A case as a file, and its readings in memory as another beside it."""
    base = os.path.join(folder, name)
    record = case.to_dict().get("record", {})
    data = f"{base}.csv" if case._given else os.path.abspath(str(record.get("file", "")))
    if case._given:
        titles = [str(record[column]) for column, _ in case._given]
        rows = zip(*(["" if value != value else repr(value) for value in values.tolist()] for _, values in case._given))
        with open(data, "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([titles, *rows])
    with open(f"{base}.toml", "w", encoding="utf-8") as file:
        file.write(case.replace(set={"record.file": data}).toml if not case._given else _of_file(case, data))


def _of_file(case: Case, data: str) -> str:
    """The text of a case whose readings are in a file."""
    sections = case.to_dict()
    sections["record"]["file"] = data
    return text_of(sections, case.reduced)


@contextlib.contextmanager
def _folder_of(report: str | None) -> Iterator[str]:
    """Where to write what a campaign has in memory: in the folder of its report, where a later call finds it again, or in one that goes."""
    if report is None:
        with tempfile.TemporaryDirectory() as folder:
            yield folder
    else:
        os.makedirs(report, exist_ok=True)
        yield report


@contextlib.contextmanager
def _folder_of_tests(tests: Mapping[str, object] | Sequence[object], common: Sections, report: str | None) -> Iterator[tuple[str, Callable[[Any], Any]]]:
    """Tests in memory as a folder of case files; and what tells of those files in words of the tests."""
    named = _named(tests)
    if not named:
        raise wrong("path", "tests", "an empty collection", 'pass them by name, {"G1": frame}')
    cases = {}
    for name, test in named.items():
        if not name or name.startswith(".") or "/" in name or "\0" in name or name == "case":
            raise wrong("path", "names of tests without a slash and a point in front", repr(name))
        cases[name] = _case_of_test(name, test, common)
    with _folder_of(report) as above:
        folder = os.path.join(os.path.abspath(above), "records")
        shutil.rmtree(folder, ignore_errors=True)
        for number, (name, case) in enumerate(cases.items()):
            place = os.path.join(folder, f"{number:06}")  # in their order
            os.makedirs(place)
            _written_case(name, case, place)
        written_as = re.compile(re.escape(folder + os.sep) + r"\d{6}/([^/\n]*?)\.(?:toml|csv)(?::\d+)?")

        def in_words(data: Any) -> Any:
            if isinstance(data, str):
                return in_keywords(in_python(written_as.sub(r"\1", data))) if folder in data else data
            if isinstance(data, dict):
                return {name: in_words(value) for name, value in data.items()}
            return [in_words(value) for value in data] if isinstance(data, list) else data

        yield folder, in_words


@with_keywords("specimen", "rig", "record")
def campaign(path: Path | pandas.DataFrame | Mapping[str, object] | Sequence[object], common: Path | Case | None = None, *, report: Path | None = None,
             figures: bool = True, test_reports: bool = False, jobs: int | None = None, model: str | None = None, false_alarms: float | None = None,
             suspect_limit: float | None = None, set: Mapping[str, object] | None = None, **keywords: object) -> Campaign:  # noqa: A002
    """Many measured tests: one table, categories, figures.

    Parameters
    ----------
    path : path, DataFrame, mapping or sequence
        Tests in memory by their names, ``{"G1": frame, "G2": (stage, force)}``, each a DataFrame, two arrays, a file, a :class:`Case` or a :class:`Fit`, or
        a list of such. A folder of case files; with `common` or keywords, of data files. Or a table with a test a row, a file (CSV) or a pandas.DataFrame:
        titles of a frame or its ``attrs["units"]`` have the units; numbers without one are in SI, whole ones of `first` and `until` rows. Its index names
        the tests, unless a column `name` does.
    common : path or Case, optional
        A case file, or a case, that says what all tests have in common.
    report : path, optional
        A folder for report.html, tables, figures and each test's results; results that are there already are not computed again.
    figures, test_reports : bool
        With `report`: are its figures drawn; has each test a report of its own?
    jobs : int, optional
        Tests computed at the same time; all cores. The answers are the same for any number.
    model, false_alarms, suspect_limit
        As of :func:`fit`.
    set : mapping, optional
        Keys that change in every test, ``{"rig.stiffness": "200 N/m"}``.
    **keywords
        What all tests have in common, as of :class:`Case`: ``specimen={"diameter": "1 mm"}, span="20 mm"``. Columns of a table come first.

    Returns
    -------
    Campaign
        A test that gives no answer is listed under `failures`, with its reason; what was left out or counts once under `notes`.

    Raises
    ------
    InputError
        For a folder without tests, a table with a column that is no key, a common case that cannot be read.
    KeyboardInterrupt
        For Ctrl-C. With `report`, the same call goes on from there.

    Examples
    --------
    >>> import flexslip
    >>> examples = flexslip.campaign("examples")
    >>> sorted(examples.to_frame().index)
    ['cracked', 'cyclic', 'simulated', 'surface']
    """
    if model is not None:
        one_of("model", model, _flexslip.model_names)
    folder = None if report is None else path_of(report, "report", "the name of a folder")

    def computed(table: str, shared: str | None) -> _flexslip.Campaign:
        return _flexslip.campaign(
            os.fsencode(path_of(table, "path", "the name of a folder or of a table")), None if shared is None else os.fsencode(path_of(shared, "common")),
            set_of(set, False), model or "", _flexslip.false_alarms if false_alarms is None else positive("false_alarms", false_alarms),
            _flexslip.suspect_limit if suspect_limit is None else positive("suspect_limit", suspect_limit),
            _flexslip.threads if jobs is None else whole("jobs", jobs, 1, 1024), None if folder is None else os.fsencode(folder), bool(figures),
            bool(test_reports))

    if not is_frame(path) and not _is_path(path):
        if not isinstance(path, (Mapping, list, tuple)):
            raise TypeError(f"path: This must be a folder, a table, a DataFrame or a dict of tests, not {type(path).__name__}; "
                            'pass the tests by name, {"G1": frame, "G2": (stage, force)}')
        with _folder_of_tests(path, _in_common(common, keywords), folder) as (cases, in_words):
            found = computed(cases, None)
            return Campaign(in_words(found.answer()), found, {part: in_words(getattr(found, part)()) for part in ("text", "test_table")})
    with _shared_case(common, keywords, folder) as shared:
        if not is_frame(path):
            found = computed(path_of(cast(Path, path), "path", "the name of a folder or of a table"), shared)
            return Campaign(found.answer(), found)
        with _table_of_tests(path, folder) as (table, in_words):
            try:
                found = computed(table, shared)
            except InputError as error:
                raise in_words_of_frame(error, table) from None
            return Campaign(in_words(found.answer()), found, {part: in_words(getattr(found, part)()) for part in ("text", "test_table")})
