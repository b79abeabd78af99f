"""Figures of slide and stick, and of tests that load and unload."""
from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ._plots import BLUE, GREEN, GREY, ORANGE, VERMILLION, above, columns_of, labelled, new_axes, number_after, words

_LIGHT = "#C8C8C8"


def teeth(figure: Mapping[str, Any], ax: Any) -> Any:
    """The position of every rise between sliding and sticking."""
    data = figure["data"]
    axes = new_axes(figure, ax, 1)[0]
    middle, begin, end, position, noise, common, compliant = columns_of(data["teeth"])
    axes.vlines(middle, position - 1.96 * common, position + 1.96 * common, color=_LIGHT, lw=4, label="95 %: common to all")
    axes.vlines(middle, position - 1.96 * noise, position + 1.96 * noise, color="black", lw=0.8, label="95 %: noise")
    axes.hlines(position, begin, end, color=GREY, lw=0.8)
    for name, mark, colour, full, label in (("sliding", "o", BLUE, True, "slides"), ("sticking", "s", VERMILLION, True, "as if stuck"),
                                            ("undecided", "o", "black", False, "undecided")):
        x, _, _, y = columns_of(data[name])[:4]
        if np.isfinite(y).any():
            axes.plot(x, y, mark, color=colour, ms=4, mfc=colour if full else "white", label=label)
    if np.isfinite(compliant).any():
        axes.plot(middle, compliant, "x", color=GREEN, ms=3, lw=0.8, label="if stuck, compliant")
    stuck = number_after(figure["script"], "set object 1 rectangle from graph 0, first ")
    axes.axhspan(stuck, 10, color=ORANGE, alpha=0.16, lw=0)
    for level, text in ((0, "sliding, friction constant"), (1, "stuck")):
        axes.axhline(level, color="black", lw=0.75)
        axes.annotate(text, (0.008, level), xycoords=("axes fraction", "data"), va="bottom" if level else "top", fontsize=7)
    low, high = position - 2 * np.hypot(noise, common), position + 2 * np.hypot(noise, common)
    axes.set_ylim(max(float(np.nanmin([-0.2, *(low - 0.05)])), -1.5), min(float(np.nanmax([1.15, *(high + 0.05)])), 2))
    labelled(axes, words(figure["script"], "x")[0], words(figure["script"], "y")[0])
    above(axes, 3)
    return axes


def loops(figure: Mapping[str, Any], ax: Any) -> Any:
    """Force against deflection, there and back."""
    data = figure["data"]
    axes = new_axes(figure, ax, 1)[0]
    axes.plot(*columns_of(data["loading"]), color=BLUE, lw=1.3, label="Loading")
    axes.plot(*columns_of(data["unloading"]), color=VERMILLION, lw=1.3, label="Unloading")
    if np.isfinite(columns_of(data["forward"])[0]).any():
        axes.plot(*columns_of(data["forward"])[:2], color="black", lw=0.7, label="Profile, run forward")
    for x, y, x_to, y_to, unloading in zip(*columns_of(data["arrows"])):
        if np.isfinite(x):
            axes.annotate("", (x_to, y_to), (x, y), arrowprops={"arrowstyle": "-|>", "color": VERMILLION if unloading else BLUE, "lw": 1.4})
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    labelled(axes, words(figure["script"], "x")[0], words(figure["script"], "y")[0])
    above(axes, 3)
    return axes


def boxes(figure: Mapping[str, Any], ax: Any) -> Any:
    """The loops as boxes in length and mobilised friction; below, friction of both directions, loop by loop."""
    data = figure["data"]
    panels = sum(name.startswith("in_") for name in data)
    axes = new_axes(figure, ax, 1 + panels, [1.6, *[1] * panels])
    box = axes[0]
    box.plot(*columns_of(data["path"]), color="#B4B4B4", lw=0.4)
    for name, look, label in (("in", {"color": BLUE, "ms": 1.2}, "In: $q = \\mu$"), ("out", {"color": VERMILLION, "ms": 1.2}, "Out: $q = -\\mu$"),
                              ("stuck", {"color": "black", "ms": 1.8, "mfc": "none", "mew": 0.6}, "Stuck")):
        box.plot(*columns_of(data[name]), "o", **look, label=label)
    box.axhline(0, color="black", lw=0.75)
    top = number_after(figure["script"], "set yrange [-")
    box.set_ylim(-top, top)
    lengths, frictions = words(figure["script"], "x"), words(figure["script"], "y")
    labelled(box, lengths[-1] if panels == 0 else "", frictions[0])
    for k, each in enumerate(axes[1:], 1):
        for name, colour in ((f"in_{k}", BLUE), (f"out_{k}", VERMILLION)):
            x, mu, error = columns_of(data[name])
            each.fill_between(x, mu - 1.96 * error, mu + 1.96 * error, color=colour, alpha=0.2, lw=0)
            each.plot(x, mu, "o", color=colour, ms=1.2)
        each.plot(*columns_of(data["profile"]), color="black", lw=0.9, label="All loops")
        each.set_ylim(0, top)
        if panels > 1:
            each.annotate(f"loop {k}", (0.985, 0.86), xycoords="axes fraction", ha="right", va="top", fontsize=7)
        labelled(each, lengths[-1] if k == panels else "", frictions[1])
    most = number_after(figure["script"], "set xrange [0:")
    for each in axes:
        each.set_xlim(0, most)
    above(box, 3)
    return axes
