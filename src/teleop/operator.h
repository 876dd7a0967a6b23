// Somebody at the keys and the mouse: selects things, moves them, plays, and runs the simulation. In a thread of its own, so that
// neither a window nor a terminal ever waits for the simulator.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "held_keys.h"
#include "match_desk.h"
#include "paddle_glide.h"
#include "paddle_play.h"
#include "ping_pong_sim/HandsState.h"
#include "sim_link.h"
#include "steady_move.h"
#include "worker.h"

namespace ping_pong_sim
{
struct OperatorParams
{
  ping_pong::GlideParams glide;
  ping_pong::Reach reach;
  ping_pong::PlayParams play;
  bool mouse = false;          ///< the mouse plays
  bool world_axes = false;     ///< moves act along the world's axes instead of the viewer's
  std::string shot = "drive";  ///< what a key launches
  double step = 0.01;          ///< [s], of the key for one step
};

/// Of the nodes that it asks.
struct NodeNames
{
  std::string simulator = "ping_pong_sim";
  std::string umpire = "umpire";
};

class Operator
{
public:
  /// Both are called in the operator's thread, and may be empty.
  struct Listener
  {
    std::function<void(const HandsState&)> changed;  ///< what `hands` says
    std::function<void()> paddle_obeys;              ///< the first motion after a key was pressed or let go
  };

  /// @param player  see MatchDesk
  Operator(const NodeNames& names, int player, std::shared_ptr<tf2_ros::Buffer> frames,
           const ping_pong::HoldLimits& limits, Listener listener = {});
  ~Operator();

  // --- Any thread ---
  void setParams(const OperatorParams& params);
  /// How the viewer looks; see viewAxes().
  void setView(const Eigen::Vector3d& right_W, const Eigen::Vector3d& up_W);
  /// Also for repetitions. A key that means nothing is told in `note`.
  void press(ping_pong::Key key);
  void release(ping_pong::Key key);
  void releaseAll();
  /// The mouse, while it plays: where it is, its wheel (opens the blade [rad]), and a button (see PlayHand::stroke).
  void point(const EyeRay& ray);
  void tilt(double angle);
  void stroke(bool up);
  /// End of the table at which the own paddle is: -1 at -x, +1 at +x.
  double ownEnd() const { return own_end_; }

private:
  void tick();
  void obey(const ping_pong::KeyEntry& entry);
  void select(ping_pong::Group group);
  void wishChanged();
  void onPaddles(const PaddleStates::ConstPtr& states);
  void findEnds();
  std::string ownPaddle() const;
  void moveSteadily(double now);
  void note(const std::string& text);
  void onOther(const HandsState::ConstPtr& other);
  void publish(bool always);
  bool gliding() const;
  Eigen::Matrix3d axes() const;

  Worker worker_;
  ros::NodeHandle nh_;
  SimLink link_;
  MatchDesk match_;
  PaddleGlide paddle_;
  PaddlePlay play_;
  SteadyMove steady_;
  ping_pong::HeldKeys held_;
  OperatorParams params_;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();  ///< the viewer's
  PaddleStates paddle_states_;
  std::atomic<double> own_end_{-1.0};
  Listener listener_;
  HandsState state_;
  HandsState told_;
  double told_at_ = 0.0;        ///< wallSeconds()
  double note_until_ = 0.0;     ///< wallSeconds()
  bool awaits_paddle_ = false;  ///< keys changed and no state has shown it yet
  bool troubled_ = false;       ///< the simulator was away in the last tick
  ros::Publisher hands_;
  ros::Subscriber others_;
  ros::Subscriber paddles_;
};
}  // namespace ping_pong_sim
