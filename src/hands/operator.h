// Somebody at the keys: selects things, moves them, and runs the simulation. In a thread of its own, so that neither a
// window nor a terminal ever waits for the simulator.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "held_keys.h"
#include "paddle_glide.h"
#include "ping_pong_sim/HandsState.h"
#include "sim_link.h"
#include "steady_move.h"

namespace ping_pong_sim
{
struct OperatorParams
{
  ping_pong::GlideParams glide;
  bool world_axes = false;     ///< moves act along the world's axes instead of the viewer's
  std::string shot = "serve";  ///< what a key launches
  double step = 0.01;          ///< [s], of the key for one step
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

  Operator(const std::string& simulator, std::shared_ptr<tf2_ros::Buffer> frames, const ping_pong::HoldLimits& limits,
           Listener listener = {});
  ~Operator();

  // --- Any thread ---
  void setParams(const OperatorParams& params);
  /// How the viewer looks; see viewAxes().
  void setView(const Eigen::Vector3d& right_W, const Eigen::Vector3d& up_W);
  /// Also for repetitions. A key that means nothing is told in `note`.
  void press(ping_pong::Key key);
  void release(ping_pong::Key key);
  void releaseAll();

private:
  void post(std::function<void()> job);
  void run();
  void tick();
  void obey(const ping_pong::KeyEntry& entry);
  void select(ping_pong::Group group);
  void wishChanged();
  void onPaddles(const PaddleStates::ConstPtr& states);
  void moveSteadily(double now);
  void note(const std::string& text);
  void onOther(const HandsState::ConstPtr& other);
  void publish(bool always);
  bool gliding() const;
  Eigen::Matrix3d axes() const;

  ros::CallbackQueue queue_;
  ros::NodeHandle nh_;
  SimLink link_;
  PaddleGlide paddle_;
  SteadyMove steady_;
  ping_pong::HeldKeys held_;
  OperatorParams params_;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();  ///< the viewer's
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
  std::atomic<bool> running_{true};
  std::thread thread_;
};
}  // namespace ping_pong_sim
