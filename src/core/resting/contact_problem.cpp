#include "resting/contact_problem.h"

#include <Eigen/QR>
#include <cmath>
#include <limits>

#include "count.h"

namespace ping_pong
{
namespace
{
constexpr int kMaxSweeps = 400;
constexpr int kPatience = 100;
constexpr int kPasses = 2;            // over all directions in which supports press on each other
constexpr double kConverged = 4e-15;  // change of a force in a sweep, as a part of the scale of accelerations and forces
constexpr double kGoodEnough = 1e-4;  // where sweeps come to their end slowly; where there is no end they grow
constexpr double kRounding = 1e-11;   // accelerations below this part of the scale are none
constexpr double kAllMet = 1e-9;
constexpr double kInsideLimit = 1.0 - 1e-9;

Vector3d limited(const Vector3d& f, double most)
{
  const double norm = f.norm();
  return norm > most ? Vector3d(most / norm * f) : f;
}

// The state of one solution under way.
struct Sweeper
{
  const ContactProblem& problem;
  BallAcceleration& motion;
  SupportForces& forces;
  double change = 0.0;
  double largest = 0.0;  // force

  void note(double by, double force)
  {
    change = std::max(change, by);
    largest = std::max(largest, force);
  }

  void push(std::size_t i, SupportForce& force)
  {
    const SupportPoint& at = problem.at[i];
    const double load = std::max(0.0, force.load + at.least - at.n.dot(motion.a));
    note(std::abs(load - force.load), load);
    motion.a += (load - force.load) * at.n;
    force.load = load;
  }

  void rub(std::size_t i, SupportForce& force)
  {
    const SupportMode& mode = problem.mode[i];
    if (mode.slip == Resistance::None) return;
    const SupportPoint& at = problem.at[i];
    const double limit = frictionLimit(*problem.law[i], force.load);
    Vector3d f;
    if (mode.slip == Resistance::Slips)
      f = -limit * mode.slip_direction;
    else
    {
      const Vector3d rate = tangentialTo(at.n, motion.a) - motion.b.cross(at.n) + at.slip_bias;
      f = limited(force.friction - rate / (1.0 + 1.0 / problem.k), limit);
    }
    const Vector3d more = f - force.friction;
    note(more.norm(), f.norm());
    motion.a += more;
    motion.b -= at.n.cross(more) / problem.k;
    force.friction = f;
  }

  void resistRoll(std::size_t i, SupportForce& force)
  {
    const SupportMode& mode = problem.mode[i];
    if (mode.roll == Resistance::None) return;
    const SupportPoint& at = problem.at[i];
    const double limit = rollLimit(*problem.law[i], problem.k, force.load);
    const Vector3d torque = mode.roll == Resistance::Slips
                                ? Vector3d(-limit * mode.roll_direction)
                                : limited(force.roll - tangentialTo(at.n, motion.b) - at.roll_bias, limit);
    note((torque - force.roll).norm(), torque.norm());
    motion.b += torque - force.roll;
    force.roll = torque;
  }

  void resistSpin(std::size_t i, SupportForce& force)
  {
    const SupportMode& mode = problem.mode[i];
    if (mode.spin == Resistance::None) return;
    const SupportPoint& at = problem.at[i];
    const double limit = spinLimit(*problem.law[i], problem.k, force.load);
    const double wanted = force.spin - at.n.dot(motion.b) - at.spin_bias;
    const double torque =
        mode.spin == Resistance::Slips ? -limit * mode.spin_direction : std::max(-limit, std::min(wanted, limit));
    note(std::abs(torque - force.spin), std::abs(torque));
    motion.b += (torque - force.spin) * at.n;
    force.spin = torque;
  }

