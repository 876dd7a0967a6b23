#!/usr/bin/env python3
"""Draws the work-precision charts from the CSV files of `chart` and fills the generated parts of speed_accuracy.md.

usage: plot_chart.py RESULTS DOCS
"""
import os
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter, NullLocator  # noqa: E402

from chart_data import LEAST, OURS, front, read_scenes  # noqa: E402
from chart_page import write_page  # noqa: E402

INK = "#7a7a7a"  # readable on white and on black
# Okabe and Ito, "Color universal design", 2008; without the two that vanish on white or on black. Blue is a little lighter: as
# far from black as from white.
BLUE, ORANGE, GREEN, RED, SKY, PURPLE = "#0a7cc4", "#e69f00", "#009e73", "#d55e00", "#56b4e9", "#cc79a7"
# Ours: full markers and lines. Others: open markers, thin lines, broken for default settings.
OUR_STYLES = {"exact": (BLUE, "o"), "auto": (BLUE, "*"), "euler_explicit": (RED, "v"), "euler_semi_implicit": (ORANGE, "^"),
              "verlet": (PURPLE, "p"), "rk4": (SKY, "s"), "rk4_located": (GREEN, "D"), "impulse": (INK, "P")}
PEER_STYLES = {"bullet": (ORANGE, "s"), "ode": (GREEN, "D"), "dart": (PURPLE, "^"), "mujoco": (RED, "v"), "simbody": (SKY, "o")}
PEER_NAMES = {"bullet": "Bullet", "ode": "ODE", "dart": "DART", "mujoco": "MuJoCo", "simbody": "Simbody"}
OVERVIEW = ["bouncing", "spin_bounce"]
ERROR_NAMES = {"position": "position error, rms", "energy": "relative energy error, rms", "overlap": "overlaps, root of the mean sum of squares"}
HEADROOM = 10.0 ** 1.6  # of failures, above the largest error

plt.rcParams.update({
    "svg.hashsalt": "ping_pong_sim", "svg.fonttype": "none", "font.size": 11, "font.family": "sans-serif",
    "text.color": INK, "axes.labelcolor": INK, "axes.edgecolor": INK, "xtick.color": INK, "ytick.color": INK,
    "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "grid.color": INK, "grid.alpha": 0.25,
    "savefig.transparent": True, "legend.frameon": False, "figure.constrained_layout.use": True,
})


