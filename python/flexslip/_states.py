"""The elastica, state by state, over arrays."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple, TypeVar, cast

import numpy as np
import numpy.typing as npt

from . import _flexslip
from ._errors import wrong

Numbers = npt.NDArray[np.float64]
ArrayLike = npt.ArrayLike
Out = Sequence[Numbers | None] | None
Answer = TypeVar("Answer", bound=tuple[Numbers, ...])
_MOST = float(_flexslip.largest_q)


class States(NamedTuple):
    """Deflections [span] and forces [EI/span²] at midspan; NaN where there is no state."""

    w: Numbers
    F: Numbers


class Slopes(NamedTuple):
    """States with their partial derivatives: to S at fixed q, and to q at fixed S. NaN also at S = 1, where those to S are infinite."""

    w: Numbers
    F: Numbers
    w_S: Numbers
    w_q: Numbers
    F_S: Numbers
    F_q: Numbers


class Details(NamedTuple):
    """Slope at the support [rad], normal force at one support, bending energy, curvature at midspan, in reduced variables."""

    theta0: Numbers
    Pn: Numbers
    U: Numbers
    curvature: Numbers


class Inverse(NamedTuple):
    """Lengths between the supports [span] and mobilised friction; NaN where no friction explains deflection and force."""

    S: Numbers
    q: Numbers


def numbers(name: str, values: ArrayLike) -> Numbers:
    """An array as it is, or what becomes one, of numbers without an imaginary part."""
    if isinstance(values, np.ndarray) or hasattr(values, "__array_ufunc__"):
        array, given = np.asarray(values), cast(Numbers, values)
    else:
        try:
            given = array = np.asarray(values)
        except ValueError:
            raise wrong(name, "an array of numbers", "rows of different lengths") from None
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{name}: These must be real numbers, not {array.dtype.name} {_first(array)}".rstrip() + ".")
    return given.astype(np.float64) if array.dtype.kind == "f" and array.dtype.itemsize > 8 else given


def _first(array: npt.NDArray[np.generic]) -> str:
    return repr(array.flat[0]) if array.size else ""


def require(name: str, array: Numbers, low: float, high: float, expected: str) -> None:
    """Refuses what is outside of [low, high], and names it; NaN is let through."""
    numbers = np.asarray(array)
    if numbers.size == 0 or (numbers.min() >= low and numbers.max() <= high):
        return
    is_outside = (numbers < low) | (numbers > high)
    if not is_outside.any():
        return
    at = np.unravel_index(int(np.argmax(is_outside)), numbers.shape)
    place = f"{name}[{', '.join(str(int(i)) for i in at)}]" if numbers.ndim else name
    raise wrong(place, expected, repr(numbers[at].item()))


_MA: Any = np.ma  # whose functions have no types
GREATEST = float(np.finfo(float).max)


def seen(values: Numbers) -> Numbers:
    """What of an array is not masked."""
    visible: Numbers = _MA.compressed(values) if _MA.isMaskedArray(values) else values
    return visible


def computed(function: np.ufunc, kind: type[Answer], inputs: tuple[Numbers, ...], out: Out, valid: tuple[float, ...]) -> Answer:
    """What a universal function gives; of masked arrays, masked where one of them is. `valid` are numbers to compute with there."""
    if any(isinstance(each, np.ma.MaskedArray) for each in inputs):
        if out is not None:
            raise wrong("out", "arrays without a mask beside it", "masked arrays")
        values = _with_nan(function, tuple(_MA.filled(each, number) for each, number in zip(inputs, valid)), None, valid)
        mask = np.zeros(np.shape(values[0]), dtype=bool)
        for each in inputs:
            mask = mask | _MA.getmaskarray(each)
        return kind(*(_MA.MaskedArray(value, mask) for value in values))
    return kind(*_with_nan(function, inputs, None if out is None else _outputs(out, function.nout), valid))


def _with_nan(function: np.ufunc, inputs: tuple[Numbers, ...], out: Out, valid: tuple[float, ...]) -> tuple[Numbers, ...]:
    """NaN where an input is NaN. The function computes with valid numbers there, because it takes several states at a time."""
    if not any(np.isnan(each).any() for each in map(np.asarray, inputs)):
        states: tuple[Numbers, ...] = function(*inputs, out=out) if out else function(*inputs)
        return states
    zero_or_nan = sum(np.multiply(0.0, each) for each in inputs)
    values = function(*(np.nan_to_num(each, nan=number) for each, number in zip(inputs, valid)), out=out or (None,) * function.nout)
    return tuple(np.add(value, zero_or_nan, out=given) for value, given in zip(values, out or (None,) * function.nout))


def _outputs(out: object, count: int) -> tuple[Numbers | None, ...]:
    if not isinstance(out, tuple) or len(out) != count:
        raise wrong("out", f"a tuple of {count} arrays, one for each answer, or None in its place", type(out).__name__)
    return out


def require_friction(q: Numbers) -> None:
    """Refuses mobilised friction that is not computed with."""
    require("q", seen(q), -_MOST, _MOST, f"a mobilised friction from {-_MOST:g} to {_MOST:g}")


def _in_domain(S: ArrayLike, q: ArrayLike) -> tuple[Numbers, Numbers]:
    lengths, friction = numbers("S", S), numbers("q", q)
    require("S", seen(lengths), 1, GREATEST, "a length of at least 1 span, finite")
    require_friction(friction)
    return lengths, friction


def elastica(S: ArrayLike, q: ArrayLike, *, out: Out = None) -> States:
    """Deflection and force of a fibre of length S between two edges, with mobilised friction q.

    The arguments broadcast against each other; the types, strides and subclasses of NumPy are what they are for its own functions.

    Parameters
    ----------
    S : array_like
        Arc length between the supports, in spans, at least 1.
    q : array_like
        Mobilised friction, tangential over normal support force, from -20 to 20.
    out : tuple of two arrays, optional
        Where to write w and F.

    Returns
    -------
    States
        ``w`` [span] and ``F`` [EI/span²], NaN where there is no state: the force has fallen to zero before.

    Raises
    ------
    InputError
        For a value outside of the domain, which is named with its index. NaN gives NaN.
    TypeError
        For what is no real number.

    Notes
    -----
    Max error 3e-15 in w, 8e-15 in F times its condition number (docs/numerics.md); about 35 ns a state. Equations (4.9) to (4.15) of Fang,
    Kochiyama and Kesari (2021); docs/theory.md, "The state".

    Examples
    --------
    >>> import flexslip
    >>> w, F = flexslip.elastica([1.0, 1.2, 1.5], 0.3)
    >>> w.round(4), F.round(4)
    (array([0.    , 0.2995, 0.497 ]), array([0.    , 7.9947, 5.4837]))
    >>> flexslip.elastica([[1.1], [1.2]], [0.0, 0.2, 0.4]).w.shape
    (2, 3)
    """
    return computed(_flexslip.states, States, _in_domain(S, q), out, (1, 0))


def elastica_slopes(S: ArrayLike, q: ArrayLike, *, out: Out = None) -> Slopes:
    """The same as :func:`elastica` with exact partial derivatives.

    Examples
    --------
    >>> import flexslip
    >>> flexslip.elastica_slopes(1.2, 0.3).w_S > 0
    True
    """
    return computed(_flexslip.states_slopes, Slopes, _in_domain(S, q), out, (1, 0))


def elastica_details(S: ArrayLike, q: ArrayLike, *, out: Out = None) -> Details:
    """Slope at the support, normal force, bending energy and curvature at midspan of states as of :func:`elastica`.

    Examples
    --------
    >>> import flexslip
    >>> float(flexslip.elastica_details(1.0, 0.3).theta0)
    0.0
    """
    return computed(_flexslip.states_more, Details, _in_domain(S, q), out, (1, 0))


def elastica_inverse(w: ArrayLike, F: ArrayLike, *, out: Out = None) -> Inverse:
    """Length and mobilised friction of states with deflection w and force F: the inverse of :func:`elastica`.

    Parameters
    ----------
    w, F : array_like
        Deflection [span] and force [EI/span²] at midspan, at least 0.
    out : tuple of two arrays, optional
        Where to write S and q.

    Returns
    -------
    Inverse
        ``S`` [span] and ``q``, NaN where no friction from -20 to 20 explains deflection and force.

    Raises
    ------
    InputError, TypeError
        As :func:`elastica`.

    Examples
    --------
    >>> import flexslip
    >>> S, q = flexslip.elastica_inverse(*flexslip.elastica(1.2, 0.3))
    >>> round(float(S), 12), round(float(q), 12)
    (1.2, 0.3)
    """
    given = numbers("w", w), numbers("F", F)
    for name, values in zip("wF", given):
        require(name, seen(values), 0, GREATEST, "a finite number of at least 0")
    return computed(_flexslip.states_from_forces, Inverse, given, out, (0, 0))
