#include "ball_placement.h"

#include <algorithm>
#include <cstdio>

#include "overlap.h"
#include "random.h"

namespace ping_pong
{
namespace
{
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
    for (std::size_t i = 0; i < group.count(); ++i)
    {
      BallState state;
      state.p_WB = findRoom(group, random, i);
      state.v_WB = group.random_speed * random.direction();
      state.w_WB = group.random_spin * random.direction();
      add(group, state);
    }
  }

  Vector3d findRoom(const BallGroup& group, Random& random, std::size_t placed) const
  {
    for (int attempt = 0; attempt < kAttempts; ++attempt)
    {
      const Vector3d p_WB = random.uniform(group.origin, group.max);
      if (!finder_.find(p_WB, group.params.radius)) return p_WB;
    }
    group.where.fail("fewer balls, or a box with room for more than " + std::to_string(placed) + " without overlap");
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
