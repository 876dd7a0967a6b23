// The match, as somebody at the keys sees it: is there one, whose turn is it, and what can be asked of umpire and opponent.
#pragma once

#include <ros/node_handle.h>

#include <optional>
#include <string>

#include "ping_pong_sim/Score.h"
#include "sim_link.h"

namespace ping_pong_sim
{
class MatchDesk
{
public:
  /// @param umpire  name of its node, for its services
  /// @param player  0 or 1: who sits at the keys; -1: nobody of the match
  MatchDesk(ros::NodeHandle& nh, SimLink& link, const std::string& umpire, int player);

  /// The newest score; nullptr: no umpire is there.
  const Score* score() const;
  /// Who sits at the keys: 0 or 1; -1: nobody of the match, or no match.
  int player() const { return score() != nullptr ? player_ : -1; }
  /// Their paddle; empty: none.
  std::string ownPaddle() const;
  /// Of the opponent: as told on `player_level`, before that as the parameter of the same name says; 0: not known.
  int level() const { return level_; }

  // --- What went wrong, for people; empty: done ---
  std::string toss();
  std::string newMatch();
  /// One level up or down, on the topic `player_level`.
  std::string changeLevel(int by);

private:
  SimLink& link_;
  std::string umpire_;
  int player_;
  std::optional<Score> score_;
  int level_ = 0;
  ros::Subscriber score_topic_;
  ros::Subscriber level_heard_;
  ros::Publisher level_told_;
};
}  // namespace ping_pong_sim
