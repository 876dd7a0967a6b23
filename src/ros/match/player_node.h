// The node `player`: a computer player that uses public topics and services alone, as any robot's node would.
#pragma once

#include <ros/node_handle.h>
#include <std_msgs/UInt8.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "ping_pong_sim/BallStates.h"
#include "ping_pong_sim/PaddleStates.h"
#include "ping_pong_sim/Score.h"
#include "ping_pong_sim/Toss.h"
#include "ping_pong_sim/scene.h"
#include "play/player.h"
#include "teleop/call_deadline.h"
#include "teleop/worker.h"

namespace ping_pong_sim
{
struct PlayerNodeParams
{
  std::string scene_path;           ///< that the simulator runs, too
  std::string paddle = "paddle_b";  ///< body that it plays with
  std::string umpire = "umpire";    ///< name of the node that throws the ball up for it
  double serve_after = 1.0;         ///< pause before its service [s of simulated time]
  int level = 3;
  ping_pong::play::Style style = ping_pong::play::Style::Mixed;
  std::uint64_t seed = 1;
  bool show_plan = false;  ///< publish markers on ~plan
};

/// For one thread. All happens in callbacks.
class PlayerNode
{
public:
  /// Throws LoadError or std::invalid_argument, in one line.
  PlayerNode(ros::NodeHandle& nh, ros::NodeHandle& private_nh, const PlayerNodeParams& params);

  /// Serves when it is its turn.
  void update();

private:
  void onBalls(const BallStates& message);
  void onPaddles(const PaddleStates& message);
  void onScore(const Score& message);
  void onLevel(const std_msgs::UInt8& message);

  void makePlayer();
  void watchNewest(const BallStates& message);
  void ask(Toss exchange);
  void act();
  bool serves() const;
  void showPlan();

  PlayerNodeParams params_;
  ping_pong::Scene scene_;
  std::unique_ptr<ping_pong::play::Player> player_;
  ping_pong::play::Observation now_;
  ping_pong::BallId ball_ = 0;  ///< that it watches
  double paddle_time_ = -1.0;   ///< of the pose in now_ [s]
  double turn_since_ = 0.0;     ///< its turn to serve, and nothing in play, since then [s]
  bool turn_ = false;           ///< its turn to serve, and nothing in play
  std::optional<Score> score_;  ///< the last
  double last_wall_ = 0.0;      ///< when it last asked for the ball [s]

  ros::Publisher commands_, plan_;
  ros::Subscriber balls_, paddles_, score_topic_, level_topic_;
  std::atomic<bool> asking_{false};  ///< for the ball
  ros::ServiceClient toss_;          ///< these two belong to the thread of the next
  CallDeadline deadline_;
  Worker asker_;  ///< last: it ends first
};
}  // namespace ping_pong_sim
