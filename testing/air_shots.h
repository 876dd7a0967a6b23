// Shots through the air that tests share, and the reference for them.
#pragma once

#include <random>

#include "air_reference.h"
#include "scene_builder.h"

namespace ping_pong
{
inline Forces onlyGravity()
{
  Forces forces;
  forces.gravity = Vector3d(0, 0, -kG);
  return forces;
}

inline Forces defaultAir()
{
  Forces forces = onlyGravity();
  forces.drag = forces.magnus = true;
  return forces;
}

// Everything at once, nothing along an axis.
inline Forces fullAir(LiftLaw::Kind lift)
{
  Forces forces = defaultAir();
  forces.buoyancy = forces.added_mass = true;
  forces.spin_decay = 0.15;
  forces.wind = Vector3d(0.3, -0.7, 0.2);
  forces.lift_law.kind = lift;
  if (lift == LiftLaw::Kind::Linear) forces.lift_law.slope = 0.6;
  return forces;
}

inline AirReference referenceOf(const Forces& forces)
{
  AirReference reference;
  reference.radius = kR;
  reference.mass = kBallMass;
  reference.density = forces.air_density;
  reference.gravity = forces.gravity.cast<Real>();
  reference.wind = forces.wind.cast<Real>();
  reference.decay = forces.spin_decay;
  reference.buoyancy = forces.buoyancy;
  reference.added_mass = forces.added_mass;
  const DragLaw drag = forces.drag_law;
  if (forces.drag)
    reference.C_D = [drag](Real S)
    { return drag.with_spin - (drag.with_spin - drag.without_spin) / (1.0L + S * S / drag.half_at / drag.half_at); };
  const LiftLaw law = forces.lift_law;
  if (forces.magnus && law.kind == LiftLaw::Kind::Linear) reference.C_L = [law](Real S) { return law.slope * S; };
  if (forces.magnus && law.kind == LiftLaw::Kind::Constant) reference.C_L = [law](Real) { return law.constant; };
  if (forces.magnus && law.kind == LiftLaw::Kind::Saturating)
    reference.C_L = [law](Real S) { return law.slope * S / (1.0L + law.saturation * S); };
  return reference;
}

// A shot of a rally: 3 to 25 m/s forwards, spin up to 120 rev/s about any axis.
inline BallState randomShot(std::mt19937& random)
{
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  BallState shot;
  shot.p_WB = Vector3d(-1.3 + 0.2 * part(random), 0.5 * part(random), 0.4 + 0.2 * part(random));
  const double speed = 14.0 + 11.0 * part(random);
  shot.v_WB = speed * Vector3d(1.0, 0.3 * part(random), 0.1 + 0.2 * part(random)).normalized();
  shot.w_WB = 2.0 * kPi * 70.0 * Vector3d(part(random), part(random), part(random));
  return shot;
}
}  // namespace ping_pong
