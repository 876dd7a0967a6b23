// On-screen text: how the simulation does, what is selected and where, what happened last; the score of a match; the next useful key.
#pragma once

#include <rviz/display.h>

#include <QColor>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "overlay_text.h"
#include "overlay_topics.h"

namespace rviz
{
class ColorProperty;
class FloatProperty;
class IntProperty;
class RosTopicProperty;
}  // namespace rviz

namespace ping_pong_sim
{
class ImagePanel;

class OverlayDisplay : public rviz::Display
{
  Q_OBJECT

public:
  OverlayDisplay();
  ~OverlayDisplay() override;

  void onInitialize() override;
  void update(float wall_dt, float ros_dt) override;
  void reset() override;

protected:
  void onEnable() override;
  void onDisable() override;

private Q_SLOTS:
  void subscribe();
  void redraw();

private:
  void drawText();
  void drawScore();
  void drawHint();
  bool ballInPlay() const;
  QColor background() const;
  std::optional<Eigen::Isometry3d> poseOf(const std::string& frame) const;

  rviz::RosTopicProperty* status_topic_;
  rviz::RosTopicProperty* hands_topic_;
  rviz::IntProperty* size_;
  rviz::IntProperty* left_;
  rviz::IntProperty* top_;
  rviz::FloatProperty* background_;
  rviz::IntProperty* score_size_;
  OverlayTopics topics_;
  std::vector<TextLine> text_drawn_;
  std::string score_drawn_;
  std::string hint_drawn_;
  std::unique_ptr<ImagePanel> text_;
  std::unique_ptr<ImagePanel> score_;
  std::unique_ptr<ImagePanel> hint_;
};
}  // namespace ping_pong_sim
