// Shapes that continue each other are one surface. A ball that lies on a face, however little it has sunk into it, touches the
// edge of the next shape in the same plane as well, with a normal that is tilted against its way: that edge is not there.
//
// A sphere touches a tangent plane in one point. So whatever else lies in the plane of the surface that is nearest to the ball
// is out of its reach, but for overlap. The same goes for a seam in an edge or in a round side.
#pragma once

#include "solver/solver_state.h"

namespace ping_pong
{
/// What of the shape of a neighbour is nearest to a place; in W. @param t  from the start of the step [s]
Proximity nearestOf(const WorldWithSolver& world, const BodyNeighbour& neighbour, const Vector3d& p_W, double t);

/// A surface that another one continues.
struct Seam
{
  bool there = false;
  std::uint32_t neighbour = ContactSolver::kEndOfList;  ///< with it, if it is a still body's
  Proximity surface;
};

/// Whether a shape is near this ball with something that only continues another shape, which is nearer: of the same body, or of
/// two still ones. @param near  what of it is nearest to the ball, at place p_W and time t
Seam seamWith(const WorldWithSolver& world, const BodyNeighbour& neighbour, const Proximity& near, const Vector3d& p_W,
              double t);
}  // namespace ping_pong
