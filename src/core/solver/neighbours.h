// What may touch soon: pairs of balls, balls and shapes, and what is kept of them from step to step.
#pragma once

#include <cstdint>

#include "base/simd4.h"

namespace ping_pong
{
/// An entry in the list of neighbours of one ball.
struct PairEnd
{
  std::uint32_t pair : 31;  ///< index
  std::uint32_t is_b : 1;   ///< the list is that of its ball b

  static PairEnd endOfList() { return {~0u >> 1, 1}; }
  bool isEnd() const { return pair == ~0u >> 1; }
};
static_assert(sizeof(PairEnd) == 4, "there are thousands of pairs");

/// Two balls that may touch soon. Each ball has a list of its pairs: see anyPair().
struct NeighbourPair
{
  std::uint32_t a, b;      ///< slots; normals point from b to a
  PairEnd next_a, next_b;  ///< in the lists of a and b
};

/// A ball and a shape that may touch soon.
struct BodyNeighbour
{
  std::uint32_t ball;
  std::uint32_t next;  ///< neighbour of this ball, a still body again
  std::uint16_t body, shape;
  Lanes impulse{};  ///< in the last step: of friction, and along the normal, >= 0 [N s]
};

/// What is kept of a pair in contact while neighbours are searched anew.
struct KeptPair
{
  std::uint32_t a, b;
  float force_at_sleep;  ///< see ContactSolver
  Lanes impulse;         ///< see ContactSolver
};

/// A pair, or a ball and a shape: an entry of one of the three lists of neighbours.
struct NeighbourRef
{
  enum List : std::uint32_t
  {
    Pairs,
    StillBodies,
    MovingBodies
  };
  std::uint32_t index : 30;
  std::uint32_t list : 2;

  bool operator>(const NeighbourRef& other) const
  {
    return index != other.index ? index > other.index : list > other.list;
  }
};
}  // namespace ping_pong
