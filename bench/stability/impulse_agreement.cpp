#include "impulse_agreement.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "play.h"
#include "random_checks.h"

namespace ping_pong::stability
{
namespace
{
constexpr double kLongest = 0.4;  // [s]

// Places at the ends of ticks.
std::vector<Vector3d> placesOf(const RandomScene& drawn, Method method, double dt, std::size_t ticks)
{
  Play play(drawn, method, dt);
  std::vector<Vector3d> places;
  for (std::size_t i = 0; i < ticks && play.advance(drawn.tick).ok(); ++i)
    places.push_back(play.world().ballState(0).p_WB);
  return places;
}

std::size_t realBounces(const World& world)
{
  return static_cast<std::size_t>(std::count_if(world.contacts().begin(), world.contacts().end(),
                                                [](const Contact& contact)
                                                { return closingOf(contact) > kRealBounce; }));
}

// Whole ticks before the second real bounce.
std::size_t ticksToCompare(const RandomScene& drawn)
{
  Play play(drawn, Method::Exact, kCoarseStep);
  const auto most = static_cast<std::size_t>(std::lround(kLongest / drawn.tick));
  std::size_t bounces = 0;
  for (std::size_t i = 0; i < most; ++i)
  {
    if (!play.advance(drawn.tick).ok()) return i;
    bounces += realBounces(play.world());
    if (bounces > 1) return i;
  }
  return most;
}

double farthest(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b)
{
  if (a.size() != b.size()) return Stage::kNoLimit;
  double distance = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) distance = std::max(distance, (a[i] - b[i]).norm());
  return distance;
}
}  // namespace

bool comparable(const RandomScene& drawn)
{
  if (drawn.scene.forces.spin_decay > 0.0 || drawn.launch == "rest") return false;
  for (const Body& body : drawn.scene.bodies)
    for (const Shape& shape : body.shapes)
    {
      const Surface& law = drawn.scene.surfaces.at(0, shape.material);
      if (law.rolling_resistance > 0.0 || law.spin_friction > 0.0) return false;
    }
  return true;
}

bool agrees(const Verdict& verdict)
{
  return verdict.fine <= kCloseEnough || verdict.coarse / verdict.fine >= kFalls;
}

Verdict compareWithImpulse(const RandomScene& drawn)
{
  Verdict verdict;
  const std::size_t ticks = ticksToCompare(drawn);
  if (ticks == 0) return verdict;
  const std::vector<Vector3d> truth = placesOf(drawn, Method::Exact, kCoarseStep, ticks);
  verdict.coarse = farthest(truth, placesOf(drawn, Method::Impulse, kCoarseStep, ticks));
  verdict.fine = farthest(truth, placesOf(drawn, Method::Impulse, kFineStep, ticks));
  return verdict;
}
}  // namespace ping_pong::stability
