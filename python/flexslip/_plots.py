"""The report's figures, drawn with matplotlib: each is data (src/report/plot.h), and one function draws them all."""
from __future__ import annotations

import base64
import io
import re
from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Union, cast

import numpy as np
import numpy.typing as npt

from . import _flexslip
from ._answers import Estimate, Numbers, suiting
from ._errors import InputError, one_of, wrong

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis as MatplotlibAxis

    from ._fields import ModulusFields
    from ._flexslip import Axis, Figure, Mark, Panel, Text
    from ._flexslip import Curve as RecordCurve

_MM = 1 / 25.4
_SMALL = {"font.size": 8, "axes.labelsize": 8, "axes.titlesize": 8, "legend.fontsize": 8, "xtick.labelsize": 8, "ytick.labelsize": 8, "axes.linewidth": 0.6,
          "axes.labelpad": 2, "axes.titlepad": 3, "xtick.direction": "in", "ytick.direction": "in", "xtick.top": True, "ytick.right": True,
          "legend.frameon": False, "axes.unicode_minus": True, "font.family": "sans-serif",
          "font.sans-serif": ["Arial", "Liberation Sans", "DejaVu Sans"], "mathtext.fontset": "dejavusans"}  # with a fontset of one's own, matplotlib looks for a cursive font
_DASHES: dict[str, str | tuple[int, tuple[float, float]]] = {"solid": "-", "dashed": (0, (3, 2)), "long_dashed": (0, (6.6, 3.3)), "dotted": (0, (1, 1.5))}
_MARKERS: dict[str, str | tuple[int, int, int]] = {"": "", "disc": "o", "circle": "o", "square": "s", "triangle": "^", "down": "v", "star": (6, 2, 0), "cross": "x"}

Drawn = Union["Axes", npt.NDArray[np.object_]]  # axes, or an array of them
Style = dict[str, object]  # arguments of matplotlib


def plot(figures: Sequence[Figure], name: str | None, ax: Drawn | None, unit: object = None) -> Drawn:
    """Draws one of the figures; gives its axes. `unit` is that of lengths, of forces, or both."""
    names = [figure["name"] for figure in figures]
    if not names:
        raise ValueError("there is nothing to draw")
    name = names[0] if name is None else name
    one_of("figure", name, names)
    figure = _in_units(figures[names.index(name)], unit)
    with matplotlib_style() if ax is None else _style_of_user():
        axes = _axes_of(figure, ax)
        for panel, each in zip(figure["panels"], axes):
            _draw_panel(figure, panel, each, ax is None)
        if ax is None:
            for text in figure["texts"]:
                axes[0].figure.text(text["x"] / figure["width"], text["y"] / figure["height"], _text(text["words"]), **_anchored(text))
    return axes[0] if len(axes) == 1 else axes


_BLUE, _ORANGE, _BLACK = "#0072B2", "#E69F00", "#000000"  # as report/plot.h


class Curve:
    """Force against deflection of a record, where there is no figure of a report: on new axes of the width of a column, or on those given."""

    def __init__(self, deflection: Numbers, force: Numbers, reduced: bool, ax: Axes | None) -> None:
        import matplotlib.pyplot as plt

        self.deflection, self.force = deflection, force
        with matplotlib_style():
            self.own, self.style = ax is None, matplotlib_style if ax is None else _style_of_user
            self.ax = plt.subplots(figsize=(85 * _MM, 64 * _MM), layout="constrained")[1] if ax is None else _given_axes(ax, 1)[0]
            length, self._to_length = suiting(deflection, "L" if reduced else "m")
            unit, self._to_force = suiting(force, "EI/L^2" if reduced else "N")
            self.ax.set_xlabel(_text(f"Deflection at midspan *w*_0 ({length})"))
            self.ax.set_ylabel(_text(f"Force *F* ({unit})"))
            self.ax.axhline(0, color=_BLACK, lw=0.75, zorder=1)
            self.line(deflection, force, label="Measured", color=_BLUE, lw=0.5, marker="o", ms=1.7, mew=0, zorder=2)

    def line(self, deflection: Numbers, force: Numbers, **style: object) -> None:
        """Draws deflections and forces in SI, or reduced, as those of the record."""
        self.ax.plot(np.multiply(self._to_length, deflection), np.multiply(self._to_force, force), **style)

    def finish(self) -> Axes:
        """Adds the key; gives the axes."""
        with self.style():
            if self.own:
                self.ax.legend(loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2, labelspacing=0.3, handlelength=2.2)
            else:
                self.ax.legend(loc="best")
        return self.ax


