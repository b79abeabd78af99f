"""Figures of equilibria and of surfaces."""
from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from ._plots import BLUE, GREEN, GREY, ORANGE, VERMILLION, above, columns_of, labelled, new_axes, number_after, words

_DARK = "#404040"


def equilibrium(figure: Mapping[str, Any], ax: Any) -> Any:
    """The curve of loading."""
    data = figure["data"]
    axes = new_axes(figure, ax, 1)[0]
    axes.plot(*columns_of(data["beam"])[:2], "--", color=ORANGE, label="Euler–Bernoulli")
    axes.plot(*columns_of(data["frictionless"])[:2], color=ORANGE, label="No friction")
    axes.plot(*columns_of(data["curve"])[:2], color=_DARK, lw=1.3, label="Equilibrium curve")
    axes.set_xlim(0, number_after(figure["script"], "set xrange [0:"))
    axes.set_ylim(0, number_after(figure["script"], "set yrange [0:"))
    labelled(axes, words(figure["script"], "x")[0], words(figure["script"], "y")[0])
    above(axes, 2)
    return axes


def region(figure: Mapping[str, Any], ax: Any) -> Any:
    """All equilibria, in three planes."""
    data = figure["data"]
    axes = new_axes(figure, ax, 3)
    inside, curve, locus = (columns_of(data[name]) for name in ("region", "curve", "locus"))
    for each, x, y in ((axes[0], 0, 1), (axes[1], 2, 0), (axes[2], 2, 1)):
        each.fill(inside[x], inside[y], color="#E2E2E2", lw=0)
        each.plot(curve[x], curve[y], color=_DARK, lw=1.3)
        each.set_ylim(bottom=0)
    axes[0].plot(locus[0], locus[1], "--", color="black", lw=1)
    for x, y, step_x, step_y in zip(*columns_of(data["arrows"])):
        axes[0].annotate("", (x + step_x, y + step_y), (x, y), arrowprops={"arrowstyle": "-|>", "color": "black", "lw": 0.8})
    axes[0].set_xlim(left=0)
    (deflection, length), (force, other) = words(figure["script"], "x")[:2], words(figure["script"], "y")[:2]
    for each, abscissa, ordinate in ((axes[0], deflection, force), (axes[1], length, other), (axes[2], length, force)):
        labelled(each, abscissa, ordinate)
    return axes


def surface(figure: Mapping[str, Any], ax: Any) -> Any:
    """Heights along a surface, the friction they predict, and their spectrum."""
    data, script = figure["data"], figure["script"]
    predicted = bool(np.isfinite(columns_of(data["friction"])[1]).any())
    axes = new_axes(figure, ax, 3 if predicted else 2, [1.2, 1, 1.6] if predicted else [1.2, 1.6], shared=False)
    lengths, ups = words(script, "x"), words(script, "y")
    axes[0].plot(*columns_of(data["heights"]), color=BLUE, lw=0.7, label="Surface")
    if np.isfinite(columns_of(data["edge"])[1]).any():
        radius = re.search(r"title '(Path of an edge of [^']*)'", script)
        axes[0].plot(*columns_of(data["edge"]), color=VERMILLION, lw=0.9, label=radius.group(1) if radius else "Path of the edge")
    along = lengths[0]
    labelled(axes[0], along, ups[0])
    above(axes[0], 3)
    if predicted:
        axes[1].plot(*columns_of(data["friction"]), color=GREEN, lw=0.7)
        axes[1].axhline(number_after(script, "rgb green notitle, "), ls="--", color="black", lw=0.8)
        labelled(axes[1], along, ups[1])
        axes[1].set_xlim(axes[0].get_xlim())
    lower = axes[-1]
    wavelength, density, low, high, smooth = columns_of(data["spectrum"])
    lower.fill_between(wavelength, low, high, color=BLUE, alpha=0.22, lw=0, label="95 %")
    lower.plot(wavelength, density, color=BLUE, lw=0.9, label="Spectrum")
    lower.plot(wavelength, smooth, "--", color="black", label="Smooth part")
    waves = columns_of(data["waves"])
    if np.isfinite(waves[1]).any():
        lower.plot(*waves, "o", mfc="none", color=VERMILLION, ms=6, mew=1.1, label="Waves")
    noise = re.search(r"\n *([0-9.e+-]+) with lines[^\n]* title 'Noise'", script)
    if noise:
        lower.axhline(float(noise.group(1)), ls=":", color="black", lw=0.75, label="Noise")
    band = re.search(r"from ([0-9.e+-]+), graph 0 to ([0-9.e+-]+), graph 1", script)
    if band:
        lower.axvspan(float(band.group(1)), float(band.group(2)), color=GREY, alpha=0.1, lw=0)
    lower.set_xscale("log")
    lower.set_yscale("log")
    limits = re.findall(r"set yrange \[([0-9.e+-]+):([0-9.e+-]+)\]", script)[-1]
    lower.set_ylim(float(limits[0]), float(limits[1]))
    labelled(lower, lengths[-1], ups[-1])
    lower.legend(loc="upper left")
    return axes
