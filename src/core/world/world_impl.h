// What a World is made of, and the parts of it that are no query.
#pragma once

#include <vector>

#include "methods/method.h"
#include "paddle/paddle_drive.h"
#include "ping_pong_sim/world.h"

namespace ping_pong
{
struct World::Impl : WorldWithWindows
{
  using WorldWithWindows::WorldWithWindows;

  const MethodFunctions* functions = nullptr;  // of the method
  BallId next_id = 0;
  double time_rest = 0.0;           // what rounding took from time: N ticks of h end at N h
  std::vector<Obstacle> obstacles;  // of the window; this and the next are kept, so that no step allocates
  std::vector<ShapePair> near_obstacles;

  std::size_t space_for = 0;  // balls that there is memory for

  void choose(Method its_method);
  void start();
  void become(const Impl& model);
  void beginTick();
  BallRecord& add(const BallParams& params, const BallState& state);
  void remove(std::size_t index);
  StepStatus endTick();
  double later(double duration);
  double movePaddles(double end);
  void makeSpace();
  void takeSpace();
  void ballChanged(std::size_t index);
  void detachFrom(std::size_t body);
  void resolveOverlaps();
  std::vector<char> ballsThatOverlap();
};

inline BallState normalized(BallState state)
{
  state.q_WB.normalize();
  return state;
}
}  // namespace ping_pong