def matplotlib_style() -> AbstractContextManager[None]:
    """The letters and lines of the report, for what is drawn inside."""
    import matplotlib

    style: AbstractContextManager[None] = matplotlib.rc_context(_SMALL)
    return style


def _style_of_user() -> AbstractContextManager[None]:
    """Letters and lines of the user, who gave the axes; without a frame around the key."""
    import matplotlib

    style: AbstractContextManager[None] = matplotlib.rc_context({"legend.frameon": False})
    return style


def changed(part: object, **values: object) -> dict[str, object]:
    """A part of a figure with other values."""
    return {**cast("Mapping[str, object]", part), **values}


def _kind_of(unit: str) -> tuple[str, float] | None:
    """What a unit measures, a length or a force, and how much of SI it is; None of any other."""
    for kind in ("length", "force"):
        try:
            return kind, float(_flexslip.in_si(np.ones(1), unit, kind)[0])
        except InputError:
            continue
    return None


def _in_units(figure: Figure, unit: object) -> Figure:
    """A figure whose lengths and forces are in other units; its ticks are left to matplotlib."""
    if unit is None:
        return figure
    units: dict[str, tuple[str, float]] = {}
    for word in unit if isinstance(unit, (tuple, list)) else (unit,):
        kind = _kind_of(word) if isinstance(word, str) else None
        if kind is None:
            raise wrong("unit", 'a unit of length or force, "mm", or one of each, ("mm", "N")', word)
        units[kind[0]] = word, kind[1]

    def other(text: str) -> tuple[str, float]:
        """A title with its unit, in brackets at its end, as it is wanted, and the factor to it."""
        found = re.search(r"[(\[]([^()\[\]]*)[)\]]$", text)
        kind = _kind_of(found[1]) if found else None
        if found is None or kind is None or kind[0] not in units:
            return text, 1.0
        word, size = units[kind[0]]
        return f"{text[:found.start(1)]}{word}{text[-1]}", kind[1] / size

    def axis(of: Axis) -> Axis:
        label, factor = other(of["label"])
        title = changed(of["title"], words=label if of["title"]["words"] else "")
        return of if factor == 1 else cast("Axis", changed(of, label=label, title=title, to=factor * of["to"], ticks=[], **{"from": factor * of["from"]}))

    def panel(of: Panel) -> Panel:
        factors = [other(each["label"])[1] for each in (of["x"], of["y"])]
        marks = [changed(mark, at=[factors[i % 2] * value for i, value in enumerate(mark["at"])]) for mark in of["marks"]]
        return cast("Panel", changed(of, x=axis(of["x"]), y=axis(of["y"]), marks=marks))

    data = {table: {name: other(name)[1] * np.asarray(values) for name, values in columns.items()} for table, columns in figure["data"].items()}
    return cast("Figure", changed(figure, panels=[panel(each) for each in figure["panels"]], data=data))


def picture(axes: Drawn) -> str:
    """A new figure as an image of a page (HTML); it is closed, so that a notebook does not show it twice."""
    import matplotlib.pyplot as plt

    figure = np.atleast_1d(np.asarray(axes, dtype=object)).ravel()[0].figure
    file = io.BytesIO()
    figure.savefig(file, format="png", dpi=144, facecolor="white")
    plt.close(figure)
    return f'<img style="max-width:100%" width="{96 * figure.get_figwidth():.0f}" src="data:image/png;base64,{base64.b64encode(file.getvalue()).decode()}">'


def record(deflection: Numbers, force: Numbers, reduced: bool, ax: Axes | None) -> Axes:
    """A record alone; gives its axes."""
    return Curve(deflection, force, reduced, ax).finish()


