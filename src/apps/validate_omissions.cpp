// What leaving something out costs in landing error, and saves in time.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "csv_file.h"
#include "ping_pong_sim/world.h"
#include "validate_parts.h"

namespace ping_pong
{
namespace
{
constexpr double kTurn = 2.0 * M_PI;  // [rad]

struct Shot
{
  std::string name;
  double speed;    ///< [m/s]
  double topspin;  ///< turns per second; negative: backspin
  double height;   ///< of the centre above the table [m]
  double reach;    ///< where it shall land [m]
};

const std::vector<Shot>& shots()
{
  static const std::vector<Shot> list = {
      {"serve 5 m/s, no spin", 5.0, 0.0, 0.30, 2.00},           {"serve 5 m/s, 40 rev/s back", 5.0, -40.0, 0.30, 2.00},
      {"drive 12 m/s, 100 rev/s top", 12.0, 100.0, 0.30, 2.70}, {"smash 25 m/s, no spin", 25.0, 0.0, 0.40, 2.70},
      {"smash 25 m/s, 40 rev/s top", 25.0, 40.0, 0.40, 2.70},
  };
  return list;
}

struct Change
{
  std::string name;
  Forces forces;
  Surface table;
  bool at_table;  ///< the change is seen at the second bounce only
};

std::vector<Change> changes()
{
  std::vector<Change> list;
  const auto air = [&](const std::string& name, void (*change)(Forces&))
  {
    Forces forces = completeForces();
    change(forces);
    list.push_back({name, forces, defaultTable(), false});
  };
  const auto table = [&](const std::string& name, const Surface& law) {
    list.push_back({name, completeForces(), law, true});
  };
  air("complete", [](Forces&) {});
  air("no drag", [](Forces& f) { f.drag = false; });
  air("no Magnus", [](Forces& f) { f.magnus = false; });
  air("vacuum",
      [](Forces& f)
      {
        const Vector3d g = f.gravity;
        f = Forces();
        f.gravity = g;
      });
  air("C_L = S/(1+2S)", [](Forces& f) { f.lift_law.slope = 1.0, f.lift_law.saturation = 2.0; });
  air("C_L = .6 S", [](Forces& f) { f.lift_law.kind = LiftLaw::Kind::Linear, f.lift_law.slope = 0.6; });
  air("C_L = 1.33 S", [](Forces& f) { f.lift_law.kind = LiftLaw::Kind::Linear, f.lift_law.slope = 1.33; });
  air("C_L = .267", [](Forces& f) { f.lift_law.kind = LiftLaw::Kind::Constant; });
  air("C_D .44", [](Forces& f) { f.drag_law = DragLaw::constant(0.44); });
  air("C_D .53", [](Forces& f) { f.drag_law = DragLaw::constant(0.53); });
  air("no buoyancy", [](Forces& f) { f.buoyancy = false; });
  air("no added mass", [](Forces& f) { f.added_mass = false; });
  air("no spin decay", [](Forces& f) { f.spin_decay = 0.0; });
  air("none of the three",
      [](Forces& f)
      {
        f.buoyancy = f.added_mass = false;
        f.spin_decay = 0.0;
      });
  const auto table_of = [](double friction, double tangential)
  {
    Surface law = defaultTable();
    law.friction = friction;
    law.tangential_restitution = tangential;
    return law;
  };
  table("table: no friction", table_of(0.0, 0.0));
  table("table: mu .20", table_of(0.20, 0.15));
  table("table: mu .30", table_of(0.30, 0.15));
  table("table: always grips", table_of(std::numeric_limits<double>::infinity(), 0.15));
  table("table: e_t 0", table_of(0.24, 0.0));
  table("table: e constant .93", surfaceWith(0.93, 0.0, 0.24, 0.0));
  table("table: e constant .876", surfaceWith(0.876, 0.0, 0.24, 0.0));
  return list;
}

Scene sceneOf(const Forces& forces, const Surface& law, const BallState& start, double tolerance)
{
  Scene scene = tableScene(forces, law, tolerance);
  scene.balls[0].state = start;
  return scene;
}

// The first contacts with the table's plane, which has no end here.
std::vector<Contact> bouncesOf(const Scene& scene, std::size_t count)
{
  World world(scene);
  std::vector<Contact> bounces;
  while (world.time() < 5.0 && bounces.size() < count)
  {
    world.advance(0.05);
    for (const Contact& contact : world.contacts())
      if (bounces.size() < count) bounces.push_back(contact);
  }
  return bounces;
}

BallState launch(const Shot& shot, double angle)
{
  BallState state;
  state.p_WB.z() = shot.height;
  state.v_WB = shot.speed * Vector3d(std::cos(angle), 0.0, std::sin(angle));
  state.w_WB.y() = kTurn * shot.topspin;
  return state;
}

// The lowest launch that lands where it shall under complete forces.
BallState aimed(const Shot& shot)
{
  const auto miss = [&](double angle)
  {
    const std::vector<Contact> bounces =
        bouncesOf(sceneOf(completeForces(), defaultTable(), launch(shot, angle), 1e-8), 1);
    return bounces.empty() ? 1.0 : bounces[0].p_WC.x() - shot.reach;
  };
  double high = -0.5;
  while (miss(high) < 0.0 && high < 1.2) high += 0.01;
  double low = high - 0.01;
  for (int i = 0; i < 40; ++i)
  {
    const double middle = 0.5 * (low + high);
    (miss(middle) < 0.0 ? low : high) = middle;
  }
  return launch(shot, high);
}

// Nanoseconds of planning and flying up to just before the landing.
class Stopwatch
{
public:
  Stopwatch(const Forces& forces, const BallState& start, double duration, double tolerance)
      : world_(sceneOf(forces, defaultTable(), start, tolerance)), start_(start), duration_(0.95 * duration)
  {
  }
  void run()
  {
    constexpr int kFlights = 20;
    const auto before = std::chrono::steady_clock::now();
    for (int i = 0; i < kFlights; ++i)
    {
      world_.setBallState(world_.ballId(0), start_);
      world_.advance(duration_);
    }
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - before;
    samples_.push_back(spent.count() / kFlights);
  }
  double median() const { return medianOf(samples_); }

private:
  World world_;
  BallState start_;
  double duration_;
  std::vector<double> samples_;
};

// Interleaved, so that a busy machine is busy for all.
std::vector<double> medianTimes(const std::vector<Change>& list, const BallState& start, double duration,
                                double tolerance)
{
  std::vector<Stopwatch> watches;
  for (const Change& change : list) watches.emplace_back(change.forces, start, duration, tolerance);
  for (int round = 0; round < 61; ++round)
    for (Stopwatch& watch : watches) watch.run();
  std::vector<double> medians;
  for (const Stopwatch& watch : watches) medians.push_back(watch.median());
  return medians;
}

void writeShots(const std::string& out)
{
  CsvFile file(out + "/omissions.csv");
  for (const char* head : {"shot", "change", "landing_cm", "second_bounce_cm", "time_ns", "time_ns_1mm"})
    file.text(head);
  file.endRow();
  const std::vector<Change> list = changes();
  for (const Shot& shot : shots())
  {
    const BallState start = aimed(shot);
    const std::vector<Contact> reference = bouncesOf(sceneOf(completeForces(), defaultTable(), start, 1e-9), 2);
    const std::vector<double> times = medianTimes(list, start, reference.at(0).time, Scene().tolerance);
    const std::vector<double> coarse = medianTimes(list, start, reference.at(0).time, 1e-3);
    for (std::size_t i = 0; i < list.size(); ++i)
    {
      const std::vector<Contact> bounces = bouncesOf(sceneOf(list[i].forces, list[i].table, start, 1e-9), 2);
      file.text(('"' + shot.name + '"').c_str());
      file.text(('"' + list[i].name + '"').c_str());
      for (std::size_t k = 0; k < 2; ++k)
        file.number(k < bounces.size() ? 100.0 * (bounces[k].p_WC.x() - reference.at(k).p_WC.x()) : std::nan(""));
      file.number(times[i]);
      file.number(coarse[i]);
      file.endRow();
    }
  }
  file.close();
}

// The same over launches of real play: distance of the landing points.
void writeLaunches(const std::vector<Launch>& launches, const std::string& out)
{
  CsvFile file(out + "/launches.csv");
  for (const char* head : {"change", "kind", "launches", "median_cm", "percentile_95_cm"}) file.text(head);
  file.endRow();
  for (const Change& change : changes())
  {
    if (change.at_table) continue;
    for (const char* kind : {"serve", "rally"})
    {
      std::vector<double> distances;
      for (const Launch& launch : launches)
      {
        if (launch.kind != kind || launch.state.p_WB.z() < 0.02) continue;
        const auto landing = [&](const Forces& forces)
        { return bouncesOf(sceneOf(forces, defaultTable(), launch.state, 1e-7), 1); };
        const std::vector<Contact> truth = landing(completeForces()), other = landing(change.forces);
        if (!truth.empty() && !other.empty()) distances.push_back(100.0 * (truth[0].p_WC - other[0].p_WC).norm());
      }
      std::sort(distances.begin(), distances.end());
      file.text(('"' + change.name + '"').c_str());
      file.text(kind);
      file.integer(distances.size());
      file.number(medianOf(distances));
      file.number(distances.empty() ? std::nan("") : distances[distances.size() * 95 / 100]);
      file.endRow();
    }
  }
  file.close();
}
}  // namespace

void writeOmissions(const std::vector<Launch>& launches, const std::string& out)
{
  writeShots(out);
  writeLaunches(launches, out);
}
}  // namespace ping_pong
