// Play with the mouse: it moves the paddle in a plane behind the end of the table, its buttons strike, its wheel tilts the blade.
// With Shift the mouse moves the camera. All keys of the tool Keys work too.
#pragma once

#include "key_tool.h"

namespace ping_pong_sim
{
class PlayTool : public KeyTool
{
  Q_OBJECT

public:
  PlayTool();
  void onInitialize() override;
  void update(float wall_dt, float ros_dt) override;
  int processMouseEvent(rviz::ViewportMouseEvent& event) override;

protected:
  void fillParams(OperatorParams& params) const override;

private:
  void turnViewWithEnds();

  rviz::FloatProperty* assistance_;
  rviz::FloatProperty* depth_;
  rviz::FloatProperty* stroke_speed_;
  double end_ = -1.0;  ///< that the view shows from behind; see Operator::ownEnd()
};
}  // namespace ping_pong_sim
