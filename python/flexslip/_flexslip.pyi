"""The compiled half of the package."""
from collections.abc import Mapping, Sequence
from typing import Protocol, TypedDict

import numpy as np
import numpy.typing as npt

Numbers = npt.NDArray[np.float64]
# Columns of a table: numbers, or a list of what stands in its rows, None where there is nothing.
Column = Numbers | list[object]
Answer = Mapping[str, object]

class Entry(TypedDict):
    """What describes a value of an answer."""
    name: str
    title: str
    shape: str
    unit: str
    reduced_unit: str
    meaning: str
    entries: list[Entry]
    may_be_missing: bool
    is_several: bool

class AnswerKind(TypedDict):
    what: str
    is_table: bool
    entries: list[Entry]

class Columns(TypedDict):
    """A table: columns by name, and the rows in which one has no value at all."""
    rows: int
    columns: dict[str, Column]
    absent: dict[str, list[int]]

class Sweep(Columns):
    units: dict[str, str]

Key = TypedDict("Key", {
    "section": str, "name": str, "holds": str, "example": str, "reduced": str, "flag": str, "meaning": str, "more": str, "unit": str, "kind": str,
    "words": list[str], "is": str,
})

# ---- Figures, as report/plot.h has them

class Style(TypedDict):
    colour: str
    dash: str
    opacity: float
    size: float
    symbol: str
    width: float

class Mark(TypedDict):
    kind: str
    table: str
    columns: list[str]
    style: Style
    title: str
    only: dict[str, float]
    at: list[float]

class Text(TypedDict):
    words: str
    x: float
    y: float
    anchor: str
    upright: bool
    boxed: bool

Axis = TypedDict("Axis", {
    "label": str, "from": float, "to": float, "logarithmic": bool, "ticks": list[tuple[float, str]], "numbers": bool, "title": Text, "upright": bool,
})

class Panel(TypedDict):
    title: str
    x: Axis
    y: Axis
    marks: list[Mark]
    colour: Axis | None
    left: float
    bottom: float
    width: float
    height: float
    key_left: float
    key_top: float
    key_width: float
    key_rows: int
    texts: list[Text]

class Figure(TypedDict):
    name: str
    title: str
    caption: str
    width: float
    height: float
    columns: int
    palette: list[tuple[float, str]]
    texts: list[Text]
    panels: list[Panel]
    data: dict[str, dict[str, Numbers]]

# ---- The module

version: str
threads: int
largest_q: float
false_alarms: float
suspect_limit: float
model_names: list[str]
states: np.ufunc
states_slopes: np.ufunc
states_from_forces: np.ufunc
states_more: np.ufunc
states_on_rollers: np.ufunc
states_on_rollers_from_forces: np.ufunc
deepest_on_supports: float
widest_supports: float
thickest: float
most_equilibria: int
most_levels: int

class Case:
    @property
    def source(self) -> str: ...
    @property
    def reduced(self) -> bool: ...
    def toml(self) -> str: ...
    def has(self, section: str) -> bool: ...

class HasFigures(Protocol):
    def figures(self) -> list[Figure]: ...

class FittedTest:
    def answer(self) -> Answer: ...
    def curves(self) -> Columns: ...
    def draws(self) -> Columns: ...
    def figures(self) -> list[Figure]: ...
    def why_no_answer(self) -> str: ...
    def screen(self) -> str: ...
    def text(self) -> str: ...
    def write_report(self, folder: bytes) -> bool: ...

class SimulatedTest:
    def answer(self, energies: bool) -> Answer: ...
    def figures(self) -> list[Figure]: ...
    @property
    def remarks(self) -> list[str]: ...
    @property
    def why_it_ends(self) -> str: ...

class DesignAnswer:
    def answer(self) -> Answer: ...
    def figures(self) -> list[Figure]: ...
    def toml(self) -> str: ...
    def text(self) -> str: ...

class Map(TypedDict):
    units: dict[str, str]
    designs: Columns

class DesignMap:
    def answer(self) -> Map: ...
    def entries(self) -> list[Entry]: ...
    def figures(self) -> list[Figure]: ...
    def toml(self) -> str: ...
    def values_taken(self) -> list[str]: ...

class EquilibriumStudy:
    def answer(self) -> Answer: ...
    def figures(self) -> list[Figure]: ...

class Campaign:
    def answer(self) -> Answer: ...
    def test_table(self) -> Columns: ...
    def figures(self) -> list[Figure]: ...
    def text(self) -> str: ...

class ExportColumn(TypedDict):
    name: str
    unit: str
    role: str
    values: Numbers | list[str]

class Export:
    @property
    def specimens(self) -> int: ...
    def answer(self, chosen: int) -> Answer: ...
    def columns(self, chosen: int) -> list[ExportColumn]: ...
    def in_si(self, chosen: int, role: str) -> Numbers: ...
    def write(self, chosen: int, path: bytes) -> None: ...

class Profile(TypedDict):
    answer: Answer
    remarks: list[str]
    why_no_answer: str

class Curve(TypedDict):
    """A record; its linear region is its first point and the one behind its last."""
    deflection: Numbers
    force: Numbers
    linear_region: tuple[int, int] | None

class Modulus(TypedDict):
    answer: Answer
    words: list[str]
    curve: Curve

def keys() -> list[Key]: ...
def answers() -> dict[str, AnswerKind]: ...
def dumped(data: object) -> str: ...
def readable(value: float, unit: str) -> str: ...
def readable_estimate(value: float, error: float, unit: str) -> str: ...
def case_text(path: bytes) -> bytes: ...
def read_case(text: str, source: bytes, changes: list[str]) -> Case: ...
def with_record(case: Case, columns: Sequence[tuple[str, Numbers]], name: str) -> Case: ...
def in_si(values: Numbers, unit: str, of: str) -> Numbers: ...
def length(name: str, text: str, may_be_zero: bool) -> float: ...
def fit(case: Case, model: str, false_alarms: float, suspect_limit: float) -> FittedTest: ...
def simulate(case: Case, points: int, noise: str, seed: int) -> SimulatedTest: ...
def friction_profile(case: Case) -> Profile: ...
def design(text: str, source: bytes, changes: list[str], threads: int) -> DesignAnswer: ...
def design_with_reload(text: str, source: bytes, changes: list[str], noise: str, threads: int) -> DesignAnswer: ...
def design_map(text: str, source: bytes, changes: list[str], over: list[str], threads: int) -> DesignMap: ...
def equilibrium(case: Case, region: bool, points: int, levels: int, longest: str) -> EquilibriumStudy: ...
def modulus(case: Case, window: list[str], friction: list[str]) -> Modulus: ...
def sweep(text: str, source: bytes, changes: list[str], threads: int) -> Sweep: ...
def campaign(
    path: bytes, common: bytes | None, changes: list[str], model: str, false_alarms: float, suspect_limit: float,
    jobs: int, report: bytes | None, figures: bool, test_reports: bool,
) -> Campaign: ...
def read(path: bytes, given: dict[str, str | int]) -> Export: ...
