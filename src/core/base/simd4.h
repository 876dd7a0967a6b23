// Four numbers at a time, as processors handle them: the same bits as one by one.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace ping_pong
{
using Lanes = float __attribute__((vector_size(16)));
using LaneMask = std::int32_t __attribute__((vector_size(16)));  ///< of a comparison: 0 is no
inline constexpr std::size_t kLanes = 4;

inline Lanes allLanes(float x)
{
  return Lanes{x, x, x, x};
}
/// b where a is not a number.
inline Lanes lesser(Lanes a, Lanes b)
{
  return a < b ? a : b;
}
inline Lanes greater(Lanes a, Lanes b)
{
  return a > b ? a : b;
}
inline Lanes squareRoot(Lanes x)
{
  return Lanes{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
}
inline bool anyLane(LaneMask mask)
{
  std::uint64_t halves[2];
  std::memcpy(halves, &mask, sizeof(mask));
  return (halves[0] | halves[1]) != 0;
}

/// Which lanes are not 0: one bit each, that of the first lane is the lowest.
inline unsigned lanesIn(LaneMask mask)
{
#ifdef __SSE2__
  return static_cast<unsigned>(__builtin_ia32_movmskps(reinterpret_cast<Lanes>(mask)));
#else
  mask &= LaneMask{1, 2, 4, 8};
  return static_cast<unsigned>(mask[0] | mask[1] | mask[2] | mask[3]);
#endif
}

/// So many, of lanes from the first one on; fewer than 32.
inline unsigned lowestBits(std::size_t count)
{
  return (1u << count) - 1u;
}

/// Four vectors.
struct LaneVectors
{
  Lanes x, y, z;

  template <class Vector>
  void set(std::size_t lane, const Vector& its)
  {
    x[lane] = static_cast<float>(its.x());
    y[lane] = static_cast<float>(its.y());
    z[lane] = static_cast<float>(its.z());
  }
  Eigen::Vector3f at(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
};

inline LaneVectors operator+(const LaneVectors& a, const LaneVectors& b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline LaneVectors operator-(const LaneVectors& a, const LaneVectors& b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline LaneVectors operator*(Lanes s, const LaneVectors& a)
{
  return {s * a.x, s * a.y, s * a.z};
}
inline Lanes dot(const LaneVectors& a, const LaneVectors& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline LaneVectors cross(const LaneVectors& a, const LaneVectors& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Of a record of four numbers.
inline Lanes lanesAt(const float* numbers)
{
  Lanes lanes;
  std::memcpy(&lanes, numbers, sizeof(lanes));
  return lanes;
}
inline void putLanes(Lanes lanes, float* numbers)
{
  std::memcpy(numbers, &lanes, sizeof(lanes));
}

/// Of a vector and another number.
template <class Vector>
Lanes lanesOf(const Vector& v, double last)
{
  return Lanes{static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()),
               static_cast<float>(last)};
}

/// Four of the eight numbers of a and b, by their indices.
template <int i, int j, int k, int l, class Vector>
Vector pick(Vector a, Vector b)
{
#ifdef __clang__
  return __builtin_shufflevector(a, b, i, j, k, l);
#else
  return __builtin_shuffle(a, b, LaneMask{i, j, k, l});
#endif
}

/// Four records of four numbers each, turned into four times the same number of each.
inline void transpose(Lanes& a, Lanes& b, Lanes& c, Lanes& d)
{
  const Lanes ab_low = pick<0, 4, 1, 5>(a, b), ab_high = pick<2, 6, 3, 7>(a, b);
  const Lanes cd_low = pick<0, 4, 1, 5>(c, d), cd_high = pick<2, 6, 3, 7>(c, d);
  a = pick<0, 1, 4, 5>(ab_low, cd_low);
  b = pick<2, 3, 6, 7>(ab_low, cd_low);
  c = pick<0, 1, 4, 5>(ab_high, cd_high);
  d = pick<2, 3, 6, 7>(ab_high, cd_high);
}

/// Four records of a vector and another number.
inline LaneVectors vectorsOf(std::array<Lanes, kLanes> records, Lanes& last)
{
  transpose(records[0], records[1], records[2], records[3]);
  last = records[3];
  return {records[0], records[1], records[2]};
}
inline LaneVectors vectorsOf(const std::array<Lanes, kLanes>& records)
{
  Lanes left_out;
  return vectorsOf(records, left_out);
}

/// The other way round.
inline std::array<Lanes, kLanes> recordsOf(const LaneVectors& vectors, Lanes last = Lanes{})
{
  std::array<Lanes, kLanes> records{vectors.x, vectors.y, vectors.z, last};
  transpose(records[0], records[1], records[2], records[3]);
  return records;
}
}  // namespace ping_pong
