#!/usr/bin/env python3
"""Writes docs/crowd_cost.md and its charts from the CSV files of the program `crowd`: crowd.csv and, if they are there, tray.csv and
threads.csv.

usage: plot_crowd.py RESULTS DOCS
"""
import csv
import os
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

from chart_data import OURS  # noqa: E402
from plot_chart import INK, label, save, style, with_prefix  # noqa: E402

SCENES = {"gas": "gas: elastic, 1 % of the room, no gravity", "crowd": "crowd: falling for 1 s, e = 0.8 and 0.9"}
ENOUGH = 1000  # balls, from which on memory is mostly theirs


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        lines = file.readlines()
    about = dict(line[2:].strip().split(": ", 1) for line in lines if line.startswith("#"))
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    for row in rows:
        row.setdefault("threads", "1")  # older files have no such column,
        row["cores"] = row.get("cores") or ""  # or rows
        for key, value in row.items():
            if key not in ("scene", "engine", "variant", "hash", "cores"):
                row[key] = float(value)
    return about, rows


def read_if_there(path):
    return read(path) if os.path.exists(path) else None


def lines_of(rows, scene, threads=1.0):
    lines = {}
    for row in rows:
        if row["scene"] == scene and row["threads"] == threads and row["done"]:
            lines.setdefault((row["engine"], row["variant"], row["step"]), []).append(row)
    return lines


def name(line):
    text = label(line[:2]).replace(", default", "")
    return text if line[2] == 0.0 else f"{text}, {with_prefix(line[2], 's')}"


def look(line):
    chosen = style(line[:2])
    if line[0] != OURS:
        chosen["linestyle"] = "-" if line[2] < 2e-3 else "--"
    return chosen


def axes_of(axis, title, unit):
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.set_title(title, loc="left", fontsize=11, color=INK)
    axis.set_xlabel("balls")
    axis.yaxis.set_major_formatter(lambda y, _: with_prefix(y, unit) if y > 0.0 else "0")
    axis.yaxis.set_minor_formatter(lambda y, _: "")


def draw_cost(axis, rows, scene):
    for line, points in lines_of(rows, scene).items():
        axis.plot([p["balls"] for p in points], [1e-6 * p["cost_us"] for p in points], label=name(line), **look(line))
    costs = [1e-6 * p["cost_us"] for points in lines_of(rows, scene).values() for p in points]
    axis.plot([1.0, 1e6], [1.0, 1e-6], color=INK, linewidth=1.0, linestyle=":", label="real time on one core")
    axes_of(axis, SCENES[scene], "s")
    axis.set_ylim(0.5 * min(costs), 3.0 * max(costs))
    axis.set_xlim(0.8, 1.3e5)
    axis.set_ylabel("cost of a ball and simulated second")


def draw_memory(axis, rows):
    for line, points in lines_of(rows, "gas").items():
        shown = [p for p in points if p["balls"] >= ENOUGH]
        axis.plot([p["balls"] for p in shown], [p["bytes"] for p in shown], **look(line))
    axes_of(axis, "gas: memory of a ball, at the peak", "B")
    axis.yaxis.set_major_formatter(lambda y, _: f"{1e-3 * y:g} kB")
    axis.set_xlim(0.8 * ENOUGH, 1.3e5)
    axis.set_ylabel("memory of a ball")


def draw_contacts(axis, rows):
    for scene, filled in (("gas", True), ("crowd", False)):
        for line, points in lines_of(rows, scene).items():
            if line[0] != OURS:
                continue
            shown = [p for p in points if p["contacts"] > 0.0]
            chosen = {**look(line), "markersize": 6}
            if not filled:
                chosen.update(markerfacecolor="none", markeredgewidth=1.2, linestyle="--")
            axis.plot([p["balls"] for p in shown], [1e-6 * p["cost_us"] / p["contacts"] for p in shown],
                      label=f"{name(line)}, {scene}", **chosen)
    axes_of(axis, "cost of an impact, on walls and balls", "s")
    axis.set_ylabel("cost of an impact")
    axis.set_ylim(top=4e-4)  # the legend is above all lines
    axis.legend(fontsize=9, ncol=2, loc="upper center")


