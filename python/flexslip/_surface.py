"""Height profiles of surfaces."""
from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _flexslip
from ._answers import ANSWERS, table_of
from ._case import encodable, quantity_in_words
from ._errors import path_of, whole, wrong
from ._fields import SurfaceFields

if TYPE_CHECKING:
    import pandas

    from ._fields import SpectrumRowsTable, TraceRowsTable


class Surface(SurfaceFields):
    """What a height profile says of its surface, as :func:`surface` gives it: every number of ``flexslip surface --json``.

    Attributes
    ----------
    profile : Table
        ``profile.position``, ``profile.height``, ``profile.edge``, ``profile.slope``, ``profile.mu``: the heights, levelled, and what an edge sees of them.
    spectrum : Table
        ``spectrum.wavelength``, ``spectrum.density``: its power spectral density.
    success : bool
        Is a surface seen in the noise? If not, `message` says so.
    """

    _title = "Surface"

    def __init__(self, data: Mapping[str, Any], study: Any = None, kept: Mapping[str, Any] | None = None) -> None:
        super().__init__(data)
        self._study, self._kept = study, dict(kept or {})

    def _part(self, name: str) -> Any:
        if name not in self._kept:
            self._kept[name] = getattr(self._study, name)()
        return self._kept[name]

    def __reduce__(self) -> tuple[Any, ...]:
        for name in ("trace_table", "spectrum_table", "figures", "text", "in_short"):
            self._part(name)
        return Surface, (self._data, None, self._kept)

    @property
    def profile(self) -> TraceRowsTable:
        """The heights, levelled, and what an edge sees of them."""
        table: TraceRowsTable = table_of(self._part("trace_table"), ANSWERS["surface --profile"]["entries"])
        return table

    @property
    def spectrum(self) -> SpectrumRowsTable:
        """The power spectral density of the heights."""
        table: SpectrumRowsTable = table_of(self._part("spectrum_table"), ANSWERS["surface --spectrum"]["entries"])
        return table

    @property
    def success(self) -> bool:
        """Is a surface seen in the noise? If not, `message` says so."""
        return bool(self._data["status"] == "ok")

    @property
    def message(self) -> str:
        """Why no surface is seen; empty if one is."""
        return "" if self.success else str(self._part("in_short"))

    def summary(self) -> str:
        """The answer in words, as the program prints it."""
        return str(self._part("text"))

    def to_frame(self) -> pandas.DataFrame:
        """The heights, and what an edge sees of them, as a pandas.DataFrame."""
        return self.profile.to_frame()

    def plot(self, ax: Any = None) -> Any:
        """The figure of ``flexslip surface --figure``, drawn with matplotlib: heights, friction where one is predicted, spectrum; gives the Axes."""
        from . import _plots

        return _plots.plot(self._part("figures"), None, ax)


_LENGTHS = ("cutoff", "edge_radius", "pixel", "amplitude", "shortest", "longest", "noise", "step")
_TEXTS = ("position_unit", "height_unit", "encoding", "separator", "decimal", "thousands")


def surface(file: Any, *, level: int = 1, cutoff: Any = None, edge_radius: Any = None, friction: Any = None, wavelength: Any = None,
            amplitude: Any = None, pixel: Any = None, noise: Any = None, shortest: Any = None, longest: Any = None, tapers: int | None = None,
            position: str | int | None = None, height: str | int | None = None, position_unit: str | None = None, height_unit: str | None = None,
            step: Any = None, sheet: str | int | None = None, encoding: str | None = None, separator: str | None = None, decimal: str | None = None,
            thousands: str | None = None) -> Surface:
    """What a height profile says of its surface: slope, waves, what it resolves, the friction it predicts.

    Parameters
    ----------
    file : path
        Height profile of a microscope, a profilometer, or an edge in an image.
    level : int
        Degree of the polynomial to take off: 0 the mean, 1 the tilt, 2 the bow; up to 9.
    cutoff : str or float, optional
        Take shorter waves out, by the Gaussian filter of ISO 16610-21 [m].
    edge_radius : str or float, optional
        Radius of the support's edge that is drawn over the surface [m].
    friction : float, optional
        Predict the friction, from this one of the flat surface.
    wavelength : str, float, or sequence of them, optional
        Can the trace show waves of this length [m]? Of those it shows.
    amplitude : str or float, optional
        Of this height, half of crest to trough [m]?
    pixel, noise : str or float, optional
        Least difference of heights that is told, standard deviation of a height [m]; found, unless they are given.
    shortest, longest : str or float, optional
        Wavelengths between which height and slope are told [m].
    tapers : int, optional
        Of the spectrum, 2 to 30: more are smoother and coarser.
    position, height : str or int, optional
        Name or number of a column, if it is not found.
    position_unit, height_unit : str, optional
        Units, where the file states none.
    step : str or float, optional
        Distance of the heights, of a file without positions [m].
    sheet, encoding, separator, decimal, thousands
        As of :func:`read`.

    Returns
    -------
    Surface
        Where noise hides the surface at all wavelengths, its `success` is False.

    Raises
    ------
    InputError
        For a file without heights, columns that cannot be told apart, or what the trace does not allow; a FileNotFoundError as well if it is not there.

    Examples
    --------
    >>> import flexslip
    >>> seen = flexslip.surface("examples/surface/trace.csv", friction=0.58, edge_radius="1 um")
    >>> seen.rms_slope.value > 0, seen.profile.mu.shape == seen.profile.height.shape
    (True, True)
    """
    given = dict(locals())
    words: dict[str, Any] = {"level": whole("level", level, 0, _flexslip.most_degree)}
    if tapers is not None:
        words["tapers"] = whole("tapers", tapers, _flexslip.least_tapers, _flexslip.most_tapers)
    for name in _LENGTHS:
        if given[name] is not None:
            words[name] = quantity_in_words(name, given[name], "m", "a length")
    if friction is not None:
        words["friction"] = quantity_in_words("friction", friction, "", "a number")
    if wavelength is not None:
        several = list(wavelength) if isinstance(wavelength, (tuple, list, np.ndarray)) and np.ndim(wavelength) else [wavelength]
        words["wavelength"] = [quantity_in_words("wavelength", each, "m", "a length") for each in several]
    if isinstance(sheet, (int, np.integer)) and not isinstance(sheet, bool):
        words["sheet_number"] = whole("sheet", sheet, 1, 2**31)
    elif sheet is not None:
        words["sheet"] = _text("sheet", sheet)
    for name in ("position", "height"):
        value = given[name]
        if value is not None:
            words[name] = str(whole(name, value, 1, 2**31)) if isinstance(value, (int, np.integer)) and not isinstance(value, bool) else _text(name, value)
    for name in _TEXTS:
        if given[name] is not None:
            words[name] = _text(name, given[name])
    if position is not None and step is not None:
        raise wrong("step", "either a column of positions or their distance", "both")
    study = _flexslip.surface(os.fsencode(path_of(file)), words)
    return Surface(study.told(), study)


def _text(name: str, value: Any) -> str:
    if not isinstance(value, str):
        raise wrong(name, "text", value)
    return encodable(name, value)
