"""The report's figures, drawn with matplotlib from the data that the report draws."""
from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ._errors import one_of, wrong

# Colours that all can tell apart (Okabe and Ito), as in the report.
BLUE, SKY, GREEN, ORANGE, VERMILLION, BROWN, GREY = "#0072B2", "#56B4E9", "#009E73", "#E69F00", "#D55E00", "#8C510A", "#8C8C8C"
_MM = 1 / 25.4
_SMALL = {"font.size": 8, "axes.labelsize": 8, "legend.fontsize": 7, "xtick.labelsize": 7, "ytick.labelsize": 7, "axes.linewidth": 0.6,
          "xtick.direction": "in", "ytick.direction": "in", "lines.linewidth": 1.0, "legend.frameon": False}

Columns = Mapping[str, Any]


def plot(figures: Sequence[Mapping[str, Any]], name: str | None, ax: Any) -> Any:
    """Draws one of the figures; gives its axes."""
    names = [figure["name"] for figure in figures]
    if not names:
        raise ValueError("there is no figure: the test has no answer to draw")
    if name is None:
        name = names[0]
    one_of("figure", name, names)
    figure = figures[names.index(name)]
    import matplotlib

    with matplotlib.rc_context(_SMALL):
        return _drawing_of(name, figure["data"])(figure, ax)


def _drawing_of(name: str, data: Mapping[str, Columns]) -> Any:
    if name.startswith("atlas"):
        return _atlas
    if name == "measured":
        return _cycles if "loading" in data else _measured
    if "border" in data:
        return _map
    if "designs" in data:
        return _over
    from . import _cycle_plots, _model_plots

    return {"teeth": _cycle_plots.teeth, "loops": _cycle_plots.loops, "boxes": _cycle_plots.boxes, "equilibrium": _model_plots.equilibrium,
            "region": _model_plots.region, "surface": _model_plots.surface, "force": _force, "record": _record, "profile": _profile, "wavelengths": _wavelengths, "design": _design,
            "distributions": _distributions}[name]


def new_axes(figure: Mapping[str, Any], ax: Any, count: int, heights: Sequence[float] | None = None, shared: bool = True) -> Any:
    """So many axes: those given, or those of a new figure of the report's size; with heights below each other, of one abscissa if that is shared."""
    if ax is not None:
        given = np.atleast_1d(np.asarray(ax, dtype=object)).ravel()
        if len(given) != count:
            raise wrong("ax", f"{count} axes" if count > 1 else "one Axes", f"{len(given)}")
        for each in given:
            if not hasattr(each, "plot"):
                raise TypeError(f"ax: expected matplotlib Axes, found {type(each).__name__}")
        return given
    import matplotlib.pyplot as plt

    size = (figure["width"] * _MM, figure["height"] * _MM)
    if heights:
        _, axes = plt.subplots(count, 1, figsize=size, sharex=shared, gridspec_kw={"height_ratios": heights, "hspace": 0.08},
                               layout="constrained")
    else:
        _, axes = plt.subplots(1, count, figsize=size, layout="constrained")
    axes = np.atleast_1d(axes)
    axes[0].figure.flexslip = True
    return axes


def columns_of(data: Columns) -> list[Any]:
    return list(data.values())


def _unit(title: str) -> str:
    """The unit in a column's title: "deflection [µm]"."""
    return title[title.rindex("[") + 1:-1] if title.endswith("]") else "1"


def labelled(axes: Any, x: str, y: str) -> None:
    axes.set_xlabel(x)
    axes.set_ylabel(y)


def above(axes: Any, columns: int) -> None:
    """The key, above axes of our own; in those of others where there is room."""
    if not getattr(axes.figure, "flexslip", False):
        axes.legend(loc="best")
        return
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1.0), ncols=columns, columnspacing=1.2, handlelength=1.8, borderaxespad=0.2)


def _force_and_deflection(axes: Any, measured: Columns) -> None:
    titles = list(measured)
    labelled(axes, f"Deflection at midspan $w_0$ ({_unit(titles[0])})", f"Force $F$ ({_unit(titles[1])})")


