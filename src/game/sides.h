// The two players of a match, and the two ends of the table that they stand at.
#pragma once

#include <array>
#include <cstddef>

namespace ping_pong::game
{
enum class Player : unsigned char
{
  A,  ///< starts the match at the -x end
  B
};

/// Ends of the table along the x axis of its frame T, see Court.
enum class End : unsigned char
{
  Minus,
  Plus
};

constexpr Player other(Player player)
{
  return player == Player::A ? Player::B : Player::A;
}
constexpr End other(End end)
{
  return end == End::Minus ? End::Plus : End::Minus;
}
constexpr double sign(End end)
{
  return end == End::Minus ? -1.0 : 1.0;
}

constexpr std::size_t index(Player player)
{
  return static_cast<std::size_t>(player);
}
constexpr std::size_t index(End end)
{
  return static_cast<std::size_t>(end);
}

const char* name(Player player);  ///< "A", "B"
const char* name(End end);        ///< "-x", "+x"

/// Who stands where, by index(End).
using PlayersAtEnds = std::array<Player, 2>;
}  // namespace ping_pong::game
