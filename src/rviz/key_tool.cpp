#include "key_tool.h"

#include <OgreCamera.h>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/properties/bool_property.h>
#include <rviz/properties/float_property.h>
#include <rviz/properties/string_property.h>
#include <rviz/tool_manager.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>

#include <QApplication>
#include <QKeyEvent>
#include <pluginlib/class_list_macros.hpp>
#include <tuple>

namespace ping_pong_sim
{
namespace
{
std::optional<ping_pong::Key> toKey(const QKeyEvent& event)
{
  const int key = event.key();
  if (key >= Qt::Key_A && key <= Qt::Key_Z) return 'a' + (key - Qt::Key_A);
  if (key >= Qt::Key_F1 && key <= Qt::Key_F12) return ping_pong::kFunction + 1 + (key - Qt::Key_F1);
  if (key == Qt::Key_Return || key == Qt::Key_Enter) return ping_pong::kEnter;
  if (key == Qt::Key_Backspace) return ping_pong::kBackspace;
  if (key == Qt::Key_Equal) return '+';  // on many keyboards the same key, with Shift
  if (key >= Qt::Key_Space && key <= Qt::Key_AsciiTilde) return key;
  return std::nullopt;  // Shift, arrows, ...
}

bool isMotion(ping_pong::Action action)
{
  return action == ping_pong::Action::Move || action == ping_pong::Action::Turn;
}

// The person at this window; whoever draws first gives the frames.
std::shared_ptr<Operator> sharedOperator(rviz::DisplayContext* context)
{
  static std::weak_ptr<Operator> shared;
  std::shared_ptr<Operator> found = shared.lock();
  if (found) return found;
  // A frame of its own for the first motion, not only when RViz' timer comes round.
  const auto draw = [context] { QMetaObject::invokeMethod(context, "onUpdate", Qt::QueuedConnection); };
  found = std::make_shared<Operator>(NodeNames(), ros::NodeHandle("~").param("player", 0),
                                     context->getFrameManager()->getTF2BufferPtr(), ping_pong::windowHold(),
                                     Operator::Listener{{}, draw});
  shared = found;
  return found;
}

Eigen::Vector3d toEigen(const Ogre::Vector3& v)
{
  return {v.x, v.y, v.z};
}
}  // namespace

KeyTool::KeyTool()
{
  shortcut_key_ = 'k';
  access_all_keys_ = true;  // also those that are other tools' shortcuts
  rviz::Property* parent = getPropertyContainer();
  const OperatorParams params;
  const ping_pong::GlideParams& g = params.glide;
  const auto number = [&](const char* name, double value, const char* text)
  {
    auto* property = new rviz::FloatProperty(name, static_cast<float>(value), text, parent, SLOT(updateParams()), this);
    property->setMin(0.0f);
    return property;
  };
  world_axes_ = new rviz::BoolProperty("World Axes", params.world_axes,
                                       "Moves act along the world's axes instead of the viewer's.", parent,
                                       SLOT(updateParams()), this);
  acceleration_ = number("Acceleration", g.acceleration, "Of a paddle while a key is held [m/s^2].");
  angular_acceleration_ = number("Angular Acceleration", g.angular_acceleration, "Likewise [rad/s^2].");
  damping_ = number("Damping", g.damping, "Top speed is acceleration / damping [1/s].");
  speed_ = number("Speed", g.speed, "Of everything else while a key is held [m/s].");
  angular_speed_ = number("Angular Speed", g.angular_speed, "Likewise [rad/s].");
  shot_ = new rviz::StringProperty("Shot", QString::fromStdString(params.shot),
                                   "What Enter launches: serve, push, drive, loop, smash or lob.", parent,
                                   SLOT(updateParams()), this);
  const ping_pong::Reach& r = params.reach;
  reach_ = new rviz::BoolProperty("Reach", r.limited, "A paddle stays within an arm's reach of its end of the table.",
                                  parent, SLOT(updateParams()), this);
  const std::tuple<const char*, double, const char*> sides[] = {{"Behind", r.behind, "The end of the table [m]."},
                                                                {"Over", r.over, "The table, from its end [m]."},
                                                                {"Side", r.side, "To each side of the middle [m]."},
                                                                {"Below", r.below, "The playing surface [m]."},
                                                                {"Above", r.above, "The playing surface [m]."}};
  for (const auto& [name, value, text] : sides)
  {
    reach_sides_.push_back(
        new rviz::FloatProperty(name, static_cast<float>(value), text, reach_, SLOT(updateParams()), this));
    reach_sides_.back()->setMin(0.0f);
  }
}

KeyTool::~KeyTool()
{
  qApp->removeEventFilter(this);
}

void KeyTool::onInitialize()
{
  setName("Keys");
  setDescription("1-6 select, WASDQE move, RTFGVB turn, H shows all keys. The mouse moves the camera.");
  operator_ = sharedOperator(context_);
}

void KeyTool::activate()
{
  active_ = true;
  updateParams();
  qApp->installEventFilter(this);
}

void KeyTool::deactivate()
{
  active_ = false;
  qApp->removeEventFilter(this);
  operator_->releaseAll();
}

void KeyTool::update(float wall_dt, float ros_dt)
{
  rviz::MoveTool::update(wall_dt, ros_dt);
  if (active_) lookAtView();
}

int KeyTool::processKeyEvent(QKeyEvent* event, rviz::RenderPanel* /*panel*/)
{
  const std::optional<ping_pong::Key> key = toKey(*event);
  if (!key || (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier))) return 0;
  const ping_pong::KeyEntry* entry = ping_pong::findKey(*key);
  if (event->isAutoRepeat() && (entry == nullptr || !isMotion(entry->action))) return 0;
  operator_->press(*key);
  if (entry != nullptr && entry->action == ping_pong::Action::View) switchView(entry->axis);
  if (entry != nullptr && entry->action == ping_pong::Action::Tool) switchTool(entry->axis);
  return Render;
}

