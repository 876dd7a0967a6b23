#include "overlay_display.h"

#include <OgreQuaternion.h>
#include <OgreVector.h>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/properties/float_property.h>
#include <rviz/properties/int_property.h>
#include <rviz/properties/ros_topic_property.h>
#include <rviz/render_panel.h>
#include <rviz/view_manager.h>

#include <pluginlib/class_list_macros.hpp>
#include <sstream>

#include "hint.h"
#include "image_panel.h"
#include "score_image.h"
#include "text_image.h"

namespace ping_pong_sim
{
namespace
{
constexpr int kHintSize = 16;   ///< height of its letters [pixels]
constexpr int kHintAbove = 14;  ///< the lower edge of the view [pixels]

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
  score_size_ = new rviz::IntProperty(
      "Score Size", 22, "Height of the letters of a match's score [pixels]; 0: no score.", this, SLOT(redraw()));
  score_size_->setMin(0);
  score_size_->setMax(100);
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
  text_ = std::make_unique<ImagePanel>();
  score_ = std::make_unique<ImagePanel>();
  hint_ = std::make_unique<ImagePanel>();
}

void OverlayDisplay::onEnable()
{
  subscribe();
  redraw();
  for (ImagePanel* panel : {text_.get(), score_.get(), hint_.get()}) panel->show(true);
}

void OverlayDisplay::onDisable()
{
  topics_.shutdown();
  for (ImagePanel* panel : {text_.get(), score_.get(), hint_.get()}) panel->show(false);
}

void OverlayDisplay::reset()
{
  rviz::Display::reset();
  topics_.forget();
  subscribe();
}

void OverlayDisplay::subscribe()
{
  topics_.shutdown();
  if (!isEnabled()) return;
  try
  {
    // Callbacks come in the window's own thread.
    topics_.subscribe(update_nh_, status_topic_->getTopicStd(), hands_topic_->getTopicStd());
    setStatus(rviz::StatusProperty::Ok, "Topics", "OK");
  }
  catch (const ros::Exception& error)
  {
    setStatus(rviz::StatusProperty::Error, "Topics", QString("Cannot subscribe: ") + error.what());
  }
}

void OverlayDisplay::redraw()
{
  text_drawn_.clear();
  score_drawn_ = hint_drawn_ = "?";
}

void OverlayDisplay::update(float /*wall_dt*/, float /*ros_dt*/)
{
  drawText();
  drawScore();
  drawHint();
  const rviz::RenderPanel* view = context_->getViewManager()->getRenderPanel();
  if (view == nullptr) return;
  // Kept in the middle, also when the window changes its size.
  score_->place((view->width() - score_->width()) / 2, top_->getInt());
  hint_->place((view->width() - hint_->width()) / 2, view->height() - hint_->height() - kHintAbove);
}

QColor OverlayDisplay::background() const
{
  return {10, 14, 22, static_cast<int>(255 * background_->getFloat())};
}

void OverlayDisplay::drawText()
{
  std::vector<OperatorLine> operators;
  for (const HandsState* hands : topics_.operators()) operators.push_back({*hands, poseOf(hands->selected)});
  std::vector<TextLine> text = overlayText(topics_.status(), operators, topics_.score() != nullptr);
  if (text == text_drawn_) return;
  std::vector<ColoredLine> lines;
  for (const TextLine& line : text) lines.emplace_back(QString::fromStdString(line.text), colorOf(line.tone));
  text_->draw(textImage(lines, size_->getInt(), background()));
  text_->place(left_->getInt(), top_->getInt());
  text_drawn_ = std::move(text);
  queueRender();
}

void OverlayDisplay::drawScore()
{
  const Score* score = score_size_->getInt() > 0 ? topics_.score() : nullptr;
  const std::vector<const HandsState*> operators = topics_.operators();
  const int level = operators.empty() ? 0 : operators.front()->level;
  std::ostringstream key;  // what the picture shows
  if (score != nullptr)
  {
    Score shown = *score;
    shown.header = {};
    key << shown << level;
    if (topics_.call() != nullptr) key << *topics_.call();
  }
  if (key.str() == score_drawn_) return;
  score_drawn_ = key.str();
  const ScoreBoard board{score != nullptr ? *score : Score(), level, operators.empty() ? -1 : operators.front()->player,
                         topics_.call()};
  score_->draw(score != nullptr ? scoreImage(board, score_size_->getInt(), background()) : QImage());
  queueRender();
}

void OverlayDisplay::drawHint()
{
  const std::vector<const HandsState*> operators = topics_.operators();
  const std::string hint =
      hintLine(topics_.status(), operators.empty() ? nullptr : operators.front(), topics_.score(), ballInPlay());
  if (hint == hint_drawn_) return;
  hint_drawn_ = hint;
  const ColoredLine line{QString::fromStdString(hint), colorOf(Tone::Title)};
  hint_->draw(hint.empty() ? QImage() : textImage({line}, kHintSize, background()));
  queueRender();
}

// The newest ball is about the table, and not on the floor.
bool OverlayDisplay::ballInPlay() const
{
  const std::optional<Eigen::Isometry3d> ball = poseOf("newest_ball");
  const std::optional<Eigen::Isometry3d> table = poseOf("table");
  const SimStatus* status = topics_.status();
  if (!ball || !table || status == nullptr || status->balls == 0) return false;
  const Eigen::Vector3d p = table->inverse() * ball->translation();
  return std::abs(p.x()) < 3.2 && std::abs(p.y()) < 2.2 && p.z() > -0.6 && status->kinetic_energy > 1e-6;
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
