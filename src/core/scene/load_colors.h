// Colours of balls in a scene file: a name, [r, g, b], or `mixed`.
#pragma once

#include <vector>

#include "ping_pong_sim/types.h"
#include "scene/yaml_reader.h"

namespace ping_pong
{
/// Colours that the balls take in turn; one unless the value is `mixed`.
std::vector<Color> readPalette(const Field& field);

/// Colour of balls that say nothing about it.
Color defaultColor();
}  // namespace ping_pong
