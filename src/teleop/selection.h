// What the keys select: groups of names in the scene.
#pragma once

#include <string>
#include <vector>

#include "key_table.h"
#include "ping_pong_sim/PaddleStates.h"
#include "ping_pong_sim/SimStatus.h"

namespace ping_pong_sim
{
/// Names of a group's members, as the simulator tells them.
std::vector<std::string> members(const SimStatus& status, ping_pong::Group group);

/// The one after `current`; the first if that is the last or none of them. `names` is not empty.
const std::string& nextOf(const std::vector<std::string>& names, const std::string& current);

/// Moves a name to the front, if it is one of them.
void putFirst(const std::string& name, std::vector<std::string>& names);

/// The paddle that stands where a player's view looks from; empty: there is none.
std::string paddleAtMinusX(const PaddleStates& states);

bool isPaddle(const SimStatus& status, const std::string& name);
}  // namespace ping_pong_sim
