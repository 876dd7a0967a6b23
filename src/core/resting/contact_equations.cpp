#include "resting/contact_equations.h"

namespace ping_pong
{
namespace
{
Effect effectOfForce(const Vector3d& n, const Vector3d& f, double k)
{
  Effect effect;
  effect << f, -n.cross(f) / k;
  return effect;
}

Effect effectOfTorque(const Vector3d& torque)
{
  Effect effect;
  effect << Vector3d::Zero(), torque;
  return effect;
}

// What the load of a support does, together with all resistances that are at their limits.
Effect effectOfLoad(const ContactProblem& problem, std::size_t i)
{
  const SupportMode& mode = problem.mode[i];
  const Surface& law = *problem.law[i];
  const Vector3d& n = problem.at[i].n;
  Effect effect;
  effect << n, Vector3d::Zero();
  if (mode.slip == Resistance::Slips) effect += effectOfForce(n, -law.friction * mode.slip_direction, problem.k);
  if (mode.roll == Resistance::Slips) effect += effectOfTorque(-rollLimit(law, problem.k, 1.0) * mode.roll_direction);
  if (mode.spin == Resistance::Slips)
    effect += effectOfTorque(-spinLimit(law, problem.k, 1.0) * mode.spin_direction * n);
  return effect;
}

}  // namespace

std::array<Vector3d, 2> tangentsOf(const Vector3d& n)
{
  const Vector3d e1 = n.unitOrthogonal();
  return {e1, n.cross(e1)};
}

ContactEquations::ContactEquations(const ContactProblem& problem)
    : rows(6, kMostUnknowns), columns(6, kMostUnknowns), wanted(kMostUnknowns)
{
  for (std::size_t i = 0; i < problem.count; ++i)
    if (problem.mode[i].loaded) addSupport(problem, i);
}

void ContactEquations::add(const Effect& row, double its_wanted, const Effect& column)
{
  rows.col(count) = row;
  columns.col(count) = column;
  wanted[count++] = its_wanted;
}

void ContactEquations::addSupport(const ContactProblem& problem, std::size_t i)
{
  const SupportPoint& at = problem.at[i];
  const SupportMode& mode = problem.mode[i];
  Effect row;
  row << at.n, Vector3d::Zero();
  add(row, at.least, effectOfLoad(problem, i));
  const std::array<Vector3d, 2> tangents = tangentsOf(at.n);
  if (mode.slip == Resistance::Holds)
    for (const Vector3d& e : tangents)
    {
      row << e, -at.n.cross(e);  // e.(a - b x n)
      add(row, -e.dot(at.slip_bias), effectOfForce(at.n, e, problem.k));
    }
  if (mode.roll == Resistance::Holds)
    for (const Vector3d& e : tangents) add(effectOfTorque(e), -e.dot(at.roll_bias), effectOfTorque(e));
  if (mode.spin == Resistance::Holds) add(effectOfTorque(at.n), -at.spin_bias, effectOfTorque(at.n));
}

BallAcceleration ContactEquations::motion(const ContactProblem& problem, const Unknowns& forces) const
{
  const Effect effect = columns.leftCols(count) * forces;
  return {problem.free.a + effect.head<3>(), problem.free.b + effect.tail<3>()};
}

Unknowns ContactEquations::missing(const ContactProblem& problem, const Unknowns& forces) const
{
  Effect free;
  free << problem.free.a, problem.free.b;
  return wanted.head(count) - rows.leftCols(count).transpose() * free - matrix() * forces;
}

int unknownsAt(const ContactProblem& problem, std::size_t i)
{
  const SupportMode& mode = problem.mode[i];
  return 1 + 2 * (mode.slip == Resistance::Holds) + 2 * (mode.roll == Resistance::Holds) +
         (mode.spin == Resistance::Holds);
}

Unknowns unknownsOf(const ContactProblem& problem, const SupportForces& forces)
{
  Unknowns list(kMostUnknowns);
  int next = 0;
  for (std::size_t i = 0; i < problem.count; ++i)
  {
    const SupportMode& mode = problem.mode[i];
    if (!mode.loaded) continue;
    const auto [e1, e2] = tangentsOf(problem.at[i].n);
    const auto addInPlane = [&, e1 = e1, e2 = e2](const Vector3d& force)
    {
      list[next++] = e1.dot(force);
      list[next++] = e2.dot(force);
    };
    list[next++] = forces[i].load;
    if (mode.slip == Resistance::Holds) addInPlane(forces[i].friction);
    if (mode.roll == Resistance::Holds) addInPlane(forces[i].roll);
    if (mode.spin == Resistance::Holds) list[next++] = forces[i].spin;
  }
  return list.head(next);
}

SupportForce forceOf(const ContactProblem& problem, std::size_t i, const Unknowns& forces, int& next)
{
  const SupportMode& mode = problem.mode[i];
  const Surface& law = *problem.law[i];
  const auto [e1, e2] = tangentsOf(problem.at[i].n);
  const auto inPlane = [&, e1 = e1, e2 = e2]
  {
    next += 2;
    return Vector3d(forces[next - 2] * e1 + forces[next - 1] * e2);
  };
  SupportForce force;
  force.load = forces[next++];
  if (mode.slip == Resistance::Holds) force.friction = inPlane();
  if (mode.slip == Resistance::Slips) force.friction = -frictionLimit(law, force.load) * mode.slip_direction;
  if (mode.roll == Resistance::Holds) force.roll = inPlane();
  if (mode.roll == Resistance::Slips) force.roll = -rollLimit(law, problem.k, force.load) * mode.roll_direction;
  if (mode.spin == Resistance::Holds) force.spin = forces[next++];
  if (mode.spin == Resistance::Slips) force.spin = -spinLimit(law, problem.k, force.load) * mode.spin_direction;
  return force;
}

SupportForces forcesOf(const ContactProblem& problem, const Unknowns& forces)
{
  SupportForces all;
  int next = 0;
  for (std::size_t i = 0; i < problem.count; ++i)
    if (problem.mode[i].loaded) all[i] = forceOf(problem, i, forces, next);
  return all;
}
}  // namespace ping_pong
