"""The report's figures, drawn with matplotlib: each is data (src/report/plot_json.h), and one function draws them all."""
from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ._errors import one_of, wrong

_MM = 1 / 25.4
_SMALL = {"font.size": 8, "axes.labelsize": 8, "axes.titlesize": 8, "legend.fontsize": 8, "xtick.labelsize": 8, "ytick.labelsize": 8, "axes.linewidth": 0.6,
          "axes.labelpad": 2, "axes.titlepad": 3, "xtick.direction": "in", "ytick.direction": "in", "xtick.top": True, "ytick.right": True,
          "legend.frameon": False, "axes.unicode_minus": True}
_DASHES: dict[str, Any] = {"solid": "-", "dashed": (0, (5, 3)), "long_dashed": (0, (10, 5)), "dotted": (0, (1.5, 2))}
_MARKERS: dict[str, Any] = {"": "", "disc": "o", "circle": "o", "square": "s", "triangle": "^", "down": "v", "star": (6, 2, 0), "cross": "x"}

Panel = Mapping[str, Any]


def plot(figures: Sequence[Mapping[str, Any]], name: str | None, ax: Any) -> Any:
    """Draws one of the figures; gives its axes."""
    names = [figure["name"] for figure in figures]
    if not names:
        raise ValueError("there is no figure: the test has no answer to draw")
    name = names[0] if name is None else name
    one_of("figure", name, names)
    figure = figures[names.index(name)]
    import matplotlib

    with matplotlib.rc_context(_SMALL):
        axes = _axes_of(figure, ax)
        for panel, each in zip(figure["panels"], axes):
            _draw_panel(figure, {**panel, "own": ax is None}, each)
        if ax is None and figure["x_label"]:
            axes[0].figure.supxlabel(_text(figure["x_label"]), fontsize=8, y=0.005)
        if ax is None and figure["y_label"]:
            axes[0].figure.supylabel(_text(figure["y_label"]), fontsize=8, x=0.005)
    return axes[0] if len(axes) == 1 else axes


def _axes_of(figure: Mapping[str, Any], ax: Any) -> Any:
    """Those of a new figure of the report's size, or those given: as many as there are panels, or one for the first of them."""
    panels = figure["panels"]
    if ax is None:
        import matplotlib.pyplot as plt

        made = plt.figure(figsize=(figure["width"] * _MM, figure["height"] * _MM))
        return np.array([made.add_axes((panel["left"], panel["bottom"], panel["width"], panel["height"])) for panel in panels], dtype=object)
    given = np.atleast_1d(np.asarray(ax, dtype=object)).ravel()
    if len(given) not in (1, len(panels)):
        raise wrong("ax", f"{len(panels)} axes, or one" if len(panels) > 1 else "one Axes", f"{len(given)}")
    for each in given:
        if not hasattr(each, "plot"):
            raise TypeError(f"ax: expected matplotlib Axes, found {type(each).__name__}")
    return given


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


