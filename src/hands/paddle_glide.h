// Drives one paddle by keys: accelerated while they are held, gliding to rest when they are not.
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "glide.h"
#include "held_keys.h"
#include "ping_pong_sim/PaddleStates.h"

namespace ping_pong_sim
{
class PaddleGlide
{
public:
  explicit PaddleGlide(ros::NodeHandle& nh) : nh_(nh) {}

  /// Which paddle; the one before is told to stop. Empty: none.
  void take(const std::string& paddle);
  /// When the wish changes: acts at once, ahead of the next state.
  /// @param axes  viewer's axes in the world
  /// @return      whether it is another wish than before
  bool wish(const ping_pong::Wish& wish, const Eigen::Matrix3d& axes, const ping_pong::GlideParams& params);
  /// With every state. It counts simulated time, so that slow motion is the same motion, only slower.
  void follow(const PaddleStates& states);

  bool moving() const { return sent_; }

private:
  void drive(double dt);
  void send(bool hold);

  ros::NodeHandle nh_;
  std::string paddle_;
  ros::Publisher command_;
  ping_pong::Wish wish_;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  ping_pong::GlideParams params_;
  ping_pong::Glide glide_;
  double driven_to_ = 0.0;  ///< simulated time that `glide_` is for [s]
  double tick_ = 0.0;       ///< between the last two states [s]
  bool sent_ = false;       ///< the paddle obeys a velocity of ours
};
}  // namespace ping_pong_sim
