// What a player has in mind, to look at: the path that it expects, where it will hit, and where it aims.
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "play/player.h"

namespace ping_pong_sim
{
/// @param time  of the world, now [s]
visualization_msgs::MarkerArray planMarkers(const ping_pong::play::Player& player, double time);
}  // namespace ping_pong_sim
