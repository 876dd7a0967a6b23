#include "resting/held_forces.h"

#include <Eigen/QR>
#include <cmath>
#include <limits>

namespace ping_pong
{
namespace
{
constexpr int kPasses = 2;       // over all directions in which supports press on each other
constexpr double kAllMet = 1e-9; // what is missed of the wanted accelerations, as a part of the scale, is rounding

constexpr int kMost = 6 * kMaxSupports;
using Equations = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMost, kMost>;
using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMost, 1>;
using Effect = Eigen::Matrix<double, 6, 1>;  // on (a, b)
using Effects = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, kMost>;

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

struct LinearProblem
{
  Effects rows, columns;  // row.(a, b) = wanted; a column is what one unknown does
  Unknowns wanted, forces;
  int count = 0;
  bool redundant = false;  // there are forces that hold each other
  double missed = 0.0;     // of what is wanted, where not all of that can be had at once [m/s^2]

  explicit LinearProblem(const ContactProblem& problem);
  // Several sticking contacts hold each other: of all forces that will do, the nearest to these.
  void solve(const ContactProblem& problem, const SupportForces& near);
  // The forces nearest to this one alone that hold each other.
  Unknowns internal(int unknown) const;
  BallAcceleration motion(const ContactProblem& problem) const;

  Equations matrix;
  Eigen::CompleteOrthogonalDecomposition<Equations> decomposition;

