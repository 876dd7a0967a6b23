// What a window asks of every ball, in one line of the cache: thousands of whole records are a long way through memory.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "base/prefetch.h"
#include "evolve/parabola.h"
#include "geometry/aabb.h"

namespace ping_pong
{
struct BallRecord;

/// No later than t, and not much earlier.
inline float floatBefore(double t)
{
  constexpr float kRounding = 2e-7f;  // more than that of the number and of the difference, 2^-24 each
  const auto near = static_cast<float>(std::min(t, 1e30));
  return near - kRounding * std::abs(near);
}

/// What changes most, in one word: of several workers one can claim a ball.
struct alignas(8) CachedBallHead
{
  /// No event with a body is earlier [s]. Of a ball that is not busy.
  float next() const
  {
    float time;
    std::memcpy(&time, &next_or_entry_, sizeof time);
    return time;
  }
  void setNext(float time) { std::memcpy(&next_or_entry_, &time, sizeof time); }
  /// Of its record, see IslandRecords. Of a busy ball.
  std::uint32_t entry() const { return next_or_entry_; }
  void setEntry(std::uint32_t entry) { next_or_entry_ = entry; }

private:
  std::uint32_t next_or_entry_ = 0;  ///< 0: the time 0

public:
  std::uint16_t version = 0;  ///< of the path: its last bits
  std::uint8_t type = 0;      ///< entry in BallCache::types_
  bool left_path : 1;         ///< the ball has left a path in this window,
  bool added : 1;             ///< or in one before since the grid was built, or may have
  bool due : 1;               ///< it is in a list, see IslandWork::due
  bool busy : 1;              ///< something happens to it in this window

  CachedBallHead() : left_path(false), added(false), due(false), busy(false) {}
};

struct alignas(64) CachedBall : CachedBallHead
{
  double start = 0.0;  ///< of the path [s]
  Vector3d p, v;       ///< there, in W [m, m/s]
};
static_assert(sizeof(CachedBallHead) == 8, "a word");
static_assert(sizeof(CachedBall) == 64, "a line of the cache");

/// What many balls have in common.
struct CachedType
{
  enum class How : std::uint8_t
  {
    AskRecord,  ///< a path that is not known here
    Away,       ///< BallRecord::away()
    Flies,      ///< p + v s + half_a s^2
    Lies
  };
  How how = How::AskRecord;
  double radius = 0.0;                 ///< [m]
  Vector3d half_a = Vector3d::Zero();  ///< [m/s^2], in W
};

class BallCache
{
public:
  void reserve(std::size_t balls);
  /// Not if someone has changed balls outside of a window since readAll(): WorldState::edits tells.
  bool known(std::uint32_t edits) const { return known_ == edits; }
  void readAll(const std::vector<BallRecord>& balls, std::uint32_t edits);
  /// To be called when ball i will not change any more, for now.
  /// @return what its `next` has to be when it is not busy
  float read(const BallRecord& ball, std::size_t i, bool left_path);

  /// While other workers may make balls busy:
  CachedBallHead head(std::size_t i) const
  {
    const Word word = __atomic_load_n(wordOf(i), __ATOMIC_RELAXED);
    CachedBallHead head;
    std::memcpy(static_cast<void*>(&head), &word, sizeof head);
    return head;
  }
  /// False, with nothing changed, if it is not `now` any more.
  bool replace(std::size_t i, const CachedBallHead& now, const CachedBallHead& other)
  {
    Word expected, wanted;
    std::memcpy(&expected, &now, sizeof expected);
    std::memcpy(&wanted, &other, sizeof wanted);
    return __atomic_compare_exchange_n(const_cast<Word*>(wordOf(i)), &expected, wanted, false, __ATOMIC_RELAXED,
                                       __ATOMIC_RELAXED);
  }

  /// It will be looked at soon, or changed: until then it comes through memory.
  void fetch(std::size_t i) const { fetchToRead(&list_[i]); }
  void fetchToChange(std::size_t i) const { fetchToWrite(&list_[i]); }
  const CachedBall& operator[](std::size_t i) const { return list_[i]; }
  CachedBall& operator[](std::size_t i) { return list_[i]; }
  const CachedType& typeOf(const CachedBall& cached) const { return types_[cached.type]; }
  bool away(std::size_t i) const { return typeOf(list_[i]).how == CachedType::How::Away; }

private:
  static constexpr std::size_t kMostTypes = 16;
  using Word [[gnu::may_alias]] = std::uint64_t;

  const Word* wordOf(std::size_t i) const
  {
    return reinterpret_cast<const Word*>(static_cast<const CachedBallHead*>(&list_[i]));
  }

  bool is(std::uint8_t type, const BallRecord& ball) const;
  std::uint8_t typeFor(const BallRecord& ball, std::uint8_t guess) const;

  std::uint32_t known_ = ~0u;  // edits then
  std::vector<CachedType> types_;
  std::vector<CachedBall> list_;
};

inline ParabolaView viewOf(const CachedBall& cached, const CachedType& type)
{
  return {cached.start, cached.p, cached.v, type.half_a};
}
}  // namespace ping_pong
