"""Thousands of planned tests, in a file."""
from __future__ import annotations

import os
import tempfile
import threading
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _flexslip
from ._answers import Quantity, Table, table_of
from ._case import _in_quotes, case_of, in_words_of, path_of, quantity_in_words, unit_of_parameter, with_keywords
from ._errors import one_of, wrong, yes_no
from ._fields import SweepFields
from ._simulate import whole

if TYPE_CHECKING:
    import pandas


class Sweep(SweepFields):
    """What thousands of planned tests show, as :func:`sweep` gives it: every number of ``flexslip sweep --json``, and the designs.

    Attributes
    ----------
    designs : Table
        A row a design: the inputs and the outcomes, ``designs.stiffness``, ``designs.snaps``, as NumPy arrays, read from the file when they are first asked
        for; `status` is a word.
    """

    _title = "Sweep"

    def __init__(self, data: Mapping[str, Any], reduced: bool, found: Any = None, kept: Mapping[str, Any] | None = None) -> None:
        super().__init__(data, reduced)
        self._found, self._kept = found, dict(kept or {})

    def _read(self) -> dict[str, Any]:
        if not self._kept:
            self._kept |= self._found.designs()
        return self._kept

    def __reduce__(self) -> tuple[Any, ...]:
        return Sweep, (self._data, self._reduced, None, self._read())

    @property
    def designs(self) -> Table[Any]:
        """A row a design: the inputs and the outcomes, as NumPy arrays; `status` is a word."""
        kept = self._read()
        table: Table[Any] = table_of(kept["table"], kept["entries"], self._reduced)
        return table

    def to_frame(self) -> pandas.DataFrame:
        """The designs as a pandas.DataFrame."""
        return self.designs.to_frame()

    def __repr__(self) -> str:
        return f"<Sweep of {self.rows} designs{': ' + self.file if self.file else ''}>"


def _value(name: str, value: Any, reduced: bool) -> str:
    if isinstance(value, str):
        return _in_quotes(value)
    unit = "" if reduced else unit_of_parameter(name)
    text = quantity_in_words(f"axes[{name!r}]", value, unit, "a number", reduced)
    return _in_quotes(text) if unit or isinstance(value, Quantity) else text


_RANGE = "a list of values, or a range: (from, to, points), and \"log\" after it for even ratios"


def _axis(name: str, given: Any, sampled: bool, reduced: bool) -> str:
    """An axis as a case file has it."""
    if hasattr(given, "__array__") or isinstance(given, range):
        given = np.asarray(given)
        if given.ndim != 1:
            raise wrong(f"axes[{name!r}]", _RANGE, f"an array of the shape {given.shape}")
        given = given.tolist()
    if isinstance(given, list):
        return "[" + ", ".join(_value(name, value, reduced) for value in given) + "]"
    if isinstance(given, tuple):
        names = ("from", "to", "spacing") if sampled else ("from", "to", "points", "spacing")
        if not 2 <= len(given) <= len(names):
            raise wrong(f"axes[{name!r}]", "(from, to) in a Latin hypercube, and \"log\" after it for even ratios" if sampled else _RANGE, given)
        given = dict(zip(names, given))
    if not isinstance(given, Mapping):
        raise wrong(f"axes[{name!r}]", _RANGE, given)
    parts = []
    for key, value in given.items():
        if key == "points":
            text = str(whole(f"axes[{name!r}] points", value, 2, 10**6))
        elif key == "spacing":
            one_of(f"axes[{name!r}] spacing", value, ("linear", "log"))
            text = _in_quotes(value)
        elif key in ("from", "to"):
            text = _value(name, value, reduced)
        else:
            raise wrong(f"axes[{name!r}]", "from, to, points and spacing", key)
        parts.append(f"{key} = {text}")
    return "{ " + ", ".join(parts) + " }"


