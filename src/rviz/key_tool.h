// The keys in RViz. The mouse still moves the camera and the handles while this tool is active.
#pragma once

#include <rviz/default_plugin/tools/interaction_tool.h>

#include <memory>
#include <optional>

#include "hands/operator.h"

namespace rviz
{
class BoolProperty;
class FloatProperty;
class StringProperty;
}  // namespace rviz

namespace ping_pong_sim
{
class KeyTool : public rviz::InteractionTool
{
  Q_OBJECT

public:
  KeyTool();
  ~KeyTool() override;

  void onInitialize() override;
  void activate() override;
  void deactivate() override;
  void update(float wall_dt, float ros_dt) override;
  /// Presses, while the mouse is over the 3D view.
  int processKeyEvent(QKeyEvent* event, rviz::RenderPanel* panel) override;
  /// Releases, and the loss of the keyboard; RViz does not pass them on.
  bool eventFilter(QObject* object, QEvent* event) override;

private Q_SLOTS:
  void updateParams();

private:
  void switchView(int number);
  void lookAtView();

  std::unique_ptr<Operator> operator_;
  rviz::BoolProperty* world_axes_;
  rviz::FloatProperty* acceleration_;
  rviz::FloatProperty* angular_acceleration_;
  rviz::FloatProperty* damping_;
  rviz::FloatProperty* speed_;
  rviz::FloatProperty* angular_speed_;
  rviz::StringProperty* shot_;
  Eigen::Vector3d right_W_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d up_W_ = Eigen::Vector3d::Zero();
};
}  // namespace ping_pong_sim
