// The keys in RViz. The mouse still moves the camera while this tool is active; for the handles there is RViz's own tool Interact.
#pragma once

#include <rviz/default_plugin/tools/move_tool.h>

#include <memory>
#include <optional>
#include <vector>

#include "teleop/operator.h"

namespace rviz
{
class BoolProperty;
class FloatProperty;
class StringProperty;
}  // namespace rviz

namespace ping_pong_sim
{
class KeyTool : public rviz::MoveTool
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

protected Q_SLOTS:
  void updateParams();

protected:
  virtual void fillParams(OperatorParams& params) const;
  Operator& hands() { return *operator_; }

private:
  void switchView(int number);
  void switchTool(int number);
  void lookAtView();

  std::shared_ptr<Operator> operator_;  ///< one for all tools of the window: there is one person at it
  bool active_ = false;
  rviz::BoolProperty* world_axes_;
  rviz::FloatProperty* acceleration_;
  rviz::FloatProperty* angular_acceleration_;
  rviz::FloatProperty* damping_;
  rviz::FloatProperty* speed_;
  rviz::FloatProperty* angular_speed_;
  rviz::StringProperty* shot_;
  rviz::BoolProperty* reach_;
  std::vector<rviz::FloatProperty*> reach_sides_;  ///< behind, over, side, below, above
  Eigen::Vector3d right_W_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d up_W_ = Eigen::Vector3d::Zero();
};
}  // namespace ping_pong_sim
