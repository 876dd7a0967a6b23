// Balls by the boxes and spheres that they can sweep for a while, in the cells of a grid.
#pragma once

#include "base/thread_pool.h"
#include "solver/solver_state.h"

namespace ping_pong
{
/// Half the edge of the box around the way of a ball along which neighbours are searched [m].
float halfEdge(const ContactSolver& solver, std::size_t i, int axis);
/// That box, and the sphere around the same way.
NeighbourGrid::Entry entryOf(const ContactSolver& solver, std::size_t i);
/// Sorts all balls into the grid and pairs those whose ways come near each other; lists by ball come later.
void findNeighbours(ContactSolver& solver, Workers& workers);

inline bool overlap(const NeighbourGrid::Entry& a, const NeighbourGrid::Entry& b)
{
  const Eigen::Vector3f d = a.centre - b.centre;
  const float round = a.round + b.round;
  return (d.cwiseAbs().array() <= (a.half + b.half).array()).all() && d.squaredNorm() <= round * round;
}

/// Every cell that may hold the centre of a box that overlaps this one.
template <typename Action>
void eachCellNear(const NeighbourGrid& grid, const NeighbourGrid::Entry& entry, const Action& action)
{
  std::array<int, 3> low, high;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double centre = grid.origin[axis] + static_cast<double>(entry.centre[axis]);
    const double reach = static_cast<double>(entry.half[axis] + 0.5f * grid.large_edge);
    low[axis] = grid.cellAt(centre - reach, axis);
    high[axis] = grid.cellAt(centre + reach, axis);
  }
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int x = low[0]; x <= high[0]; ++x)
        action(static_cast<std::size_t>((z * grid.count[1] + y) * grid.count[0] + x));
}
}  // namespace ping_pong
