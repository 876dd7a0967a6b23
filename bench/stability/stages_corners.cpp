#include "stages.h"
#include "testing/scene_builder.h"

namespace ping_pong::stability
{
namespace
{
// Half of the walls stand upright.
double lean(Dice& dice, double most)
{
  return dice.chance(0.5) ? 0.0 : dice.symmetric(most);
}

// A body of its own, or one more shape of that one.
std::size_t bodyFor(Stage& stage, Dice& dice, std::size_t body, const char* name)
{
  return stage.bodies[body].name != "floor" && dice.chance(0.5) ? body : stage.addBody(name, BodyKind::Static);
}

ShapeName floorOrTable(Stage& stage, Dice& dice)
{
  if (dice.chance(0.4)) return stage.addFloor(0.0);
  return stage.addBox(stage.addBody("table", BodyKind::Static), {-0.6, -0.8, -0.1}, {0.9, 0.8, 0.0});
}
}  // namespace

Stage floorAndWall(Dice& dice)
{
  Stage stage;
  const ShapeName floor = floorOrTable(stage, dice);
  const double thickness = dice.log(0.002, 0.1), height = dice.chance(0.5) ? 0.1525 : dice.uniform(0.02, 0.4);
  const Pose leaning = turnedAbout({0, 0, 0}, {0, 1, 0}, lean(dice, 0.5));
  const std::size_t body = bodyFor(stage, dice, floor.body, "wall");
  const ShapeName wall = stage.addBox(body, {-thickness, -0.7, -0.05}, {0, 0.7, height}, leaning);
  stage.feature = {floor, wall};
  stage.target = {kR, dice.symmetric(0.2), kR};
  stage.low = {0.05, -0.2, 0};
  stage.high = {0.4, 0.2, 0};
  stage.tilt = 0.4;
  return stage;
}

Stage groove(Dice& dice)
{
  Stage stage;
  const std::size_t body = stage.addBody("left", BodyKind::Static);
  // Level faces turned about the line where they meet; what lies behind one of them does not stand before the other.
  const double left = dice.uniform(0.15, 1.45), right = dice.uniform(0.15, 1.45);
  stage.feature.push_back(
      stage.addBox(body, {-0.4, -0.6, -0.05}, {0.03, 0.6, 0}, turnedAbout({0, 0, 0}, {0, 1, 0}, left)));
  const std::size_t other = bodyFor(stage, dice, body, "right");
  stage.feature.push_back(
      stage.addBox(other, {-0.03, -0.6, -0.05}, {0.4, 0.6, 0}, turnedAbout({0, 0, 0}, {0, 1, 0}, -right)));
  if (dice.chance(0.3))
    stage.feature.push_back(stage.addBox(stage.addBody("end", BodyKind::Static), {-0.4, 0.3, -0.05}, {0.4, 0.35, 0.4},
                                         turnedAbout({0, 0.3, 0}, {1, 0, 0}, lean(dice, 0.3))));
  stage.target = {0, dice.uniform(-0.1, 0.28), kR};
  stage.low = {-0.06, -0.25, 0};
  stage.high = {0.06, 0.2, 0};
  return stage;
}

Stage trayCorner(Dice& dice)
{
  Stage stage;
  const ShapeName floor = floorOrTable(stage, dice);
  const Pose first = turnedAbout({0, 0, 0}, {0, 1, 0}, lean(dice, 0.3));
  const Vector3d about = dice.chance(0.5) ? Vector3d::UnitZ() : Vector3d::UnitX();
  const Pose second = turnedAbout({0, 0, 0}, about, lean(dice, 0.5));
  const std::size_t body = bodyFor(stage, dice, floor.body, "wall");
  stage.feature = {floor, stage.addBox(body, {-0.02, -0.3, -0.05}, {0, 0.7, 0.2}, first)};
  const std::size_t side = bodyFor(stage, dice, body, "side");
  stage.feature.push_back(stage.addBox(side, {-0.3, -0.02, -0.05}, {0.8, 0, 0.2}, second));
  stage.target = {kR, kR, kR};
  stage.low = {0.05, 0.05, 0};
  stage.high = {0.3, 0.3, 0};
  return stage;
}

Stage tray(Dice& dice)
{
  Stage stage;
  const double x = dice.uniform(0.06, 0.25), y = dice.uniform(0.06, 0.25), height = dice.uniform(0.03, 0.2);
  const std::size_t body = stage.addBody("tray", BodyKind::Static);
  stage.feature.push_back(stage.addBox(body, {-x, -y, -0.02}, {x, y, 0}));
  stage.feature.push_back(stage.addBox(body, {-x - 0.02, -y, -0.02}, {-x, y, height}));
  stage.feature.push_back(stage.addBox(body, {-x, -y - 0.02, -0.02}, {x, -y, height}));
  stage.addBox(body, {x, -y, -0.02}, {x + 0.02, y, height});
  stage.addBox(body, {-x, y, -0.02}, {x, y + 0.02, height});
  stage.addFloor(-0.3);
  stage.target = {kR - x, kR - y, kR};
  stage.low = {0.04 - x, 0.04 - y, 0};
  stage.high = {x - 0.04, y - 0.04, 0};
  return stage;
}

Stage slope(Dice& dice)
{
  Stage stage;
  stage.feature.push_back(floorOrTable(stage, dice));
  stage.target = {dice.symmetric(0.3), dice.symmetric(0.3), kR};
  stage.low = {-0.1, -0.1, 0};
  stage.high = {0.1, 0.1, 0};
  stage.tilt = 0.7;
  return stage;
}
}  // namespace ping_pong::stability
