// The node `umpire`: watches `contacts` and `balls`, publishes `score` and `umpire_call`, throws the ball up for the server.
#pragma once

#include <ros/node_handle.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "event_order.h"
#include "game/umpire.h"
#include "ping_pong_sim/BallStates.h"
#include "ping_pong_sim/Contact.h"
#include "ping_pong_sim/NewMatch.h"
#include "ping_pong_sim/PaddleStates.h"
#include "ping_pong_sim/Score.h"
#include "ping_pong_sim/Toss.h"
#include "ping_pong_sim/UmpireCall.h"
#include "ping_pong_sim/scene.h"
#include "teleop/sim_link.h"

namespace ping_pong_sim
{
struct UmpireParams
{
  std::string scene_path;  ///< that the simulator runs, too
  std::string simulator = "ping_pong_sim";
  std::string rules = "relaxed";
  int best_of = 0;  ///< games, odd; 0: as the rules have it
  std::array<std::string, 2> players{"A", "B"};
  bool change_ends = false;   ///< if the rules ask for it; the node `player` keeps its paddle
  std::string result_file;    ///< written when a match is over; empty: none
  double serve_within = 0.0;  ///< a server who has no ball in play by then forfeits the match [s]; 0: nobody is hurried
};

/// For one thread, which serves the callbacks and calls update() often.
class UmpireNode
{
public:
  /// Throws LoadError or std::invalid_argument, in one line: no such scene, or none that a match can be played in.
  UmpireNode(ros::NodeHandle& nh, ros::NodeHandle& private_nh, const UmpireParams& params);

  /// Judges what has come.
  void update();

private:
  void onContact(const Contact& message);
  void onBalls(const BallStates& message);
  bool newMatch(NewMatch::Request& request, NewMatch::Response& response);
  bool toss(Toss::Request& request, Toss::Response& response);

  void judge(const ping_pong::Contact& contact);
  void judge(const TickEnd& tick);
  void beginService(const TickEnd& tick);
  void watchServer();
  std::string startMatch(const NewMatch::Request& request);
  std::string throwUp(const Toss::Request& request, ping_pong::BallId& ball);
  ping_pong::Vector3d handOf(const Toss::Request& request) const;
  bool rightScene();

  void publish();
  void writeResultFile();
  void publishScore();
  void publishCall(UmpireCall message, double time);
  void notice(const std::string& text);
  ros::Time stamp(double time) const;

  UmpireParams params_;
  ping_pong::Scene scene_;
  std::map<std::string, std::size_t> body_of_;  ///< by name
  std::unique_ptr<ping_pong::game::Umpire> umpire_;
  EventOrder events_;
  SimLink simulator_;
  double time_ = 0.0;                        ///< of the last tick that was judged [s]
  double idle_since_ = 0.0;                  ///< no ball was in play since then [s]
  ros::Time last_stamp_;                     ///< clock of the last message
  double last_time_ = 0.0;                   ///< world time of the same message [s]
  std::optional<ping_pong::BallId> thrown_;  ///< on its way up, not yet seen
  double thrown_at_ = 0.0;                   ///< [s]
  ping_pong::BallId last_ball_ = 0;          ///< of the rally before; 0: none
  double stroke_speed_ = 0.0, stroke_spin_ = 0.0;
  std::array<ping_pong::Vector3d, 2> racket_;  ///< where the rackets are, by index(End) [m]
  bool scene_told_ = false;                    ///< the wrong scene was complained of
  Score shown_;                                ///< what was published last

  ros::Publisher score_, calls_;
  ros::Subscriber contacts_, balls_, paddles_;
  ros::ServiceServer new_match_, toss_;
};
}  // namespace ping_pong_sim