def draw(rows, docs):
    figure, axes = plt.subplots(2, 2, figsize=(11, 9))
    draw_cost(axes[0][0], rows, "gas")
    draw_cost(axes[0][1], rows, "crowd")
    draw_memory(axes[1][0], rows)
    draw_contacts(axes[1][1], rows)
    handles, names = axes[0][0].get_legend_handles_labels()
    axes[1][0].set_ylim(top=4e5)
    axes[1][0].legend(handles, names, fontsize=9, ncol=2, loc="upper center")
    save(figure, docs, "crowd.svg")


def gains(rows, scene):
    """What two threads gain: for each line of ours, balls and the ratio of costs."""
    alone = {(line, p["balls"]): p for line, points in lines_of(rows, scene).items() for p in points}
    for line, points in lines_of(rows, scene, 2.0).items():
        pairs = [(p, alone[line, p["balls"]]) for p in points if (line, p["balls"]) in alone]
        if pairs:
            yield line, [(p["balls"], one["cost_us"] / p["cost_us"]) for p, one in pairs]


def draw_threads(rows, docs):
    figure, axis = plt.subplots(figsize=(6, 4.2))
    for scene, filled in (("gas", True), ("crowd", False)):
        for line, points in gains(rows, scene):
            chosen = {**look(line), "markersize": 6}
            if not filled:
                chosen.update(markerfacecolor="none", markeredgewidth=1.2, linestyle="--")
            axis.plot([p[0] for p in points], [p[1] for p in points], label=f"{name(line)}, {scene}", **chosen)
    axis.axhline(2.0, color=INK, linewidth=1.0, linestyle=":")
    axis.set_xscale("log")
    axis.set_ylim(0.0, 2.2)
    axis.set_title("one thread / two threads: cost", loc="left", fontsize=11, color=INK)
    axis.set_xlabel("balls")
    axis.legend(fontsize=9)
    save(figure, docs, "crowd_threads.svg")


def threads_table(rows):
    text = ["| scene | engine | balls | cost with one thread / with two |", "| --- | --- | --- | --- |"]
    for scene in SCENES:
        for line, points in gains(rows, scene):
            text += [f"| {scene} | {name(line)} | {balls:.0f} | {gain:.2f} |" for balls, gain in points]
    return "\n".join(text)


def long_runs(about, rows):
    """One thread, two, and one beside another world, of many runs; with near and with far processors."""
    text = ["| scene | balls | processors | runs | an impact, one thread | two threads | one / two | two worlds at once gain |", "| --- | --- | --- | --- | --- | --- | --- | --- |"]
    exact = (OURS, "exact", 0.0)
    for scene in SCENES:
        for cores, where in (("near", "on one chip"), ("far", "on two")):
            mine = [row for row in rows if row["cores"] == cores]
            ones, twos = (lines_of(mine, scene, n).get(exact, []) for n in (1.0, 2.0))
            for one, two, beside in zip(ones, twos, lines_of(mine, scene).get((OURS, "exact_with_companion", 0.0), [])):
                text.append(f"| {scene} | {one['balls']:.0f} | {where} | {two['runs']:.0f} | {one['cost_us'] / one['contacts']:.3g} µs | {two['cost_us'] / two['contacts']:.3g} µs | "
                            f"{one['cost_us'] / two['cost_us']:.2f} | {2.0 * one['cost_us'] / beside['cost_us']:.2f} |")
    return f"""What two processors of this machine gain at most, two worlds tell that share nothing and move on at the same time, with a thread each: on cores of their own they do twice as much as one.
The system lets our two run on one chip, where a line of the cache takes some 50 ns from one to the other, or on two, where it takes 200 to 250 ns, and moves them at times. `scripts/crowd --threads` runs `exact`
with one thread, with two, and beside another world in turn, two hundred times, and looks at that way before and after each run; a run counts for where it began and ended:

{chr(10).join(text)}

Commit {about.get("commit", "?")}, load of the machine at the start {about.get("load", "?")}.

"""