def _force(figure: Mapping[str, Any], ax: Any) -> Any:
    data = figure["data"]
    given = None if ax is None else np.atleast_1d(np.asarray(ax, dtype=object)).ravel()
    alone = given is not None and len(given) == 1
    axes = new_axes(figure, ax, 1 if alone else 2, None if alone else (2.6, 1))
    upper = axes[0]
    w, force, residual, seen = columns_of(data["measured"])
    upper.plot(w, force, "-o", color=BLUE, lw=0.6, ms=1.5, label="Measured")
    drops = columns_of(data["drops"])
    upper.plot(*drops, "--", color=GREY, lw=0.6, label="Drops, slope $-k_c$", zorder=1)
    x, euler, frictionless = columns_of(data["references"])
    upper.plot(x, euler, "--", color=ORANGE, label="Euler–Bernoulli")
    upper.plot(x, frictionless, color=ORANGE, label="Model without friction")
    upper.plot(*columns_of(data["sliding"]), color="black", lw=1.1, label="Mean of the fit")
    upper.plot(*columns_of(data["snaps"]), ":", color="black", label="Its snaps")
    upper.set_xlim(0, 1.02 * np.nanmax(w))
    upper.set_ylim(0, 1.05 * np.nanmax(force))
    above(upper, 3)
    _force_and_deflection(upper, data["measured"])
    if alone:
        return upper
    lower = axes[1]
    upper.set_xlabel("")
    lower.axhline(0, color="black", lw=0.6)
    lower.plot(np.where(seen == 1, w, np.nan), residual, "o", color=BLUE, ms=1.5)
    lower.plot(np.where(seen == 0, w, np.nan), residual, "o", color=GREY, ms=1.5)
    labelled(lower, f"Deflection at midspan $w_0$ ({_unit(list(data['measured'])[0])})", f"Residual ({_unit(list(data['measured'])[1])})")
    most = np.nanmax(np.abs(residual))
    lower.set_ylim(-1.05 * most, 1.05 * most)
    return axes


def _record(figure: Mapping[str, Any], ax: Any) -> Any:
    axes = new_axes(figure, ax, 1)[0]
    for name, columns in figure["data"].items():
        x, *ys = columns_of(columns)
        for title, y, look in zip(list(columns)[1:], ys, ("--", "-")):
            label = "Measured" if name == "measured" else title.split(" force")[0][:1].upper() + title.split(" force")[0][1:]
            axes.plot(x, y, "-o" if name == "measured" else look, color=BLUE if name == "measured" else ORANGE, ms=1.5, lw=0.8, label=label)
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    first = next(iter(figure["data"].values()))
    _force_and_deflection(axes, first)
    above(axes, 3)
    return axes


def _profile(figure: Mapping[str, Any], ax: Any) -> Any:
    data = figure["data"]
    axes = new_axes(figure, ax, 1)[0]
    x, mean, deviation = columns_of(data["band"])
    axes.fill_between(x, mean - 2 * deviation, mean + 2 * deviation, color="#909090", alpha=0.35, lw=0, label="Mean ± 2 deviations")
    axes.plot(x, mean, color="black", lw=1.1, label="Mean of the fit")
    axes.plot(*columns_of(data["wave"])[:2], color=ORANGE, lw=0.9, label="Wave")
    axes.plot(*columns_of(data["slips"])[:2], color=VERMILLION, lw=0.7, label="Slips")
    at, mu, error, _ = columns_of(data["profile"])
    axes.errorbar(at, mu, 1.96 * error, fmt="o", color=BLUE, ms=1.5, elinewidth=0.5, label="Measured, 95 %")
    imaged = columns_of(data["imaged"])
    axes.plot(imaged[0], imaged[1], "o", mfc="none", mec="#606060", ms=2, mew=0.5)
    axes.set_xlim(left=0)
    shown = mu[np.isfinite(mu)]
    if len(shown):
        axes.set_ylim(0, 1.15 * max(float(np.quantile(shown, 0.98)), float(np.nanmax(mean))))
    labelled(axes, f"Length drawn in over one support ({_unit(list(data['profile'])[0])})", "Coefficient of friction $\\mu$")
    above(axes, 5)
    return axes


