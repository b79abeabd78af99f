"""Tests computed forward, and friction read off a record without a fit."""
from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, cast

from . import _flexslip
from ._answers import Data
from ._case import Case, case_of, in_words_of, quantity_in_words, with_keywords
from ._errors import advice, whole
from ._fields import ProfileFields, SimulationFields

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

    from ._flexslip import Figure


class Simulation(SimulationFields):
    """What a test would measure, as :func:`simulate` gives it: every number of ``flexslip simulate --json``.

    Attributes
    ----------
    path : Table
        Point by point: ``path.stage``, ``path.deflection``, ``path.force``, ``path.motion``, ... as NumPy arrays.
    success : bool
        Does the path go to the end of its programme? If not, `message` says why.
    remarks : tuple of str
        What there is to say besides.
    case : Case
    """

    _title = "Simulation"

    def __init__(self, data: Data, case: Case, test: _flexslip.SimulatedTest | None = None, kept: Mapping[str, object] | None = None) -> None:
        super().__init__(data, case.reduced)
        self.case = case
        self._test = test
        self._kept: dict[str, object] = dict(kept or {})
        if test is not None:
            self._kept |= {"remarks": tuple(map(advice, test.remarks)), "message": advice(test.why_it_ends)}

    def __reduce__(self) -> tuple[object, ...]:
        self._figures()
        return _simulation_again, (self._data, self.case, self._kept)

    def _figures(self) -> list[Figure]:
        if "figures" not in self._kept:
            assert self._test is not None  # or it was pickled with its figures
            self._kept["figures"] = self._test.figures()
        return cast("list[Figure]", self._kept["figures"])

    @property
    def success(self) -> bool:
        """Does the path go to the end of its programme? If not, `message` says why."""
        return not self._kept["message"]

    @property
    def message(self) -> str:
        """Why the path ends before its programme does; empty if it goes to the end."""
        return str(self._kept["message"])

    @property
    def remarks(self) -> tuple[str, ...]:
        """What there is to say besides."""
        return cast(tuple[str, ...], self._kept["remarks"])

    def to_frame(self) -> pandas.DataFrame:
        """The path as a pandas.DataFrame."""
        return self.path.to_frame()

    def plot(self, ax: Axes | None = None) -> Axes:
        """Force against deflection, snaps dashed, as ``flexslip simulate --figure``; gives the Axes."""
        from . import _plots

        return _plots.plot(self._figures(), None, ax)

    def __repr__(self) -> str:
        end = "" if self.success else f"; {self.message}"
        return f"<Simulation: {self.status}, {len(self.path)} points, {len(self.snaps)} snaps{end}>"


def _simulation_again(data: Data, case: Case, kept: Mapping[str, object]) -> Simulation:
    return Simulation(data, case, None, kept)


class Profile(ProfileFields):
    """Friction read off a record point by point, as :func:`friction_profile` gives it: every number of ``flexslip invert --json``.

    Attributes
    ----------
    success : bool
        Does a reading tell a friction? If not, `message` says why.
    remarks : tuple of str
        What was assumed, and left out.
    case : Case
    """

    _title = "Profile"

    def __init__(self, data: Data, case: Case, remarks: tuple[str, ...], message: str) -> None:
        super().__init__(data, case.reduced)
        self.case, self.remarks, self.message = case, remarks, message

    def __reduce__(self) -> tuple[object, ...]:
        return Profile, (self._data, self.case, self.remarks, self.message)

    @property
    def success(self) -> bool:
        """Does a reading tell a friction? If not, `message` says why."""
        return not self.message

    def to_frame(self) -> pandas.DataFrame:
        """Point by point, as a pandas.DataFrame."""
        return self.profile.to_frame()

    def __repr__(self) -> str:
        return f"<Profile: {self.status}, {len(self.profile)} points>"


@with_keywords("specimen", "rig", "friction", "stage")
def simulate(file: object = None, *, points: int = 200, noise: str | float | None = None, seed: int = 1, energies: bool = False,
             set: Mapping[str, object] | None = None, **keywords: object) -> Simulation:  # noqa: A002
    """What a specimen on a rig would show, loaded, unloaded and cycled.

    Parameters
    ----------
    file : path or Case, optional
        A case file, or a :class:`Case`; or keywords alone.
    points : int
        Points on each stretch of sticking or sliding, if the stage moves continuously.
    noise : quantity, optional
        Standard deviation of the force readings, ``"10 uN"`` or in N.
    seed : int
        Of the noise: the same seed gives the same readings.
    energies : bool
        Has the path the energies up to each point?
    set, **keywords
        As of :class:`Case`.

    Raises
    ------
    InputError
        For a case that is wrong, with file, line and remedy.

    Examples
    --------
    >>> import flexslip
    >>> test = flexslip.simulate(diameter="34.8 um", modulus="29.6 GPa", span="1278 um", stiffness="90.65 N/m",
    ...                          friction=dict(model="sinusoid", mu0=0.5, amplitude=0.15, wavelength="10.9 um"),
    ...                          stage=dict(program=[0, 900e-6]))
    >>> test.success, len(test.snaps) > 10, test.path.force.max() > 1e-3
    (True, True, True)
    """
    case = case_of(file, (), set, keywords)
    number = whole("points", points, 2, 1_000_000)
    whole("seed", seed, 0, 2**64 - 1)
    text = "" if noise is None else quantity_in_words("noise", noise, "N", "a force", case.reduced)
    with in_words_of(case) as given:
        test = _flexslip.simulate(given, number, text, int(seed))
    return Simulation(test.answer(bool(energies)), case, test)


@with_keywords("specimen", "rig", "record")
def friction_profile(file: object = None, *arrays: object, set: Mapping[str, object] | None = None, **keywords: object) -> Profile:  # noqa: A002
    """Friction along the specimen, read off a record point by point at the bending stiffness stated, without a fit.

    Parameters
    ----------
    file : path, Case, DataFrame or array
        A case file, the data of a test, which the keywords describe, or a :class:`Case`. Data may be a file, a pandas.DataFrame, or two arrays,
        ``(stage, force)``, in SI.
    set, **keywords
        As of :class:`Case`.

    Raises
    ------
    InputError
        For a case or a record that is wrong, with file, line and remedy.

    Examples
    --------
    >>> import flexslip
    >>> read = flexslip.friction_profile("examples/simulated/case.toml")
    >>> 0.4 < read.profile.mu.mean() < 0.6
    True
    """
    case = case_of(file, arrays, set, keywords)
    with in_words_of(case) as given:
        answer = _flexslip.friction_profile(given)
    return Profile(answer["answer"], case, tuple(map(advice, answer["remarks"])), advice(answer["why_no_answer"]))