def size(length):
    return "0" if length == 0.0 else f"{1e3 * length:.2g} mm" if length >= 1e-5 else f"{length:.0e} m"


def share(change):
    return f"{change:+.0e}" if abs(change) < 1e-3 else f"{100.0 * change:+.1f} %"


def table(rows, scene, balls):
    text = ["| engine | cost of a ball and simulated second | times real time | simulated | energy | deepest overlap | escaped |",
            "| --- | --- | --- | --- | --- | --- | --- |"]
    for line, points in lines_of(rows, scene).items():
        for p in points:
            if p["balls"] != balls:
                continue
            text.append(f"| {name(line)} | {p['cost_us']:.3g} µs | {1e6 / (p['cost_us'] * balls):.2g} | {p['simulated_s']:.2g} s | {share(p['energy_change'])} | "
                        f"{size(p['overlap_m'])} | {p['escaped']:.0f} |")
    return "\n".join(text)


def seconds(time):
    return f"{time:.2g} s" if time >= 0.0 else "not"


def tray_table(rows, balls):
    text = ["| engine | wall time of a simulated second | of the costliest | simulated | runs | deepest overlap | escaped | at rest after |",
            "| --- | --- | --- | --- | --- | --- | --- | --- |"]
    for threads, line, points in [(n, *its) for n in (1.0, 2.0) for its in lines_of(rows, "tray", n).items()]:
        for p in points:
            if p["balls"] != balls:
                continue
            wall = 1e-6 * p["cost_us"] * balls
            # A run that was cut short may not have a whole second.
            worst = f"{1e-6 * p['most_cost_us'] * balls:.2g} s" if p["most_cost_us"] > 0.0 else ""
            text.append(f"| {name(line)}{', two threads' if threads > 1.0 else ''} | {wall:.2g} s | {worst} | {p['simulated_s']:.2g} s | {p['runs']:.0f} | {size(p['overlap_m'])} | {p['escaped']:.0f} | "
                        f"{seconds(p['rest_after_s'])} |")
    return "\n".join(text)


def others(about):
    """Where rows of others were kept: at which commit those were measured."""
    return f" (others at {about['others']})" if "others" in about else ""


def undone(rows):
    names = [name((p["engine"], p["variant"], p["step"])) for p in rows if p["scene"] == "tray" and not p["done"]]
    return f"Not even a quarter of a second in a minute: {'; '.join(names)}.\n\n" if names else ""


def tray_section(about, rows):
    counts = [p["balls"] for points in lines_of(rows, "tray").values() for p in points]
    if not counts:
        return ""
    balls = 10000.0 if 10000.0 in counts else max(counts)
    return f"""## A tray is filled

{balls:.0f} balls fall into a tray and come to rest ten layers deep; e = 0.8, friction 0.3. "At rest": no ball is faster than 10 mm/s from then on.
A run that would take more than a minute is cut short, after a quarter of a simulated second or more: its cost is that of the fall, before balls lie on each other. Shorter runs were repeated. `scripts/crowd --tray --peers` measures this table alone.

{tray_table(rows, balls)}

{undone(rows)}Commit {about.get("commit", "?")}{others(about)}, load of the machine at the start {about.get("load", "?")}.

"""


