"""The numbers of the bending standards."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from . import _flexslip
from ._answers import Data
from ._case import Case, case_of, in_words_of, quantity_in_words, with_keywords
from ._errors import advice, wrong
from ._fields import ModulusFields

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._flexslip import Curve


class Modulus(ModulusFields):
    """Stiffness and flexural modulus, as :func:`modulus` gives them: every number of ``flexslip modulus --json``.

    Attributes
    ----------
    success : bool
        Does the record tell a stiffness? If not, `message` says why.
    remarks : tuple of str
        Where the numbers come from, what they assume, and where that does not hold.
    case : Case
    """

    _title = "Modulus"

    def __init__(self, data: Data, case: Case, remarks: tuple[str, ...], curve: Curve) -> None:
        super().__init__(data, case.reduced)
        self.case, self.remarks, self._curve = case, remarks, curve

    def __reduce__(self) -> tuple[object, ...]:
        return Modulus, (self._data, self.case, self.remarks, self._curve)

    @property
    def success(self) -> bool:
        """Does the record tell a stiffness? If not, `message` says why."""
        return bool(self._data["status"] == "ok")

    @property
    def message(self) -> str:
        """Why there is no stiffness; empty if there is one."""
        return "" if self.success else self.remarks[0]

    def plot(self, ax: Axes | None = None) -> Axes:
        """Force against deflection with the linear region and the chord of ISO 178, drawn with matplotlib; gives the Axes.

        Deflections are counted from the origin of strains, or from the contact if there is no linear region.
        """
        from . import _plots

        return _plots.modulus(self._curve, self, self._reduced, ax)


def _window(given: object) -> list[str]:
    if given is None:
        return []
    if not isinstance(given, (tuple, list)) or len(given) != 2:
        raise wrong("window", "two rising shares of the greatest force, (0.1, 0.3)", given)
    return [quantity_in_words("window", share, "", "a share of the greatest force") for share in given]


def _friction(given: object) -> list[str]:
    if given is None:
        return []
    both = given if isinstance(given, (tuple, list)) else (given,)
    if len(both) not in {1, 2}:
        raise wrong("friction_range", "a friction, or the least and the greatest, (0.1, 0.5)", given)
    return [quantity_in_words("friction_range", each, "", "a friction") for each in both]


@with_keywords("specimen", "rig", "friction", "record")
def modulus(file: object = None, *arrays: object, window: Sequence[str | float] | None = None, friction_range: str | float | Sequence[str | float] | None = None,
            set: Mapping[str, object] | None = None, **keywords: object) -> Modulus:  # noqa: A002
    """Stiffness and flexural modulus as the bending standards have them: small deflections, no friction, no shear.

    Parameters
    ----------
    file : path, Case, DataFrame or array, optional
        A case file, the data of a test, which the keywords describe, or a :class:`Case`. Data may be a file, a pandas.DataFrame, or two arrays,
        ``(stage, force)``, in SI. Without a span there is only a stiffness, without a section no
        modulus.
    window : (from, to), optional
        The straight part, in shares of the greatest force at deflections below a tenth of the span; the steepest stretch that the
        noise allows, of a quarter or more.
    friction_range : float or (least, greatest), optional
        At the supports, whose part in modulus, strength and work is told; that of the case, or 0.1 to 0.5.
    set, **keywords
        As of :class:`Case`.

    Returns
    -------
    Modulus
        Where the record tells no stiffness, its `success` is False and its `message` says why.

    Raises
    ------
    InputError
        For a case or a record that is wrong, with file, line and remedy.

    Examples
    --------
    >>> import flexslip
    >>> found = flexslip.modulus("examples/simulated/case.toml")
    >>> found.success, 20e9 < found.modulus.value < 40e9, found.modulus.unit
    (True, True, 'Pa')
    """
    case = case_of(file, arrays, set, keywords)
    with in_words_of(case) as given:
        found = _flexslip.modulus(given, _window(window), _friction(friction_range))
    return Modulus(found["answer"], case, tuple(map(advice, found["words"])), found["curve"])
