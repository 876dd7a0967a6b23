// Typical shots of table tennis: what a ball launcher plays. They come from the +x side and land on the half at -x.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ping_pong_sim/types.h"

namespace ping_pong
{
/// How a ball leaves the launcher, relative to the frame T of the table: origin in the middle of the playing surface,
/// x along the table, y left, z up. Vectors are expressed in T.
struct Shot
{
  std::string name;
  Vector3d p_TB = Vector3d::Zero();  ///< centre of the ball [m]
  Vector3d v_TB = Vector3d::Zero();  ///< [m/s]
  Vector3d w_TB = Vector3d::Zero();  ///< spin [rad/s]; topspin is along -y, backspin along +y
};

/// All named shots: serve, push, drive, loop, smash, lob. They land where docs/ros.md says in air (default of Forces,
/// with drag, Magnus and buoyancy); without air they go elsewhere, spin and all. The serve bounces on its own half
/// first.
const std::vector<Shot>& shots();

/// The shot of that name, or nullptr.
const Shot* findShot(const std::string& name);

/// "serve, push, ...", for messages.
std::string shotNames();

/// The n-th of an endless series: each round plays every shot once, in an order drawn anew. The same n, the same shot.
const Shot& drawnShot(std::uint64_t n);

/// The shot as a person would play it: speed and spin off by up to the part `scatter`, both vectors turned by up to
/// `scatter` [rad]. The position stays. The same seed, the same bits.
/// @param scatter  0 to 1
Shot scattered(const Shot& shot, double scatter, std::uint64_t seed);
}  // namespace ping_pong
