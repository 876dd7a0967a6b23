// A contact solver without a world around it, so that a test sees what it keeps.
#pragma once

#include <memory>

#include "evolve/flight.h"
#include "solver/solver_state.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
inline constexpr double kStep = 1e-3;  // [s]

// Balls that are all in the solver, step by step.
struct SolverRun
{
  WorldWithSolver world;

  SolverRun(const Scene& scene, std::size_t threads) : world(std::make_shared<const Scene>(scene))
  {
    world.workers.start(threads);
    world.contacts.reserve(2 * scene.balls.size());
    for (const Body& body : scene.bodies)
    {
      BodyRecord& record = world.bodies.emplace_back();
      record.body = body;
      placeBody(record, body.pose);
    }
    for (const SceneBall& ball : scene.balls) add(ball);
  }
  void add(const SceneBall& ball)
  {
    const auto index = static_cast<std::uint32_t>(world.balls.size());
    world.balls.emplace_back(index, world.types.of(ball.params, world.scene.forces)).path =
        flyParabola(ball.state, world.time, Vector3d::Zero());
    addToSolver(world, index, world.time);
  }
  void remove(std::uint32_t index)
  {
    removeFromSolver(world.solver, index);
    world.balls.erase(world.balls.begin() + index);
  }
  // As an observer sees it who is faster by -v: who meets whom, and when, stays as it is.
  void speedUp(const Vector3d& v)
  {
    for (BallRecord& ball : world.balls) ball.path.c[1] += v;
    disturbSolver(world);
  }
  void step()
  {
    stepSolver(world, world.time, world.time + kStep, kStep);
    world.time += kStep;
  }
  BallState state(std::size_t index) const { return world.balls[index].stateAt(world.time); }
  std::size_t slabs() const { return world.solver.slab_count; }
};
}  // namespace ping_pong