def modulus(curve: RecordCurve, found: ModulusFields, reduced: bool, ax: Axes | None) -> Axes:
    """A record with its linear region and the chord of ISO 178, as far as there are such; gives its axes."""
    drawn = Curve(curve["deflection"], curve["force"], reduced, ax)
    if curve["linear_region"] is not None:
        region = slice(*curve["linear_region"])
        w, F = drawn.deflection[region], drawn.force[region]
        slope = found.stiffness.value
        ends = w[[0, -1]]
        title = _with_value("Linear region", found.linear_modulus, found.stiffness)
        drawn.line(ends, F.mean() + slope * (ends - w.mean()), label=title, color=_ORANGE, lw=4, alpha=0.6, solid_capstyle="butt", zorder=1.5)
    if found.chord is not None:
        ends = np.asarray(found.chord.deflection)
        title = _with_value("Chord of ISO 178", found.chord.modulus, found.chord.stiffness)
        drawn.line(ends, _force_at(ends, drawn), label=title, color=_BLACK, lw=1.2, marker="o", ms=4, mfc="white", mew=1, zorder=4)
    return drawn.finish()


def _with_value(title: str, modulus: Estimate, stiffness: Estimate) -> str:
    return f"{title}: {stiffness if modulus.value != modulus.value else modulus}"


def _force_at(deflections: Numbers, drawn: Curve) -> Numbers:
    """Forces of the loading, up to where it is bent the most."""
    loading = slice(0, int(np.argmax(drawn.deflection)) + 1)
    rising = np.maximum.accumulate(drawn.deflection[loading])
    return np.interp(deflections, rising, drawn.force[loading])


def _given_axes(ax: Drawn, count: int) -> npt.NDArray[np.object_]:
    """The axes that a user gives, one or as many as there are panels."""
    given: npt.NDArray[np.object_] = np.atleast_1d(np.asarray(ax, dtype=object)).ravel()
    if len(given) not in (1, count):
        raise wrong("ax", f"{count} axes, or one" if count > 1 else "one Axes", f"{len(given)}")
    for each in given:
        if not hasattr(each, "plot"):
            raise TypeError(f"ax: These must be matplotlib Axes, not {type(each).__name__}.")
    return given


def _axes_of(figure: Figure, ax: Drawn | None) -> npt.NDArray[np.object_]:
    """Those of a new figure of the report's size, or those given: as many as there are panels, or one for the first of them."""
    panels = figure["panels"]
    if ax is None:
        import matplotlib.pyplot as plt

        made = plt.figure(figsize=(figure["width"] * _MM, figure["height"] * _MM))
        width, height = figure["width"], figure["height"]
        return np.array([made.add_axes((panel["left"] / width, panel["bottom"] / height, panel["width"] / width, panel["height"] / height))
                         for panel in panels], dtype=object)
    return _given_axes(ax, len(panels))


def _text(markup: str) -> str:
    """The report's markup (src/report/plot.h) as matplotlib has it: *F*_0 is $F_{0}$."""
    out, in_italics, math = "", False, ""
    for escaped, star, script, group, single, plain in re.findall(r"\\(.)|(\*)|([_^])(?:\{([^}]*)\}|(.))|([^\\*_^]+|.)", markup):
        if star:
            in_italics = not in_italics
        elif script:
            math += f"{script}{{\\mathrm{{{group or single}}}}}"
        elif in_italics:
            math += escaped + plain
        else:
            out += (f"${math}$" if math else "") + (escaped + plain).replace("$", r"\$")
            math = ""
    return out + (f"${math}$" if math else "")


