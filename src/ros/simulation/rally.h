// What the players did lately: the last impact worth telling, and hits in a row.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "ping_pong_sim/world.h"

namespace ping_pong_sim
{
class Rally
{
public:
  /// After each tick. @param is_played  body by body: somebody has moved it. A ball that comes by a paddle which only waits is no rally
  void observe(const ping_pong::World& world, const std::function<bool(std::size_t body)>& is_played);
  void restart() { *this = Rally(); }

  /// Paddle hits of the ball that a paddle hit last, until that ball meets the floor: then zero.
  std::uint32_t hits() const { return hits_; }
  std::uint32_t best() const { return best_; }  ///< since start or reset
  /// The last impact but for the faint ones of a ball that comes to rest.
  const std::optional<ping_pong::Contact>& lastContact() const { return last_; }

private:
  void observe(const ping_pong::World& world, const ping_pong::Contact& contact,
               const std::function<bool(std::size_t body)>& is_played);

  std::optional<ping_pong::BallId> ball_;
  std::uint32_t hits_ = 0;
  std::uint32_t best_ = 0;
  std::optional<ping_pong::Contact> last_;
};
}  // namespace ping_pong_sim