bool KeyTool::eventFilter(QObject* object, QEvent* event)
{
  if (event->type() == QEvent::KeyRelease)
  {
    const auto& release = static_cast<const QKeyEvent&>(*event);
    const std::optional<ping_pong::Key> key = toKey(release);
    if (key && !release.isAutoRepeat()) operator_->release(*key);
  }
  else if (event->type() == QEvent::WindowDeactivate || event->type() == QEvent::ApplicationDeactivate ||
           event->type() == QEvent::FocusOut)
  {
    operator_->releaseAll();
  }
  return rviz::MoveTool::eventFilter(object, event);
}

void KeyTool::updateParams()
{
  if (!operator_ || !active_) return;
  OperatorParams params;
  fillParams(params);
  operator_->setParams(params);
}

void KeyTool::fillParams(OperatorParams& params) const
{
  params.world_axes = world_axes_->getBool();
  params.glide.acceleration = acceleration_->getFloat();
  params.glide.angular_acceleration = angular_acceleration_->getFloat();
  params.glide.damping = damping_->getFloat();
  params.glide.speed = speed_->getFloat();
  params.glide.angular_speed = angular_speed_->getFloat();
  params.shot = shot_->getStdString();
  params.reach.limited = reach_->getBool();
  double* sides[] = {&params.reach.behind, &params.reach.over, &params.reach.side, &params.reach.below,
                     &params.reach.above};
  for (std::size_t i = 0; i < reach_sides_.size(); ++i) *sides[i] = reach_sides_[i]->getFloat();
}

void KeyTool::switchTool(int number)
{
  static const char* const kTools[] = {"ping_pong_sim/Play", "ping_pong_sim/Keys", "rviz/Interact"};
  rviz::ToolManager* tools = context_->getToolManager();
  for (int i = 0; i < tools->numTools(); ++i)
  {
    if (tools->getTool(i)->getClassId() == kTools[number]) return tools->setCurrentTool(tools->getTool(i));
  }
  setStatus(QString("This window has no tool %1.").arg(kTools[number]));
}

void KeyTool::switchView(int number)
{
  rviz::ViewManager* views = context_->getViewManager();
  if (number < views->getNumViews())
    views->setCurrentFrom(views->getViewAt(number));
  else
    setStatus(QString("There is no saved view number %1.").arg(number + 1));
}

void KeyTool::lookAtView()
{
  const rviz::ViewController* view = context_->getViewManager()->getCurrent();
  if (view == nullptr) return;
  const Eigen::Vector3d right = toEigen(view->getCamera()->getDerivedRight());
  const Eigen::Vector3d up = toEigen(view->getCamera()->getDerivedUp());
  if (right.isApprox(right_W_, 1e-6) && up.isApprox(up_W_, 1e-6)) return;
  right_W_ = right;
  up_W_ = up;
  operator_->setView(right, up);
}
}  // namespace ping_pong_sim

PLUGINLIB_EXPORT_CLASS(ping_pong_sim::KeyTool, rviz::Tool)
