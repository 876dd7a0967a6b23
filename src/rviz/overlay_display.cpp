#include "overlay_display.h"

#include <OgreQuaternion.h>
#include <OgreVector.h>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/properties/float_property.h>
#include <rviz/properties/int_property.h>
#include <rviz/properties/ros_topic_property.h>

#include <chrono>
#include <pluginlib/class_list_macros.hpp>

#include "text_panel.h"

namespace ping_pong_sim
{
namespace
{
constexpr double kSilence = 2.5;  ///< after which a speaker counts as gone [s]; both topics come at least once a second

double wallNow()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

QColor colorOf(Tone tone)
{
  switch (tone)
  {
    case Tone::Title:
      return {255, 214, 120};
    case Tone::Faint:
      return {170, 182, 200};
    case Tone::Warning:
      return {255, 120, 100};
    case Tone::Normal:
      break;
  }
  return {236, 240, 248};
}
}  // namespace

OverlayDisplay::OverlayDisplay()
{
  using ros::message_traits::datatype;
  status_topic_ = new rviz::RosTopicProperty("Status Topic", "status", datatype<SimStatus>(),
                                             "ping_pong_sim/SimStatus of the simulator.", this, SLOT(subscribe()));
  hands_topic_ = new rviz::RosTopicProperty("Hands Topic", "hands", datatype<HandsState>(),
                                            "ping_pong_sim/HandsState of those at the keys.", this, SLOT(subscribe()));
  size_ = new rviz::IntProperty("Size", 14, "Height of the letters [pixels].", this, SLOT(redraw()));
  size_->setMin(6);
  size_->setMax(100);
  left_ = new rviz::IntProperty("Left", 10, "From the left edge of the view [pixels].", this, SLOT(redraw()));
  top_ = new rviz::IntProperty("Top", 10, "From its upper edge [pixels].", this, SLOT(redraw()));
  background_ =
      new rviz::FloatProperty("Background", 0.45f, "How dark it is behind the text, 0 to 1.", this, SLOT(redraw()));
  background_->setMin(0.0f);
  background_->setMax(1.0f);
}

OverlayDisplay::~OverlayDisplay() = default;

void OverlayDisplay::onInitialize()
{
  panel_ = std::make_unique<TextPanel>();
}

void OverlayDisplay::onEnable()
{
  subscribe();
  drawn_.clear();
  panel_->show(true);
}

void OverlayDisplay::onDisable()
{
  status_subscriber_.shutdown();
  hands_subscriber_.shutdown();
  panel_->show(false);
}

void OverlayDisplay::reset()
{
  rviz::Display::reset();
  heard_.clear();
  status_.reset();
  subscribe();
}

void OverlayDisplay::subscribe()
{
  status_subscriber_.shutdown();
  hands_subscriber_.shutdown();
  if (!isEnabled()) return;
  // Callbacks come in the window's own thread.
  const boost::function<void(const SimStatus::ConstPtr&)> on_status = [this](const SimStatus::ConstPtr& message)
  {
    status_ = *message;
    status_at_ = wallNow();
  };
  const boost::function<void(const HandsState::ConstPtr&)> on_hands = [this](const HandsState::ConstPtr& message) {
    heard_[message->operator_name] = {*message, wallNow()};
  };
  try
  {
    status_subscriber_ = update_nh_.subscribe<SimStatus>(status_topic_->getTopicStd(), 1, on_status);
    hands_subscriber_ = update_nh_.subscribe<HandsState>(hands_topic_->getTopicStd(), 10, on_hands);
    setStatus(rviz::StatusProperty::Ok, "Topics", "OK");
  }
  catch (const ros::Exception& error)
  {
    setStatus(rviz::StatusProperty::Error, "Topics", QString("Cannot subscribe: ") + error.what());
  }
}

void OverlayDisplay::redraw()
{
  drawn_.clear();
}

void OverlayDisplay::update(float /*wall_dt*/, float /*ros_dt*/)
{
  const double now = wallNow();
  const bool alive = status_ && now - status_at_ < kSilence;
  std::vector<TextLine> text = overlayText(alive ? &*status_ : nullptr, operators(now));
  if (text == drawn_) return;
  std::vector<TextPanel::Line> lines;
  for (const TextLine& line : text) lines.emplace_back(QString::fromStdString(line.text), colorOf(line.tone));
  panel_->draw(lines, size_->getInt(), QColor(10, 14, 22, static_cast<int>(255 * background_->getFloat())));
  panel_->place(left_->getInt(), top_->getInt());
  drawn_ = std::move(text);
  queueRender();
}

std::vector<OperatorLine> OverlayDisplay::operators(double now)
{
  std::vector<OperatorLine> lines;
  for (auto heard = heard_.begin(); heard != heard_.end();)
  {
    if (now - heard->second.at > kSilence)
    {
      heard = heard_.erase(heard);
      continue;
    }
    lines.push_back({heard->second.state, poseOf(heard->second.state.selected)});
    ++heard;
  }
  return lines;
}

std::optional<Eigen::Isometry3d> OverlayDisplay::poseOf(const std::string& frame) const
{
  Ogre::Vector3 p;
  Ogre::Quaternion q;
  if (frame.empty() || !context_->getFrameManager()->getTransform(frame, ros::Time(), p, q)) return std::nullopt;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
  pose.translation() << p.x, p.y, p.z;
  return pose;
}
}  // namespace ping_pong_sim

PLUGINLIB_EXPORT_CLASS(ping_pong_sim::OverlayDisplay, rviz::Display)
