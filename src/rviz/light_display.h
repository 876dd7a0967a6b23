// A light on a TF frame: it shines along the frame's x axis and moves with it.
#pragma once

#include <OgreColourValue.h>
#include <rviz/display.h>

#include <memory>

#include "shadow_rig.h"

namespace Ogre
{
class Light;
}
namespace rviz
{
class BoolProperty;
class ColorProperty;
class EnumProperty;
class FloatProperty;
class Shape;
class StringProperty;
class TfFrameProperty;
}  // namespace rviz

namespace ping_pong_sim
{
class LightDisplay : public rviz::Display
{
  Q_OBJECT

public:
  LightDisplay();
  ~LightDisplay() override;

  void onInitialize() override;
  void update(float wall_dt, float ros_dt) override;

protected:
  void onEnable() override;
  void onDisable() override;

private Q_SLOTS:
  void updateLight();

private:
  void shine(bool on);
  bool followFrame();
  void dimHeadlight(bool dim);

  rviz::TfFrameProperty* frame_;
  rviz::EnumProperty* type_;
  rviz::ColorProperty* color_;
  rviz::FloatProperty* intensity_;
  rviz::FloatProperty* ambient_;
  rviz::FloatProperty* inner_;
  rviz::FloatProperty* outer_;
  rviz::BoolProperty* bulb_shown_;
  rviz::BoolProperty* headlight_off_;
  rviz::BoolProperty* casts_;
  rviz::FloatProperty* shade_;
  rviz::StringProperty* receivers_;
  rviz::StringProperty* silent_;

  Ogre::Light* light_ = nullptr;
  Ogre::SceneNode* light_node_ = nullptr;
  std::unique_ptr<rviz::Shape> bulb_;
  std::shared_ptr<ShadowRig> shadows_;
  Ogre::ColourValue ambient_before_;
  bool headlight_before_ = false;
  bool headlight_dimmed_ = false;
  bool enabled_here_ = false;
  int frames_ = 0;
};
}  // namespace ping_pong_sim
