#include "ping_pong_sim/shots.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "base/random.h"

namespace ping_pong
{
namespace
{
constexpr double kPi = 3.14159265358979323846;

/// @param x, z       where the ball leaves the racket, above the table's long axis [m]
/// @param speed      [m/s]
/// @param elevation  above the horizontal [deg]
/// @param topspin    [rev/s]; below zero: backspin
Shot shot(const char* name, double x, double z, double speed, double elevation, double topspin)
{
  const double angle = elevation * kPi / 180.0;
  return {
      name, {x, 0.0, z}, {-speed * std::cos(angle), 0.0, speed * std::sin(angle)}, {0.0, -2.0 * kPi * topspin, 0.0}};
}
}  // namespace

// Elevations were searched for: in air each ball clears the net by about 8 cm or more (the smash by 6) and lands well
// inside the half at -x. The serve does so off tables of any usual restitution and friction. test/core/scene/test_shots.cpp
// holds them to it.
const std::vector<Shot>& shots()
{
  static const std::vector<Shot> all = {
      shot("serve", 1.5, 0.30, 5.0, -15.0, -40.0), shot("push", 1.2, 0.20, 4.5, 21.0, -30.0),
      shot("drive", 1.7, 0.25, 12.0, 8.0, 50.0),   shot("loop", 1.9, 0.10, 10.0, 16.5, 100.0),
      shot("smash", 1.5, 0.45, 25.0, -5.5, 20.0),  shot("lob", 1.5, 0.20, 6.0, 62.0, 30.0),
  };
  return all;
}

const Shot* findShot(const std::string& name)
{
  for (const Shot& known : shots())
    if (known.name == name) return &known;
  return nullptr;
}

std::string shotNames()
{
  std::string names;
  for (const Shot& known : shots()) names += (names.empty() ? "" : ", ") + known.name;
  return names;
}

const Shot& drawnShot(std::uint64_t n)
{
  const std::size_t count = shots().size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  Random random(1, n / count);
  for (std::size_t i = count - 1; i > 0; --i) std::swap(order[i], order[random.next() % (i + 1)]);
  return shots()[order[n % count]];
}

Shot scattered(const Shot& shot, double scatter, std::uint64_t seed)
{
  if (scatter == 0.0) return shot;
  Random random(seed, 0);
  const double faster = 1.0 + random.uniform(-scatter, scatter);
  const double more_spin = 1.0 + random.uniform(-scatter, scatter);
  // (1, tan(angle / 2) axis) is a turn; tan is taken for its argument, so that no bits depend on a maths library.
  const Vector3d half_turn = 0.5 * random.uniform(0.0, scatter) * random.direction();
  const Quaterniond turn = Quaterniond(1.0, half_turn.x(), half_turn.y(), half_turn.z()).normalized();
  Shot result = shot;
  result.v_TB = faster * (turn * shot.v_TB);
  result.w_TB = more_spin * (turn * shot.w_TB);
  return result;
}
}  // namespace ping_pong