def _wavelengths(figure: Mapping[str, Any], ax: Any) -> Any:
    data = figure["data"]
    axes = new_axes(figure, ax, 1)[0]
    axes.plot(*columns_of(data["likeliest"]), "--", color="black", label="the wave")
    axes.axhline(3, ls=":", color="black", lw=0.75, label="claimed above")
    axes.plot(*columns_of(data["gains"]), color=BLUE)
    axes.set_xscale("log")
    gains = columns_of(data["gains"])[1]
    axes.set_ylim(max(float(np.nanmin(gains)), -0.1 * float(np.nanmax(gains))) if np.nanmax(gains) > 0 else None, None)
    labelled(axes, f"Wavelength along the specimen $\\lambda$ ({_unit(list(data['gains'])[0])})", "Gain of log-evidence")
    above(axes, 2)
    return axes


def _measured(figure: Mapping[str, Any], ax: Any) -> Any:
    data = figure["data"]
    axes = new_axes(figure, ax, 1)[0]
    axes.plot(*columns_of(data["curve"])[:2], color="#BDBDBD", lw=1.6, label="Equilibrium curve")
    w, force = columns_of(data["measured"])[:2]
    axes.plot(w, force, color="black", lw=1.2, label="Measured curve")
    axes.plot(*columns_of(data["snaps"])[:2], "--", color="black", lw=0.8, label="Snaps")
    axes.set_xlim(0, 1.05 * np.nanmax(w))
    axes.set_ylim(0, 1.15 * np.nanmax(force))
    labelled(axes, f"Deflection $w_0$ ({_unit(list(data['curve'])[0])})", f"Force $F$ ({_unit(list(data['curve'])[1])})")
    above(axes, 2)
    return axes


def _cycles(figure: Mapping[str, Any], ax: Any) -> Any:
    data = figure["data"]
    axes = new_axes(figure, ax, 2)
    lines = (("limits", "#CFCFCF", "-", 2.2, "$q = \\pm\\mu$"), ("snaps", "black", "--", 0.8, "Snaps"), ("sticking_in", BLUE, ":", 1, "Sticking"),
             ("sticking_out", VERMILLION, ":", 1, None), ("loading", BLUE, "-", 1.5, "Loading"), ("unloading", VERMILLION, "-", 1.5, "Unloading"))
    for name, color, style, wide, label in lines:
        w, force, length, q = columns_of(data[name])
        axes[0].plot(w, force, style, color=color, lw=wide, label=label)
        axes[1].plot(length, q, style, color=color, lw=wide)
    loading = columns_of(data["loading"])
    most = max(float(np.nanmax(np.abs(columns_of(data[name])[3]), initial=0)) for name in ("loading", "unloading"))
    axes[0].set_xlim(0, 1.05 * np.nanmax(loading[0]))
    axes[0].set_ylim(0, 1.1 * np.nanmax(loading[1]))
    axes[1].set_ylim(-1.3 * most, 1.3 * most)
    titles = list(data["loading"])
    labelled(axes[0], f"Deflection $w_0$ ({_unit(titles[0])})", f"Force $F$ ({_unit(titles[1])})")
    labelled(axes[1], f"Length $S$ ({_unit(titles[2])})", "Mobilised friction $q$")
    above(axes[0], 3)
    return axes


def _design(figure: Mapping[str, Any], ax: Any) -> Any:
    data = figure["data"]
    axes = new_axes(figure, ax, 2)
    stage, force = columns_of(data["record"])
    axes[0].plot(stage, force, color="black", label="Record")
    axes[0].plot(*columns_of(data["drops"]), color=VERMILLION, lw=1.5, label="Drops")
    deflection, stiffness, at_stage, at_force = columns_of(data["first"])
    axes[0].plot(at_stage, at_force, "o", mfc="none", color=VERMILLION, ms=4, label="First snap")
    axes[0].plot(*columns_of(data["breaks"])[:2], "x", color="black", ms=5)
    w, fold, softest = columns_of(data["folds"])
    axes[1].fill_between(w, 0, np.maximum(np.nan_to_num(fold), 0), color=SKY, alpha=0.35, lw=0, label="Unstable")
    axes[1].plot(w, fold, color=BLUE, lw=0.8)
    axes[1].plot(w, softest, ":", color="black", lw=1.2, label="End of travel")
    axes[1].plot(deflection, stiffness, "o", mfc="none", color=VERMILLION, ms=4)
    for line, color, style, label in _levels(figure["script"]):
        axes[1].axhline(line, color=color, ls=style, lw=1.4, label=label)
    axes[0].set_xlim(left=0)
    axes[0].set_ylim(bottom=0)
    axes[1].set_xlim(left=0)
    axes[1].set_ylim(0, _range(figure["script"]))
    titles = words(figure["script"])
    labelled(axes[0], titles[0], titles[1])
    labelled(axes[1], titles[2], titles[3])
    above(axes[0], 3)
    above(axes[1], 2)
    return axes


