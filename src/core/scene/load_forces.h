// The part `forces` of a scene file.
#pragma once

#include "ping_pong_sim/forces.h"
#include "scene/yaml_reader.h"

namespace ping_pong
{
/// What the file does not list is not computed.
Forces readForces(const Field& field);
}  // namespace ping_pong
