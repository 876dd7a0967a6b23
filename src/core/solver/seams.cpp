#include "solver/seams.h"

#include <cmath>

namespace ping_pong
{
namespace
{
constexpr double kFlush = 1e-9;  // what is no farther from a plane lies in it [m]

Proximity nearestTo(const Shape& shape, const BodyFrame& frame, const Vector3d& p)
{
  Proximity near = proximity(shape, frame.R_WB.transpose() * (p - frame.p_WB));
  near.normal = frame.R_WB * near.normal;
  near.t1 = frame.R_WB * near.t1;
  return near;
}

// b lies in the tangent plane of a: what is between their points has no part along the normal of a.
bool continues(const Proximity& b, const Proximity& a)
{
  return a.distance > 0.0 && b.distance > 0.0 && std::abs(a.distance - a.normal.dot(b.normal) * b.distance) <= kFlush;
}

// Of two surfaces that continue each other one counts: a face, or else what is nearer. `first` decides where both are the same.
bool comesFirst(const Proximity& a, const Proximity& b, bool first)
{
  if (a.flat() != b.flat()) return a.flat();
  return a.distance != b.distance ? a.distance < b.distance : first;
}

// The surface that comes before all others that this one continues.
class Search
{
public:
  explicit Search(const Proximity& near) : near_(near) {}

  void look(const Proximity& other, bool first, std::uint32_t neighbour)
  {
    if (!continues(near_, other) || !comesFirst(other, near_, first)) return;
    if (!found_.there || comesFirst(other, found_.surface, false)) found_ = {true, neighbour, other};
  }
  const Seam& found() const { return found_; }

private:
  const Proximity& near_;
  Seam found_;
};

Seam seamInBody(const WorldWithSolver& world, const BodyNeighbour& neighbour, const Proximity& near, const Vector3d& p,
                double t)
{
  const BodyRecord& body = world.bodies[neighbour.body];
  const BodyFrame frame = body.at(world.solver.start + t);
  Search search(near);
  for (std::size_t s = 0; s < body.body.shapes.size(); ++s)
    if (s != neighbour.shape)
      search.look(nearestTo(body.body.shapes[s], frame, p), s < neighbour.shape, ContactSolver::kEndOfList);
  return search.found();
}

Seam seamAmongStill(const WorldWithSolver& world, const BodyNeighbour& neighbour, const Proximity& near,
                    const Vector3d& p)
{
  const ContactSolver& solver = world.solver;
  Search search(near);
  for (std::uint32_t l = solver.first_body[neighbour.ball]; l != ContactSolver::kEndOfList; l = solver.bodies[l].next)
  {
    const BodyNeighbour& other = solver.bodies[l];
    if (other.body == neighbour.body && other.shape == neighbour.shape) continue;
    const bool first = other.body != neighbour.body ? other.body < neighbour.body : other.shape < neighbour.shape;
    search.look(proximity(world.bodies[other.body].placed[other.shape], p), first, l);
  }
  return search.found();
}
}  // namespace

Proximity nearestOf(const WorldWithSolver& world, const BodyNeighbour& neighbour, const Vector3d& p, double t)
{
  const BodyRecord& body = world.bodies[neighbour.body];
  if (!body.moving) return proximity(body.placed[neighbour.shape], p);
  return nearestTo(body.body.shapes[neighbour.shape], body.at(world.solver.start + t), p);
}

Seam seamWith(const WorldWithSolver& world, const BodyNeighbour& neighbour, const Proximity& near, const Vector3d& p,
              double t)
{
  return world.bodies[neighbour.body].moving ? seamInBody(world, neighbour, near, p, t)
                                             : seamAmongStill(world, neighbour, near, p);
}
}  // namespace ping_pong
