"""Thousands of planned tests."""
from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from . import _flexslip
from ._answers import Quantity
from ._case import _in_quotes, case_of, in_words_of, quantity_in_words, unit_of_parameter, with_keywords
from ._errors import one_of, whole, wrong

if TYPE_CHECKING:
    import pandas


def _value(name: str, value: object, reduced: bool) -> str:
    if isinstance(value, str):
        return _in_quotes(value)
    unit = "" if reduced else unit_of_parameter(name)
    text = quantity_in_words(f"axes[{name!r}]", value, unit, "a number", reduced)
    return _in_quotes(text) if unit or isinstance(value, Quantity) else text


_RANGE = "a list of values, or a range: (from, to, points), and \"log\" after it for even ratios"


def _axis(name: str, given: object, sampled: bool, reduced: bool) -> str:
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
            text = str(whole(f"axes[{name!r}] points", value, 2, 10**12))
        elif key == "spacing":
            one_of(f"axes[{name!r}] spacing", value, ("linear", "log"))
            text = _in_quotes(value)
        elif key in ("from", "to"):
            text = _value(name, value, reduced)
        else:
            raise wrong(f"axes[{name!r}]", "from, to, points and spacing", key)
        parts.append(f"{key} = {text}")
    return "{ " + ", ".join(parts) + " }"


def _changes(axes: object, samples: object, seed: object, reduced: bool) -> list[str]:
    changes = []
    if samples is not None:
        changes += ['sweep.method="latin hypercube"', f"sweep.samples={whole('samples', samples, 1, 10**12)}"]
        changes.append(f"sweep.seed={whole('seed', 1 if seed is None else seed, 0, 2**63 - 1)}")
    elif seed is not None:
        raise wrong("seed", "left out of a grid, which is not drawn", seed)
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


@with_keywords("specimen", "rig", "friction", "stage")
def sweep(file: object = None, *, axes: Mapping[str, object] | None = None, samples: int | None = None, seed: int | None = None, threads: int | None = None,
          set: Mapping[str, object] | None = None, **keywords: object) -> pandas.DataFrame:  # noqa: A002
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
    threads : int, optional
        Designs computed at the same time; all cores. The answers are the same for any number.
    set, **keywords
        As of :class:`Case`.

    Returns
    -------
    pandas.DataFrame
        A row a design, with the columns of ``flexslip sweep``: the inputs, `status`, and the outcomes, NaN where there are none. `attrs["units"]` has the
        units.

    Raises
    ------
    InputError
        For a case or an axis that is wrong.

    Examples
    --------
    >>> import flexslip
    >>> designs = flexslip.sweep("examples/design.toml", axes={"stiffness": ("10 N/m", "1 kN/m", 5, "log"), "mu0": [0.3, 0.5]})
    >>> len(designs), sorted(set(designs.mu0)), designs.attrs["units"]["stiffness"]
    (10, [0.3, 0.5], 'N/m')
    """
    import pandas

    case = case_of(file, (), set, keywords)
    changes = [*case._changes, *_changes(axes, samples, seed, case.reduced)]
    count = _flexslip.threads if threads is None else whole("threads", threads, 1, 1024)
    with in_words_of(case):
        found = _flexslip.sweep(case._text, os.fsencode(case._source), changes, count)
    frame = pandas.DataFrame(found["columns"])
    frame.attrs["units"] = found["units"]
    return frame
