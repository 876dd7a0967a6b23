// A ball: what it is and where it is.
#pragma once

#include "ping_pong_sim/constants.h"
#include "ping_pong_sim/types.h"

namespace ping_pong
{
struct BallParams
{
  double radius = kBallRadius;     ///< r [m]
  double mass = kBallMass;         ///< m [kg]
  double inertia = kShellInertia;  ///< k = I / (m r^2): 2/3 thin shell, 2/5 solid
  Color color;
  MaterialId material = 0;
};

struct BallState
{
  Vector3d p_WB = Vector3d::Zero();            ///< centre [m]
  Quaterniond q_WB = Quaterniond::Identity();  ///< turns with the spin
  Vector3d v_WB = Vector3d::Zero();            ///< [m/s]
  Vector3d w_WB = Vector3d::Zero();            ///< spin, expressed in W [rad/s]
};
}  // namespace ping_pong
