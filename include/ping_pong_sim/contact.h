// The record of one impact.
#pragma once

#include "ping_pong_sim/types.h"

namespace ping_pong
{
/// One impact of ball B with a body or with another ball, at an instant.
struct Contact
{
  double time = 0.0;                     ///< world time [s]
  BallId ball = 0;                       ///< B
  bool with_ball = false;                ///< the other is a ball, not a body
  BallId other_ball = 0;                 ///< if with_ball
  std::size_t body = kNone;              ///< index of the body, if not with_ball
  std::size_t shape = kNone;             ///< index of the shape of that body
  Vector3d p_WC = Vector3d::Zero();      ///< point of contact [m]
  Vector3d n_W = Vector3d::UnitZ();      ///< unit normal, from the other to B
  Vector3d v_before = Vector3d::Zero();  ///< v_WB just before [m/s]
  Vector3d v_after = Vector3d::Zero();   ///< v_WB just after, of all surfaces that are struck together [m/s]
  Vector3d w_before = Vector3d::Zero();  ///< spin of B just before [rad/s]
  Vector3d w_after = Vector3d::Zero();   ///< spin of B just after [rad/s]
  Vector3d v_other = Vector3d::Zero();   ///< velocity of the touched point of the other, before [m/s]
  Vector3d impulse = Vector3d::Zero();   ///< on B, expressed in W [N s]

  // Not "= default": a list that grows would fill each record with zeros before the values above.
  Contact() {}
};
}  // namespace ping_pong
