// The shadow that always lies under a table: dark in the middle, clear at its rim.
#pragma once

#include <visualization_msgs/Marker.h>

namespace ping_pong_sim
{
/// Name of the URDF material of a box that is drawn so.
constexpr char kSoftShadow[] = "soft_shadow";

/// Turns a box into a sheet as long and as wide, whose colour fades towards a rounded rim. One sheet with colours at
/// its corners: sheets over each other look the same, but without a GPU each of them costs as much as the floor.
void makeSoft(visualization_msgs::Marker& box);
}  // namespace ping_pong_sim
