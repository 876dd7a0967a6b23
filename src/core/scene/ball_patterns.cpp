#include "scene/ball_patterns.h"

#include <algorithm>
#include <cstdio>

#include "base/random.h"
#include "ping_pong_sim/room.h"
#include "scene/overlap_check.h"

namespace ping_pong
{
namespace
{
constexpr std::size_t kManyBalls = 100;  ///< in a box much larger than a ball, so that its walls hardly count
/// Part of a box that balls put down at random, one after the other, can fill: Torquato, Uche, Stillinger, "Random sequential
/// addition of hard spheres in high Euclidean dimensions", Phys. Rev. E 74, 061308 (2006).
constexpr double kFullest = 0.384;
constexpr int kAttempts = 10000;  ///< for each random ball; in a box that is 1/8 full, one in about 2 succeeds

class Placement
{
public:
  Placement(const LoadOptions& options, double largest_radius, Scene& scene)
      : options_(options), scene_(scene), finder_(scene.bodies, largest_radius)
  {
  }

  void place(const BallGroup& group, std::size_t index)
  {
    Random random(options_.has_seed ? options_.seed : group.seed, index);
    if (group.random)
      placeRandom(group, random);
    else
      placeGrid(group, random);
  }

private:
  void placeGrid(const BallGroup& group, Random& random)
  {
    const Vector3d jitter = Vector3d::Constant(group.jitter);
    for (std::size_t z = 0; z < group.grid[2]; ++z)
      for (std::size_t y = 0; y < group.grid[1]; ++y)
        for (std::size_t x = 0; x < group.grid[0]; ++x)
        {
          BallState state;
          const Vector3d step(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
          state.p_WB = group.origin + step.cwiseProduct(group.spacing);
          if (group.jitter > 0.0) state.p_WB += random.uniform(-jitter, jitter);
          state.v_WB = group.velocity;
          state.w_WB = group.spin;
          checkRoom(group, state.p_WB);
          add(group, state);
        }
  }

  void placeRandom(const BallGroup& group, Random& random)
  {
    const RandomBox box = boxOf(group);
    checkFill(group, box);
    for (std::size_t i = 0; i < group.count(); ++i)
    {
      BallState state;
      state.p_WB = findRoom(group, box, random, i);
      state.v_WB = group.random_speed * random.direction();
      if (group.thermal_speed > 0.0)
        for (int axis = 0; axis < 3; ++axis) state.v_WB[axis] += group.thermal_speed * random.normal();
      state.w_WB = group.random_spin * random.direction();
      add(group, state);
    }
  }

  /// Of centres, in the frame of a room or of the world.
  struct RandomBox
  {
    Pose frame;
    Vector3d low, high;
  };

  RandomBox boxOf(const BallGroup& group) const
  {
    if (!group.room) return {{}, group.origin, group.max};
    const std::string name = group.room->text();
    for (const Body& body : scene_.bodies)
    {
      const std::optional<Vector3d> size = body.name == name ? roomSize(body) : std::nullopt;
      if (!size) continue;
      const Vector3d low = Vector3d(-0.5 * size->x(), -0.5 * size->y(), 0.0).array() + group.params.radius;
      const Vector3d high = Vector3d(0.5 * size->x(), 0.5 * size->y(), size->z()).array() - group.params.radius;
      if (!(low.array() <= high.array()).all()) failCount(group, "a room with room for one ball");
      return {body.pose, low, high};
    }
    group.room->fail("the name of a body that is a room");
  }

  void checkFill(const BallGroup& group, const RandomBox& box) const
  {
    const double r = group.params.radius;
    const Vector3d edges = (box.high - box.low).array() + 2.0 * r;
    const double fill = static_cast<double>(group.count()) * 4.18879 * r * r * r / edges.prod();
    if (group.count() < kManyBalls || fill < kFullest) return;
    char percent[32];
    std::snprintf(percent, sizeof percent, "%.3g", 100.0 * fill);
    failCount(group, std::string("fewer balls, or a larger box: they would fill ") + percent +
                         " % of it, and random places are found up to 38 %");
  }

  Vector3d findRoom(const BallGroup& group, const RandomBox& box, Random& random, std::size_t placed) const
  {
    for (int attempt = 0; attempt < kAttempts; ++attempt)
    {
      const Vector3d p = random.uniform(box.low, box.high);
      const Vector3d p_WB = group.room ? Vector3d(box.frame.p + box.frame.q * p) : p;
      if (finder_.free(p_WB, group.params.radius)) return p_WB;
    }
    failCount(group, "fewer balls, or a box with room for more than " + std::to_string(placed) + " without overlap");
  }

  /// The number may be the file's, or the one that was asked for instead.
  [[noreturn]] void failCount(const BallGroup& group, const std::string& expected) const
  {
    group.where.failWith(std::to_string(group.count()), expected);
  }

  void checkRoom(const BallGroup& group, const Vector3d& p_WB) const
  {
    const std::optional<Overlap> overlap = finder_.find(p_WB, group.params.radius);
    if (!overlap) return;
    char depth[64];
    std::snprintf(depth, sizeof depth, "%.6g", 1e3 * overlap->depth);
    group.where.fail("no overlap, but ball_" + std::to_string(scene_.balls.size()) + " is " + depth + " mm deep in " +
                     overlap->with);
  }

  void add(const BallGroup& group, const BallState& state)
  {
    BallParams params = group.params;
    params.color = group.palette[scene_.balls.size() % group.palette.size()];
    scene_.balls.push_back({params, state});
    finder_.addBall(state.p_WB, params.radius);
  }

  const LoadOptions& options_;
  Scene& scene_;
  OverlapFinder finder_;
};
}  // namespace

void placeBalls(const std::vector<BallGroup>& groups, const LoadOptions& options, Scene& scene)
{
  double largest_radius = 0.0;
  for (const BallGroup& group : groups) largest_radius = std::max(largest_radius, group.params.radius);
  Placement placement(options, largest_radius, scene);
  for (std::size_t i = 0; i < groups.size(); ++i) placement.place(groups[i], i);
}
}  // namespace ping_pong
