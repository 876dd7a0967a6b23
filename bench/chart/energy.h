// Energy and momentum of all balls together, from their states alone.
#pragma once

#include "chart/scenes/chart_scene.h"

namespace ping_pong::bench
{
/// Motion, spin and height [J].
double energyOf(const Scene& scene, const std::vector<BallState>& balls);
/// The same of the truth at this sample [J].
double trueEnergy(const Start& start, std::size_t sample);

/// |sum of m v| along the floor, relative to what all mass would have if all energy moved it.
double sidewaysMomentum(const Scene& scene, const std::vector<BallState>& balls, double energy);
}  // namespace ping_pong::bench
