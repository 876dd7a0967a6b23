// What a player has in its head: the ball, the stroke in hand, the way of the racket.
#pragma once

#include <optional>

#include "ball_estimate.h"
#include "player.h"
#include "ready_position.h"

namespace ping_pong::play
{
struct Player::Impl
{
  Impl(const Scene& scene, const PlayerParams& its_params);

  PaddleCommand update(const Observation& now);
  const SeenBall* ballToPlay(const Observation& now);
  void follow(const SeenBall& ball, const Observation& now, const RacketNow& racket);
  void forgetBall();
  void reset();
  BallState toss() const;
  void think(bool refine, const RacketNow& racket);
  bool window(double& from, double& to) const;
  bool asPlanned() const;
  StrokeError drawError();
  PaddleCommand toWorld(PaddleCommand command) const;
  PaddleCommand moved(const RacketNow& racket, double tick);

  PlayerParams params;
  LevelTraits level;
  Court court;
  BallParams ball;
  Blade blade;
  RacketDrive drive;
  ReadyPosition ready;
  StrokePlanner planner;
  BallEstimate estimate;
  Random random;
  std::optional<StrokePlan> plan;
  StrokeError error;
  bool served = false;   // while the host still says that this player is to serve
  bool serving = false;  // the ball is in the air after the own toss
  bool failed = false;   // no stroke was found for this ball
  bool stale = false;    // the plan does not fit the prediction any more
  bool has_ball = false;
  BallId ball_id = 0;
  int strokes = 0;  // of its own, in this rally
  double try_again = 0.0, last_time = -1e9;
  std::uint64_t plans = 0, unplayable = 0;
};
}  // namespace ping_pong::play
