// Constraints of the solver in batches of four that have no ball in common.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/simd4.h"

namespace ping_pong
{
/// Where a constraint is in a list of batches.
struct ConstraintIndex
{
  std::uint32_t value;  ///< of all lanes, those of one batch after those of the one before

  std::size_t batch() const { return value / kLanes; }
  std::size_t lane() const { return value % kLanes; }
};

/// Contacts, as the iteration needs them: four pairs of balls, or four balls with bodies.
struct alignas(64) ConstraintBatch
{
  LaneVectors n{};        ///< unit normals, to the first ball
  LaneVectors slip{};     ///< of the touching points, before the contacts [m/s]
  LaneVectors tangent{};  ///< impulses of friction [N s]
  Lanes normal{};         ///< impulses along n, >= 0 [N s]
  Lanes target{};         ///< least changes of the velocities along n of the first relative to the second [m/s]
  Lanes normal_mass{}, slip_mass{};        ///< impulses by changes of the relative velocities [kg]
  Lanes friction{};                        ///< coefficients
  std::array<std::uint32_t, kLanes> a, b;  ///< slots of the balls; in a lane without a constraint both are the same

  static constexpr std::uint32_t kBody = ~0u;  ///< the second one of a ball with a body

  explicit ConstraintBatch(std::uint32_t ball)
  {
    a.fill(ball);
    b.fill(ball);
  }
  bool full() const { return a.back() != b.back(); }  // lanes are filled in their order
  bool has(std::size_t lane) const { return a[lane] != b[lane]; }
};
static_assert(sizeof(ConstraintBatch) == 256, "four lines of the cache");

/// Two balls in contact, as they are found.
struct FoundPair
{
  Lanes
      way;  ///< from the second one to the first at the end of the step [m], and its square less that of their reach [m^2]
  Lanes
      u;  ///< velocity of the first relative to the second [m/s], and as above at the start of the step, at most 0 [m^2]
  Lanes impulse;  ///< impulse of friction that it begins with, and along the normal [N s]
};

/// Batches that have lanes left, while constraints are listed.
class OpenBatches
{
public:
  OpenBatches() { balls_.fill(kFull); }

  /// A lane for a constraint between these balls. The rest of it is to be written.
  ConstraintIndex add(std::vector<ConstraintBatch>& batches, std::uint32_t a, std::uint32_t b)
  {
    const std::uint64_t balls = bit(a) | bit(b);
    unsigned fit = 0;
    for (std::size_t k = 0; k < kMost; ++k) fit |= static_cast<unsigned>((balls_[k] & balls) == 0) << k;
    const std::size_t k = fit != 0 ? static_cast<std::size_t>(__builtin_ctz(fit)) : open(batches, a);
    const ConstraintIndex index{next_[k].value++};
    const std::size_t lane = index.lane();
    batches[index.batch()].a[lane] = a;
    batches[index.batch()].b[lane] = b;
    balls_[k] = lane + 1 == kLanes ? kFull : balls_[k] | balls;
    return index;
  }

private:
  static constexpr std::size_t kMost = 8;
  static constexpr std::uint64_t kFull = ~std::uint64_t{0};

  static std::uint64_t bit(std::uint32_t ball)
  {
    return ball == ConstraintBatch::kBody ? 0 : std::uint64_t{1} << (ball % 64);
  }
  std::size_t open(std::vector<ConstraintBatch>& batches, std::uint32_t ball)
  {
    std::size_t k = oldest_++ % kMost;  // stays as it is, unless another one is full
    for (std::size_t other = 0; other < kMost; ++other)
      if (balls_[other] == kFull) k = other;
    balls_[k] = 0;
    next_[k].value = static_cast<std::uint32_t>(kLanes * batches.size());
    batches.emplace_back(ball);
    return k;
  }

  std::array<std::uint64_t, kMost> balls_;  ///< a bit for each, which it may share with others
  std::array<ConstraintIndex, kMost> next_{};
  std::size_t oldest_ = 0;
};
}  // namespace ping_pong
