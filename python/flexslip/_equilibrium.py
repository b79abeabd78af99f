"""Equilibria of a specimen, whatever the rig."""
from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, cast

import numpy as np
import numpy.typing as npt

from . import _flexslip
from ._answers import Data
from ._case import Case, case_of, in_words_of, quantity_in_words, with_keywords
from ._errors import whole
from ._fields import EquilibriumFields, EquilibriumRegionFields

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

    from ._flexslip import Figure


class _Drawn:
    """What has a figure that is made when it is first asked for."""

    case: Case
    _data: Data
    _study: _flexslip.EquilibriumStudy | None
    _kept: dict[str, object]

    def _keep(self, case: Case, study: _flexslip.EquilibriumStudy | None, kept: Mapping[str, object] | None) -> None:
        self.case, self._study, self._kept = case, study, dict(kept or {})

    def _figures(self) -> list[Figure]:
        if "figures" not in self._kept:
            assert self._study is not None  # or it was pickled with its figures
            self._kept["figures"] = self._study.figures()
        return cast("list[Figure]", self._kept["figures"])

    def __reduce__(self) -> tuple[object, ...]:
        self._figures()
        return type(self), (self._data, self.case, None, self._kept)

    def plot(self, ax: Axes | npt.NDArray[np.object_] | None = None) -> Axes | npt.NDArray[np.object_]:
        """The figure of ``flexslip equilibrium --figure``, drawn with matplotlib; gives the Axes: three of a region."""
        from . import _plots

        return _plots.plot(self._figures(), None, ax)


class Equilibrium(_Drawn, EquilibriumFields):
    """The curve along which a specimen slides in, as :func:`equilibrium` gives it: every number of ``flexslip equilibrium --json``.

    Attributes
    ----------
    curve : Table
        ``curve.length``, ``curve.mu``, ``curve.deflection``, ``curve.force``; of a thick specimen or on rollers ``curve.drawn_in``.
    case : Case
    """

    _title = "Equilibrium"

    def __init__(self, data: Data, case: Case, study: _flexslip.EquilibriumStudy | None = None, kept: Mapping[str, object] | None = None) -> None:
        EquilibriumFields.__init__(self, data, case.reduced)
        self._keep(case, study, kept)

    def to_frame(self) -> pandas.DataFrame:
        """The curve as a pandas.DataFrame."""
        return self.curve.to_frame()

    def __repr__(self) -> str:
        return f"<Equilibrium: {self.status}, {len(self.curve)} points>"


class EquilibriumRegion(_Drawn, EquilibriumRegionFields):
    """All equilibria of a specimen, as :func:`equilibrium_region` gives them: every number of ``flexslip equilibrium --region --json``.

    Attributes
    ----------
    region : Table
        ``region.length``, ``region.q``, ``region.deflection``, ``region.force``; of a thick specimen or on rollers ``region.drawn_in``.
    case : Case
    """

    _title = "EquilibriumRegion"

    def __init__(self, data: Data, case: Case, study: _flexslip.EquilibriumStudy | None = None, kept: Mapping[str, object] | None = None) -> None:
        EquilibriumRegionFields.__init__(self, data, case.reduced)
        self._keep(case, study, kept)

    def to_frame(self) -> pandas.DataFrame:
        """The equilibria as a pandas.DataFrame."""
        return self.region.to_frame()

    def __repr__(self) -> str:
        return f"<EquilibriumRegion: {self.status}, {len(self.region)} points>"


def _longest(value: object, case: Case) -> str:
    return "" if value is None else quantity_in_words("longest", value, "m", "a length", case.reduced)


@with_keywords("specimen", "rig", "friction", "stage")
def equilibrium(file: object = None, *, points: int | None = None, longest: str | float | None = None, set: Mapping[str, object] | None = None,  # noqa: A002
                **keywords: object) -> Equilibrium:
    """The curve of loading: force and deflection where friction is fully mobilised, whatever the rig.

    Parameters
    ----------
    file : path or Case, optional
        A case with a span, a bending stiffness and a friction.
    points : int, optional
        Along the length; as many as the friction needs.
    longest : str or float, optional
        Length between the supports up to which to compute [m]; 1.5 spans.
    set, **keywords
        As of :class:`Case`.

    Raises
    ------
    InputError
        For a case that lacks one of these, or a length that is not beyond the span.

    Examples
    --------
    >>> import flexslip
    >>> found = flexslip.equilibrium("examples/design.toml", points=300)
    >>> found.status, found.curve.force.max() > 1e-3
    ('ok', True)
    """
    case = case_of(file, (), set, keywords)
    count = 0 if points is None else whole("points", points, 2, _flexslip.most_equilibria)
    with in_words_of(case) as given:
        study = _flexslip.equilibrium(given, False, count, 2, _longest(longest, case))
    return Equilibrium(study.answer(), case, study)


@with_keywords("specimen", "rig", "friction", "stage")
def equilibrium_region(file: object = None, *, points: int | None = None, levels: int = 41, longest: str | float | None = None,
                       set: Mapping[str, object] | None = None, **keywords: object) -> EquilibriumRegion:  # noqa: A002
    """All equilibria of a specimen: those with less friction mobilised, too.

    Parameters
    ----------
    file, longest, set, **keywords
        As of :func:`equilibrium`.
    points : int, optional
        Along the length; 100.
    levels : int
        Of mobilised friction, from that of sliding out to that of sliding in.

    Raises
    ------
    InputError
        As of :func:`equilibrium`.

    Examples
    --------
    >>> import flexslip
    >>> found = flexslip.equilibrium_region("examples/design.toml", points=50, levels=11)
    >>> found.region.q.min() < 0 < found.region.q.max()
    True
    """
    case = case_of(file, (), set, keywords)
    count = 0 if points is None else whole("points", points, 2, _flexslip.most_equilibria)
    with in_words_of(case) as given:
        study = _flexslip.equilibrium(given, True, count, whole("levels", levels, 2, _flexslip.most_levels), _longest(longest, case))
    return EquilibriumRegion(study.answer(), case, study)
