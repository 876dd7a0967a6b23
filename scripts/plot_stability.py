#!/usr/bin/env python3
"""Writes docs/stability.md and its maps from the CSV files of the program `stability`.

usage: plot_stability.py RESULTS DOCS
"""
import csv
import math
import os
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

INK = "#7a7a7a"  # readable on white and on black
# Okabe and Ito, "Color universal design", 2008. Numbers in the cells say the same as the colours.
PASS, FAIL, LOST = "#0072b2", "#e69f00", "#d55e00"
ON = {PASS: "white", FAIL: "black", LOST: "black"}
FROM = [(0.0, "#0072b2", "white"), (0.001, "#f0e442", "black"), (0.25, "#e69f00", "black"), (0.75, "#d55e00", "black")]

plt.rcParams.update({
    "svg.hashsalt": "ping_pong_sim", "svg.fonttype": "none", "font.size": 10, "font.family": "sans-serif",
    "text.color": INK, "axes.labelcolor": INK, "xtick.color": INK, "ytick.color": INK, "xtick.bottom": False,
    "ytick.left": False, "savefig.transparent": True, "figure.constrained_layout.use": True,
})


def read(results, name):
    with open(os.path.join(results, name), newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def unique(values):
    return list(dict.fromkeys(values))


def save(figure, docs, name):
    os.makedirs(os.path.join(docs, "stability"), exist_ok=True)
    figure.savefig(os.path.join(docs, "stability", name), metadata={"Date": None})
    plt.close(figure)


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def step_name(step):
    seconds = float(step)
    whole = round(1.0 / seconds)
    if seconds > 1.1e-3 and whole % 60 == 0:
        return f"1/{whole} s"
    return f"{1e3 * seconds:g} ms"


def number(text):
    value = float(text)
    if not math.isfinite(value):
        return "lost"
    return "0" if value == 0.0 else f"{value:.0f}" if value >= 10.0 else f"{value:.2g}"


def color_of(row):
    if row["passes"] == "1":
        return PASS
    return FAIL if math.isfinite(float(row["value"])) else LOST


def tile(axis, column, line, color, text, ink):
    axis.add_patch(plt.Rectangle((column, line), 0.94, 0.9, color=color, linewidth=0))
    axis.text(column + 0.47, line + 0.46, text, ha="center", va="center", fontsize=8, color=ink)


def frame(axis, columns, column_names, lines, line_names):
    axis.set_xlim(0, columns)
    axis.set_ylim(lines, 0)
    axis.set_xticks([i + 0.47 for i in range(columns)], column_names)
    axis.set_yticks([i + 0.45 for i in range(lines)], line_names)
    axis.xaxis.tick_top()
    for side in axis.spines.values():
        side.set_visible(False)


# --- plots ---

def plot_map(rows, docs):
    cases = unique(row["case"] for row in rows)
    titles = {row["case"]: row["title"] for row in rows}
    columns = unique((row["method"], row["step_s"]) for row in rows)
    figure, axis = plt.subplots(figsize=(0.62 * len(columns) + 3.2, 0.29 * len(cases) + 1.0))
    for row in rows:
        color = color_of(row)
        tile(axis, columns.index((row["method"], row["step_s"])), cases.index(row["case"]), color, number(row["value"]), ON[color])
    steps = ["any" if method == "exact" else step_name(step) for method, step in columns]
    frame(axis, len(columns), steps, len(cases), [titles[case] for case in cases])
    for method in unique(method for method, _ in columns):
        own = [i for i, column in enumerate(columns) if column[0] == method]
        axis.text((own[0] + own[-1] + 0.94) / 2, -1.25, method, ha="center", va="bottom", fontweight="bold", fontsize=9)
    save(figure, docs, "map.svg")


def plot_shots(shots, docs):
    rows = [row for row in shots if row["method"] != "exact"]
    speeds = unique(row["speed_m_s"] for row in rows)
    steps = unique(row["step_s"] for row in rows)
    figure, axes = plt.subplots(1, 2, figsize=(10, 2.3), sharey=True)
    for axis, key, title in zip(axes, ["missed", "wrong_side"], ["flown through", "pushed out behind"]):
        for row in rows:
            part = float(row[key])
            _, color, ink = [entry for entry in FROM if part >= entry[0]][-1]
            tile(axis, speeds.index(row["speed_m_s"]), steps.index(row["step_s"]), color, f"{100 * part:.0f} %", ink)
        frame(axis, len(speeds), [f"{speed}\nm/s" for speed in speeds], len(steps), [step_name(step) for step in steps])
        axis.set_title(title, color=INK, fontsize=10)
    save(figure, docs, "tunnelling.svg")


# --- page ---

CONTACTS = {
    "floor_wall": "floor and wall", "groove": "V groove", "tray_corner": "corner of three faces", "tray": "tray",
    "flush": "flush faces", "nearly_flush": "nearly flush faces", "step": "step", "cylinder": "cylinders", "edge": "edge and corner",
    "blade": "blade and handle", "spheres": "spheres", "slope": "slope", "clutter": "heap of shapes", "moving": "tray that moves",
    "turning": "table that turns", "pushed": "wall that pushes over a floor",
}


def cell(rows):
    return "<br>".join(("" if row["passes"] == "1" else "✗ ") + number(row["value"]) for row in rows)


def percent(broken, scenes):
    return "0" if broken == 0 else f"{max(1, round(100 * broken / scenes))}"


def random_tables(random):
    """Part of the scenes, per cent: by kind of contact, and by what they break."""
    methods = unique(row["method"] for row in random)
    categories = unique(row["category"] for row in random)
    says = {row["check"]: row["says"] for row in random if row["check"] != "any"}
    of = {(row["method"], row["category"], row["check"]): (int(row["broken"]), int(row["scenes"])) for row in random}

    def share(method, chosen, check):
        counts = [of[method, category, check] for category in chosen if (method, category, check) in of]
        return percent(sum(broken for broken, _ in counts), sum(scenes for _, scenes in counts))

    head = [f"`{method}`" for method in methods]
    by_kind = table(["kind of contact"] + head,
                    [[CONTACTS[c]] + [share(m, [c], "any") for m in methods] for c in categories] +
                    [["all"] + [share(m, categories, "any") for m in methods]])
    broken = [check for check in says if any(share(m, categories, check) != "0" for m in methods)]
    by_check = table(["shall hold"] + head,
                     [[says[check]] + [share(m, categories, check) for m in methods] for check in broken])
    return by_kind, by_check, sum(of[methods[0], c, "any"][1] for c in categories)


def write_page(rows, shots, random, docs):
    cases = unique(row["case"] for row in rows)
    methods = unique(row["method"] for row in rows)
    of = {(case, method): [row for row in rows if (row["case"], row["method"]) == (case, method)] for case in cases for method in methods}
    first = {case: of[case, "exact"][0] for case in cases}
    numbers = table(["", "number"] + [f"`{method}`" for method in methods],
                    [[first[c]["title"], first[c]["measures"]] + [cell(of[c, m]) for m in methods] for c in cases])
    bounds = table(["", "passes up to", "why"],
                   [[first[c]["title"], number(first[c]["bound"]), first[c]["reason"]] for c in cases])
    passed = {m: sum(row["passes"] == "1" for c in cases for row in of[c, m]) for m in methods}
    total = {m: sum(len(of[c, m]) for c in cases) for m in methods}
    score = table(["method"] + [f"`{m}`" for m in methods], [["passes"] + [f"{passed[m]} of {total[m]}" for m in methods]])
    lost = sum(float(row["missed"]) + float(row["wrong_side"]) > 0.0 for row in shots if row["method"] == "exact")
    steps = unique(row["step_s"] for row in rows if row["method"] != "exact")
    by_kind, by_check, scenes = random_tables(random)

    def finest(case):
        return float(of[case, "euler_semi_implicit"][-1]["value"])

    text = f"""# Where methods fail

<!-- Written by scripts/stability from the output of `stability`. Change scripts/plot_stability.py, not this page. -->

Every method of the ladder in every situation that is known to break simulators, at steps of {", ".join(step_name(s) for s in steps)}.
`scripts/stability` measures the map; the test `stability` holds `exact` to every row, the simple methods and `impulse` to the numbers at which they break.

![Stability map](stability/map.svg)

Blue passes, orange does not, red is lost altogether: missed, never at rest, not finite. The number in a cell is what was measured.

{score}

## What one sees

- **Sampling contacts is what breaks**, not the way of flying: in most rows the four methods from `euler_explicit` to `rk4` fail alike. A better integrator does not
  help a ball that is through the plate before anybody looks.
- **Locating contacts mends these rows at any step**: `rk4_located` fails only where steps of a fixed length are the trouble themselves: drag at 10 000 m/s, and far from the
  origin, where every step rounds the place to 1e-10 m and shorter steps are worse.
- **Simple methods do pass**: two walls at once, touching starts, a start in overlap, the collapse of three balls and spin at no speed are no trouble
  for "push out and reflect". Waiting 1000 s costs both Euler methods nothing that one sees at whole seconds.
- **Small steps buy time, not safety**: at 0.1 ms nothing tunnels up to 200 m/s, but a ball still never comes to rest, an edge still throws it off by
  {100 * finest('edges'):.0f} % of its speed, and {finest('galperin_3141'):.0f} of 3141 collisions are missing.

## Numbers

From top to bottom in a cell: {", ".join(step_name(s) for s in steps)}; `exact` takes no steps. ✗: does not pass.

{numbers}

## Bounds

{bounds}

Paddles that move give the world windows of at most 5 ms: in those rows a step of 10 ms is one of 5 ms.

## Tunnelling over speed and step

A plate of 14 mm, 200 shots from places spread over the way of one step. Methods that sample contacts are alike here (no force acts); `exact` loses
{"none" if lost == 0 else lost} of them. A ball is in touch for 54 mm of its way: it flies through where a step is longer. It is pushed out behind where a step is longer than
27 mm: then some shots are seen first when their centre is past the middle of the plate.

![Tunnelling](stability/tunnelling.svg)

## Contacts under friction and load

{scenes} random scenes of one ball with each method, steps of 1 ms: it rolls, slides, drops, spins into corners, grooves, over seams, edges, curved, turning and
pushing surfaces, with all kinds of contact laws and air. How many of them break anything that shall hold, in per cent, by kind of contact:

{by_kind}

And by what they break:

{by_check}

`scripts/stability --random 100000` runs more of them and tells which fail; the test `random_contacts` holds `exact` to a thousand. Where the bounds
come from stands in `bench/stability/random_checks.h`. `exact` leaves 1e-9 m of depth, and of energy and slip what its tolerance permits; methods with steps are held to the
same. Methods that sample contacts know no rest: what is said of balls that lie does not touch them.

Of the first 10 000 scenes (seed 1) `exact` hangs in none, passes through nothing, is no deeper than 1e-9 m, and none makes more than 200 events a second after its last
bounce, however small; six miss a stricter bound of the check (events after the last bounce of more than 1 mm/s, a law at the onset of slip, a seam by 1e-8 m). Of 100 000 some sixty
do, and two of them are 1.4 and 7 nm deep.
"""
    with open(os.path.join(docs, "stability.md"), "w", encoding="utf-8") as file:
        file.write(text)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    results, docs = sys.argv[1:]
    rows, shots, random = (read(results, name + ".csv") for name in ["stability", "tunnelling", "random"])
    plot_map(rows, docs)
    plot_shots(shots, docs)
    write_page(rows, shots, random, docs)


if __name__ == "__main__":
    main()
