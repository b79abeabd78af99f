"""The elastica on rollers, and of a thick specimen, state by state, over arrays."""
from __future__ import annotations

from typing import NamedTuple

import numpy as np

from . import _flexslip
from ._states import GREATEST, ArrayLike, Inverse, Numbers, Out, computed, numbers, require, require_friction, seen

_DEEPEST = float(_flexslip.deepest_on_supports)
_WIDEST_SAID = float(_flexslip.widest_supports)
_WIDEST = float(np.nextafter(_WIDEST_SAID, 0))
_THICKEST = float(_flexslip.thickest)
_LEAST = 5e-324  # above 0


class RollerStates(NamedTuple):
    """Mobilised friction, force, slope at the contacts [rad], normal force at one support, bending energy, curvature at midspan; the lengths of the axis
    between the contacts, of what has slid past them along the surface, and of the axis between the verticals through the supports, as a camera sees it. In
    reduced variables; NaN where there is no state."""

    q: Numbers
    F: Numbers
    theta0: Numbers
    Pn: Numbers
    U: Numbers
    curvature: Numbers
    length: Numbers
    slid: Numbers
    imaged: Numbers


def _supports(roller_radius: ArrayLike, thickness: ArrayLike) -> tuple[Numbers, Numbers]:
    radius, thick = numbers("roller_radius", roller_radius), numbers("thickness", thickness)
    require("roller_radius", seen(radius), 0, GREATEST, "a finite number of at least 0, in spans")
    require("thickness", seen(thick), 0, float(np.nextafter(_THICKEST, 0)), f"0 or more, and less than {_THICKEST:g} spans, for beam theory")
    with np.errstate(over="ignore"):
        together = np.add(radius, np.multiply(0.5, thick))
    require("roller_radius", seen(together), 0, _WIDEST, f"a radius, and half of a thickness, of less than {_WIDEST_SAID:g} spans together")
    return radius, thick


def _require_deflection(w: Numbers) -> None:
    require("w", seen(w), _LEAST, _DEEPEST, f"a deflection above 0 and up to {_DEEPEST:g} spans")


def elastica_on_rollers(w: ArrayLike, q: ArrayLike, *, roller_radius: ArrayLike = 0.0, thickness: ArrayLike = 0.0, out: Out = None) -> RollerStates:
    """States on fixed rollers, of a specimen with a thickness at whose surface friction acts, bent by w with mobilised friction q.

    All arguments broadcast against each other, as those of :func:`elastica`. States are told apart by their deflection: with a thickness, two of them may
    have one length.

    Parameters
    ----------
    w : array_like
        Deflection at midspan, in spans, above 0 and up to 2.
    q : array_like
        Mobilised friction, from -20 to 20.
    roller_radius, thickness : array_like
        Radius of the rollers and thickness of the specimen, in spans; the former and half of the latter are less than 0.45 together, and the latter is less
        than 0.2, for beam theory.
    out : tuple of nine arrays, optional
        Where to write the answers.

    Returns
    -------
    RollerStates
        NaN where there is no state, none with a force, or none was found.

    Raises
    ------
    InputError
        For a value outside of the domain, which is named with its index. NaN gives NaN.
    TypeError
        For what is no real number.

    Notes
    -----
    Max error 1e-11 for w up to 0.35 and q from -0.8 to 1.5; about 1 µs a state. docs/theory.md, "Rollers and thickness".

    Examples
    --------
    >>> import flexslip
    >>> states = flexslip.elastica_on_rollers([0.05, 0.1], 0.3, roller_radius=0.078, thickness=0.0625)
    >>> states.F.round(4)
    array([2.5395, 5.2452])
    >>> edges = flexslip.elastica(1.2, 0.3)
    >>> abs(flexslip.elastica_on_rollers(edges.w, 0.3).F - edges.F) < 1e-10
    True
    """
    deflection, friction = numbers("w", w), numbers("q", q)
    _require_deflection(deflection)
    require_friction(friction)
    return computed(_flexslip.states_on_rollers, RollerStates, (deflection, friction, *_supports(roller_radius, thickness)), out, (0.1, 0, 0, 0))


def elastica_on_rollers_inverse(w: ArrayLike, F: ArrayLike, *, roller_radius: ArrayLike = 0.0, thickness: ArrayLike = 0.0, out: Out = None) -> Inverse:
    """Length between the contacts and mobilised friction of states with deflection w and force F: the inverse of :func:`elastica_on_rollers`.

    Parameters
    ----------
    w, F : array_like
        Deflection [span], above 0 and up to 2, and force [EI/span²], at least 0.
    roller_radius, thickness, out
        As of :func:`elastica_on_rollers`; `out` has two arrays.

    Returns
    -------
    Inverse
        NaN where no friction from -2 to 2 explains deflection and force, and below a deflection of twice the thickness, where forces tell none.

    Examples
    --------
    >>> import flexslip
    >>> supports = {"roller_radius": 0.078, "thickness": 0.04}
    >>> w = 0.2
    >>> S, q = flexslip.elastica_on_rollers_inverse(w, flexslip.elastica_on_rollers(w, 0.3, **supports).F, **supports)
    >>> round(float(q), 9)
    0.3
    """
    deflection, force = numbers("w", w), numbers("F", F)
    _require_deflection(deflection)
    require("F", seen(force), 0, GREATEST, "a finite number of at least 0")
    return computed(_flexslip.states_on_rollers_from_forces, Inverse, (deflection, force, *_supports(roller_radius, thickness)), out, (0.1, 0, 0, 0))
