#include "match_desk.h"

#include <std_msgs/UInt8.h>

#include <algorithm>

#include "ping_pong_sim/NewMatch.h"
#include "ping_pong_sim/Toss.h"

namespace ping_pong_sim
{
namespace
{
constexpr char kNoMatch[] = "there is no match here: scene:=match has one";
constexpr int kLowest = 1, kHighest = 5, kUnheard = 3;  ///< levels
}  // namespace

MatchDesk::MatchDesk(ros::NodeHandle& nh, SimLink& link, const std::string& umpire, int player)
    : link_(link), umpire_(umpire), player_(player)
{
  const boost::function<void(const Score::ConstPtr&)> keep = [this](const Score::ConstPtr& score) { score_ = *score; };
  score_topic_ = nh.subscribe<Score>("score", 1, keep);
  const boost::function<void(const std_msgs::UInt8::ConstPtr&)> hear = [this](const std_msgs::UInt8::ConstPtr& level)
  { level_ = level->data; };
  nh.param("player_level", level_, level_);
  level_heard_ = nh.subscribe<std_msgs::UInt8>("player_level", 1, hear);
}

const Score* MatchDesk::score() const
{
  return score_ && score_topic_.getNumPublishers() > 0 ? &*score_ : nullptr;
}

std::string MatchDesk::ownPaddle() const
{
  return player() >= 0 ? score()->paddles[static_cast<std::size_t>(player())] : "";
}

std::string MatchDesk::toss()
{
  Toss exchange;
  return link_.callAt(umpire_ + "/toss", exchange);
}

std::string MatchDesk::newMatch()
{
  if (score() == nullptr) return kNoMatch;
  NewMatch exchange;
  exchange.request.server = -1;
  return link_.callAt(umpire_ + "/new_match", exchange);
}

std::string MatchDesk::changeLevel(int by)
{
  if (score() == nullptr) return kNoMatch;
  // Advertised late: a latched level that nobody chose would hide the one that the player began with.
  if (!level_told_) level_told_ = link_.nh().advertise<std_msgs::UInt8>("player_level", 1, true);
  const int wanted = (level_ > 0 ? level_ : kUnheard) + by;
  level_ = std::clamp(wanted, kLowest, kHighest);
  std_msgs::UInt8 message;
  message.data = static_cast<std::uint8_t>(level_);
  level_told_.publish(message);
  return wanted == level_ ? "" : "this is the " + std::string(by > 0 ? "highest" : "lowest") + " level";
}
}  // namespace ping_pong_sim
