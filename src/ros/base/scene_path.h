// Scenes by path, or by name in a directory.
#pragma once

#include <string>

namespace ping_pong_sim
{
/// @param directory  where scenes are looked up by name; empty: nowhere
/// @param scene      a path if it has a slash or ends in .yaml
std::string scenePath(const std::string& directory, const std::string& scene);
}  // namespace ping_pong_sim