def with_prefix(value, unit):
    for factor, prefix in [(1.0, ""), (1e-2, "c"), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"), (1e-12, "p"), (1e-15, "f")]:
        if prefix == "c" and (unit != "m" or value < 0.00999):
            continue
        if value >= 0.999 * factor:
            return f"{value / factor:g} {prefix}{unit}"
    return f"{value:.0e} {unit}"


def style(line):
    engine, variant = line
    if engine == OURS:
        color, marker = OUR_STYLES.get(variant, (INK, "X"))
        wide = variant in ("exact", "auto")
        return {"color": color, "marker": marker, "linewidth": 2.6 if wide else 1.8, "markersize": 7 if wide else 6,
                "markeredgewidth": 0.0, "zorder": 5 if wide else 4, "linestyle": "-"}
    color, marker = PEER_STYLES.get(engine, (INK, "X"))
    return {"color": color, "marker": marker, "linewidth": 1.0, "markersize": 6, "markerfacecolor": "none", "zorder": 3,
            "linestyle": "--" if variant == "default" else "-"}


def label(line):
    engine, variant = line
    return variant if engine == OURS else f"{PEER_NAMES.get(engine, engine)}, {variant}"


def decades(low, high, every=1):
    first = next(k for k in range(-30, 30) if 10.0 ** k >= 0.999 * low)
    return [10.0 ** k for k in range(first, 30, every) if 10.0 ** k <= 1.001 * high]


def scale_axes(axis, scene):
    costs = [p.cost for p in scene.points if p.measured]
    errors = [max(p.error, LEAST) for p in scene.points if p.good]
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.set_xlim(min(costs) / 2.0, max(max(costs) * 2.0, min(costs) * 20.0))
    low, high = min(errors) / 4.0, max(max(errors), min(errors) * 1e6) * HEADROOM
    axis.set_ylim(low, high)
    axis.xaxis.set_major_locator(FixedLocator(decades(*axis.get_xlim())))
    axis.xaxis.set_major_formatter(FuncFormatter(lambda x, _: with_prefix(x, "s")))
    spread = [k for k in range(-18, 3) if low <= 10.0 ** k <= high / HEADROOM * 1.01]
    if scene.measure == "energy":
        ticks = [10.0 ** k for k in spread if k % 3 == 0]
        axis.yaxis.set_major_formatter(FuncFormatter(lambda y, _: f"{y:g}"))
    else:
        ticks = [10.0 ** k for k in spread if k % 3 == 0 or k == -2]
        axis.yaxis.set_major_formatter(FuncFormatter(lambda y, _: with_prefix(y, "m")))
    axis.yaxis.set_major_locator(FixedLocator(ticks))
    for which in (axis.xaxis, axis.yaxis):
        which.set_minor_locator(NullLocator())
        which.set_minor_formatter(NullFormatter())
    return high


def draw_front(axis, scene):
    points = front(scene.points)
    x, y = [], []
    for before, after in zip(points, points[1:] + [None]):
        x += [before.cost] + ([after.cost] if after else [])
        y += [max(before.error, LEAST)] * (2 if after else 1)
    axis.plot(x, y, color=INK, alpha=0.28, linewidth=6, solid_capstyle="butt", solid_joinstyle="round", zorder=1)


def draw_failures(axis, scene, top):
    """In a band at the top edge, one row for each engine or method that fails."""
    rows = [line for line, points in scene.lines().items() if any(p.measured and p.failures for p in points)]
    for k, line in enumerate(rows):
        part = 0.05 + 0.55 * (k / max(1, len(rows) - 1)) if len(rows) > 1 else 0.2
        height = top / HEADROOM ** part
        failed = [p.cost for p in scene.lines()[line] if p.measured and p.failures]
        look = style(line)
        axis.plot(failed, [height] * len(failed), linestyle="", marker="x", markersize=7, markeredgewidth=2.0,
                  color=look["color"], zorder=6, clip_on=False)
    axis.axhline(top / HEADROOM ** 0.72, color=INK, linewidth=0.8, linestyle=":")


def takes_tolerance(line):
    return line[0] == OURS and line[1] in ("exact", "auto")


def draw_line(axis, line, good):
    look = style(line)
    axis.plot([p.cost for p in good], [max(p.error, LEAST) for p in good], **look)
    millisecond = [p for p in good if abs(p.step - 1e-3) < 1e-9 and not takes_tolerance(line)]
    look.update(linestyle="", markersize=11)
    axis.plot([p.cost for p in millisecond], [max(p.error, LEAST) for p in millisecond], **look)


def label_ends(axis, line, good):
    """Names of our lines, and the tolerances at the ends of `exact`."""
    if not takes_tolerance(line):
        return
    notes = [(good[0], f" {line[1]}")] if len(good) == 1 else [(p, f" {with_prefix(p.step, 'm')}") for p in (good[0], good[-1])]
    for point, text in notes:
        axis.annotate(text, (point.cost, max(point.error, LEAST)), xytext=(7, 0), textcoords="offset points", va="center",
                      fontsize=10, color=style(line)["color"], zorder=7)


def draw_scene(axis, scene):
    top = scale_axes(axis, scene)
    draw_front(axis, scene)
    for line, points in scene.lines().items():
        good = sorted((p for p in points if p.good), key=lambda p: -p.step)
        if good:
            draw_line(axis, line, good)
            label_ends(axis, line, good)
    draw_failures(axis, scene, top)
    axis.set_title(scene.title, loc="left", fontsize=12, color=INK)
    axis.set_xlabel("cost of a ball and simulated second")
    axis.set_ylabel(ERROR_NAMES[scene.measure])


def legend_entries(scenes):
    lines = list(dict.fromkeys(line for scene in scenes for line in scene.lines() if any(p.measured for p in scene.lines()[line])))
    lines.sort(key=lambda line: (line[0] != OURS, line != (OURS, "exact") and line[0] == OURS))
    entries = [(Line2D([], [], **{**style(line), "zorder": 1}), label(line)) for line in lines]
    entries.append((Line2D([], [], color=INK, alpha=0.28, linewidth=6), "Pareto front"))
    entries.append((Line2D([], [], color=INK, linestyle="", marker="o", markersize=11), "large: step of 1 ms"))
    entries.append((Line2D([], [], color=INK, linestyle="", marker="x", markersize=7, markeredgewidth=2), "fails"))
    return entries


def save(figure, docs, name):
    os.makedirs(os.path.join(docs, "chart"), exist_ok=True)
    figure.savefig(os.path.join(docs, "chart", name), metadata={"Date": None})
    plt.close(figure)


def draw_one(scene, docs):
    figure, axis = plt.subplots(figsize=(9, 5.2))
    draw_scene(axis, scene)
    handles, names = zip(*legend_entries([scene]))
    axis.legend(handles, names, loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=10)
    save(figure, docs, scene.name + ".svg")


def draw_overview(scenes, docs):
    shown = [scene for name in OVERVIEW for scene in scenes if scene.name == name]
    if len(shown) < len(OVERVIEW):
        return
    entries = legend_entries(shown)
    rows = (len(entries) + 4) // 5
    figure, axes = plt.subplots(2, len(shown), figsize=(11, 4.5 + 0.22 * rows), height_ratios=[4.5, 0.22 * rows])
    for axis, scene in zip(axes[0], shown):
        draw_scene(axis, scene)
    axes[0][1].set_ylabel("")
    below = figure.add_subplot(axes[1][0].get_gridspec()[1, :])
    for axis in [*axes[1], below]:
        axis.axis("off")
    handles, names = zip(*entries)
    below.legend(handles, names, loc="center", ncol=5, fontsize=10)
    save(figure, docs, "overview.svg")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    results, docs = sys.argv[1:]
    scenes = read_scenes(results)
    for scene in scenes:
        scene.check_reference()
        draw_one(scene, docs)
    draw_overview(scenes, docs)
    write_page(scenes, docs)


if __name__ == "__main__":
    main()
