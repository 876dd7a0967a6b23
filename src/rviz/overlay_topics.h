// What the overlay listens to: the simulator, those at the keys, and a match. In the thread that serves the node handle.
#pragma once

#include <ros/node_handle.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ping_pong_sim/HandsState.h"
#include "ping_pong_sim/Score.h"
#include "ping_pong_sim/SimStatus.h"
#include "ping_pong_sim/UmpireCall.h"

namespace ping_pong_sim
{
class OverlayTopics
{
public:
  /// Throws ros::Exception. `score` and `umpire_call` keep their names.
  void subscribe(ros::NodeHandle& nh, const std::string& status, const std::string& hands);
  void shutdown();
  /// What was heard so far.
  void forget();

  /// Null: it is silent.
  const SimStatus* status() const;
  /// Those who are heard, by name.
  std::vector<const HandsState*> operators();
  /// Null: no umpire is there.
  const Score* score() const;
  /// The last call, while it is news; null: none.
  const UmpireCall* call() const;

private:
  template <class Message>
  struct Heard
  {
    Message message;
    double at;  ///< wall time [s]
  };
  std::optional<Heard<SimStatus>> status_;
  std::map<std::string, Heard<HandsState>> hands_;
  std::optional<Score> score_;
  std::optional<Heard<UmpireCall>> call_;
  std::vector<ros::Subscriber> subscribers_;
  ros::Subscriber score_topic_;
};
}  // namespace ping_pong_sim
