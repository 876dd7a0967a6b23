// Whether surfaces pushed a ball as their laws allow: from what a short time did to its velocity and spin, whoever
// computed it.
#pragma once

#include <optional>

#include "moment.h"

namespace ping_pong::stability
{
/// The part of the forces and torques that no loads and frictions allowed by the laws explain, 0 to 1. With loads N >=
/// 0 along the normals, a sliding contact has friction mu N against its slip, a gripping one any up to mu N; a single
/// gripping one also the torques of rolling resistance and spin friction. Nothing where one cannot tell: touches or
/// kinds of friction change, slip or path turn much in this time, resistance on several surfaces.
std::optional<double> againstTheLaw(const Scene& scene, const Moment& before, const Moment& after);
}  // namespace ping_pong::stability
