// What the air costs in a whole scene: flights, contact searches, bounces.
#include <chrono>

#include "csv_file.h"
#include "ping_pong_sim/scene_loader.h"
#include "ping_pong_sim/shots.h"
#include "ping_pong_sim/world.h"
#include "validate_parts.h"

namespace ping_pong
{
namespace
{
constexpr double kRally = 1.2;  // [s]
constexpr int kRounds = 61;
constexpr int kRallies = 20;  // in a round

Scene inVacuum(Scene scene)
{
  const Vector3d gravity = scene.forces.gravity;
  scene.forces = Forces();
  scene.forces.gravity = gravity;
  return scene;
}

BallState launched(const Shot& shot, const Pose& table)
{
  BallState state;
  state.p_WB = table.p + table.q * shot.p_TB;
  state.v_WB = table.q * shot.v_TB;
  state.w_WB = table.q * shot.w_TB;
  return state;
}

// Nanoseconds of rallies of one ball, setting its state included.
class RallyClock
{
public:
  explicit RallyClock(const Scene& scene) : world_(scene) {}
  void run(const BallState& start)
  {
    const auto before = std::chrono::steady_clock::now();
    for (int i = 0; i < kRallies; ++i)
    {
      world_.setBallState(world_.ballId(0), start);
      world_.advance(kRally);
    }
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - before;
    samples_.push_back(spent.count() / kRallies);
  }
  double median() const { return medianOf(samples_); }
  std::size_t contacts() const { return world_.contacts().size(); }

private:
  World world_;
  std::vector<double> samples_;
};
}  // namespace

void writeRallyCosts(const std::string& scene_file, const std::string& out)
{
  Scene scene = loadScene(scene_file);
  scene.method = Method::Exact;
  scene.tolerance = 1e-3;
  const World world(scene);
  const Pose table = world.bodyPose(world.findBody("table"));
  CsvFile file(out + "/rally_costs.csv");
  for (const char* head : {"shot", "air_ns", "vacuum_ns", "air_contacts", "vacuum_contacts"}) file.text(head);
  file.endRow();
  for (const Shot& shot : shots())
  {
    RallyClock air(scene), vacuum(inVacuum(scene));
    for (int round = 0; round < kRounds; ++round)
    {
      air.run(launched(shot, table));
      vacuum.run(launched(shot, table));
    }
    file.text(shot.name.c_str());
    file.number(air.median());
    file.number(vacuum.median());
    file.integer(air.contacts());
    file.integer(vacuum.contacts());
    file.endRow();
  }
  file.close();
}
}  // namespace ping_pong
