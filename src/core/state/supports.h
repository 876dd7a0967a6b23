// Contact mode: the surfaces that carry a ball which has stopped bouncing on them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/pooled.h"

namespace ping_pong
{
/// Surfaces that a ball lies on.
class Supports
{
public:
  static constexpr std::size_t kMax = 8;
  struct Surface
  {
    std::uint16_t body = 0;
    std::uint16_t shape = 0;
  };

  std::size_t count() const { return list_ ? list_->count : 0; }
  bool none() const { return count() == 0; }
  const Surface& operator[](std::size_t index) const { return list_->surfaces[index]; }
  bool has(std::size_t body, std::size_t shape) const { return list_ && list_->has(body, shape); }
  void add(std::size_t body, std::size_t shape);  ///< ignores what it has already, and more than kMax
  void remove(std::size_t index);
  void replace(std::size_t index, std::size_t body, std::size_t shape);  ///< by one that is not there yet

  double since() const { return list_ ? list_->since : 0.0; }  ///< world time at which its bounces ended [s]
  void setSince(double time) { list_.make().since = time; }

  /// The path that ended had hardly begun, or not: paths that are short one after the other.
  void countShort(bool is_short);
  std::uint32_t shortPaths() const { return list_ ? list_->short_paths : 0; }

  /// Memory for those of so many balls, see Pooled::reserve().
  static void reserve(std::size_t balls, std::size_t threads) { Pooled<List>::reserve(balls, threads); }

private:
  struct List
  {
    double since = 0.0;
    std::array<Surface, kMax> surfaces;
    std::uint32_t count = 0;
    std::uint32_t short_paths = 0;

    bool has(std::size_t body, std::size_t shape) const;
  };

  Pooled<List> list_;  ///< few balls of a crowd lie
};
}  // namespace ping_pong
