// On-screen text: how the simulation does, what is selected and where, what happened last.
#pragma once

#include <ros/subscriber.h>
#include <rviz/display.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "overlay_text.h"

namespace rviz
{
class ColorProperty;
class FloatProperty;
class IntProperty;
class RosTopicProperty;
}  // namespace rviz

namespace ping_pong_sim
{
class TextPanel;

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
  struct Heard
  {
    HandsState state;
    double at;  ///< wall time [s]
  };
  std::vector<OperatorLine> operators(double now);
  std::optional<Eigen::Isometry3d> poseOf(const std::string& frame) const;

  rviz::RosTopicProperty* status_topic_;
  rviz::RosTopicProperty* hands_topic_;
  rviz::IntProperty* size_;
  rviz::IntProperty* left_;
  rviz::IntProperty* top_;
  rviz::FloatProperty* background_;
  ros::Subscriber status_subscriber_;
  ros::Subscriber hands_subscriber_;
  std::optional<SimStatus> status_;
  double status_at_ = 0.0;  ///< wall time [s]
  std::map<std::string, Heard> heard_;
  std::vector<TextLine> drawn_;
  std::unique_ptr<TextPanel> panel_;
};
}  // namespace ping_pong_sim