def _changes(axes: Any, samples: Any, seed: Any, reduced: bool) -> list[str]:
    changes = []
    if samples is not None:
        changes += ['sweep.method="latin hypercube"', f"sweep.samples={whole('samples', samples, 1, 10**12)}"]
        changes.append(f"sweep.seed={whole('seed', 1 if seed is None else seed, 0, 2**63 - 1)}")
    elif seed is not None:
        raise wrong("seed", "samples beside it: a grid is not drawn", seed)
    if axes is None:
        return changes
    if not isinstance(axes, Mapping) or not axes:
        raise wrong("axes", "a dict of the numbers that vary, {\"mu0\": [0.3, 0.5]}", axes)
    if samples is None:
        changes.append('sweep.method="grid"')
    for name, given in axes.items():
        if not isinstance(name, str) or not name.replace("_", "").isalnum():
            raise wrong("axes", "names of numbers that vary", name)
        changes.append(f"sweep.axes.{name}={_axis(name, given, samples is not None, reduced)}")
    return changes


_ONE_AT_A_TIME: dict[str, threading.Lock] = {}  # calls of this process that write one file: the second finds what the first has done


@with_keywords("specimen", "rig", "friction", "stage")
def sweep(file: Any = None, *, axes: Mapping[str, Any] | None = None, samples: int | None = None, seed: int | None = None, output: Any = None,
          threads: int | None = None, keep_parts: bool = False, set: Mapping[str, Any] | None = None, **keywords: Any) -> Sweep:  # noqa: A002
    """Thousands of designs of a test: a grid or a sample of them.

    Parameters
    ----------
    file : path or Case, optional
        A case as for :func:`design`, with a section ``[sweep]``, or with `axes`.
    axes : mapping, optional
        The numbers of the case that vary: a list of values, or a range ``(from, to, points)``, ``(from, to, points, "log")``. With `samples`, ranges without
        points.
    samples, seed : int, optional
        A Latin hypercube of so many designs, instead of a grid; the seed of its draw.
    output : path, optional
        The HDF5 file to write, as ``flexslip sweep`` does. Where it is there already, it is read; where parts of it are, the call goes on from them.
        Without it, the designs are in memory alone.
    threads : int, optional
        Designs computed at the same time; all cores. The answers are the same for any number.
    keep_parts : bool
        Leave the parts where they are once they are joined in `output`.
    set, **keywords
        As of :class:`Case`.

    Raises
    ------
    InputError
        For a case or an axis that is wrong; for an output that is another file.
    KeyboardInterrupt
        For Ctrl-C. With `output`, the same call goes on from there.

    Examples
    --------
    >>> import flexslip
    >>> found = flexslip.sweep("examples/design.toml", axes={"stiffness": ("10 N/m", "1 kN/m", 5, "log"), "mu0": [0.3, 0.5]})
    >>> len(found.designs), sorted(set(found.designs.mu0))
    (10, [0.3, 0.5])
    """
    case = case_of(file, (), set, keywords)
    changes = [*case._changes, *_changes(axes, samples, seed, case.reduced)]
    count = _flexslip.threads if threads is None else whole("threads", threads, 1, 1024)
    keep_parts = yes_no("keep_parts", keep_parts)
    if output is not None:
        path = path_of(output, "output")
        with _ONE_AT_A_TIME.setdefault(os.path.realpath(path), threading.Lock()):
            return _swept(case, changes, path, count, keep_parts)
    with tempfile.TemporaryDirectory() as folder:
        found = _swept(case, changes, os.path.join(folder, "sweep.h5"), count, False)
        found._read()
    return Sweep({**found._data, "file": None}, case.reduced, None, found._kept)


def _swept(case: Any, changes: list[str], path: str, threads: int, keep_parts: bool) -> Sweep:
    with in_words_of(case):
        found = _flexslip.sweep(case._text, os.fsencode(case._source), changes, os.fsencode(path), threads, keep_parts)
    return Sweep(found.told(), case.reduced, found)
