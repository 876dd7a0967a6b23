// The table as the player at one end sees it, and the world in which that player thinks.
#pragma once

#include <string>

#include "ping_pong_sim/scene.h"

namespace ping_pong::play
{
/// End of the table, by its frame: A at -x, B at +x.
enum class End
{
  A,
  B
};

/// The end at which a paddle starts. Throws std::invalid_argument, in one line, if the scene has no such paddle or no table.
End endOfPaddle(const Scene& scene, const std::string& paddle);

/// Frame O of a player: origin in the middle of the playing surface, x over the net to the other half, y left, z up. The own half
/// is x < 0 for the player of either end.
class Court
{
public:
  /// Throws std::invalid_argument, in one line, if the scene has no static body `table` with a box of material `table`, or if it does not
  /// lie level.
  Court(const Scene& scene, End end);

  double halfLength() const { return half_length_; }  ///< of the playing surface [m]
  double halfWidth() const { return half_width_; }
  double netHeight() const { return net_height_; }  ///< above the playing surface [m]; 0 without a net
  std::size_t table() const { return table_; }      ///< index of the body in the scene
  std::size_t surface() const { return surface_; }  ///< index of the shape with the playing surface
  MaterialId surfaceMaterial() const { return material_; }

  BallState toOwn(const BallState& state) const;
  Pose toOwn(const Pose& pose) const { return {X_WO_.toB(pose.p), X_WO_.q.conjugate() * pose.q}; }
  Vector3d turnedToOwn(const Vector3d& v_W) const { return X_WO_.q.conjugate() * v_W; }
  BallState toWorld(const BallState& state) const;
  Vector3d turnedToWorld(const Vector3d& v_O) const { return X_WO_.q * v_O; }
  Pose toWorld(const Pose& pose) const { return {X_WO_.q * pose.p + X_WO_.p, X_WO_.q * pose.q}; }

  /// The scene in frame O with its static bodies and one ball, moved by `exact`.
  Scene ownScene(const Scene& scene, const BallParams& ball) const;

private:
  Pose X_WO_;
  double half_length_ = 0.0, half_width_ = 0.0, net_height_ = 0.0;
  std::size_t table_ = kNone, surface_ = kNone;
  MaterialId material_ = 0;
};
}  // namespace ping_pong::play
