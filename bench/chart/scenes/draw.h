// Random starts with the same bits everywhere.
#pragma once

#include "base/random.h"

namespace ping_pong::bench
{
/// Any direction; the length first, since the order of two draws in one expression is the compiler's.
inline Vector3d randomVector(Random& random, double least, double most)
{
  const double length = random.uniform(least, most);
  return length * random.direction();
}
}  // namespace ping_pong::bench
