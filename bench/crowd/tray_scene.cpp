#include "tray_scene.h"

#include <cmath>

#include "base/random.h"

namespace ping_pong::bench
{
namespace
{
constexpr double kPitch = 0.045;   // of the grid [m]
constexpr double kJitter = 0.002;  // [m]
constexpr double kSpeed = 1.0;     // along each axis at most [m/s]
constexpr double kLowest = 0.1;    // [m]
constexpr std::size_t kLayers = 10;
constexpr double kHeight = 1.5;      // of the walls [m]
constexpr double kThickness = 0.02;  // [m]
constexpr std::uint64_t kSeed = 1;

std::size_t ballsInARow(std::size_t balls)
{
  const double layer = static_cast<double>(balls) / static_cast<double>(kLayers);
  return static_cast<std::size_t>(std::ceil(std::sqrt(layer) - 1e-9));
}

Shape box(const Vector3d& size, const Vector3d& middle)
{
  Shape shape;
  shape.half_size = 0.5 * size;
  shape.p_BS = middle;
  shape.material = 1;
  return shape;
}

Body trayBody(const Vector3d& inside)
{
  Body body;
  body.name = "tray";
  const double x = inside.x(), y = inside.y(), z = inside.z(), t = kThickness;
  body.shapes.push_back(box({x + 2 * t, y + 2 * t, t}, {0, 0, -0.5 * t}));
  for (const double side : {-0.5, 0.5})
  {
    body.shapes.push_back(box({t, y + 2 * t, z}, {side * (x + t), 0, 0.5 * z}));
    body.shapes.push_back(box({x + 2 * t, t, z}, {0, side * (y + t), 0.5 * z}));
  }
  return body;
}
}  // namespace

Vector3d traySize(std::size_t balls)
{
  const double side = kPitch * static_cast<double>(ballsInARow(balls));
  return {side, side, kHeight};
}

Scene trayScene(std::size_t balls)
{
  Scene scene;
  scene.name = "tray";
  scene.forces.gravity = Vector3d(0, 0, -9.81);
  scene.materials = {"ball", "wall"};
  scene.surfaces = SurfaceTable(scene.materials.size());
  Surface law;
  law.restitution = 0.8;
  law.friction = 0.3;
  scene.surfaces.set(0, 0, law);
  scene.surfaces.set(0, 1, law);
  const Vector3d size = traySize(balls);
  scene.bodies.push_back(trayBody(size));
  const std::size_t row = ballsInARow(balls);
  Random random(kSeed, 0);
  const Vector3d first(0.5 * (kPitch - size.x()), 0.5 * (kPitch - size.y()), kLowest);
  const Vector3d jitter = Vector3d::Constant(kJitter), speed = Vector3d::Constant(kSpeed);
  for (std::size_t i = 0; i < balls; ++i)
  {
    const Vector3d place(static_cast<double>(i % row), static_cast<double>(i / row % row),
                         static_cast<double>(i / (row * row)));
    SceneBall ball;
    ball.state.p_WB = first + kPitch * place + random.uniform(-jitter, jitter);
    ball.state.v_WB = random.uniform(-speed, speed);
    scene.balls.push_back(ball);
  }
  return scene;
}
}  // namespace ping_pong::bench
