// Drives one paddle by keys: accelerated while they are held, gliding to rest when they are not.
#pragma once

#include <ros/node_handle.h>

#include <optional>
#include <string>

#include "glide.h"
#include "held_keys.h"
#include "ping_pong_sim/PaddleStates.h"
#include "reach.h"

namespace ping_pong_sim
{
class PaddleGlide
{
public:
  explicit PaddleGlide(ros::NodeHandle& nh) : nh_(nh) {}

  /// Which paddle; the one before is told to stop. Empty: none.
  void take(const std::string& paddle);
  /// Where an arm at that end of a table reaches; nothing: no table is there. A paddle that is taken elsewhere is free.
  void setReach(const std::optional<ping_pong::TableEnd>& end, const ping_pong::Reach& reach);
  /// When the wish changes: acts at once, ahead of the next state.
  /// @param axes  viewer's axes in the world
  /// @return      whether it is another wish than before
  bool wish(const ping_pong::Wish& wish, const Eigen::Matrix3d& axes, const ping_pong::GlideParams& params);
  /// With every state. It counts simulated time, so that slow motion is the same motion, only slower.
  void follow(const PaddleStates& states);

  bool moving() const { return sent_; }

private:
  void drive(double dt);
  void keepWithinReach();
  void send(bool hold);

  ros::NodeHandle nh_;
  std::string paddle_;
  ros::Publisher command_;
  ping_pong::Wish wish_;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  ping_pong::GlideParams params_;
  ping_pong::Glide glide_;
  std::optional<ping_pong::TableEnd> end_;
  ping_pong::Reach reach_;
  std::optional<Eigen::Vector3d> p_W_;  ///< of the paddle
  bool in_reach_ = false;               ///< when it was taken
  double driven_to_ = 0.0;              ///< simulated time that `glide_` is for [s]
  double tick_ = 0.0;                   ///< between the last two states [s]
  bool sent_ = false;                   ///< the paddle obeys a velocity of ours
};
}  // namespace ping_pong_sim