def _in_math(text: str) -> str:
    """A label of the report, its symbols as matplotlib has them."""
    text = re.sub(r"\{/:Italic ([^}]*)\}_([0-9a-z])", r"$\1_\2$", text)
    text = re.sub(r"\{/:Italic ([^}]*)\}", r"$\1$", text)
    return text.replace("$μ", "$\\mu").replace("$λ", "$\\lambda")


def words(script: str, axes: str = "xy") -> list[str]:
    """The labels of axes in the order of a report's script."""
    return [_in_math(text) for _, text in re.findall(rf"set ([{axes}])label '([^']*)'", script)]


def number_after(script: str, begin: str) -> float:
    """The number that follows some words in a report's script."""
    at = script.index(begin) + len(begin)
    found = re.match(r"[0-9.e+-]+", script[at:])
    return float(found.group()) if found else float("nan")


def _levels(script: str) -> list[tuple[float, str, str, str]]:
    """Levels that a report's script draws: "90.65 with lines … title 'This load train'"."""
    looks = {"black": "black", "green": GREEN}
    return [(float(value), looks.get(color.strip("'"), GREY), "--" if "dt" in look else "-", title) for value, look, color, title in
            re.findall(r"^\s+([0-9.e+-]+) with lines(.*?)lc rgb (\S+) title '([^']*)'", script, re.M)]


def _range(script: str) -> float | None:
    ranges = re.findall(r"set yrange \[[^:]*:([0-9.e+-]+)\]", script)
    return float(ranges[-1]) if ranges else None


def _ticks(script: str, axis: str) -> list[tuple[str, float]]:
    """The ticks of a logarithmic axis, whose places are logarithms in the report's data."""
    found = re.search(rf"set {axis}tics \(('[^)]*)\)", script)
    return [(label, float(at)) for label, at in re.findall(r"'([^']*)' ([0-9.e+-]+)", found.group(1))] if found else []


def _with_ticks(axes: Any, script: str) -> None:
    for axis, put in (("x", axes.set_xticks), ("y", axes.set_yticks)):
        ticks = _ticks(script, axis)
        if ticks:
            put([at for _, at in ticks], [label for label, _ in ticks])


def _over(figure: Mapping[str, Any], ax: Any) -> Any:
    axes = new_axes(figure, ax, 2)
    at, largest, mean, friction, first = columns_of(figure["data"]["designs"])
    axes[0].plot(at, largest, color="black", lw=1.4, label="Largest drop")
    axes[0].plot(at, mean, "--", color="black", label="Mean drop")
    axes[0].plot(at, friction, color=VERMILLION, lw=1.4, label="Friction")
    axes[1].plot(at, first, "o", color=BLUE, ms=1.8)
    axes[0].set_ylim(bottom=0)
    axes[1].set_ylim(bottom=0)
    axes[1].set_xlim(axes[0].get_xlim())
    titles = words(figure["script"])
    labelled(axes[0], titles[0], titles[1])
    labelled(axes[1], titles[0], titles[2])
    for each in axes:
        _with_ticks(each, figure["script"])
    above(axes[0], 3)
    return axes


def _map(figure: Mapping[str, Any], ax: Any) -> Any:
    import matplotlib.colors

    axes = new_axes(figure, ax, 1)[0]
    x, y, drop = columns_of(figure["data"]["designs"])
    xs, ys = np.unique(x), np.unique(y)
    values = np.full((len(ys), len(xs)), np.nan)
    values[np.searchsorted(ys, y), np.searchsorted(xs, x)] = drop
    colours = matplotlib.colors.LinearSegmentedColormap.from_list(
        "drops", [(0, "#FFFFFF"), (0.005, "#EAF2F8"), (0.3, "#9CC9E6"), (0.65, "#2F83BE"), (1, "#08306B")])
    image = axes.pcolormesh(xs, ys, values, cmap=colours, vmin=0, shading="nearest", rasterized=True)
    axes.figure.colorbar(image, ax=axes, label="Largest drop (% of the greatest force)")
    axes.plot(*columns_of(figure["data"]["border"]), color=VERMILLION, lw=1.5, label="Border of snapping")
    axes.plot(*columns_of(figure["data"]["own"]), "o", color="black", ms=4, label="This test")
    titles = words(figure["script"])
    labelled(axes, titles[0], titles[1])
    _with_ticks(axes, figure["script"])
    above(axes, 2)
    return axes


