// What balls of one type have in common, once for all of them.
#pragma once

#include <functional>
#include <unordered_map>

#include "ping_pong_sim/forces.h"

namespace ping_pong
{
/// Parameters, and the forces on a ball that has them.
using BallType = std::pair<const BallParams, FlightModel>;

/// Each type once, at an address that it keeps.
class BallTypes
{
public:
  const BallType& of(const BallParams& params, const Forces& forces)
  {
    return *types_.try_emplace(params, forces, params).first;
  }
  void forget(const BallType& type) { types_.erase(type.first); }
  void clear() { types_.clear(); }

private:
  struct Hash
  {
    std::size_t operator()(const BallParams& ball) const
    {
      std::size_t sum = ball.material;
      for (const double x : {ball.radius, ball.mass, ball.inertia}) add(std::hash<double>()(x), sum);
      for (const float x : {ball.color.r, ball.color.g, ball.color.b, ball.color.a}) add(std::hash<float>()(x), sum);
      return sum;
    }
    static void add(std::size_t part, std::size_t& sum) { sum = (sum ^ part ^ (part >> 32)) * 0x9e3779b97f4a7c15u; }
  };
  struct Same
  {
    bool operator()(const BallParams& a, const BallParams& b) const
    {
      return a.radius == b.radius && a.mass == b.mass && a.inertia == b.inertia && a.material == b.material &&
             a.color.r == b.color.r && a.color.g == b.color.g && a.color.b == b.color.b && a.color.a == b.color.a;
    }
  };

  std::unordered_map<BallParams, FlightModel, Hash, Same> types_;
};
}  // namespace ping_pong