def ours_table(rows, scene):
    text = ["| balls | start | cost of a ball and simulated second | impacts of a ball and second | cost of an impact | memory of a ball | deepest overlap |",
            "| --- | --- | --- | --- | --- | --- | --- |"]
    for p in lines_of(rows, scene).get((OURS, "exact", 0.0), []):
        memory = f"{p['bytes']:.0f} B" if p["balls"] >= ENOUGH else ""
        impact = f"{p['cost_us'] / p['contacts']:.2g} µs" if p["contacts"] > 0.0 else ""
        text.append(f"| {p['balls']:.0f} | {with_prefix(float(format(p['start_s'], '.2g')), 's')} | {p['cost_us']:.3g} µs | {p['contacts']:.3g} | {impact} | {memory} | "
                    f"{size(p['overlap_m'])} |")
    return "\n".join(text)


def most(rows, scene):
    shown = [p["balls"] for points in lines_of(rows, scene).values() for p in points]
    return max((n for n in (10000.0, 3162.0, 1000.0) if shown.count(n) > 1), default=1000.0)


def write_page(about, rows, tray, long, docs):
    text = f"""# Crowds: cost against the number of balls

<!-- Written by scripts/crowd from the output of `crowd`. Change scripts/plot_crowd.py, not this page. -->

The scenes `crowd`, `gas` and `pour` hold 1000 balls each, or as many as one asks for:

```
scripts/play scene:=crowd balls:=3000 seed:=2
simulate config/scenes/gas.yaml --duration 10 --balls 10000 > states.csv
```

![The scene `crowd` in RViz](crowd.png)

The rooms of `crowd` and `gas` grow with the number, so that any number meets the same conditions: that is what the chart needs. [physics.md](physics.md#crowds-as-a-gas)
holds `gas` against kinetic theory; [ros.md](ros.md#topics) says what RViz is told of a crowd.

## The chart

`scripts/crowd --peers` measures and writes this page. Every point is a process of its own, each of its threads on a processor of its own, ticks of 10 ms, no output. All points are run
in turn, up to eight times if a run takes less than a quarter of a minute; every run of a point does the same work, and of each tick the least time counts: others on the machine can only add to it.
A line ends where a run would take more than a minute. Dotted: what a core can carry in real time. Others with their default settings, at steps of 5 ms (broken lines) and 1 ms.

![Cost, memory and impacts against the number of balls](chart/crowd.svg)

`exact`, gas:

{ours_table(rows, "gas")}

`exact`, crowd:

{ours_table(rows, "crowd")}

Memory is the peak of the whole process less what it held before the engine was made: the scene, 160 B a ball, which ours shares with
whoever has loaded it, and the list of states to look at. Of few balls it is that of the process. "start" is from the scene to the first tick.

## Threads

![What two threads gain](chart/crowd_threads.svg)

{threads_table(rows)}

The result is the same, bit by bit, in every run. Both threads need a core at the same time, and cores that are near each other; where the machine gives
parts of its cores to others, as the one below does, that is rare, and what is shown is the least that two threads gain. [crowds.md](crowds.md#threads) says how the work is shared.

{long}## Soundness beside cost

Gas, {most(rows, "gas"):.0f} balls. An elastic gas keeps its energy; what others show is what their contacts add or take.

{table(rows, "gas", most(rows, "gas"))}

Crowd, {most(rows, "crowd"):.0f} balls, after a second. Here energy is lost in impacts: `exact` says how much.

{table(rows, "crowd", most(rows, "crowd"))}

A ball is 40 mm wide.

{tray}{about.get("machine", "?")}, {about.get("compiler", "?")}, commit {about.get("commit", "?")}{others(about)}. Load of the
machine at the start: {about.get("load", "?")}.
"""
    with open(os.path.join(docs, "crowd_cost.md"), "w", encoding="utf-8") as file:
        file.write(text)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    results, docs = sys.argv[1:]
    about, rows = read(os.path.join(results, "crowd.csv"))
    tray = read_if_there(os.path.join(results, "tray.csv")) or (about, rows)
    long = read_if_there(os.path.join(results, "threads.csv"))
    draw(rows, docs)
    draw_threads(rows, docs)
    write_page(about, rows, tray_section(*tray), long_runs(*long) if long else "", docs)


if __name__ == "__main__":
    main()
