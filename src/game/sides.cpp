#include "game/sides.h"

namespace ping_pong::game
{
const char* name(Player player)
{
  return player == Player::A ? "A" : "B";
}

const char* name(End end)
{
  return end == End::Minus ? "-x" : "+x";
}
}  // namespace ping_pong::game
