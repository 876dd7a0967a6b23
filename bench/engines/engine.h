// One simulator on the chart, ours or a peer: built from a scene, moved on, asked for its state.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ping_pong_sim/scene.h"

namespace ping_pong::bench
{
class Engine
{
public:
  virtual ~Engine() = default;
  /// From now on this kinematic body moves with this constant twist.
  virtual void drive(std::size_t body, const Twist& twist) = 0;
  /// Moves everything on by `duration` [s]: a whole number of steps for engines that step.
  virtual void advance(double duration) = 0;
  virtual BallState ballState(std::size_t ball) const = 0;
};

/// A kind of engine with the settings that it is measured in.
struct EngineKind
{
  std::string name;  ///< "ping_pong_sim", "bullet", ...
  /// Settings, in the order of the chart. Ours: the methods. A peer: "default" and "best".
  std::vector<std::string> variants;
  /// Why it cannot run this scene in this variant; empty if it can. Such a point is named in the chart's table, not left out.
  std::function<std::string(const Scene& scene, const std::string& variant)> refuse;
  /// @param step  length of a step [s]; of `exact` the tolerance [m]
  std::function<std::unique_ptr<Engine>(const Scene& scene, const std::string& variant, double step)> make;
};

/// Engines that are part of this build: ours first, then the peers (-DBENCH_PEERS=ON).
const std::vector<EngineKind>& engineKinds();
}  // namespace ping_pong::bench
