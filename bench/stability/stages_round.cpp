#include "stages.h"
#include "testing/scene_builder.h"

namespace ping_pong::stability
{
namespace
{
const Vector3d kAlongX(1, 0, 0);

Pose lying(const Vector3d& p)
{
  return at(p, 0.5 * kPi, kAlongX);  // axis along y
}

Pose anywhere(Dice& dice, const Vector3d& p)
{
  const double angle = dice.symmetric(kPi);
  return at(p, angle, dice.direction());
}

void onTopOf(Stage& stage, Dice& dice, double radius)
{
  stage.feature.push_back(
      stage.add(stage.addBody("roller", BodyKind::Static), cylinderShape(radius, 0.8), lying({0, 0, 0})));
  if (dice.chance(0.5)) stage.addFloor(-radius);
  stage.target = {0, dice.symmetric(0.1), radius + kR};
  stage.low = {-0.2 * radius, -0.1, 0};
  stage.high = {0.2 * radius, 0.1, 0};
}

void against(Stage& stage, Dice& dice, double radius, bool standing)
{
  const ShapeName floor = stage.addFloor(0.0);
  const std::size_t body = stage.addBody("roller", BodyKind::Static);
  const Pose pose = standing ? at({-radius, 0, 0.05}) : lying({-radius, 0, radius});
  stage.feature = {floor, stage.add(body, cylinderShape(radius, standing ? 0.2 : 0.8), pose)};
  stage.target = {kR, dice.symmetric(0.1), kR};
  stage.low = {0.04, -0.1, 0};
  stage.high = {0.2, 0.1, 0};
}

void between(Stage& stage, Dice& dice, double radius)
{
  const double half = radius + dice.uniform(0.15, 0.9) * kR;
  for (const double side : {-1.0, 1.0})
    stage.feature.push_back(stage.add(stage.addBody(side < 0.0 ? "left" : "right", BodyKind::Static),
                                      cylinderShape(radius, 0.8), lying({side * half, 0, 0})));
  stage.target = {0, dice.symmetric(0.1), 0.5 * radius + kR};
  stage.low = {-0.2 * half, -0.2, 0};
  stage.high = {0.2 * half, 0.2, 0};
}

void onTheEnd(Stage& stage, Dice& dice, double radius)
{
  stage.feature.push_back(
      stage.add(stage.addBody("post", BodyKind::Static), cylinderShape(radius, 0.2), at({-radius, 0, -0.1})));
  if (dice.chance(0.5)) stage.addFloor(-0.2);
  stage.target = {0, dice.symmetric(0.5 * radius), kR};
  stage.low = {-radius, -0.5 * radius, 0};
  stage.high = {0.005, 0.5 * radius, 0};
}

Shape anyShape(Dice& dice)
{
  switch (dice.pick(3))
  {
    case 0:
      return boxShape(dice.uniform(Vector3d::Constant(0.03), Vector3d::Constant(0.2)));
    case 1:
    {
      const double radius = dice.uniform(0.02, 0.1);
      return cylinderShape(radius, dice.uniform(0.02, 0.2));
    }
    default:
      return sphereShape(dice.uniform(0.02, 0.1));
  }
}
}  // namespace

Stage cylinder(Dice& dice)
{
  Stage stage;
  const double radius = dice.log(0.02, 0.3);
  switch (dice.pick(5))
  {
    case 0:
      onTopOf(stage, dice, radius);
      break;
    case 1:
      against(stage, dice, radius, false);
      break;
    case 2:
      against(stage, dice, radius, true);
      break;
    case 3:
      between(stage, dice, radius);
      break;
    default:
      onTheEnd(stage, dice, radius);
  }
  return stage;
}

Stage edge(Dice& dice)
{
  Stage stage;
  const std::size_t body = stage.addBody("table", BodyKind::Static);
  const double corner = dice.chance(0.5) ? 0.4 : dice.uniform(0.0, 0.1);
  stage.feature.push_back(stage.addBox(body, {-0.4, -0.4, -0.2}, {0, corner, 0}));
  if (dice.chance(0.3)) stage.addFloor(-0.3);
  stage.target = {0, corner < 0.2 ? corner : 0.0, kR};
  const bool right_above = dice.chance(0.4);
  stage.low = {right_above ? -0.003 : -0.15, -0.1, 0};
  stage.high = {right_above ? 0.018 : -0.01, corner < 0.2 ? corner : 0.1, 0};
  return stage;
}

Stage blade(Dice& dice)
{
  Stage stage;
  const std::size_t body = stage.addBody("paddle", BodyKind::Static);
  const double thickness = dice.uniform(0.006, 0.015), width = dice.uniform(0.01, 0.03);
  const Shape disc = dice.chance(0.7) ? cylinderShape(0.08, thickness) : boxShape({0.16, 0.15, thickness});
  const ShapeName face = stage.add(body, disc, at({0, 0, -0.5 * thickness}));
  const double proud = dice.uniform(0.003, 0.02);  // of the handle over the blade
  const ShapeName handle = stage.addBox(body, {0.055, -width, -thickness - proud}, {0.2, width, proud});
  if (dice.chance(0.3)) stage.addFloor(-0.2);
  stage.feature = {face, handle};
  stage.target = {0.055 - kR, dice.symmetric(width), kR};
  stage.low = {-0.05, -0.04, 0};
  stage.high = {0.03, 0.04, 0};
  stage.tilt = 0.5;
  return stage;
}

Stage spheres(Dice& dice)
{
  Stage stage;
  const int count = 1 + dice.pick(3);
  const double radius = dice.log(0.02, 0.1), apart = radius + dice.uniform(0.1, 0.9) * kR;
  const bool floor = dice.chance(0.7);
  if (floor) stage.feature.push_back(stage.addFloor(-radius));
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * kPi * i / count;
    const std::size_t body = stage.addBody("dome_" + std::to_string(i), BodyKind::Static);
    const double out = count == 1 ? 0.0 : apart;
    stage.feature.push_back(
        stage.add(body, sphereShape(radius), at({out * std::cos(angle), out * std::sin(angle), 0})));
  }
  stage.target = {0, 0, 0};
  const double reach = count == 1 ? 0.5 * radius : apart;
  stage.low = {-reach, -reach, 0};
  stage.high = {reach, reach, 0};
  return stage;
}

Stage clutter(Dice& dice)
{
  Stage stage;
  stage.feature.push_back(stage.addFloor(-0.1));
  const int count = 3 + dice.pick(4);
  const std::size_t one = stage.addBody("heap", BodyKind::Static);
  for (int i = 0; i < count; ++i)
  {
    const Vector3d p = dice.uniform(Vector3d(-0.12, -0.12, -0.15), Vector3d(0.12, 0.12, 0.0));
    const std::size_t body = dice.chance(0.5) ? one : stage.addBody("piece_" + std::to_string(i), BodyKind::Static);
    const Shape shape = anyShape(dice);
    const ShapeName name = stage.add(body, shape, anywhere(dice, p));
    if (stage.feature.size() < 3) stage.feature.push_back(name);
  }
  stage.low = {-0.15, -0.15, 0};
  stage.high = {0.15, 0.15, 0};
  return stage;
}
}  // namespace ping_pong::stability
