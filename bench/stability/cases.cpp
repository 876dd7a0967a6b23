#include "cases.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "situations.h"

namespace ping_pong::stability
{
namespace
{
constexpr double kPlate = 0.014;  // [m]
const char* const kAll = "none may be lost";
const char* const kRoundings = "a rounding per hit";
const char* const kCount = "a count is right or wrong";

Case plate(const std::string& name, double speed)
{
  const std::string title = "tunnelling: plate of 14 mm, " + std::to_string(std::lround(speed)) + " m/s";
  return {name, title, "part of 200 shots that fly through",
          0.0,  kAll,  [=](Method method, double dt) { return shootAtPlate(method, dt, kPlate, speed).missed; }};
}

Case wrongSide(const std::string& name, double speed)
{
  const std::string title = "wrong side: plate of 14 mm, " + std::to_string(std::lround(speed)) + " m/s";
  return {name, title, "part of 200 shots that are pushed out behind",
          0.0,  kAll,  [=](Method method, double dt) { return shootAtPlate(method, dt, kPlate, speed).wrong_side; }};
}

Case galperin(int collisions, double mass_ratio)
{
  const std::string count = std::to_string(collisions);
  return {"galperin_" + count,
          "Galperin's " + count + " collisions",
          "collisions too few or too many",
          0.0,
          kCount,
          [=](Method method, double dt)
          { return std::abs(static_cast<double>(galperinHits(method, dt, mass_ratio)) - collisions); }};
}

double orbitError(Method method, double dt)
{
  const Orbit orbit = vibratingPaddle(method, dt);
  return orbit.hits < 50 ? std::numeric_limits<double>::infinity() : orbit.time;
}

std::vector<Case> makeCases()
{
  return {
      plate("plate_5", 5.0),
      plate("plate_25", 25.0),
      plate("plate_200", 200.0),
      wrongSide("wrong_side_10", 10.0),
      wrongSide("wrong_side_40", 40.0),
      {"swinging_paddle", "swinging paddle, 60 rad/s", "worst relative error of the ball's velocity", 1e-9,
       "roundings of place and angle", turningBladeError},
      {"zeno", "endless bounces, e = 0.9", "error of the time to rest [s]", 1e-9, "the last bounces are 1e-12 m high",
       endOfBouncing},
      {"rest", "resting for 60 s", "greatest speed [m/s]", 0.0, "at rest is at rest", restingJitter},
      {"cradle", "Newton's cradle, gaps 0 to 1 mm", "worst error of a place [m] or speed [m/s]", 1e-12, kRoundings,
       cradleError},
      {"two_walls", "two walls at once", "worst error of the velocity [m/s]", 1e-12, kRoundings, twoWallsError},
      {"edges", "edge and corner, 9 m/s", "worst relative error of the velocity", 1e-12,
       "a normal is a difference of rounded places over 20 mm", edgeError},
      {"grazing", "grazing by 1 um", "wrong calls of 100", 0.0, kCount,
       [](Method method, double dt) { return static_cast<double>(wrongNetCalls(method, dt)); }},
      {"touching", "touching starts", "wrong of 5", 0.0, kCount,
       [](Method method, double dt) { return static_cast<double>(wrongTouchingStarts(method, dt)); }},
      {"overlap", "15 mm deep at the start", "greatest speed [m/s]", 1.6,
       "a tenth of depth / 1 ms; the lift is worth 0.5 m/s", overlapAtStart},
      {"squeeze", "squeezed by a paddle", "depth in the table [m]", 1e-6, "far less than its shell is thick",
       squeezeDepth},
      {"closing_walls", "closing walls", "error of the place at the end [m]", 1e-11,
       "roundings grow as the room shrinks, from 1 m to 0.08 m",
       [](Method method, double dt) { return closingWalls(method, dt).place; }},
      {"vibrating_paddle", "vibrating paddle, 50 periods", "worst error of a hit's time [s]", 1e-12,
       "the orbit is stable: roundings do not add up", orbitError},
      {"collapse", "collapse of three balls, e = 0.05", "worst difference from the common speed [m/s]", 1e-6,
       "the pile-up ends elastic, e^(n/2) of 1 m/s after n hits", collapseError},
      galperin(31, 1e2),
      galperin(314, 1e4),
      galperin(3141, 1e6),
      {"fast_drag", "drag at 10 000 m/s", "relative error of the speed", 1e-6, "the tolerance", fastDragError},
      {"magnus_circle", "Magnus force for one turn", "relative change of the speed", 1e-6, "the tolerance",
       magnusCircleError},
      {"spin_without_speed", "spin at no speed", "greatest speed [m/s]", 1e-6, "the tolerance", spinWithoutSpeed},
      {"far_away", "coordinates of 1e6 m", "difference after 2 s from the same at the origin [m]", 1e-7,
       "places are rounded to 1e-10 m, and four bounces pass that on as speed", farAway},
      {"waiting", "1000 s of waiting", "difference after 1 s from the same at once [m]", 1e-11,
       "time is rounded to 1e-13 s", waiting},
  };
}
}  // namespace

const std::vector<Case>& cases()
{
  static const std::vector<Case> list = makeCases();
  return list;
}

const Case& caseNamed(const std::string& name)
{
  for (const Case& each : cases())
    if (each.name == name) return each;
  throw std::out_of_range("no case " + name);
}
}  // namespace ping_pong::stability
