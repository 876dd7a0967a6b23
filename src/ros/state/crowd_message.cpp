#include "crowd_message.h"

namespace ping_pong_sim
{
namespace
{
void store(const ping_pong::Vector3d& vector, float* place)
{
  for (int axis = 0; axis < 3; ++axis) place[axis] = static_cast<float>(vector[axis]);
}

void fillRadii(const ping_pong::World& world, std::vector<float>& radii)
{
  radii.resize(world.ballCount());
  bool alike = true;
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    radii[i] = static_cast<float>(world.ballParams(i).radius);
    alike = alike && radii[i] == radii[0];
  }
  if (alike && !radii.empty()) radii.resize(1);
}
}  // namespace

void fillCrowd(const Simulation& simulation, Crowd& message)
{
  const ping_pong::World& world = simulation.world();
  const std::size_t count = world.ballCount();
  message.header.stamp = simulation.clock().now();
  message.header.frame_id = "world";
  message.time = world.time();
  message.id.resize(count);
  message.position.resize(3 * count);
  message.velocity.resize(3 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const ping_pong::BallState state = world.ballState(i);
    message.id[i] = world.ballId(i);
    store(state.p_WB, &message.position[3 * i]);
    store(state.v_WB, &message.velocity[3 * i]);
  }
  fillRadii(world, message.radius);
}
}  // namespace ping_pong_sim
