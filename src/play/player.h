// A computer player: sees the ball, plans a stroke, moves a paddle. Without ROS, and without rules: who serves is told from outside.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "court.h"
#include "level.h"
#include "stroke_planner.h"

namespace ping_pong::play
{
struct PlayerParams
{
  End end = End::A;
  std::string paddle = "paddle_a";  ///< body that it moves
  int level = 5;                    ///< 1 to 5
  Style style = Style::Mixed;
  std::uint64_t seed = 1;  ///< the same seed and observations, the same commands
};

/// A ball as it is, or as a tracker estimates it; frame `world`.
struct SeenBall
{
  BallId id = 0;
  Vector3d p_WB = Vector3d::Zero();  ///< [m]
  Vector3d v_WB = Vector3d::Zero();  ///< [m/s]
  Vector3d w_WB = Vector3d::Zero();  ///< spin [rad/s]
};

/// What a player is told at a tick; frame `world`.
struct Observation
{
  double time = 0.0;            ///< now [s]
  double tick = 1e-3;           ///< until the next update [s], > 0
  std::vector<SeenBall> balls;  ///< now. A level below 5 uses them later, and with errors
  Pose pose;                    ///< of the own paddle, now
  Twist twist;
  bool to_serve = false;  ///< from when the ball is in this player's hand until the player has struck it
};

class Player
{
public:
  /// Throws std::invalid_argument, in one line: a level that is not 1 to 5, no such paddle, no table.
  Player(const Scene& scene, const PlayerParams& params);
  ~Player();
  Player(Player&&) noexcept;
  Player& operator=(Player&&) noexcept;

  /// To be given to the paddle for the coming tick, whose length is in the observation. Takes microseconds; a new plan up to 3 ms.
  PaddleCommand update(const Observation& now);
  /// How this player wants the ball thrown for its service: from here, straight up, 30 cm high. Frame `world`.
  BallState toss() const;
  /// Where the paddle waits. Frame `world`.
  Pose ready() const;
  void reset();  ///< another point: forgets ball and plan; random numbers go on

  // To look at: plans and predictions for markers and tests. Frame O of court().
  const Court& court() const;
  const Prediction& prediction() const;
  const StrokePlan* plan() const;    ///< of the stroke in hand or just made; nullptr: none
  std::uint64_t plans() const;       ///< made since the start
  std::uint64_t unplayable() const;  ///< balls that came and for which no stroke was found

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};
}  // namespace ping_pong::play