  void sweep()
  {
    change = largest = 0.0;
    for (std::size_t i = 0; i < problem.count; ++i)
    {
      push(i, forces[i]);
      rub(i, forces[i]);
      resistRoll(i, forces[i]);
      resistSpin(i, forces[i]);
    }
  }
};

// --- known modes: linear equations for the unknown forces ---

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
  decomposition.setThreshold(kRounding);
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

// If the supports that are marked as loaded are, and all that may hold there holds: whether the forces that this takes exist.
// @param squeezed  even where supports carry loads only because they press on each other through the ball
bool allHold(const ContactProblem& problem, bool squeezed, BallAcceleration& motion, SupportForces& forces)
{
  LinearProblem linear(problem);
  if (linear.count == 0) return false;
  linear.solve(problem, SupportForces());
  const double scale = scaleOf(problem), slack = kRounding * scale;
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

ContactProblem withLoads(ContactProblem problem, const SupportForces* forces, double slack)
{
  for (std::size_t i = 0; i < problem.count; ++i) problem.mode[i].loaded = !forces || (*forces)[i].load > slack;
  return problem;
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
                         : Vector3d(-(tangentialTo(at.n, motion.a) - motion.b.cross(at.n) + at.slip_bias) / (1.0 + 1.0 / problem.k));
  motion.a += f;
  motion.b -= at.n.cross(f) / problem.k;
  return true;
}

Resistance kindOf(double force, double limit, double rate, double slack)
{
  return force < kInsideLimit * limit || rate <= slack ? Resistance::Holds : Resistance::Slips;
}
}  // namespace

double frictionLimit(const Surface& law, double load) { return load > 0.0 ? law.friction * load : 0.0; }

double rollLimit(const Surface& law, double k, double load)
{
  return load > 0.0 ? (1.0 + k) / k * law.rolling_resistance * load : 0.0;
}

double spinLimit(const Surface& law, double k, double load) { return load > 0.0 ? law.spin_friction / k * load : 0.0; }

double scaleOf(const ContactProblem& problem)
{
  double scale = problem.free.a.norm() + problem.free.b.norm();
  for (std::size_t i = 0; i < problem.count; ++i)
    scale = std::max({scale, std::abs(problem.at[i].least), problem.at[i].slip_bias.norm(), problem.at[i].roll_bias.norm(),
                      std::abs(problem.at[i].spin_bias)});
  return scale;
}

bool findForces(const ContactProblem& problem, BallAcceleration& motion, SupportForces& forces)
{
  for (std::size_t i = 0; i < problem.count; ++i)
    if (problem.mode[i].slip != Resistance::None) count(Law::Friction);
  if (allHold(withLoads(problem, nullptr, 0.0), false, motion, forces)) return true;
  const double scale = scaleOf(problem);
  motion = problem.free;
  for (std::size_t i = 0; i < problem.count; ++i) forces[i] = SupportForce();
  Sweeper sweeper{problem, motion, forces};
  for (int i = 0; i < kMaxSweeps; ++i)
  {
    sweeper.sweep();
    if (sweeper.change <= kConverged * (scale + sweeper.largest)) return true;
    // Sweeps that come to the border of what can be held do so without end.
    if (i == kPatience && allHold(withLoads(problem, &forces, kRounding * scale), true, motion, forces)) return true;
    if (!(sweeper.change < 1e9 * scale)) return false;
  }
  return sweeper.change <= kGoodEnough * scale;
}

std::array<SupportMode, kMaxSupports> modesOf(const ContactProblem& problem, const BallAcceleration& motion,
                                              const SupportForces& forces)
{
  std::array<SupportMode, kMaxSupports> modes = problem.mode;
  const double slack = kRounding * scaleOf(problem);
  for (std::size_t i = 0; i < problem.count; ++i)
  {
    const SupportPoint& at = problem.at[i];
    const Surface& law = *problem.law[i];
    const SupportForce& force = forces[i];
    SupportMode& mode = modes[i];
    mode.loaded = force.load > slack;
    if (!mode.loaded)
    {
      mode.slip = mode.roll = mode.spin = Resistance::None;
      continue;
    }
    if (mode.slip == Resistance::Holds)
    {
      const Vector3d rate = tangentialTo(at.n, motion.a) - motion.b.cross(at.n) + at.slip_bias;
      mode.slip = kindOf(force.friction.norm(), frictionLimit(law, force.load), rate.norm(), slack);
      if (mode.slip == Resistance::Slips) mode.slip_direction = -force.friction.normalized();
    }
    if (mode.roll == Resistance::Holds)
    {
      const Vector3d rate = tangentialTo(at.n, motion.b) + at.roll_bias;
      mode.roll = kindOf(force.roll.norm(), rollLimit(law, problem.k, force.load), rate.norm(), slack);
      if (mode.roll == Resistance::Slips) mode.roll_direction = -force.roll.normalized();
    }
    if (mode.spin == Resistance::Holds)
    {
      const double rate = at.n.dot(motion.b) + at.spin_bias;
      mode.spin = kindOf(std::abs(force.spin), spinLimit(law, problem.k, force.load), std::abs(rate), slack);
      mode.spin_direction = -std::copysign(1.0, force.spin);
    }
  }
  return modes;
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