def _draw_panel(figure: Mapping[str, Any], panel: Panel, ax: Any) -> None:
    own = panel["own"]
    for name, axis in (("x", panel["x"]), ("y", panel["y"])):
        if axis["logarithmic"]:
            getattr(ax, f"set_{name}scale")("log")
        getattr(ax, f"set_{name}lim")(axis["from"], axis["to"])
        if axis["shown"] or not own:
            getattr(ax, f"set_{name}label")(_text(axis["label"]))
        if own:
            _set_ticks(getattr(ax, f"{name}axis"), axis)
    handles = []
    for level, mark in enumerate(panel["marks"]):
        handle = _DRAWN[mark["kind"]](figure, panel, mark, ax, {"zorder": 2 + 0.01 * level})
        if mark["title"] and mark["kind"] != "label":
            handle.set_label(_text(mark["title"]))
            handles.append(handle)
    if panel["title"]:
        ax.set_title(_text(panel["title"]), loc="left")
    if handles and own:
        ax.figure.legend(handles=handles, loc="lower left", ncols=-(-len(handles) // panel["key_rows"]), bbox_to_anchor=(panel["key_left"], panel["key_bottom"]),
                         borderaxespad=0, borderpad=0.1, columnspacing=1.6, handlelength=2.2, labelspacing=0.3)
    elif handles:
        ax.legend(handles=handles, loc="best")


def _set_ticks(axis: Any, wanted: Mapping[str, Any]) -> None:
    with_number = [(at, text) for at, text in zip(wanted["ticks"], wanted["texts"]) if text]
    axis.set_ticks([at for at, _ in with_number], [_text(text) if wanted["numbers"] else "" for _, text in with_number])
    axis.set_ticks([at for at, text in zip(wanted["ticks"], wanted["texts"]) if not text], minor=True)
    axis.set_tick_params(which="minor", labelleft=False, labelbottom=False)


def _columns(figure: Mapping[str, Any], mark: Mapping[str, Any]) -> list[Any]:
    """The columns of a mark; NaN in rows that it does not draw."""
    table = figure["data"][mark["table"]]
    columns = [table[name] for name in mark["columns"]]
    for name, value in mark["only"].items():
        columns = [np.where(table[name] == value, column, np.nan) for column in columns]
    return columns


def _whole_rows(figure: Mapping[str, Any], mark: Mapping[str, Any]) -> list[Any]:
    columns = _columns(figure, mark)
    whole = np.isfinite(columns).all(axis=0)
    return [column[whole] for column in columns]


def _stroke(mark: Mapping[str, Any]) -> dict[str, Any]:
    style = mark["style"]
    return {"color": style["colour"], "lw": style["width"], "ls": _DASHES[style["dash"]]}


def _symbols(mark: Mapping[str, Any]) -> dict[str, Any]:
    style = mark["style"]
    return {"marker": _MARKERS[style["symbol"]], "ms": style["size"], "mew": style["width"] if style["symbol"] in ("circle", "star", "cross") else 0,
            "mec": style["colour"], "mfc": "white" if style["symbol"] == "circle" else style["colour"]}


def _fill(mark: Mapping[str, Any]) -> dict[str, Any]:
    return {"facecolor": mark["style"]["colour"], "alpha": mark["style"]["opacity"], "lw": 0}


def _line(figure: Any, panel: Any, mark: Any, ax: Any, order: Any) -> Any:
    return ax.plot(*_columns(figure, mark), **_stroke(mark), **_symbols(mark), **order)[0]


def _points(figure: Any, panel: Any, mark: Any, ax: Any, order: Any) -> Any:
    return ax.plot(*_columns(figure, mark), **{**_stroke(mark), "ls": ""}, **_symbols(mark), **order)[0]


def _band(figure: Any, panel: Any, mark: Any, ax: Any, order: Any) -> Any:
    return ax.fill_between(*_columns(figure, mark), **_fill(mark), **order)


def _area(figure: Any, panel: Any, mark: Any, ax: Any, order: Any) -> Any:
    return ax.fill(*_columns(figure, mark), **_fill(mark), **order)[0]


def _bars(figure: Any, panel: Any, mark: Any, ax: Any, order: Any) -> Any:
    return ax.vlines(*_whole_rows(figure, mark), **_stroke(mark), **order)


def _spans(figure: Any, panel: Any, mark: Any, ax: Any, order: Any) -> Any:
    low, high, y = _whole_rows(figure, mark)
    return ax.hlines(y, low, high, **_stroke(mark), **order)


def _arrows(figure: Any, panel: Any, mark: Any, ax: Any, order: Any) -> Any:
    for x, y, to_x, to_y in zip(*_whole_rows(figure, mark)):
        ax.annotate("", (to_x, to_y), (x, y), arrowprops={"arrowstyle": "-|>", "color": mark["style"]["colour"], "lw": mark["style"]["width"], "shrinkA": 0, "shrinkB": 0}, **order)


def _pixels(figure: Any, panel: Any, mark: Any, ax: Any, order: Any) -> Any:
    import matplotlib.colors

    left, right, low, high, value = _columns(figure, mark)
    xs, ys = np.unique(left), np.unique(low)
    values = np.full((len(ys), len(xs)), np.nan)
    values[np.searchsorted(ys, low), np.searchsorted(xs, left)] = value
    colours = matplotlib.colors.LinearSegmentedColormap.from_list("report", [tuple(stop) for stop in figure["palette"]])
    shown = panel["colour"]
    image = ax.pcolormesh([*xs, right.max()], [*ys, high.max()], values, cmap=colours, vmin=shown["from"], vmax=shown["to"], rasterized=True, **order)
    beside = 3 / figure["width"]  # mm
    place = ax.figure.add_axes((panel["left"] + panel["width"] + beside, panel["bottom"], beside, panel["height"])) if panel["own"] else None
    ax.figure.colorbar(image, ax=ax, cax=place, label=_text(shown["label"]))
    return image


def _horizontal(figure: Any, panel: Any, mark: Any, ax: Any, order: Any) -> Any:
    return ax.axhline(mark["at"][0], **_stroke(mark), **order)


def _vertical(figure: Any, panel: Any, mark: Any, ax: Any, order: Any) -> Any:
    return ax.axvline(mark["at"][0], **_stroke(mark), **order)


def _rectangle(figure: Any, panel: Any, mark: Any, ax: Any, order: Any) -> Any:
    ends = [panel[axis]["from"] if at == "begin" else panel[axis]["to"] if at == "end" else at for axis, at in zip("xxyy", mark["at"])]
    return ax.fill([ends[0], ends[1], ends[1], ends[0]], [ends[2], ends[2], ends[3], ends[3]], **_fill(mark), **order)[0]


def _label(figure: Any, panel: Any, mark: Any, ax: Any, order: Any) -> Any:
    x, y = mark["at"]
    of_edge = {"begin": 0, "end": 1}
    inwards = {"begin": 4, "end": -4}
    level = inwards.get(y, 3 if x in of_edge else 0)
    across = "left" if x == "begin" else "right" if x == "end" else "center"
    upright = "top" if y == "end" else "bottom" if y == "begin" or x in of_edge else "center"
    ax.annotate(_text(mark["title"]), (of_edge.get(x, x), of_edge.get(y, y)), (inwards.get(x, 0), level), textcoords="offset points",
                xycoords=("axes fraction" if x in of_edge else "data", "axes fraction" if y in of_edge else "data"), ha=across, va=upright,
                bbox=None if x in of_edge or y in of_edge else {"facecolor": "white", "edgecolor": "none", "pad": 1.5}, **{"zorder": 4})


def _key(figure: Any, panel: Any, mark: Any, ax: Any, order: Any) -> Any:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    if mark["kind"] == "key_fill":
        return Patch(**_fill(mark))
    return Line2D([], [], **({**_stroke(mark), "ls": ""} if mark["kind"] == "key_points" else _stroke(mark)), **_symbols(mark))


_DRAWN = {"line": _line, "points": _points, "band": _band, "area": _area, "bars": _bars, "spans": _spans, "arrows": _arrows, "pixels": _pixels,
          "horizontal": _horizontal, "vertical": _vertical, "rectangle": _rectangle, "label": _label, "key_line": _key, "key_points": _key, "key_fill": _key}
