#include "play_tool.h"

#include <OgreCamera.h>
#include <OgreRay.h>
#include <OgreViewport.h>
#include <rviz/display_context.h>
#include <rviz/properties/float_property.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/viewport_mouse_event.h>

#include <cmath>
#include <pluginlib/class_list_macros.hpp>

namespace ping_pong_sim
{
namespace
{
constexpr double kTiltPerNotch = 0.09;  ///< of the wheel [rad]
constexpr double kNotch = 120.0;        ///< what Qt calls a notch

EyeRay rayOf(const rviz::ViewportMouseEvent& event)
{
  const Ogre::Viewport& view = *event.viewport;
  const Ogre::Ray ray = view.getCamera()->getCameraToViewportRay(static_cast<float>(event.x) / view.getActualWidth(),
                                                                 static_cast<float>(event.y) / view.getActualHeight());
  const Ogre::Vector3 o = ray.getOrigin(), d = ray.getDirection();
  return {{o.x, o.y, o.z}, {d.x, d.y, d.z}};
}
}  // namespace

PlayTool::PlayTool()
{
  shortcut_key_ = 'p';
  const ping_pong::PlayParams play;
  rviz::Property* parent = getPropertyContainer();
  const auto number = [&](const char* name, double value, double least, double most, const char* text)
  {
    auto* property = new rviz::FloatProperty(name, static_cast<float>(value), text, parent, SLOT(updateParams()), this);
    property->setMin(static_cast<float>(least));
    property->setMax(static_cast<float>(most));
    return property;
  };
  assistance_ = number("Assistance", play.assistance, 0.0, 1.0,
                       "0: none. 1: how the blade is held and its stroke are helped; time and place are always yours.");
  depth_ = number("Depth", -play.depth, -1.0, 3.0,
                  "Of the plane in which the mouse moves the paddle, behind the end of the table [m].");
  stroke_speed_ = number("Stroke Speed", play.stroke_speed, 0.0, 20.0, "Of the blade when a button is pressed [m/s].");
}

void PlayTool::onInitialize()
{
  KeyTool::onInitialize();
  setName("Play");
  setDescription(
      "The mouse is the paddle. Left: drive, right: push, wheel: tilt, with Shift: camera. Enter serves, H shows all "
      "keys.");
  setCursor(QCursor(Qt::CrossCursor));
}

void PlayTool::update(float wall_dt, float ros_dt)
{
  KeyTool::update(wall_dt, ros_dt);
  turnViewWithEnds();
}

int PlayTool::processMouseEvent(rviz::ViewportMouseEvent& event)
{
  if (event.shift() || event.middle()) return KeyTool::processMouseEvent(event);
  if (event.wheel_delta != 0) hands().tilt(kTiltPerNotch * event.wheel_delta / kNotch);
  if (event.leftDown()) hands().stroke(true);
  if (event.rightDown()) hands().stroke(false);
  hands().point(rayOf(event));
  return 0;
}

void PlayTool::fillParams(OperatorParams& params) const
{
  KeyTool::fillParams(params);
  params.mouse = true;
  params.play.assistance = assistance_->getFloat();
  params.play.depth = -depth_->getFloat();
  params.play.stroke_speed = stroke_speed_->getFloat();
}

// A player who changes ends looks from the other one.
void PlayTool::turnViewWithEnds()
{
  const double end = hands().ownEnd();
  rviz::ViewController* view = context_->getViewManager()->getCurrent();
  if (end == end_ || view == nullptr) return;
  end_ = end;
  rviz::Property* yaw = view->subProp("Yaw");
  if (yaw->getValue().isValid()) yaw->setValue(std::remainder(yaw->getValue().toDouble() + M_PI, 2.0 * M_PI));
}
}  // namespace ping_pong_sim

PLUGINLIB_EXPORT_CLASS(ping_pong_sim::PlayTool, rviz::Tool)
