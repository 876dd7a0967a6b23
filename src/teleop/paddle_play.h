// A paddle at the mouse, for a player: poses at every tick, and at once when the mouse moves.
#pragma once

#include <ros/node_handle.h>

#include <optional>
#include <string>

#include "ping_pong_sim/BallStates.h"
#include "ping_pong_sim/PaddleState.h"
#include "play_hand.h"

namespace ping_pong_sim
{
/// From the eye through the mouse, in the world.
struct EyeRay
{
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
};

class PaddlePlay
{
public:
  explicit PaddlePlay(ros::NodeHandle& nh) : nh_(nh) {}

  ping_pong::PlayHand& hand() { return hand_; }
  /// Which paddle, and at which end of which table. Nothing: none, or no table.
  void take(const std::string& paddle, const std::optional<ping_pong::TableEnd>& end);
  void point(const EyeRay& ray, const ping_pong::Reach& reach);
  void follow(const PaddleState& state, double time);
  /// The paddle is no longer ours.
  void release();

  bool active() const { return pointed_; }
  const std::string& paddle() const { return paddle_; }

private:
  void onBalls(const BallStates& balls);
  void move(double dt);
  void send(const ping_pong::Followed& blade_E);

  ros::NodeHandle nh_;
  ros::Publisher command_;
  ros::Subscriber balls_topic_;
  std::string paddle_;
  std::optional<ping_pong::TableEnd> end_;
  ping_pong::PlayHand hand_;
  std::optional<ping_pong::BallSight> ball_;  ///< that comes
  bool pointed_ = false;                      ///< the mouse has been in the view
  bool taken_ = false;                        ///< the hand knows where the paddle is
  double time_ = 0.0;                         ///< simulated, of the last state [s]
  double ahead_ = 0.0;                        ///< moved beyond it already [s]
  double tick_ = 0.0;                         ///< between the last two states [s]
};
}  // namespace ping_pong_sim
