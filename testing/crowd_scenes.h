// Crowds whose bits are compared: large enough that several workers get something to do.
#pragma once

#include "scene_builder.h"

namespace ping_pong
{
/// The same law between all materials.
inline Scene withLaw(Scene scene, const Surface& law)
{
  for (MaterialId a = 0; a < scene.materials.size(); ++a)
    for (MaterialId b = 0; b < scene.materials.size(); ++b) scene.surfaces.set(a, b, law);
  return scene;
}

/// Four walls on a floor, `width` apart.
inline SceneBuilder shaft(Method method, double width)
{
  SceneBuilder builder(method, 1e-3);
  builder.gravity(kG).floor();
  for (const double side : {-1.0, 1.0})
  {
    builder.box(side < 0 ? "left" : "right", {0.02, 3, 3}, at({side * (0.5 * width + 0.01), 0, 1.5}));
    builder.box(side < 0 ? "front" : "back", {3, 0.02, 3}, at({0, side * (0.5 * width + 0.01), 1.5}));
  }
  return builder;
}

/// Balls on a lattice with `per_row` in each direction of the plane.
inline void stackBalls(SceneBuilder& builder, int balls, int per_row, double spacing, double speed)
{
  const double middle = 0.5 * (per_row - 1);
  for (int i = 0; i < balls; ++i)
  {
    const int layer = i / (per_row * per_row);
    builder.ball({spacing * (i % per_row - middle), spacing * (i / per_row % per_row - middle), 0.1 + spacing * layer},
                 speed * Vector3d(std::sin(1.0 * i), std::cos(2.0 * i), std::sin(3.0 * i)));
  }
}

/// Elastic balls without weight.
inline Scene gasOf(int balls)
{
  SceneBuilder builder = shaft(Method::Exact, 1.0);
  builder.box("lid", {3, 3, 0.02}, at({0, 0, 1.0 + 0.01}));
  stackBalls(builder, balls, 9, 0.1, 2.0);
  return builder.gravity(0.0).build();
}

/// Falls into a heap: `exact` hands it to the contact solver.
inline Scene pourOf(int balls, Method method = Method::Exact)
{
  SceneBuilder builder = shaft(method, 0.33);
  stackBalls(builder, balls, 7, 0.045, 0.3);
  Surface law;
  law.restitution = 0.6;
  law.friction = 0.3;
  law.spin_friction = law.rolling_resistance = 0.006;
  return withLaw(builder.build(), law);
}

/// Spinning balls in air that bounce on a floor and from a paddle, the last body.
inline Scene airOf(int balls)
{
  SceneBuilder builder = shaft(Method::Exact, 2.0);
  builder.paddle("paddle", boxShape({0.02, 0.6, 0.6}), at({-0.3, 0, 0.5}));
  stackBalls(builder, balls, 11, 0.15, 1.0);
  Surface law;
  law.restitution = 0.8;
  law.friction = 0.3;
  Scene scene = withLaw(builder.build(), law);
  scene.forces.drag = scene.forces.magnus = true;
  scene.forces.spin_decay = 0.1;
  for (SceneBall& ball : scene.balls) ball.state.w_WB = 20.0 * ball.state.v_WB;
  std::vector<SceneBall> clear;  // of the paddle
  for (const SceneBall& ball : scene.balls)
    if (std::abs(ball.state.p_WB.x() + 0.3) > 0.1) clear.push_back(ball);
  scene.balls = clear;
  return scene;
}
}  // namespace ping_pong
