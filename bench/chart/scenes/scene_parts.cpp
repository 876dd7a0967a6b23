#include "scene_parts.h"

#include <limits>

namespace ping_pong::bench
{
namespace
{
constexpr MaterialId kBall = 0, kWall = 1;
}

Surface contactLaw(double restitution, double friction)
{
  Surface law;
  law.restitution = restitution;
  law.friction = friction;
  return law;
}

Scene emptyScene(const std::string& name, const Surface& law)
{
  Scene scene;
  scene.name = name;
  scene.forces.gravity = Vector3d(0, 0, -kGravity);
  scene.materials = {"ball", "wall"};
  scene.surfaces = SurfaceTable(scene.materials.size());
  for (const MaterialId other : {kBall, kWall}) scene.surfaces.set(kBall, other, law);
  return scene;
}

void addAir(Scene& scene, const DragLaw& drag)
{
  scene.forces.drag = scene.forces.magnus = true;
  scene.forces.drag_law = drag;
}

void addFloor(Scene& scene, double height)
{
  Shape half_space;
  half_space.kind = ShapeKind::HalfSpace;
  half_space.material = kWall;
  Body floor;
  floor.name = "floor";
  floor.shapes = {half_space};
  floor.pose.p.z() = height;
  scene.bodies.push_back(floor);
}

void addBox(Scene& scene, const std::string& name, BodyKind kind, const Vector3d& size, const Pose& pose)
{
  Shape box;
  box.half_size = 0.5 * size;
  box.material = kWall;
  Body body;
  body.name = name;
  body.kind = kind;
  body.shapes = {box};
  body.pose = pose;
  const double any = std::numeric_limits<double>::infinity();
  body.limits = {any, any, any, any};
  scene.bodies.push_back(body);
}

void addBall(Scene& scene, const BallParams& params, const BallState& state)
{
  scene.balls.push_back({params, state});
}
}  // namespace ping_pong::bench
