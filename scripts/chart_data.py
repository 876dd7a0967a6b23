"""Reads what `chart` measured: points, fronts, costs at an accuracy."""
import csv
import math
import os

OURS = "ping_pong_sim"
SCENES = ["flight_vacuum", "flight_air", "bouncing", "elastic_666", "inelastic_666", "drop_to_rest", "spin_bounce",
          "spin_bounce_vacuum", "ball_in_box", "paddle_hit", "rally"]
ERRORS = {"position": "position_rms_m", "energy": "energy_rms", "overlap": "overlap_rms_m"}  # columns
LEAST = 1e-17  # an error of zero is drawn here
ROUNDING = 3.6e-15  # unit in the last place of a double at 20 m [m]


class Point:
    def __init__(self, row, measure):
        self.engine, self.variant = row["engine"], row["variant"]
        self.step, self.cost = float(row["step"]), float(row["cost_s"])
        self.error = float(row[ERRORS[measure]])
        self.wrong_bounces = float(row["wrong_bounces"])
        self.penetration = float(row["penetration_m"])
        self.starts = int(row["starts"])
        self.refusal = row["refusal"]
        self.failures = row["failures"].split()
        if not self.refusal and not math.isfinite(self.error):
            self.failures = self.failures or ["not_finite"]

    @property
    def line(self):
        return (self.engine, self.variant)

    @property
    def measured(self):
        return not self.refusal

    @property
    def good(self):
        return self.measured and not self.failures


class Scene:
    def __init__(self, path):
        self.name = os.path.basename(path)[:-len(".csv")]
        self.about = {}
        with open(path, newline="", encoding="utf-8") as file:
            lines = file.readlines()
        for line in lines:
            if line.startswith("# "):
                key, _, value = line[2:].strip().partition(": ")
                self.about[key] = value
        rows = csv.DictReader(line for line in lines if not line.startswith("#"))
        self.points = [Point(row, self.measure) for row in rows]

    @property
    def title(self):
        return self.about["title"]

    @property
    def measure(self):
        return self.about["measure"]

    @property
    def accuracies(self):
        return [1e-3, 1e-6, 1e-12] if self.measure == "energy" else [1e-2, 1e-3, 1e-6]

    def lines(self):
        """(engine, variant) in the order of the file, each with its points."""
        found = {}
        for point in self.points:
            found.setdefault(point.line, []).append(point)
        return found

    def check_reference(self):
        """The truth must be a hundred times better than the best point that is held against it, or as good as ROUNDING."""
        least = min((p.error for p in self.points if p.good and p.error > 0.0), default=0.0)
        if float(self.about["reference_error_m"]) > max(ROUNDING, 0.01 * least):
            raise SystemExit(f"{self.name}: the reference is off by {self.about['reference_error_m']} m, "
                             f"too much for a point with an error of {least:g} m")


def read_scenes(results):
    paths = [os.path.join(results, name + ".csv") for name in SCENES]
    return [Scene(path) for path in paths if os.path.exists(path)]


def front(points):
    """Points that no other one beats in both cost and error, by rising cost."""
    best, result = math.inf, []
    for point in sorted((p for p in points if p.good), key=lambda p: (p.cost, p.error)):
        if point.error < best:
            best = point.error
            result.append(point)
    return result


def cost_at(points, accuracy):
    """Cost at which this line reaches the accuracy [s], between points of its front; None if it never does."""
    before = None
    for point in front(points):
        if point.error <= accuracy:
            if before is None:
                return point.cost
            high, low = math.log(before.error), math.log(max(point.error, LEAST))
            part = (high - math.log(accuracy)) / (high - low)
            return math.exp(math.log(before.cost) + part * (math.log(point.cost) - math.log(before.cost)))
        before = point
    return None
