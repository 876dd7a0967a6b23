#include "ping_pong_sim/choose_method.h"

#include <cstdio>
#include <map>
#include <vector>

#include "evolve/flight.h"

namespace ping_pong
{
namespace
{
using Words = std::vector<std::string>;

// "a", "a and b", "a, b and c".
std::string listOf(const Words& words)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

std::string metres(double length)
{
  char text[32];
  std::snprintf(text, sizeof text, "%g m", length);
  return text;
}

std::string flight(const Forces& forces, double tolerance)
{
  Words words;
  if (forces.dependOnVelocity())
  {
    if (forces.drag) words.push_back("drag");
    if (forces.magnus) words.push_back("the Magnus force");
    if (!forces.wind.isZero(0.0)) words.push_back("wind");
    return "flight by collocation of degree " + std::to_string(pieceDegree(tolerance)) + " to " + metres(tolerance) +
           ", for " + listOf(words);
  }
  if (forces.gravity.isZero(0.0)) return "flight in closed form, since no force acts";
  words.push_back("gravity");
  if (forces.buoyancy) words.push_back("buoyancy");
  return "flight in closed form, since no force but " + listOf(words) + " acts";
}

std::string pairs(std::size_t balls)
{
  if (balls == 0) return "no ball";
  if (balls == 1) return "one ball, so no pair search";
  return std::to_string(balls) + " balls, so pairs are searched";
}

// Friction anywhere the balls can touch.
bool anyFriction(const Scene& scene)
{
  std::map<MaterialId, int> balls;  // how many of each material
  for (const SceneBall& ball : scene.balls) ++balls[ball.params.material];
  const auto rough = [&](MaterialId a, MaterialId b) { return scene.surfaces.at(a, b).friction > 0.0; };
  for (const auto& [mine, count] : balls)
  {
    for (const auto& [other, its_count] : balls)
      if ((mine != other || count > 1) && rough(mine, other)) return true;
    for (const Body& body : scene.bodies)
      for (const Shape& shape : body.shapes)
        if (rough(mine, shape.material)) return true;
  }
  return false;
}

std::string spin(const Scene& scene)
{
  Words words;
  if (scene.forces.magnus) words.push_back("the Magnus force");
  if (scene.forces.drag && scene.forces.drag_law.feelsSpin()) words.push_back("drag");
  if (anyFriction(scene)) words.push_back("friction");
  if (!words.empty()) return "spin carried, for " + listOf(words);
  return "no friction and no force that feels spin, so spin is not integrated";
}
}  // namespace

Choice chooseMethod(const Scene& scene)
{
  if (scene.method != Method::Auto) return {scene.method, std::string(name(scene.method)) + ", as the scene says"};
  return {Method::Exact, std::string(name(Method::Exact)) + ": " + flight(scene.forces, scene.tolerance) + "; " +
                             pairs(scene.balls.size()) + "; " + spin(scene)};
}
}  // namespace ping_pong