def _draw_panel(figure: Figure, panel: Panel, ax: Axes, own: bool) -> None:
    width, height = figure["width"], figure["height"]
    for name, axis in (("x", panel["x"]), ("y", panel["y"])):
        if axis["logarithmic"]:
            getattr(ax, f"set_{name}scale")("log")
        getattr(ax, f"set_{name}lim")(axis["from"], axis["to"])
        title = axis["title"]
        shared = len(getattr(ax, f"get_shared_{name}_axes")().get_siblings(ax)) > 1
        if title["words"] or not (own or shared):  # else another panel has the label
            getattr(ax, f"set_{name}label")(_text(axis["label"]), **({"va": "center"} if own else {}))
        if own:
            getattr(ax, f"{name}axis").set_label_coords(title["x"] / width, title["y"] / height, transform=ax.figure.transFigure)
            _set_ticks(getattr(ax, f"{name}axis"), axis)
    handles = []
    for level, mark in enumerate(panel["marks"]):
        handle = (_DRAWN[mark["kind"]] if mark["table"] or mark["at"] else _key)(_Drawing(figure, panel, ax, own, 2 + 0.01 * level), mark)
        label = mark["title"] or ("" if own else _beyond(figure, mark))
        if label:
            handle.set_label(_text(label))
            handles.append(handle)
    if panel["title"]:
        ax.set_title(_text(panel["title"]), loc="left")
    for text in panel["texts"]:
        x, y = (text["x"] - panel["left"]) / panel["width"], (text["y"] - panel["bottom"]) / panel["height"]
        if 0 <= x <= 1 and 0 <= y <= 1:  # a label: the title has been set
            ax.text(x, y, _text(text["words"]), transform=ax.transAxes, zorder=4, **_anchored(text))
    if not own and handles:
        ax.legend(handles=handles, loc="best")
    for column in range(0, len(handles) if own else 0, max(1, panel["key_rows"])):
        left = panel["key_left"] + panel["key_width"] * column / panel["key_rows"]
        ax.figure.legend(handles=handles[column:column + panel["key_rows"]], loc="upper left", bbox_to_anchor=(left / width, panel["key_top"] / height),
                         borderaxespad=0, borderpad=0.1, handlelength=2.2, handletextpad=0.4, labelspacing=0.3)


def _beyond(figure: Figure, mark: Mark) -> str:
    """What triangles at the edge of a panel are, if there are any."""
    at_edge = mark["kind"] == "points" and mark["style"]["symbol"] in ("triangle", "down")
    return "Beyond the axis" if at_edge and np.isfinite(_columns(figure, mark)).all(axis=0).any() else ""


def _anchored(text: Text) -> Style:
    import matplotlib

    return {"ha": text["anchor"], "va": "center", "fontsize": matplotlib.rcParams["legend.fontsize"], "rotation": 90 if text["upright"] else 0,
            "bbox": {"facecolor": "white", "edgecolor": "none", "pad": 1} if text["boxed"] else None}


def _set_ticks(axis: MatplotlibAxis, wanted: Axis) -> None:
    if not wanted["ticks"]:
        axis.set_tick_params(labelleft=wanted["numbers"], labelbottom=wanted["numbers"])
        return
    with_number = [(at, text) for at, text in wanted["ticks"] if text]
    axis.set_ticks([at for at, _ in with_number], [_text(text) if wanted["numbers"] else "" for _, text in with_number])
    axis.set_ticks([at for at, text in wanted["ticks"] if not text], minor=True)
    axis.set_tick_params(which="minor", labelleft=False, labelbottom=False)
    if wanted["upright"]:
        axis.set_tick_params(rotation=90)


def _columns(figure: Figure, mark: Mark) -> list[Numbers]:
    """The columns of a mark, NaN in rows that it does not draw; or what its own numbers are."""
    if not mark["table"]:
        x, y = mark["at"][0::2], mark["at"][1::2]
        corners = [[x[0], x[1], x[1], x[0]], [y[0], y[0], y[1], y[1]]] if mark["kind"] == "area" else [x, y]
        return [np.array(each, dtype=float) for each in corners]
    table = figure["data"][mark["table"]]
    columns = [table[name] for name in mark["columns"]]
    for name, value in mark["only"].items():
        columns = [np.where(table[name] == value, column, np.nan) for column in columns]
    return columns


def _whole_rows(figure: Figure, mark: Mark) -> list[Numbers]:
    columns = _columns(figure, mark)
    whole = np.isfinite(columns).all(axis=0)
    return [column[whole] for column in columns]


