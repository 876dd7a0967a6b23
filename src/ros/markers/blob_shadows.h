// A dark disc under every ball: shadows for pictures without lights, and for crowds, which cast none.
#pragma once

#include "ball_markers.h"

namespace ping_pong_sim
{
/// One marker with a disc per ball (up to a thousand), where the line from the light through the ball meets the floor
/// or a level plate. It takes itself away when there is none.
/// @param light_W  [m]
visualization_msgs::Marker blobShadows(const Simulation& simulation, const ping_pong::Vector3d& light_W);
}  // namespace ping_pong_sim
