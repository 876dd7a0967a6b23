// Scenes built in code: floor, boxes at any pose, paddles, balls, restitution per pair of materials.
#pragma once

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "ping_pong_sim/world.h"

namespace ping_pong
{
constexpr double kG = 9.81;  // gravity of these tests [m/s^2]
constexpr double kR = 0.02;  // radius of most balls [m]
constexpr double kPi = 3.14159265358979323846;

inline Pose at(const Vector3d& p)
{
  return {p, Quaterniond::Identity()};
}

inline Pose at(const Vector3d& p, double angle, const Vector3d& axis)
{
  return {p, Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()))};
}

inline Shape boxShape(const Vector3d& size)
{
  Shape shape;
  shape.kind = ShapeKind::Box;
  shape.half_size = 0.5 * size;
  return shape;
}

inline Shape cylinderShape(double radius, double length)
{
  Shape shape;
  shape.kind = ShapeKind::Cylinder;
  shape.half_size = Vector3d(radius, radius, 0.5 * length);
  return shape;
}

inline Shape sphereShape(double radius)
{
  Shape shape;
  shape.kind = ShapeKind::Sphere;
  shape.half_size = Vector3d::Constant(radius);
  return shape;
}

/// Materials are named where they are used. Every pair has restitution 1 until it is told another.
class SceneBuilder
{
public:
  explicit SceneBuilder(Method method = Method::Exact, double dt = 1e-3)
  {
    scene_.method = method;
    scene_.dt = dt;
    scene_.materials = {"ball", "wall"};
  }

  SceneBuilder& gravity(double g) { return gravity(Vector3d(0, 0, -g)); }
  SceneBuilder& gravity(const Vector3d& g)
  {
    scene_.forces.gravity = g;
    return *this;
  }
  SceneBuilder& restitution(double e) { return restitution("", "", e); }
  SceneBuilder& restitution(const std::string& a, const std::string& b, double e)
  {
    pairs_.push_back({a, b, e});
    return *this;
  }
  SceneBuilder& floor(double height = 0.0)
  {
    Shape half_space;
    half_space.kind = ShapeKind::HalfSpace;
    return body("floor", BodyKind::Static, {half_space}, at({0, 0, height}));
  }
  SceneBuilder& box(const std::string& name, const Vector3d& size, const Pose& pose, const std::string& of = "wall")
  {
    return body(name, BodyKind::Static, {boxShape(size)}, pose, of);
  }
  /// A drive without limits: what is commanded is reached within one tick.
  SceneBuilder& paddle(const std::string& name, const Shape& shape, const Pose& pose)
  {
    body(name, BodyKind::Kinematic, {shape}, pose);
    const double any = std::numeric_limits<double>::infinity();
    scene_.bodies.back().limits = {any, any, any, any};
    return *this;
  }
  SceneBuilder& body(const std::string& name, BodyKind kind, std::vector<Shape> shapes, const Pose& pose,
                     const std::string& of = "wall")
  {
    for (Shape& shape : shapes) shape.material = material(of);
    Body added;
    added.name = name;
    added.kind = kind;
    added.shapes = std::move(shapes);
    added.pose = pose;
    scene_.bodies.push_back(added);
    return *this;
  }
  SceneBuilder& ball(const Vector3d& p, const Vector3d& v = Vector3d::Zero(), double mass = kBallMass,
                     double radius = kR, const std::string& of = "ball")
  {
    SceneBall added;
    added.params.mass = mass;
    added.params.radius = radius;
    added.params.material = material(of);
    added.state.p_WB = p;
    added.state.v_WB = v;
    scene_.balls.push_back(added);
    return *this;
  }

  Scene build()
  {
    Scene scene = scene_;
    const std::size_t count = scene.materials.size();
    scene.surfaces = SurfaceTable(count);
    for (const Pair& pair : pairs_)
      for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = 0; b < count; ++b)
          if ((pair.a.empty() || pair.a == scene.materials[a]) && (pair.b.empty() || pair.b == scene.materials[b]))
            scene.surfaces.set(static_cast<MaterialId>(a), static_cast<MaterialId>(b), {pair.e});
    return scene;
  }
  World world() { return World(build()); }

private:
  struct Pair
  {
    std::string a, b;
    double e;
  };

  MaterialId material(const std::string& of)
  {
    for (std::size_t i = 0; i < scene_.materials.size(); ++i)
      if (scene_.materials[i] == of) return static_cast<MaterialId>(i);
    scene_.materials.push_back(of);
    return static_cast<MaterialId>(scene_.materials.size() - 1);
  }

  Scene scene_;
  std::vector<Pair> pairs_;
};

/// Advances in ticks and collects the contacts of all of them.
inline std::vector<Contact> run(World& world, double tick, int ticks)
{
  std::vector<Contact> all;
  for (int i = 0; i < ticks; ++i)
  {
    world.advance(tick);
    all.insert(all.end(), world.contacts().begin(), world.contacts().end());
  }
  return all;
}

inline Vector3d positionOf(const World& world, std::size_t ball = 0)
{
  return world.ballState(ball).p_WB;
}
inline Vector3d velocityOf(const World& world, std::size_t ball = 0)
{
  return world.ballState(ball).v_WB;
}

inline PaddleCommand velocityCommand(const Vector3d& v, const Vector3d& w = Vector3d::Zero())
{
  PaddleCommand command;
  command.mode = PaddleCommand::Mode::Velocity;
  command.twist = {v, w};
  return command;
}

/// Shows a number beside the bound that it is held against.
inline void measured(const char* what, double value)
{
  std::printf("[ measured ] %s: %.4g\n", what, value);
}
}  // namespace ping_pong
