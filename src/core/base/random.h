// Random numbers with the same bits everywhere: the distributions of <random> differ between libraries.
#pragma once

#include <cmath>
#include <cstdint>

#include "ping_pong_sim/types.h"

namespace ping_pong
{
/// splitmix64: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
class Random
{
public:
  /// Streams with the same seed and another index are independent of each other.
  Random(std::uint64_t seed, std::uint64_t stream) : state_(seed)
  {
    state_ = next() + stream;
    state_ = next();
  }

  std::uint64_t next()
  {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// At least lo, below hi (up to rounding), with 53 random bits.
  double uniform(double lo, double hi) { return lo + (hi - lo) * (static_cast<double>(next() >> 11) * 0x1p-53); }

  Vector3d uniform(const Vector3d& lo, const Vector3d& hi)
  {
    const double x = uniform(lo.x(), hi.x()), y = uniform(lo.y(), hi.y()), z = uniform(lo.z(), hi.z());
    return {x, y, z};
  }

  /// Unit vector, by rejection from a cube: only operations that IEEE 754 rounds correctly, no sin or cos.
  Vector3d direction()
  {
    for (;;)
    {
      const Vector3d v = uniform(Vector3d::Constant(-1.0), Vector3d::Constant(1.0));
      const double square = v.x() * v.x() + v.y() * v.y() + v.z() * v.z();
      if (square > 0.01 && square <= 1.0) return v / std::sqrt(square);
    }
  }

  /// Normally distributed with deviation 1, by Marsaglia's polar method; it, too, does without the maths library.
  double normal()
  {
    for (;;)
    {
      const double u = uniform(-1.0, 1.0), v = uniform(-1.0, 1.0);
      const double square = u * u + v * v;
      if (square > 0.0 && square < 1.0) return u * std::sqrt(-2.0 * logarithm(square) / square);
    }
  }

private:
  /// ln x for x > 0, to a few units in the last place: x = m 2^e, ln m = 2 artanh((m - 1) / (m + 1)).
  static double logarithm(double x)
  {
    int exponent = 0;
    double m = std::frexp(x, &exponent);  // exact
    if (m < 0.70710678118654752)
    {
      m *= 2.0;
      --exponent;
    }
    const double z = (m - 1.0) / (m + 1.0), zz = z * z;
    double sum = 0.0;
    for (int k = 25; k > 0; k -= 2) sum = sum * zz + 1.0 / k;
    return 2.0 * z * sum + exponent * 0.69314718055994531;
  }

  std::uint64_t state_;
};
}  // namespace ping_pong
