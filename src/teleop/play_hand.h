// The hand at the mouse: where the blade shall be, how it is tilted, and its strokes. In the frame E of the player's end (reach.h).
#pragma once

#include <optional>

#include "assistance.h"
#include "reach.h"
#include "swing.h"

namespace ping_pong
{
struct PlayParams
{
  double depth = -0.30;       ///< x of the plane in which the mouse moves the blade [m]
  double assistance = 1.0;    ///< 0: none. 1: attitude and stroke are the helper's; time and place stay the hand's
  double stroke_speed = 4.0;  ///< of the blade, when a button is pressed [m/s]
};

class PlayHand
{
public:
  explicit PlayHand(Helper helper = mirrorHelp) : helper_(std::move(helper)) {}

  void setParams(const PlayParams& params) { params_ = params; }
  const PlayParams& params() const { return params_; }

  /// Where the mouse points: height and place across the table.
  void point(const Eigen::Vector3d& p_E, const Reach& reach);
  /// Opens the blade (up) or closes it. @param angle  [rad]
  void tilt(double angle);
  /// A stroke that hits in a moment: forward and up (a drive, brushing over the ball) or forward and down (a push or chop, under it).
  void stroke(bool up);
  /// Begins anew from here: after a jump, or when the hand takes the paddle.
  void take(const Followed& paddle);

  /// The blade after dt.
  /// @param ball  that comes; nothing: none does
  const Followed& move(double dt, const std::optional<BallSight>& ball);
  const Followed& blade() const { return blade_; }

private:
  void ask(const std::optional<BallSight>& ball);
  void strikeWithHelp();
  Eigen::Quaterniond attitude() const;

  Helper helper_;
  PlayParams params_;
  Eigen::Vector3d wanted_ = Eigen::Vector3d(-0.3, 0.0, 0.2);  ///< of the blade without its strokes
  double tilt_ = 0.0;                                         ///< [rad]
  double time_ = 0.0;                                         ///< simulated [s]
  std::optional<Help> help_;
  std::optional<Swing> swing_;
  bool by_helper_ = false;   ///< the swing
  double swing_tilt_ = 0.0;  ///< of a stroke's blade [rad]
  Followed hand_;            ///< without its strokes
  Followed blade_;
};
}  // namespace ping_pong
