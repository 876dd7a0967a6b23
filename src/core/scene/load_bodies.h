// The parts `floor` and `bodies` of a scene file.
#pragma once

#include <string>

#include "ping_pong_sim/scene.h"
#include "scene/yaml_reader.h"

namespace ping_pong
{
/// A material's name. `any` is taken.
std::string readMaterial(const Field& field);

/// Appends the listed bodies, then the floor: body i of the file is body i of the scene.
/// @param growth  how many times as many balls as the file says are asked for: rooms may grow with them
void readBodies(const Map& scene_map, double growth, Scene& scene);
}  // namespace ping_pong
