// From a shot to a ball in the world.
#pragma once

#include <string>

#include "ping_pong_sim/shots.h"
#include "ping_pong_sim/world.h"

namespace ping_pong_sim
{
/// The shot of that name; throws InputError that lists the known ones.
const ping_pong::Shot& shotNamed(const std::string& name);

/// Where shots start from: the frame of the body `table` if there is one, else the world's.
ping_pong::Pose tableFrame(const ping_pong::World& world);

/// The material "ball" of the scene, or what its first ball is made of.
ping_pong::MaterialId ballMaterial(const ping_pong::Scene& scene);

/// Adds a standard ball that leaves as the shot says, seen from the frame at X_WF. Throws InputError if the world
/// refuses.
ping_pong::BallId launchBall(ping_pong::World& world, const ping_pong::Pose& X_WF, const ping_pong::Shot& shot);
}  // namespace ping_pong_sim
