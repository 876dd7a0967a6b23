// How balls look.
#pragma once

#include <visualization_msgs/Marker.h>

#include <vector>

#include "ros/simulation/simulation.h"

namespace ping_pong_sim
{
using Markers = std::vector<visualization_msgs::Marker>;

/// A marker that is empty but for what all markers need.
visualization_msgs::Marker makeMarker(const std::string& frame, const std::string& ns, int id, int type);
/// Takes away all markers of a topic.
visualization_msgs::Marker deleteAllMarkers();

/// One sphere and one stripe per ball, locked to the ball's own frame: RViz moves them with every TF, at its own frame
/// rate, and they need not be sent again.
void appendSingleBalls(const ping_pong::World& world, Markers& markers);
/// One list of spheres per radius, where they are now; to be sent again and again.
void appendCrowd(const ping_pong::World& world, const ros::Time& stamp, Markers& markers);
}  // namespace ping_pong_sim
