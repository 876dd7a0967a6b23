#include "resting/constrained_forces.h"

#include <Eigen/QR>
#include <cmath>
#include <limits>

#include "resting/contact_equations.h"

namespace ping_pong
{
namespace
{
constexpr int kPasses = 2;          // over all directions in which supports press on each other
constexpr int kCuts = 24;           // of golden section, to 1e-5 of the range
constexpr double kNoMotion = 1e-9;  // what inner forces do to the ball, as a part of them: rounding
constexpr double kFarApart = 0.1;   // distance of two contacts, as a part of the radius, that makes an axis
constexpr double kAllMet = 1e-9;    // what is missed of the wanted accelerations, as a part of the scale, is rounding

struct LinearProblem
{
  ContactEquations equations;
  Unknowns forces;
  bool redundant = false;  // there are forces that hold each other
  double missed = 0.0;     // of what is wanted, where not all of that can be had at once [m/s^2]

  explicit LinearProblem(const ContactProblem& problem) : equations(problem) {}
  int count() const { return equations.count; }
  // Several sticking contacts hold each other: of all forces that will do, the nearest to these.
  void solve(const ContactProblem& problem, const SupportForces& near);
  // The forces nearest to these that hold each other.
  Unknowns internal(const Unknowns& wished) const;

  Square matrix;
  Eigen::CompleteOrthogonalDecomposition<Square> decomposition;
};

void LinearProblem::solve(const ContactProblem& problem, const SupportForces& near)
{
  matrix = equations.matrix();
  const Unknowns start = unknownsOf(problem, near);
  const Unknowns missing = equations.missing(problem, start);
  decomposition.setThreshold(kContactRounding);
  decomposition.compute(matrix);
  redundant = decomposition.rank() < count();
  const Unknowns more = decomposition.solve(missing);
  missed = (missing - matrix * more).norm();
  forces = start + more;
}

Unknowns LinearProblem::internal(const Unknowns& wished) const
{
  const Unknowns felt = matrix * wished;
  return wished - decomposition.solve(felt);
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
    const auto inside = [&](double limit, double its_force)
    { margin = std::min(margin, kInsideLimit * limit - its_force); };
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
  for (int i = 0; i < kCuts && std::max(f1, f2) <= enough; ++i)
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

// First all supports harder on the ball, then one unknown after the other. Where a resistance slips, more load may brake or turn
// the ball, too: that is another motion, and no inner force.
void pressWithinLimits(const ContactProblem& problem, double enough, double most, LinearProblem& linear)
{
  if (marginOf(problem, linear.forces) > enough) return;
  const auto press = [&](const Unknowns& wished)
  {
    if (marginOf(problem, linear.forces) > enough) return;
    const Unknowns direction = linear.internal(wished);
    const double moves = (linear.equations.columns.leftCols(linear.count()) * direction).norm();
    if (direction.norm() > 1e-6 && moves <= kNoMotion * direction.norm())
      pressAlong(problem, direction / direction.norm(), most, enough, linear.forces);
  };
  Unknowns loads = Unknowns::Zero(linear.count());
  for (std::size_t i = 0, next = 0; i < problem.count; ++i)
    if (problem.mode[i].loaded) loads[next] = 1.0, next += unknownsAt(problem, i);
  for (int pass = 0; pass < kPasses; ++pass)
  {
    press(loads);
    for (int unknown = 0; unknown < linear.count(); ++unknown) press(Unknowns::Unit(linear.count(), unknown));
  }
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
  const Vector3d f = mode.slip == Resistance::Slips ? Vector3d(-problem.law[0]->friction * load * mode.slip_direction)
                                                    : Vector3d(-slipRate(at, motion) / (1.0 + 1.0 / problem.k));
  motion.a += f;
  motion.b -= at.n.cross(f) / problem.k;
  return true;
}

bool onlySticks(const SupportMode& mode)
{
  return mode.loaded && mode.slip == Resistance::Holds && mode.roll == Resistance::None &&
         mode.spin == Resistance::None;
}

// Two supports that stick, as in a groove, leave the ball the turning about the axis through both contacts. With w the
// acceleration that each wants of its point, a - b x n = w at both; what is left follows from d'Alembert's principle: contact
// forces do no work on a turning (d x n, d) about that axis.
bool onTwoThatStick(const ContactProblem& problem, BallAcceleration& motion)
{
  if (problem.count != 2 || !onlySticks(problem.mode[0]) || !onlySticks(problem.mode[1])) return false;
  const SupportPoint &one = problem.at[0], &other = problem.at[1];
  const Vector3d between = one.n - other.n;
  const double distance = between.norm();
  if (distance < kFarApart) return false;
  const Vector3d w = one.least * one.n - one.slip_bias;
  const Vector3d difference = other.least * other.n - other.slip_bias - w;
  if (std::abs(difference.dot(between)) > kAllMet * scaleOf(problem)) return false;
  const Vector3d d = between / distance, turning = d.cross(one.n);
  const Vector3d b_across = d.cross(difference) / distance;
  const Vector3d a_across = w + b_across.cross(one.n);
  const double along = (problem.k * problem.free.b.dot(d) - (a_across - problem.free.a).dot(turning)) /
                       (turning.squaredNorm() + problem.k);
  motion.a = a_across + along * turning;
  motion.b = b_across + along * d;
  return true;
}
}  // namespace

bool allHold(const ContactProblem& problem, const SupportForces& near, bool squeezed, BallAcceleration& motion,
             SupportForces& forces)
{
  LinearProblem linear(problem);
  if (linear.count() == 0) return false;
  linear.solve(problem, near);
  const double scale = scaleOf(problem), slack = kContactRounding * scale;
  if (linear.missed > kAllMet * scale || !(squeezed || pressesOnAll(problem, linear.forces, slack))) return false;
  if (linear.redundant) pressWithinLimits(problem, slack, 10.0 * scale, linear);
  if (marginOf(problem, linear.forces) <= slack) return false;
  motion = linear.equations.motion(problem, linear.forces);
  if (!respectsOthers(problem, motion, slack)) return false;
  forces = forcesOf(problem, linear.forces);
  return true;
}

BallAcceleration accelerationInModes(const ContactProblem& problem, const SupportForces& near)
{
  BallAcceleration motion;
  if (onOne(problem, motion) || onTwoThatStick(problem, motion)) return motion;
  LinearProblem linear(problem);
  if (linear.count() == 0) return problem.free;
  linear.solve(problem, near);
  return linear.equations.motion(problem, linear.forces);
}
}  // namespace ping_pong
