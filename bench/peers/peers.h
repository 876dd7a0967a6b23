// Other simulators on our chart: Bullet, ODE, DART, MuJoCo and Simbody as Debian ships them. Built with
// -DBENCH_PEERS=ON.
#pragma once

#include <vector>

#include "engines/engine.h"

namespace ping_pong::bench
{
/// All peers, each as "default" and "best". What the settings are, and why, is in README.md beside this file.
std::vector<EngineKind> peerKinds();

EngineKind bulletKind();
EngineKind odeKind();
EngineKind dartKind();
EngineKind mujocoKind();
EngineKind simbodyKind();
}  // namespace ping_pong::bench
