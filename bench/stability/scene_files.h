// Random scenes as files that `simulate` and the launch files read.
#pragma once

#include <string>

#include "random_scene.h"

namespace ping_pong::stability
{
/// Writes scene.yaml and a URDF file for each body into this folder. Poses go through roll, pitch and yaw: the last
/// bits may differ. Commands to bodies stand in comments. Throws std::runtime_error.
void dumpScene(const RandomScene& drawn, const std::string& folder);
}  // namespace ping_pong::stability
