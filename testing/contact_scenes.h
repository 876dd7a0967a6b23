// Rough surfaces, corners and grooves for tests of balls that lie, slide and roll.
#pragma once

#include "scene_builder.h"

namespace ping_pong
{
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kShell = kShellInertia;

inline Surface rough(double e, double mu, double rolling_resistance = 0.0, double spin_friction = 0.0)
{
  Surface law;
  law.restitution = e;
  law.friction = mu;
  law.rolling_resistance = rolling_resistance;
  law.spin_friction = spin_friction;
  return law;
}

/// By the names of the materials.
inline void setSurface(Scene& scene, const std::string& a, const std::string& b, const Surface& law)
{
  const auto id = [&](const std::string& name)
  {
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
      if (scene.materials[i] == name) return static_cast<MaterialId>(i);
    return static_cast<MaterialId>(-1);
  };
  scene.surfaces.set(id(a), id(b), law);
}

/// One ball on the floor z = 0.
inline Scene ballOnFloor(const Vector3d& gravity, const Surface& law, const Vector3d& v = Vector3d::Zero(),
                         const Vector3d& w = Vector3d::Zero(), double k = kShell)
{
  Scene scene = SceneBuilder().gravity(gravity).floor().ball({0, 0, kR}, v).build();
  scene.balls[0].state.w_WB = w;
  scene.balls[0].params.inertia = k;
  setSurface(scene, "ball", "wall", law);
  return scene;
}

/// One ball beside the corner of a floor z = 0 (material "floor") and a wall x = 0 ("wall"), on the side x > 0.
inline Scene cornerScene(const Vector3d& gravity, const Surface& floor, const Surface& wall, const BallState& ball)
{
  Shape half_space;
  half_space.kind = ShapeKind::HalfSpace;
  Scene scene = SceneBuilder()
                    .gravity(gravity)
                    .body("floor", BodyKind::Static, {half_space}, at({0, 0, 0}), "floor")
                    .box("wall", {2, 20, 20}, at({-1, 0, 0}))
                    .ball(ball.p_WB, ball.v_WB)
                    .build();
  scene.balls[0].state.w_WB = ball.w_WB;
  setSurface(scene, "ball", "floor", floor);
  setSurface(scene, "ball", "wall", wall);
  return scene;
}

inline BallState inCorner(const Vector3d& v = Vector3d::Zero(), const Vector3d& w = Vector3d::Zero())
{
  BallState state;
  state.p_WB = {kR, 0, kR};
  state.v_WB = v;
  state.w_WB = w;
  return state;
}

/// A groove along y whose walls meet in the y axis, each at the angle `half` from the plane x = 0, and one ball that touches
/// both. It rolls about the line through both touching points, at r sin(half) below the centre.
inline Scene grooveScene(double half, const Vector3d& gravity, const Surface& law, double v, double k = kShell)
{
  SceneBuilder builder;
  builder.gravity(gravity);
  for (const int side : {-1, 1})
  {
    const Vector3d out(-side * std::cos(half), 0, std::sin(half)), along(side * std::sin(half), 0, std::cos(half));
    Eigen::Matrix3d axes;
    axes << side * along, Vector3d::UnitY(), out;
    const Quaterniond q(axes);
    builder.box(side < 0 ? "left" : "right", {1, 40, 0.1}, {0.5 * along - 0.05 * out, q});
  }
  Scene scene = builder.ball({0, 0, kR / std::sin(half)}, {0, v, 0}).build();
  scene.balls[0].state.w_WB = {-v / (kR * std::sin(half)), 0, 0};
  scene.balls[0].params.inertia = k;
  setSurface(scene, "ball", "wall", law);
  return scene;
}

inline double rimSpeed(const World& world, int axis, std::size_t ball = 0)
{
  return kR * world.ballState(ball).w_WB[axis];
}

/// Slip over a surface with normal n whose touched point moves with u.
inline double slipSpeed(const World& world, const Vector3d& n, const Vector3d& u = Vector3d::Zero(),
                        std::size_t ball = 0)
{
  const BallState state = world.ballState(ball);
  const Vector3d slip = state.v_WB - kR * state.w_WB.cross(n) - u;
  return (slip - n.dot(slip) * n).norm();
}

struct Sum
{
  std::size_t events = 0, contacts = 0;
  bool ok = true;
};

inline Sum runFor(World& world, double duration, double tick)
{
  Sum sum;
  const int ticks = static_cast<int>(std::lround(duration / tick));
  for (int i = 0; i < ticks; ++i)
  {
    const StepStatus status = world.advance(tick);
    sum.events += status.events;
    sum.contacts += status.contacts;
    sum.ok &= status.ok();
  }
  return sum;
}
}  // namespace ping_pong
