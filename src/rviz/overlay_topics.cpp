#include "overlay_topics.h"

#include "teleop/sim_link.h"

namespace ping_pong_sim
{
namespace
{
constexpr double kSilence = 2.5;  ///< after which a speaker counts as gone [s]; both topics come at least once a second
constexpr double kCallLife = 4.0;  ///< a call is news for so long [s]

template <class Message, class Keep>
ros::Subscriber listen(ros::NodeHandle& nh, const std::string& topic, std::uint32_t queue, Keep keep)
{
  const boost::function<void(const boost::shared_ptr<const Message>&)> call =
      [keep](const boost::shared_ptr<const Message>& message) { keep(*message); };
  return nh.subscribe<Message>(topic, queue, call);
}
}  // namespace

void OverlayTopics::subscribe(ros::NodeHandle& nh, const std::string& status, const std::string& hands)
{
  shutdown();
  subscribers_ = {listen<SimStatus>(nh, status, 1,
                                    [this](const SimStatus& m) {
                                      status_ = {m, wallSeconds()};
                                    }),
                  listen<HandsState>(nh, hands, 10,
                                     [this](const HandsState& m) {
                                       hands_[m.operator_name] = {m, wallSeconds()};
                                     }),
                  listen<UmpireCall>(nh, "umpire_call", 10,
                                     [this](const UmpireCall& m) {
                                       call_ = {m, wallSeconds()};
                                     })};
  score_topic_ = listen<Score>(nh, "score", 1, [this](const Score& m) { score_ = m; });
}

void OverlayTopics::shutdown()
{
  subscribers_.clear();
  score_topic_.shutdown();
}

void OverlayTopics::forget()
{
  *this = OverlayTopics();
}

const SimStatus* OverlayTopics::status() const
{
  return status_ && wallSeconds() - status_->at < kSilence ? &status_->message : nullptr;
}

std::vector<const HandsState*> OverlayTopics::operators()
{
  std::vector<const HandsState*> heard;
  for (auto entry = hands_.begin(); entry != hands_.end();)
  {
    if (wallSeconds() - entry->second.at > kSilence)
    {
      entry = hands_.erase(entry);
      continue;
    }
    heard.push_back(&entry->second.message);
    ++entry;
  }
  return heard;
}

const Score* OverlayTopics::score() const
{
  return score_ && score_topic_.getNumPublishers() > 0 ? &*score_ : nullptr;
}

const UmpireCall* OverlayTopics::call() const
{
  return call_ && wallSeconds() - call_->at < kCallLife ? &call_->message : nullptr;
}
}  // namespace ping_pong_sim