def _stroke(mark: Mark) -> Style:
    style = mark["style"]
    return {"color": style["colour"], "lw": style["width"], "ls": _DASHES[style["dash"]]}


def _symbols(mark: Mark) -> Style:
    style = mark["style"]
    return {"marker": _MARKERS[style["symbol"]], "ms": style["size"], "mew": style["width"] if style["symbol"] in ("circle", "star", "cross") else 0,
            "mec": style["colour"], "mfc": "white" if style["symbol"] == "circle" else style["colour"]}


def _fill(mark: Mark) -> Style:
    return {"facecolor": mark["style"]["colour"], "alpha": mark["style"]["opacity"], "lw": 0}


@dataclass(frozen=True)
class _Drawing:
    """Where a mark is drawn, and over what."""

    figure: Figure
    panel: Panel
    ax: Axes
    own: bool  # is the figure that of the report?
    level: float


def _line(on: _Drawing, mark: Mark) -> Artist:
    return on.ax.plot(*_columns(on.figure, mark), **_stroke(mark), **_symbols(mark), zorder=on.level)[0]


def _points(on: _Drawing, mark: Mark) -> Artist:
    return on.ax.plot(*_columns(on.figure, mark), **(_stroke(mark) | {"ls": ""}), **_symbols(mark), zorder=on.level)[0]


def _band(on: _Drawing, mark: Mark) -> Artist:
    return on.ax.fill_between(*_columns(on.figure, mark), **_fill(mark), zorder=on.level)


def _area(on: _Drawing, mark: Mark) -> Artist:
    return on.ax.fill(*_columns(on.figure, mark), **_fill(mark), zorder=on.level)[0]


def _bars(on: _Drawing, mark: Mark) -> Artist:
    return on.ax.vlines(*_whole_rows(on.figure, mark), **_stroke(mark), zorder=on.level)


def _spans(on: _Drawing, mark: Mark) -> Artist:
    low, high, y = _whole_rows(on.figure, mark)
    return on.ax.hlines(y, low, high, **_stroke(mark), zorder=on.level)


def _arrows(on: _Drawing, mark: Mark) -> Artist:
    for x, y, to_x, to_y in zip(*_whole_rows(on.figure, mark)):
        on.ax.annotate("", (to_x, to_y), (x, y), arrowprops={"arrowstyle": "-|>", "color": mark["style"]["colour"], "lw": mark["style"]["width"], "shrinkA": 0, "shrinkB": 0}, zorder=on.level)


def _pixels(on: _Drawing, mark: Mark) -> Artist:
    import matplotlib.colors

    left, right, low, high, value = _columns(on.figure, mark)
    xs, ys = np.unique(left), np.unique(low)
    values = np.full((len(ys), len(xs)), np.nan)
    values[np.searchsorted(ys, low), np.searchsorted(xs, left)] = value
    colours = matplotlib.colors.LinearSegmentedColormap.from_list("report", [tuple(stop) for stop in on.figure["palette"]])
    shown, panel = on.panel["colour"], on.panel
    assert shown is not None  # pixels have a colour axis
    image = on.ax.pcolormesh([*xs, right.max()], [*ys, high.max()], values, cmap=colours, vmin=shown["from"], vmax=shown["to"], rasterized=True, zorder=on.level)
    bar, width, height = 3, on.figure["width"], on.figure["height"]  # mm, and what stands before it
    place = on.ax.figure.add_axes(((panel["left"] + panel["width"] + bar) / width, panel["bottom"] / height, bar / width, panel["height"] / height)) if on.own else None
    on.ax.figure.colorbar(image, ax=on.ax, cax=place, label=_text(shown["label"]))
    return image


def _key(on: _Drawing, mark: Mark) -> Artist:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    if mark["kind"] in ("area", "band"):
        return Patch(**_fill(mark))
    return Line2D([], [], **(_stroke(mark) | {"ls": ""} if mark["kind"] == "points" else _stroke(mark)), **_symbols(mark))


_DRAWN = {"line": _line, "points": _points, "band": _band, "area": _area, "bars": _bars, "spans": _spans, "arrows": _arrows, "pixels": _pixels}
