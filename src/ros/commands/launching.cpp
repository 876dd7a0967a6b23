#include "launching.h"

#include "ros/base/conversions.h"

namespace ping_pong_sim
{
const ping_pong::Shot& shotNamed(const std::string& name)
{
  const ping_pong::Shot* shot = ping_pong::findShot(name);
  if (shot == nullptr) throw InputError("shot: " + name + ": expected one of " + ping_pong::shotNames());
  return *shot;
}

ping_pong::Pose tableFrame(const ping_pong::World& world)
{
  const std::size_t table = world.findBody("table");
  return table == ping_pong::kNone ? ping_pong::Pose() : world.bodyPose(table);
}

ping_pong::MaterialId ballMaterial(const ping_pong::Scene& scene)
{
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
  {
    if (scene.materials[i] == "ball") return static_cast<ping_pong::MaterialId>(i);
  }
  return scene.balls.empty() ? 0 : scene.balls.front().params.material;
}

ping_pong::BallId launchBall(ping_pong::World& world, const ping_pong::Pose& X_WF, const ping_pong::Shot& shot)
{
  ping_pong::BallParams params;
  params.material = ballMaterial(world.scene());
  ping_pong::BallState state;
  state.p_WB = X_WF.p + X_WF.q * shot.p_TB;
  state.v_WB = X_WF.q * shot.v_TB;
  state.w_WB = X_WF.q * shot.w_TB;
  ping_pong::BallId id = 0;
  const ping_pong::Refusal refusal = world.spawnBall(params, state, &id);
  if (refusal) throw InputError(refusal.reason);
  return id;
}
}  // namespace ping_pong_sim
