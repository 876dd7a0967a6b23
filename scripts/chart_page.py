"""The generated parts of docs/speed_accuracy.md: they stand between <!-- chart: NAME --> and <!-- /chart -->."""
import os
import re

from chart_data import OURS, cost_at

PEER_NAMES = {"bullet": "Bullet", "ode": "ODE", "dart": "DART", "mujoco": "MuJoCo", "simbody": "Simbody"}
FAILURES = {"not_finite": "not a number", "tunnelled": "tunnels", "missed": "misses hits", "energy": "gains energy",
            "unsettled": "leaves balls on others"}


def short(value, unit):
    """Two digits and a prefix: 3.1 µs."""
    if value == 0.0:
        return "0"
    for factor, prefix in [(1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"), (1e-12, "p"), (1e-15, "f")]:
        if value >= 0.995 * factor:
            scaled = value / factor
            return f"{scaled:.0f} {prefix}{unit}" if scaled >= 9.95 else f"{scaled:.1f} {prefix}{unit}"
    return f"{value:.0e} {unit}"


def cost_text(cost):
    return "-" if cost is None else short(cost, "s")


def error_text(scene, error):
    return f"{error:.1g}" if scene.measure == "energy" else short(error, "m")


def line_name(line):
    engine, variant = line
    return f"`{variant}`" if engine == OURS else f"{PEER_NAMES.get(engine, engine)}, {variant}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def step_text(step):
    return short(step, "s").replace(".0 ", " ")


def step_range(points):
    steps = sorted({p.step for p in points})
    return step_text(steps[0]) if len(steps) == 1 else f"{step_text(steps[0])} to {step_text(steps[-1])}"


def failure_text(points):
    """Where and how a line fails, and what was not measured."""
    failed = [p for p in points if p.measured and p.failures]
    parts = []
    if failed:
        what = list(dict.fromkeys(FAILURES[f] for p in failed for f in p.failures))
        parts.append(f"{', '.join(what)} at {step_range(failed)}")
    wrong = [p for p in points if p.good and p.wrong_bounces > 0.0]
    if wrong:
        parts.append(f"wrong number of bounces at {step_range(wrong)}")
    slow = [p.step for p in points if p.refusal == "takes too long"]
    if slow:
        parts.append(f"not tried at {step_text(max(slow))} and below, takes too long")
    return "; ".join(parts)


def scene_table(scene):
    units = ["1e-3", "1e-6", "1e-12"] if scene.measure == "energy" else ["1 cm", "1 mm", "1 µm"]
    rows = []
    for line, points in scene.lines().items():
        measured = [p for p in points if p.measured]
        if not measured:
            rows.append([line_name(line), "-", "-", "-", "", "", points[0].refusal])
            continue
        best = min((p for p in points if p.good), key=lambda p: p.error, default=None)
        rows.append([line_name(line)] + [cost_text(cost_at(points, a)) for a in scene.accuracies] +
                    ["" if best is None else error_text(scene, best.error),
                     "" if best is None else short(best.penetration, "m"), failure_text(points)])
    return table(["", *units, "least error", "deepest overlap then", ""], rows)


def scene_block(scene):
    about = scene.about
    starts = max(p.starts for p in scene.points)
    own = f"; its own error {float(about['reference_error_m']):.0e} m" if float(about["reference_error_m"]) > 0.0 else ""
    return "\n\n".join([f"![{scene.title}](chart/{scene.name}.svg)", scene_table(scene),
                        f"Cost of a ball and simulated second at this accuracy. Reference: {about['reference']}{own}. "
                        f"Starts per point: {starts}."])


def cheapest(scene, accuracy, keep):
    found = [(cost_at(points, accuracy), line) for line, points in scene.lines().items() if keep(line)]
    found = [(cost, line) for cost, line in found if cost is not None]
    return min(found, default=(None, None))


def is_other_method(line):
    return line[0] == OURS and line[1] not in ("exact", "auto")


def summary_block(scenes):
    """`exact` beside the cheapest of the rest, at the middle accuracy of each scene."""
    rows = []
    for scene in scenes:
        accuracy = scene.accuracies[1]
        exact, _ = cheapest(scene, accuracy, lambda line: line == (OURS, "exact"))
        row = [scene.title, "1e-6 of the energy" if scene.measure == "energy" else "1 mm", cost_text(exact)]
        for keep in (is_other_method, lambda line: line[0] != OURS):
            cost, line = cheapest(scene, accuracy, keep)
            ratio = f" (x {cost / exact:.2g})" if cost and exact and cost / exact < 100 else ""
            if cost and exact and cost / exact >= 100:
                ratio = f" (x {float(f'{cost / exact:.2g}'):,.0f})"
            row.append("-" if cost is None else f"{cost_text(cost)}{ratio}, {line_name(line)}")
        rows.append(row)
    return table(["scene", "accuracy", "`exact`", "cheapest other method", "cheapest other simulator"], rows)


def provenance_block(scenes):
    return "\n".join("- " + text for text in dict.fromkeys(
        f"{s.about['machine']}, {s.about['compiler']}, commit {s.about['commit']}" for s in scenes))


def write_page(scenes, docs):
    blocks = {scene.name: scene_block(scene) for scene in scenes}
    blocks["summary"] = summary_block(scenes)
    blocks["provenance"] = provenance_block(scenes)
    path = os.path.join(docs, "speed_accuracy.md")
    with open(path, encoding="utf-8") as file:
        text = file.read()

    def fill(match):
        name = match.group(1)
        inside = f"\n{blocks[name]}\n" if name in blocks else match.group(2)
        return f"<!-- chart: {name} -->{inside}<!-- /chart -->"

    text, count = re.subn(r"<!-- chart: (\w+) -->(.*?)<!-- /chart -->", fill, text, flags=re.S)
    if count == 0:
        raise SystemExit(f"{path}: no <!-- chart: NAME --> in it")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
