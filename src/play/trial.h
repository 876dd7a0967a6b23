// A world with players, tick by tick: what drills and matches without ROS are run in.
#pragma once

#include "ping_pong_sim/world.h"
#include "player.h"

namespace ping_pong::play
{
/// It knows no rules.
class Trial
{
public:
  /// @param scene  with one ball and the players' paddles
  Trial(std::shared_ptr<const Scene> scene, const std::vector<PlayerParams>& players, double tick = 1e-3);

  /// Everything as at the start, with other seeds; then the ball in this state.
  void restart(const BallState& ball, std::uint64_t seed);
  void tick();
  void serves(std::size_t player) { server_ = player; }  ///< kNone: nobody

  World& world() { return world_; }
  const World& world() const { return world_; }
  Player& player(std::size_t i) { return players_[i]; }
  std::size_t bodyOf(std::size_t player) const { return bodies_[player]; }
  std::size_t playerOf(std::size_t body) const;  ///< whose paddle; or kNone

  double planningTime() const { return planning_; }  ///< of all updates, time of the thread [s]
  double worstPlanning() const { return worst_; }    ///< of one update [s]
  std::uint64_t updates() const { return updates_; }
  double topSpeed() const { return top_speed_; }                ///< of any paddle [m/s]
  double topAcceleration() const { return top_acceleration_; }  ///< mean of a tick [m/s^2]
  std::uint64_t blocked() const { return blocked_; }            ///< ticks in which the table stopped a paddle

private:
  std::shared_ptr<const Scene> scene_;
  std::vector<PlayerParams> params_;
  double tick_;
  World world_;
  std::vector<Player> players_;
  std::vector<std::size_t> bodies_;
  std::vector<Vector3d> before_;  // velocities of the paddles [m/s]
  Observation seen_;
  std::size_t server_ = kNone;
  double planning_ = 0.0, worst_ = 0.0, top_speed_ = 0.0, top_acceleration_ = 0.0;
  std::uint64_t updates_ = 0, blocked_ = 0;
};
}  // namespace ping_pong::play
