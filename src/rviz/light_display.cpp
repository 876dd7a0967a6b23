#include "light_display.h"

#include <OgreLight.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/ogre_helpers/shape.h>
#include <rviz/properties/bool_property.h>
#include <rviz/properties/color_property.h>
#include <rviz/properties/enum_property.h>
#include <rviz/properties/float_property.h>
#include <rviz/properties/parse_color.h>
#include <rviz/properties/string_property.h>
#include <rviz/properties/tf_frame_property.h>

#include <algorithm>
#include <pluginlib/class_list_macros.hpp>
#include <sstream>

namespace ping_pong_sim
{
namespace
{
constexpr char kHeadlight[] = "MainDirectional";  ///< RViz's own name for it
constexpr int kRolesEvery = 15;                   ///< frames between looks for new things in the scene

std::string uniqueName()
{
  static int count = 0;
  return "ping_pong_light_" + std::to_string(count++);
}

std::vector<std::string> words(const std::string& text)
{
  std::istringstream stream(text);
  std::vector<std::string> found;
  for (std::string word; stream >> word;) found.push_back(word);
  return found;
}
}  // namespace

LightDisplay::LightDisplay()
{
  const auto number = [this](const char* name, float value, float most, const char* text)
  {
    auto* property = new rviz::FloatProperty(name, value, text, this, SLOT(updateLight()));
    property->setMin(0.0f);
    property->setMax(most);
    return property;
  };
  const auto flag = [this](const char* name, bool value, const char* text)
  { return new rviz::BoolProperty(name, value, text, this, SLOT(updateLight())); };
  frame_ = new rviz::TfFrameProperty("Frame", "light", "The light is in its origin and shines along its x axis.", this,
                                     nullptr, false);
  type_ = new rviz::EnumProperty("Type", "Spot", "How it shines.", this, SLOT(updateLight()));
  type_->addOption("Spot", Ogre::Light::LT_SPOTLIGHT);
  type_->addOption("Directional", Ogre::Light::LT_DIRECTIONAL);
  type_->addOption("Point", Ogre::Light::LT_POINT);
  color_ = new rviz::ColorProperty("Color", QColor(255, 244, 224), "Its colour.", this, SLOT(updateLight()));
  intensity_ = number("Intensity", 1.0f, 10.0f, "Factor of the colour.");
  ambient_ = number("Ambient", 0.35f, 1.0f, "Light from everywhere, so that nothing is black.");
  inner_ = number("Inner Angle", 40.0f, 170.0f, "Spot: full light within this cone [degrees].");
  outer_ = number("Outer Angle", 75.0f, 175.0f, "Spot: no light outside this cone [degrees].");
  bulb_shown_ = flag("Show Bulb", true, "Shows where the light is.");
  headlight_off_ = flag("Replace Headlight", true, "RViz's own light at the viewer is off while this one is on.");
  casts_ = flag("Cast Shadows", false, "Shadows cost about a quarter of the frame rate without a GPU.");
  shade_ = number("Shade", 0.45f, 1.0f, "How much light stays in a shadow.");
  silent_ = new rviz::StringProperty("No Shadow From", "table_frame",
                                     "Parts of mesh names: what would throw a shadow on the surface above it.", this,
                                     SLOT(updateLight()));
  receivers_ = new rviz::StringProperty("Receivers", "floor table_top",
                                        "Parts of mesh names: surfaces that take shadows and throw none.", this,
                                        SLOT(updateLight()));
}

LightDisplay::~LightDisplay()
{
  if (light_ == nullptr) return;
  shine(false);
  bulb_.reset();
  light_node_->detachObject(light_);
  scene_manager_->destroyLight(light_);
  scene_manager_->destroySceneNode(light_node_);
}

void LightDisplay::onInitialize()
{
  frame_->setFrameManager(context_->getFrameManager());
  light_ = scene_manager_->createLight(uniqueName());
  light_->setVisible(false);
  light_node_ = scene_node_->createChildSceneNode();
  // Ogre's lights shine along -z.
  light_node_->setOrientation(Ogre::Quaternion(Ogre::Degree(-90.0f), Ogre::Vector3::UNIT_Y));
  light_node_->attachObject(light_);
  bulb_ = std::make_unique<rviz::Shape>(rviz::Shape::Cone, scene_manager_, scene_node_);
  bulb_->setScale(Ogre::Vector3(0.10f, 0.14f, 0.10f));
  bulb_->setOrientation(Ogre::Quaternion(Ogre::Degree(90.0f), Ogre::Vector3::UNIT_Z));  // wide end in front
  bulb_->getRootNode()->setVisible(false);
}

void LightDisplay::onEnable()
{
  shine(true);
  updateLight();
}

void LightDisplay::onDisable()
{
  shine(false);
}

// What is not this display's own is put back as it was.
void LightDisplay::shine(bool on)
{
  if (on == enabled_here_) return;
  enabled_here_ = on;
  if (on)
  {
    ambient_before_ = scene_manager_->getAmbientLight();
    shadows_ = ShadowRig::of(scene_manager_);
    return;
  }
  light_->setVisible(false);
  bulb_->getRootNode()->setVisible(false);
  dimHeadlight(false);
  shadows_->removeLight(light_);
  shadows_.reset();
  scene_manager_->setAmbientLight(ambient_before_);
}

void LightDisplay::dimHeadlight(bool dim)
{
  if (dim == headlight_dimmed_ || !scene_manager_->hasLight(kHeadlight)) return;
  Ogre::Light* headlight = scene_manager_->getLight(kHeadlight);
  if (dim) headlight_before_ = headlight->getVisible();
  headlight->setVisible(!dim && headlight_before_);
  headlight_dimmed_ = dim;
}

void LightDisplay::updateLight()
{
  if (!enabled_here_) return;
  const auto type = static_cast<Ogre::Light::LightTypes>(type_->getOptionInt());
  const Ogre::ColourValue color = rviz::qtToOgre(color_->getColor()) * intensity_->getFloat();
  light_->setType(type);
  light_->setDiffuseColour(color);
  light_->setSpecularColour(color * 0.3f);
  light_->setAttenuation(100.0f, 1.0f, 0.0f, 0.0f);
  if (type == Ogre::Light::LT_SPOTLIGHT)
  {
    const float outer = outer_->getFloat();
    light_->setSpotlightRange(Ogre::Degree(std::min(inner_->getFloat(), outer)), Ogre::Degree(outer), 1.0f);
  }
  light_->setShadowFarClipDistance(40.0f);
  light_->setCastShadows(casts_->getBool());
  const float ambient = ambient_->getFloat();
  scene_manager_->setAmbientLight(Ogre::ColourValue(ambient, ambient, ambient));
  bulb_->setColor(rviz::qtToOgre(color_->getColor()));
  dimHeadlight(headlight_off_->getBool());

  shadows_->setRoles(words(receivers_->getStdString()), words(silent_->getStdString()));
  shadows_->setShade(shade_->getFloat());
  shadows_->setLight(light_, casts_->getBool());
  if (casts_->getBool() && !shadows_->problem().empty())
    setStatusStd(rviz::StatusProperty::Warn, "Shadows", shadows_->problem());
  else
    deleteStatus("Shadows");
  queueRender();
}

void LightDisplay::update(float /*wall_dt*/, float /*ros_dt*/)
{
  const bool there = followFrame();
  light_->setVisible(there);
  bulb_->getRootNode()->setVisible(there && bulb_shown_->getBool());
  if (shadows_ && casts_->getBool() && frames_++ % kRolesEvery == 0) shadows_->assignRoles();
}

bool LightDisplay::followFrame()
{
  Ogre::Vector3 p;
  Ogre::Quaternion q;
  const std::string frame = frame_->getFrameStd();
  if (!context_->getFrameManager()->getTransform(frame, ros::Time(), p, q))
  {
    setStatusStd(rviz::StatusProperty::Error, "Frame", "nobody says where " + frame + " is: the light is off");
    return false;
  }
  setStatus(rviz::StatusProperty::Ok, "Frame", "OK");
  scene_node_->setPosition(p);
  scene_node_->setOrientation(q);
  return true;
}
}  // namespace ping_pong_sim

PLUGINLIB_EXPORT_CLASS(ping_pong_sim::LightDisplay, rviz::Display)
