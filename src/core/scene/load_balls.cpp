#include "scene/load_balls.h"

#include "scene/ball_patterns.h"
#include "scene/load_bodies.h"
#include "scene/load_colors.h"
#include "scene/materials.h"

namespace ping_pong
{
namespace
{
const std::vector<std::string> kSingleKeys = {"position", "velocity", "spin",  "radius",
                                              "mass",     "inertia",  "color", "material"};

/// I / (m r^2)
double readInertia(const Field& field)
{
  const std::string kind = field.text();
  if (kind == "shell") return kShellInertia;
  if (kind == "solid") return kSolidInertia;
  field.fail("shell or solid");
}

/// Keys that all three ways to list balls have in common.
void readParams(const Map& map, Scene& scene, BallGroup& group)
{
  if (const Field* f = map.find("radius")) group.params.radius = f->positive();
  if (const Field* f = map.find("mass")) group.params.mass = f->positive();
  if (const Field* f = map.find("inertia")) group.params.inertia = readInertia(*f);
  if (const Field* f = map.find("color")) group.palette = readPalette(*f);
  const Field* material = map.find("material");
  group.params.material =
      internMaterial(scene.materials, material != nullptr ? readMaterial(*material) : kBallMaterial);
}

void readVelocities(const Map& map, BallGroup& group)
{
  if (const Field* f = map.find("velocity")) group.velocity = f->vector();
  if (const Field* f = map.find("spin")) group.spin = f->vector();
}

BallGroup readSingle(const Field& field, Scene& scene)
{
  const Map map(field, kSingleKeys);
  const Field& position = map.at("position", "the centre [x, y, z], or grid, or random");
  BallGroup group(position);
  group.origin = position.vector();
  readParams(map, scene, group);
  readVelocities(map, group);
  return group;
}

Vector3d readSpacing(const Field& field)
{
  if (!field.isList()) return Vector3d::Constant(field.positive());
  const std::vector<Field> items = field.list(3, "a number, or three numbers [x, y, z]");
  return {items[0].positive(), items[1].positive(), items[2].positive()};
}

BallGroup readGrid(const Field& field, Scene& scene)
{
  const Map map(field, {"count", "spacing", "origin", "jitter", "seed", "velocity", "spin", "radius", "mass", "inertia",
                        "color", "material"});
  const Field& origin = map.at("origin", "the centre [x, y, z] of the first ball");
  BallGroup group(origin);
  group.origin = origin.vector();
  const std::string three = "three integers [x, y, z]";
  const std::vector<Field> count = map.at("count", three).list(3, three);
  for (std::size_t axis = 0; axis < 3; ++axis) group.grid[axis] = count[axis].count(kMaxBalls);
  group.spacing = readSpacing(map.at("spacing", "the distance between centres"));
  if (const Field* f = map.find("jitter")) group.jitter = f->notNegative();
  if (const Field* f = map.find("seed")) group.seed = f->integer();
  readParams(map, scene, group);
  readVelocities(map, group);
  return group;
}

/// A speed that all have, or {maxwell: s}.
void readSpeed(const Field& field, BallGroup& group)
{
  if (!field.isMap())
  {
    group.random_speed = field.notNegative();
    return;
  }
  const Map map(field, {"maxwell"});
  group.thermal_speed = map.at("maxwell", "the standard deviation of each component of the velocity").notNegative();
}

void readBox(const Map& map, BallGroup& group)
{
  if (const Field* room = map.find("in"))
  {
    for (const char* corner : {"min", "max"})
      if (const Field* f = map.find(corner)) f->failWith("beside in", "either in, or min and max");
    group.room = *room;
    return;
  }
  group.origin = map.at("min", "the lowest centre [x, y, z], or in: a room").vector();
  const Field& max = map.at("max", "the highest centre [x, y, z]");
  group.max = max.vector();
  if (!(group.origin.array() <= group.max.array()).all()) max.fail("a corner that is not below min on any axis");
}

BallGroup readRandom(const Field& field, Scene& scene)
{
  const Map map(
      field, {"count", "min", "max", "in", "seed", "speed", "spin", "radius", "mass", "inertia", "color", "material"});
  const Field& count = map.at("count", "the number of balls");
  BallGroup group(count);
  group.random = true;
  group.grid[0] = count.count(kMaxBalls);
  readBox(map, group);
  if (const Field* f = map.find("seed")) group.seed = f->integer();
  if (const Field* f = map.find("speed")) readSpeed(*f, group);
  if (const Field* f = map.find("spin")) group.random_spin = f->notNegative();
  readParams(map, scene, group);
  return group;
}

/// An entry is a single ball, or holds a pattern and nothing beside it.
BallGroup readGroup(const Field& field, Scene& scene)
{
  std::vector<std::string> keys = kSingleKeys;
  keys.insert(keys.end(), {"grid", "random"});
  const Map map(field, keys);
  if (const Field* grid = map.find("grid"))
  {
    Map(field, {"grid"});
    return readGrid(*grid, scene);
  }
  if (const Field* random = map.find("random"))
  {
    Map(field, {"random"});
    return readRandom(*random, scene);
  }
  return readSingle(field, scene);
}

[[noreturn]] void failTotal(const BallGroup& group, std::size_t total)
{
  group.where.failWith(std::to_string(total) + " balls", "at most " + std::to_string(kMaxBalls) + " in a scene");
}

std::vector<BallGroup> readGroups(const Map& scene_map, Scene& scene)
{
  std::vector<BallGroup> groups;
  if (const Field* balls = scene_map.find("balls"))
    for (const Field& field : balls->list()) groups.push_back(readGroup(field, scene));
  return groups;
}

/// Puts the number that was asked for in place of the one random pattern's.
/// @return  new number / old number
double takeCount(const Map& scene_map, std::size_t wanted, std::vector<BallGroup>& groups)
{
  BallGroup* crowd = nullptr;
  std::size_t patterns = 0;
  for (BallGroup& group : groups)
  {
    if (!group.random) continue;
    crowd = &group;
    ++patterns;
  }
  if (patterns != 1)
  {
    const Field* balls = scene_map.find("balls");
    const Field& where = balls != nullptr ? *balls : scene_map.field();
    where.failWith(std::to_string(patterns) + " random patterns",
                   "exactly one, to take the " + std::to_string(wanted) + " balls that are asked for");
  }
  const double growth = static_cast<double>(wanted) / static_cast<double>(crowd->grid[0]);
  crowd->grid[0] = wanted;
  return growth;
}
}  // namespace

double crowdGrowth(const Map& scene_map, const LoadOptions& options)
{
  if (options.balls == 0) return 1.0;
  Scene scratch;
  std::vector<BallGroup> groups = readGroups(scene_map, scratch);
  return takeCount(scene_map, options.balls, groups);
}

void readBalls(const Map& scene_map, const LoadOptions& options, Scene& scene)
{
  std::vector<BallGroup> groups = readGroups(scene_map, scene);
  if (options.balls > 0) takeCount(scene_map, options.balls, groups);
  std::size_t total = 0;
  for (const BallGroup& group : groups)
  {
    total += group.count();
    if (total > kMaxBalls) failTotal(group, total);
  }
  placeBalls(groups, options, scene);
}
}  // namespace ping_pong
