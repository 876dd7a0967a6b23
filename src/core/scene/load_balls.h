// The part `balls` of a scene file.
#pragma once

#include "ping_pong_sim/scene.h"
#include "ping_pong_sim/scene_loader.h"
#include "scene/yaml_reader.h"

namespace ping_pong
{
/// How many times as many balls are asked for as the file's one random pattern holds; 1 if no number is asked for. Throws
/// LoadError if there is not exactly one such pattern.
double crowdGrowth(const Map& scene_map, const LoadOptions& options);

/// Appends all balls, placed and checked against overlap. Bodies must be complete.
void readBalls(const Map& scene_map, const LoadOptions& options, Scene& scene);
}  // namespace ping_pong
