// What both Simbody adapters share: a multibody system with a free body for each ball, and the forces of flight.
#pragma once

#include <simbody/Simbody.h>

#include "stepped_engine.h"

namespace ping_pong::bench
{
inline SimTK::Vec3 toSimbody(const Vector3d& v)
{
  return {v.x(), v.y(), v.z()};
}
inline Vector3d fromSimbody(const SimTK::Vec3& v)
{
  return {v[0], v[1], v[2]};
}

/// Balls only; walls, contacts and events are the business of each adapter.
struct SimbodyBalls
{
  explicit SimbodyBalls(const Scene& scene);
  void put(SimTK::State& state, std::size_t ball, const BallState& now) const;
  BallState get(const SimTK::State& state, std::size_t ball) const;

  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter;
  SimTK::GeneralForceSubsystem forces;
  std::vector<SimTK::MobilizedBody::Free> balls;
};

/// Total force on a ball in flight, gravity included [N].
class SimbodyFlight : public SimTK::Force::Custom::Implementation
{
public:
  SimbodyFlight(const Scene& scene, const SimbodyBalls& balls);
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& on_bodies,
                 SimTK::Vector_<SimTK::Vec3>& on_particles, SimTK::Vector& on_mobilities) const override;
  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0.0; }

private:
  const Scene& scene_;
  const SimbodyBalls& balls_;
  std::vector<FlightModel> flight_;
};

std::unique_ptr<Engine> makeLocatedSimbody(const Scene& scene, double tolerance);
}  // namespace ping_pong::bench
