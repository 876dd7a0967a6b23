// The part `surfaces` of a scene file: the contact law of each pair of materials.
#pragma once

#include "ping_pong_sim/scene.h"
#include "scene/yaml_reader.h"

namespace ping_pong
{
/// Fills scene.surfaces. Bodies, balls and materials must be complete: every pair that can meet needs a law.
void readSurfaces(const Map& scene_map, Scene& scene);
}  // namespace ping_pong
