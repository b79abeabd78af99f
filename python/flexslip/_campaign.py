"""Many tests."""
from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from . import _flexslip
from ._answers import ANSWERS, table_of
from ._case import path_of, set_of
from ._errors import InputError, one_of, wrong
from ._fields import CampaignFields
from ._fit import positive
from ._frames import in_words, in_words_of_frame, is_frame, table_of_tests
from ._simulate import whole

if TYPE_CHECKING:
    import pandas

    from ._fields import CategoryRowsTable, SpecimenRowsTable, TestRowsTable



class Campaign(CampaignFields):
    """What many tests show, as :func:`campaign` gives it: every number of ``flexslip campaign --json``.

    Attributes
    ----------
    tests : Table
        A row a test; ``tests.name``, ``tests[0].parameters["mu0"].value``.
    table, category_table, specimen_table : Table
        The columns of tests.csv, categories.csv and specimens.csv.
    """

    _title = "Campaign"

    def __init__(self, data: Mapping[str, Any], campaign: Any = None, kept: Mapping[str, Any] | None = None) -> None:
        super().__init__(data)
        self._campaign = campaign
        self._kept: dict[str, Any] = dict(kept or {})

    def _part(self, name: str) -> Any:
        if name not in self._kept:
            self._kept[name] = getattr(self._campaign, name)()
        return self._kept[name]

    def __reduce__(self) -> tuple[Any, ...]:
        for name in ("test_table", "category_table", "specimen_table", "figures", "text"):
            self._part(name)
        return _campaign_again, (self._data, self._kept)

    @property
    def table(self) -> TestRowsTable:
        table: TestRowsTable = table_of(self._part("test_table"), table_columns("campaign: tests.csv"))
        return table

    @property
    def category_table(self) -> CategoryRowsTable:
        table: CategoryRowsTable = table_of(self._part("category_table"), table_columns("campaign: categories.csv"))
        return table

    @property
    def specimen_table(self) -> SpecimenRowsTable:
        table: SpecimenRowsTable = table_of(self._part("specimen_table"), table_columns("campaign: specimens.csv"))
        return table

    def to_frame(self) -> pandas.DataFrame:
        """A pandas.DataFrame with a row for each test: the columns of tests.csv, in SI."""
        frame = self.table.to_frame()
        return frame.set_index("test")

    def summary(self) -> str:
        """The answer in words, as the program prints it."""
        return str(self._part("text"))

    def plot(self, figure: str | None = None, ax: Any = None) -> Any:
        """The distributions of wavelength and friction, or a page of the atlas of force curves; gives the Axes.

        `figure` is "distributions", or "atlas-clear-1", ...
        """
        from . import _plots

        return _plots.plot(self._part("figures"), figure, ax)

    def __repr__(self) -> str:
        return self.summary().split("\n\n")[0].strip()

    def _repr_html_(self) -> str:
        import html

        return f"<p><b>{html.escape(repr(self))}</b></p>" + str(self.table.to_frame()._repr_html_())


def table_columns(answer: str) -> list[dict[str, Any]]:
    """The columns of a table, those of an estimate one by one."""
    columns: list[dict[str, Any]] = []
    for entry in ANSWERS[answer]["entries"]:
        columns += _split(entry, entry["title"] or entry["name"])
    return columns


def _split(entry: Mapping[str, Any], name: str) -> list[dict[str, Any]]:
    if entry["shape"] == "group":
        return [column for below in entry["entries"] for column in _split(below, f"{name}_{below['title'] or below['name']}")]
    if entry["shape"] != "estimate":
        return [{**entry, "name": name}]
    columns = [{**entry, "name": name + suffix, "shape": "number", "meaning": entry["meaning"] + words, "entries": []}
               for suffix, words in (("", ""), ("_standard_error", ", its standard error"), ("_low", ", lower end of its 95 % interval"),
                                     ("_high", ", upper end of its 95 % interval"))]
    return columns + [column for below in entry["entries"] for column in _split(below, f"{name}_{below['name']}")]


def _campaign_again(data: Mapping[str, Any], kept: Mapping[str, Any]) -> Campaign:
    return Campaign(data, None, kept)


def campaign(path: Any, common: Any = None, *, report: Any = None, figures: bool = True, test_reports: bool = False,
             jobs: int | None = None, share: str | Iterable[str] = (), model: str | None = None, false_alarms: float | None = None,
             suspect_limit: float | None = None, check_stability: bool = False, set: Mapping[str, Any] | None = None) -> Campaign:  # noqa: A002
    """Many measured tests: one table, categories, figures.

    Parameters
    ----------
    path : path or DataFrame
        A folder of case files; with `common`, of data files; or a table with a test a row, a file (CSV) or a pandas.DataFrame, whose titles or
        ``attrs["units"]`` have the units.
    common : path, optional
        A case file that says what all tests have in common.
    report : path, optional
        A folder for report.html, tables, figures and each test's results; results that are there already are not computed again.
    figures, test_reports : bool
        With `report`: are its figures drawn; has each test a report of its own?
    jobs : int, optional
        Tests computed at the same time; all cores. The answers are the same for any number.
    share : str or iterable of str
        Parameters of which all records together tell one value: "modulus", "bending_stiffness", "wavelength", "roughness",
        "correlation_length", "mu0".
    model, false_alarms, suspect_limit, check_stability
        As of :func:`fit`.
    set : mapping, optional
        Keys that change in every test, ``{"rig.stiffness": "200 N/m"}``.

    Returns
    -------
    Campaign
        A test that gives no answer is listed under `failures`, with its reason.

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
    >>> sorted(examples.table.test)
    ['cracked', 'cyclic', 'simulated', 'surface']
    """
    if model is not None:
        one_of("model", model, _flexslip.model_names)
    if not isinstance(share, Iterable):
        raise wrong("share", "names of parameters", share)
    names = [share] if isinstance(share, str) else list(share)
    for name in names:
        one_of("share", name, _flexslip.shareable_names)
    folder = None if report is None else path_of(report, "report", "the name of a folder")

    def computed(table: Any) -> Any:
        return _flexslip.campaign(
            os.fsencode(path_of(table, "path", "the name of a folder or of a table")), None if common is None else os.fsencode(path_of(common, "common")),
            set_of(set, False), model or "", _flexslip.false_alarms if false_alarms is None else positive("false_alarms", false_alarms),
            _flexslip.suspect_limit if suspect_limit is None else positive("suspect_limit", suspect_limit), bool(check_stability), names,
            _flexslip.threads if jobs is None else whole("jobs", jobs, 1, 1024), None if folder is None else os.fsencode(folder), bool(figures),
            bool(test_reports))

    if not is_frame(path):
        found = computed(path)
        return Campaign(found.told(), found)
    with table_of_tests(path, folder) as table:
        try:
            found = computed(table)
        except InputError as error:
            raise in_words_of_frame(error, table) from None
        return Campaign(in_words(found.told(), table), found, {"text": in_words(found.text(), table)})
