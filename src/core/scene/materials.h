// Materials by name. Indices are handed out in order of first use.
#pragma once

#include <string>
#include <vector>

#include "ping_pong_sim/types.h"

namespace ping_pong
{
/// Stands for every material in the pairs of a scene; no material may have this name.
constexpr char kAnyMaterial[] = "any";

/// Of balls that say nothing about it. Every scene has it as material 0, the default of BallParams.
constexpr char kBallMaterial[] = "ball";

/// Index of a material, or kNone.
std::size_t findMaterial(const std::vector<std::string>& materials, const std::string& name);

/// Index of a material, which is appended if it is new.
MaterialId internMaterial(std::vector<std::string>& materials, const std::string& name);
}  // namespace ping_pong
