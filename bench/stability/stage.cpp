#include "stage.h"

#include "stages.h"
#include "testing/scene_builder.h"

namespace ping_pong::stability
{
std::size_t Stage::addBody(const std::string& name, BodyKind kind, const Pose& pose)
{
  Body body;
  body.name = name;
  body.kind = kind;
  body.pose = pose;
  bodies.push_back(body);
  return bodies.size() - 1;
}

ShapeName Stage::add(std::size_t body, Shape shape, const Pose& pose)
{
  const Pose& X_LB = bodies[body].pose;
  shape.p_BS = X_LB.q.conjugate() * (pose.p - X_LB.p);
  shape.R_BS = (X_LB.q.conjugate() * pose.q).toRotationMatrix();
  bodies[body].shapes.push_back(shape);
  return {body, bodies[body].shapes.size() - 1};
}

ShapeName Stage::addBox(std::size_t body, const Vector3d& from, const Vector3d& to, const Pose& then)
{
  return add(body, boxShape(to - from), {then.p + then.q * Vector3d(0.5 * (from + to)), then.q});
}

ShapeName Stage::addFloor(double height)
{
  Shape half_space;
  half_space.kind = ShapeKind::HalfSpace;
  return add(addBody("floor", BodyKind::Static, at({0, 0, height})), half_space, at({0, 0, height}));
}

Pose turnedAbout(const Vector3d& point, const Vector3d& axis, double angle)
{
  if (angle == 0.0) return Pose();
  const Quaterniond q(Eigen::AngleAxisd(angle, axis.normalized()));
  return {point - q * point, q};
}

const std::vector<StageKind>& stageKinds()
{
  static const std::vector<StageKind> kinds = {
      {"floor_wall", floorAndWall},
      {"groove", groove},
      {"tray_corner", trayCorner},
      {"tray", tray},
      {"flush", flush},
      {"nearly_flush", nearlyFlush},
      {"step", step},
      {"cylinder", cylinder},
      {"edge", edge},
      {"blade", blade},
      {"spheres", spheres},
      {"slope", slope},
      {"clutter", clutter},
      {"moving", movingTray},
      {"turning", turningTable},
      {"pushed", pushed},
  };
  return kinds;
}
}  // namespace ping_pong::stability