_CATEGORIES = ("clear sawtooth", "nominal sawtooth", "almost no sawtooth")


def _distributions(figure: Mapping[str, Any], ax: Any) -> Any:
    axes = new_axes(figure, ax, 2)
    test, category, suspect, mu0, low, high, wave, wave_low, wave_high, claimed = columns_of(figure["data"]["tests"])
    marks = ("*", "^", "o")
    for k, (name, mark) in enumerate(zip(_CATEGORIES, marks)):
        chosen = category == k
        for values, bottom, top, each in ((wave, wave_low, wave_high, axes[0]), (mu0, low, high, axes[1])):
            each.plot(np.vstack([test[chosen]] * 2), np.vstack([bottom[chosen], top[chosen]]), color=GREY, lw=0.8)
            sure = chosen & (suspect == 0)
            if each is axes[0]:
                each.plot(test[sure & (claimed == 0)], values[sure & (claimed == 0)], mark, color=GREY, ms=4)
                sure = sure & (claimed == 1)
            each.plot(test[sure], values[sure], mark, color="black", ms=4, label=name if chosen.any() else None)
            doubtful = chosen & (suspect == 1)
            each.plot(test[doubtful], values[doubtful], "x", color=VERMILLION, ms=5)
    axes[0].plot([], [], "x", color=VERMILLION, ms=5, label="suspect")
    axes[0].plot([], [], "s", color=GREY, ms=3, label="wave only indicative")
    labelled(axes[0], "Test, in the order of the table", f"Wavelength $\\lambda$ ({_unit(list(figure['data']['tests'])[6])})")
    labelled(axes[1], "Test, in the order of the table", "Mean friction $\\mu_0$")
    axes[0].set_ylim(bottom=0)
    above(axes[0], 2)
    return axes


def _atlas(figure: Mapping[str, Any], ax: Any) -> Any:
    data = figure["data"]
    panels = {name: columns_of(columns)[0] for name, columns in data.items()}
    count = int(np.nanmax(panels["measured"]))
    names = re.findall(r"set label 4 '([^']*)'", figure["script"])
    if ax is None:
        import matplotlib.pyplot as plt

        wide = min(count, 4)
        rows = -(-count // wide)
        _, grid = plt.subplots(rows, wide, figsize=(figure["width"] * _MM * wide / 4, max(figure["height"], 45 * rows + 15) * _MM), layout="constrained",
                               squeeze=False)
        axes = grid.ravel()
        for spare in axes[count:]:
            spare.remove()
        axes = axes[:count]
    else:
        axes = new_axes(figure, ax, count)
    for panel, (each, name) in enumerate(zip(axes, names), 1):
        def of(which: str) -> list[Any]:
            # A row of NaN interrupts a line of the panel that it is in.
            columns = columns_of(data[which])
            chosen = (columns[0] == panel) | np.isnan(columns[0])
            return [np.where(columns[0][chosen] == panel, column[chosen], np.nan) for column in columns[1:]]
        each.plot(*of("drops"), "--", color=GREY, lw=0.6)
        x, euler, frictionless = of("references")
        each.plot(x, euler, "--", color=BROWN, lw=0.9)
        each.plot(x, frictionless, color=BROWN, lw=0.9)
        w, force = of("measured")
        each.plot(w, force, color=BLUE, lw=1.1)
        each.plot(*of("model"), color="black", lw=0.9)
        each.set_title(name, fontsize=8, loc="left")
        each.set_xlim(0, 1.05 * np.nanmax(w))
        each.set_ylim(0, 1.15 * np.nanmax(force))
    titles = list(data["measured"])
    axes[0].figure.supxlabel(f"Deflection at midspan $w_0$ ({_unit(titles[1])})", fontsize=8)
    axes[0].figure.supylabel(f"Force $F$ ({_unit(titles[2])})", fontsize=8)
    return axes
