// Where a racket waits between strokes, how it gets there, and what keeps it off the table on all its ways.
#pragma once

#include <optional>

#include "ball_estimate.h"
#include "stroke_path.h"

namespace ping_pong::play
{
class ReadyPosition
{
public:
  ReadyPosition(const Court& court, const Blade& blade, const RacketDrive& drive);

  /// Behind the middle of the end line, edge on with the tip to the net: a quarter turn to either stroke. Frame O.
  const Pose& pose() const { return pose_; }
  /// For a racket without a stroke in hand: there, or out of the way of a ball that is not to be touched.
  /// @param y  where the middle would be in the way [m]
  PaddleCommand command(const RacketNow& racket, double tick, const BallEstimate& ball, double y);
  void leave() { way_.reset(); }  ///< a stroke begins: the way back is another after it

  /// The command, or braking where the racket could otherwise no longer stop before the table. What it does then is safe in the next
  /// tick, too.
  PaddleCommand guarded(PaddleCommand command, const RacketNow& racket, double tick) const;

private:
  Vector3d place(const RacketNow& racket, const BallEstimate& ball, double y) const;

  const Court& court_;
  const Blade& blade_;
  const RacketDrive& drive_;
  Pose pose_;
  std::optional<Waypoint> way_;
};
}  // namespace ping_pong::play
