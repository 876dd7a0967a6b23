#include "stages.h"
#include "testing/scene_builder.h"

namespace ping_pong::stability
{
namespace
{
constexpr double kLow = -0.5, kHigh = 0.5;  // of the deck along x and y [m]

// Edges of planks along x: the middle one or two lie where the ball comes by.
std::vector<double> edges(Dice& dice)
{
  std::vector<double> all = {kLow, dice.symmetric(0.02)};
  const int more = dice.pick(4);
  for (int i = 0; i < more; ++i) all.push_back(all.back() + dice.uniform(0.03, 0.12));
  all.push_back(kHigh);
  return all;
}

// How a tile lies off the common plane. Never further than 2 mm.
struct Unevenness
{
  double step = 0.0, gap = 0.0, tilt = 0.0;  // [m], [m], [rad]
};

Unevenness drawn(Dice& dice)
{
  Unevenness off;
  off.step = dice.chance(0.7) ? dice.log(1e-6, 1e-3) * (dice.chance(0.5) ? 1.0 : -1.0) : 0.0;
  off.gap = dice.chance(0.3) ? dice.log(1e-6, 1e-3) : 0.0;
  off.tilt = dice.chance(0.2) ? dice.log(1e-6, 1e-3) * (dice.chance(0.5) ? 1.0 : -1.0) : 0.0;
  return off;
}

void addTile(Stage& stage, std::size_t body, Vector3d from, Vector3d to, const Unevenness& off)
{
  from.x() += off.gap;
  from.z() += off.step;
  to.z() += off.step;
  stage.feature.push_back(stage.addBox(body, from, to, turnedAbout({from.x(), 0, to.z()}, {0, 1, 0}, off.tilt)));
}

Stage tiles(Dice& dice, bool even)
{
  Stage stage;
  const std::size_t first = stage.addBody("deck", BodyKind::Static);
  const std::size_t other = dice.chance(0.5) ? first : stage.addBody("other", BodyKind::Static);
  const bool rows = dice.chance(0.4);
  const double middle = dice.symmetric(0.01);
  const std::vector<double> x = edges(dice);
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    for (int row = 0; row < (rows ? 2 : 1); ++row)
    {
      const double from = row == 0 ? kLow : middle, to = rows && row == 0 ? middle : kHigh;
      const double depth = dice.chance(0.5) ? 0.02 : dice.uniform(0.01, 0.06);
      const bool flat = even || (i == 0 && row == 0);
      addTile(stage, (i + static_cast<std::size_t>(row)) % 2 == 0 ? first : other, {x[i], from, -depth},
              {x[i + 1], to, 0.0}, flat ? Unevenness() : drawn(dice));
    }
  stage.target = {0, rows ? middle : dice.symmetric(0.1), kR};
  stage.low = {-0.25, -0.1, 0};
  stage.high = {0.02, 0.1, 0};
  return stage;
}
}  // namespace

Stage flush(Dice& dice)
{
  Stage stage = tiles(dice, true);
  stage.feature.resize(2);
  Stage whole;
  whole.addBox(whole.addBody("deck", BodyKind::Static), {kLow, kLow, -0.02}, {kHigh, kHigh, 0});
  stage.whole = whole.bodies;
  return stage;
}

Stage nearlyFlush(Dice& dice)
{
  Stage stage = tiles(dice, false);
  stage.feature.resize(1);
  return stage;
}

Stage step(Dice& dice)
{
  Stage stage;
  const double height = dice.log(1e-3, 0.04);
  const ShapeName floor = stage.addFloor(0.0);
  const std::size_t body = stage.addBody("step", BodyKind::Static);
  stage.addBox(body, {-0.4, -0.4, -0.05}, {0, 0.4, height}, turnedAbout({0, 0, 0}, {0, 0, 1}, dice.symmetric(0.6)));
  stage.feature = {floor, {body, 0}};
  stage.target = {0.01, dice.symmetric(0.1), kR};
  const bool up = dice.chance(0.6);
  stage.low = {up ? 0.04 : -0.2, -0.1, 0};
  stage.high = {up ? 0.2 : 0.0, 0.1, 0};
  return stage;
}
}  // namespace ping_pong::stability
