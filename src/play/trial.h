// Players put to the test: against a launcher, in their service, with each other.
#pragma once

#include "ping_pong_sim/world.h"
#include "player.h"

namespace ping_pong
{
/// A world with players, tick by tick, without rules.
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

enum class Outcome
{
  Returned,     ///< lands on the other half
  NotItsHalf,   ///< the launch does not bounce once on the player's half first: nothing to return
  Untouched,    ///< the racket does not meet it
  TouchedTwice,
  IntoNet,      ///< touches net or own half first
  Out           ///< lands beside the other half
};
const char* name(Outcome outcome);

struct ReturnResult
{
  Outcome outcome = Outcome::Untouched;
  Stroke stroke = Stroke::Drive;
  double landing_error = 0.0;  ///< from the target, if it lands on the table [m]
  double spin = 0.0;           ///< with which it comes to the racket [rad/s]
  double speed = 0.0;          ///< the same [m/s]
};

/// One ball from a launcher to player 0.
/// @param launch  in frame O of that player
ReturnResult returnOf(Trial& trial, const BallState& launch, std::uint64_t seed);

struct ServeResult
{
  bool legal = false;
  std::string fault;           ///< empty if legal
  double rise = 0.0;           ///< of the ball after the toss [m]
  double landing_error = 0.0;  ///< on the other half [m]
  Stroke stroke = Stroke::LongServe;
};
/// Toss and service of player 0: rises 16 cm or more, struck as it falls, behind the end line and above the surface (ITTF 2.6.2 to 2.6.4),
/// lands on the own half, then on the other.
ServeResult serveOf(Trial& trial, std::uint64_t seed);

/// Strokes of two players after the service of player 0, until a ball is not returned; at most so many.
std::size_t rallyOf(Trial& trial, std::uint64_t seed, std::size_t most);
}  // namespace ping_pong
