// How bodies look: the <visual> elements of their URDF files.
#pragma once

#include <string>

#include "ball_markers.h"

namespace ping_pong_sim
{
/// The markers of one body, locked to its frame. A body without a file (the floor) gets a plain plate.
/// What cannot be read or shown is left out: pictures are not worth refusing a scene.
void appendBody(const ping_pong::Body& body, Markers& markers);

/// Text of a file; empty if it cannot be read.
std::string readText(const std::string& path);
}  // namespace ping_pong_sim
