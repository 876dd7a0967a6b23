// What a match came to, as a YAML file for whoever runs many.
#pragma once

#include <array>
#include <string>

#include "game/umpire.h"

namespace ping_pong_sim
{
/// Writes rules, players, winner, points of each game, strokes of the longest rally. Throws std::runtime_error "FILE: ...: expected ...".
/// @param time  of the world at the end [s]
void writeResult(const std::string& file, const ping_pong::game::Umpire& umpire,
                 const std::array<std::string, 2>& players, double time);
}  // namespace ping_pong_sim