  void add(const Effect& row, double its_wanted, const Effect& column)
  {
    rows.col(count) = row;
    columns.col(count) = column;
    wanted[count++] = its_wanted;
  }
};

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
  if (mode.spin == Resistance::Slips) effect += effectOfTorque(-spinLimit(law, problem.k, 1.0) * mode.spin_direction * n);
  return effect;
}

void addSupport(const ContactProblem& problem, std::size_t i, LinearProblem& linear)
{
  const SupportPoint& at = problem.at[i];
  const SupportMode& mode = problem.mode[i];
  Effect row;
  row << at.n, Vector3d::Zero();
  linear.add(row, at.least, effectOfLoad(problem, i));
  const Vector3d e1 = at.n.unitOrthogonal();
  const std::array<Vector3d, 2> tangents{e1, at.n.cross(e1)};
  if (mode.slip == Resistance::Holds)
    for (const Vector3d& e : tangents)
    {
      row << e, -at.n.cross(e);  // e.(a - b x n)
      linear.add(row, -e.dot(at.slip_bias), effectOfForce(at.n, e, problem.k));
    }
  if (mode.roll == Resistance::Holds)
    for (const Vector3d& e : tangents) linear.add(effectOfTorque(e), -e.dot(at.roll_bias), effectOfTorque(e));
  if (mode.spin == Resistance::Holds) linear.add(effectOfTorque(at.n), -at.spin_bias, effectOfTorque(at.n));
}

LinearProblem::LinearProblem(const ContactProblem& problem)
{
  rows.resize(6, kMost);
  columns.resize(6, kMost);
  wanted.resize(kMost);
  for (std::size_t i = 0; i < problem.count; ++i)
    if (problem.mode[i].loaded) addSupport(problem, i, *this);
}

Unknowns unknownsOf(const ContactProblem& problem, const SupportForces& forces)
{
  Unknowns list(kMost);
  int next = 0;
  for (std::size_t i = 0; i < problem.count; ++i)
  {
    const SupportMode& mode = problem.mode[i];
    if (!mode.loaded) continue;
    const Vector3d& n = problem.at[i].n;
    const Vector3d e1 = n.unitOrthogonal(), e2 = n.cross(e1);
    const auto addInPlane = [&](const Vector3d& force)
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

void LinearProblem::solve(const ContactProblem& problem, const SupportForces& near)
{
  Effect free;
  free << problem.free.a, problem.free.b;
  matrix = rows.leftCols(count).transpose() * columns.leftCols(count);
  const Unknowns start = unknownsOf(problem, near);
  const Unknowns missing = wanted.head(count) - rows.leftCols(count).transpose() * free - matrix * start;
  decomposition.setThreshold(kContactRounding);
  decomposition.compute(matrix);
  redundant = decomposition.rank() < count;
  const Unknowns more = decomposition.solve(missing);
  missed = (missing - matrix * more).norm();
  forces = start + more;
}

BallAcceleration LinearProblem::motion(const ContactProblem& problem) const
{
  const Effect effect = columns.leftCols(count) * forces;
  return {problem.free.a + effect.head<3>(), problem.free.b + effect.tail<3>()};
}

Unknowns LinearProblem::internal(int unknown) const
{
  Unknowns one = Unknowns::Zero(count);
  one[unknown] = 1.0;
  const Unknowns felt = matrix * one;
  return one - decomposition.solve(felt);
}

// The forces of a support among the unknowns, in the order of addSupport().
SupportForce forceOf(const ContactProblem& problem, std::size_t i, const Unknowns& forces, int& next)
{
  const SupportMode& mode = problem.mode[i];
  const Surface& law = *problem.law[i];
  const Vector3d& n = problem.at[i].n;
  const Vector3d e1 = n.unitOrthogonal(), e2 = n.cross(e1);
  const auto inPlane = [&]
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

// How far the forces are inside of all limits, negative if they are not: a concave function of them [m/s^2].
double marginOf(const ContactProblem& problem, const Unknowns& forces)
{
  double margin = std::numeric_limits<double>::infinity();
  int next = 0;
  for (std::size_t i = 0; i < problem.count; ++i)
  {
    const SupportMode& mode = problem.mode[i];
    if (!mode.loaded) continue;
    const Surface& law = *problem.law[i];
    const SupportForce force = forceOf(problem, i, forces, next);
    margin = std::min(margin, force.load);
    const auto inside = [&](double limit, double its_force) { margin = std::min(margin, kInsideLimit * limit - its_force); };
    if (mode.slip == Resistance::Holds) inside(frictionLimit(law, force.load), force.friction.norm());
    if (mode.roll == Resistance::Holds) inside(rollLimit(law, problem.k, force.load), force.roll.norm());
    if (mode.spin == Resistance::Holds) inside(spinLimit(law, problem.k, force.load), std::abs(force.spin));
  }
  return margin;
}

// Supports may press on each other through the ball, which does not move it: as much of that as brings the forces furthest
// inside of their limits, along one direction, by golden-section search.
void pressAlong(const ContactProblem& problem, const Unknowns& direction, double most, double enough, Unknowns& forces)
{
  constexpr double kGolden = 0.6180339887498949;
  const auto at = [&](double x) { return marginOf(problem, forces + x * direction); };
  double low = -most, high = most;
  double x1 = high - kGolden * (high - low), x2 = low + kGolden * (high - low);
  double f1 = at(x1), f2 = at(x2);
  for (int i = 0; i < 40 && std::max(f1, f2) <= enough; ++i)
  {
    if (f1 < f2)
    {
      low = x1, x1 = x2, f1 = f2;
      x2 = low + kGolden * (high - low), f2 = at(x2);
    }
    else
    {
      high = x2, x2 = x1, f2 = f1;
      x1 = high - kGolden * (high - low), f1 = at(x1);
    }
  }
  const double best = f1 < f2 ? x2 : x1;
  if (std::max(f1, f2) > marginOf(problem, forces)) forces += best * direction;
}

bool respectsOthers(const ContactProblem& problem, const BallAcceleration& motion, double slack)
{
  for (std::size_t i = 0; i < problem.count; ++i)
    if (!problem.mode[i].loaded && problem.at[i].n.dot(motion.a) < problem.at[i].least - slack) return false;
  return true;
}

bool pressesOnAll(const ContactProblem& problem, const Unknowns& forces, double slack)
{
  int next = 0;
  for (std::size_t i = 0; i < problem.count; ++i)
    if (problem.mode[i].loaded && !(forceOf(problem, i, forces, next).load > slack)) return false;
  return true;
}

// The commonest case, one support without rolling resistance or spin friction, has a closed form.
bool onOne(const ContactProblem& problem, BallAcceleration& motion)
{
  const SupportMode& mode = problem.mode[0];
  if (problem.count != 1 || mode.roll != Resistance::None || mode.spin != Resistance::None) return false;
  motion = problem.free;
  if (!mode.loaded) return true;
  const SupportPoint& at = problem.at[0];
  const double load = at.least - at.n.dot(motion.a);
  motion.a += load * at.n;
  if (mode.slip == Resistance::None) return true;
  const Vector3d f = mode.slip == Resistance::Slips
                         ? Vector3d(-problem.law[0]->friction * load * mode.slip_direction)
                         : Vector3d(-slipRate(at, motion) / (1.0 + 1.0 / problem.k));
  motion.a += f;
  motion.b -= at.n.cross(f) / problem.k;
  return true;
}
}  // namespace

bool allHold(const ContactProblem& problem, bool squeezed, BallAcceleration& motion, SupportForces& forces)
{
  LinearProblem linear(problem);
  if (linear.count == 0) return false;
  linear.solve(problem, SupportForces());
  const double scale = scaleOf(problem), slack = kContactRounding * scale;
  if (linear.missed > kAllMet * scale || !(squeezed || pressesOnAll(problem, linear.forces, slack))) return false;
  double margin = marginOf(problem, linear.forces);
  for (int pass = 0; pass < kPasses && linear.redundant && margin <= slack; ++pass)
    for (int unknown = 0; unknown < linear.count && margin <= slack; ++unknown)
    {
      const Unknowns direction = linear.internal(unknown);
      if (direction.norm() > 1e-6) pressAlong(problem, direction / direction.norm(), 10.0 * scale, slack, linear.forces);
      margin = marginOf(problem, linear.forces);
    }
  if (margin <= slack) return false;
  motion = linear.motion(problem);
  if (!respectsOthers(problem, motion, slack)) return false;
  int next = 0;
  for (std::size_t i = 0; i < problem.count; ++i)
    forces[i] = problem.mode[i].loaded ? forceOf(problem, i, linear.forces, next) : SupportForce();
  return true;
}

BallAcceleration accelerationInModes(const ContactProblem& problem, const SupportForces& near)
{
  BallAcceleration motion;
  if (onOne(problem, motion)) return motion;
  LinearProblem linear(problem);
  if (linear.count == 0) return problem.free;
  linear.solve(problem, near);
  return linear.motion(problem);
}
}  // namespace ping_pong
