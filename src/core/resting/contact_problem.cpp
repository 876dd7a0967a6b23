#include "resting/contact_problem.h"

#include <cmath>
#include <limits>

#include "base/law_counter.h"
#include "resting/constrained_forces.h"
#include "resting/contact_newton.h"

namespace ping_pong
{
namespace
{
constexpr int kMaxIterations = 400;  // Newton takes over before, where they converge slowly
constexpr int kPatience = 100;       // iterations, before it is asked whether supports press on each other
constexpr int kSlowIterations = 20;  // with so many left to do, Newton's method is tried
constexpr double kConverged =
    4e-15;  // change of a force in an iteration, as a part of the scale of accelerations and forces
constexpr double kGoodEnough = 1e-4;  // where iterations converge slowly; where there is no end they grow

Vector3d limited(const Vector3d& f, double most)
{
  const double norm = f.norm();
  return norm > most ? Vector3d(most / norm * f) : f;
}

// The state of one solution under way.
struct PicardIteration
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
      f = limited(force.friction - slipRate(at, motion) / (1.0 + 1.0 / problem.k), limit);
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
                                : limited(force.roll - tangential(motion.b, at.n) - at.roll_bias, limit);
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

  void iteration()
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

ContactProblem withLoads(ContactProblem problem, const SupportForces* forces, double slack)
{
  for (std::size_t i = 0; i < problem.count; ++i) problem.mode[i].loaded = !forces || (*forces)[i].load > slack;
  return problem;
}

Resistance kindOf(double force, double limit, double rate, double slack)
{
  return force < kInsideLimit * limit || rate <= slack ? Resistance::Holds : Resistance::Slips;
}
}  // namespace

double frictionLimit(const Surface& law, double load)
{
  return load > 0.0 ? law.friction * load : 0.0;
}

double rollLimit(const Surface& law, double k, double load)
{
  return load > 0.0 ? (1.0 + k) / k * law.rolling_resistance * load : 0.0;
}

double spinLimit(const Surface& law, double k, double load)
{
  return load > 0.0 ? law.spin_friction / k * load : 0.0;
}

double scaleOf(const ContactProblem& problem)
{
  double scale = problem.free.a.norm() + problem.free.b.norm();
  for (std::size_t i = 0; i < problem.count; ++i)
    scale = std::max({scale, std::abs(problem.at[i].least), problem.at[i].slip_bias.norm(),
                      problem.at[i].roll_bias.norm(), std::abs(problem.at[i].spin_bias)});
  return scale;
}

namespace
{
// A smooth surface alone, the commonest of all.
bool onOneSmooth(const ContactProblem& problem, BallAcceleration& motion, SupportForces& forces)
{
  if (problem.count != 1 || problem.mode[0].slip != Resistance::None) return false;
  const SupportPoint& at = problem.at[0];
  motion = problem.free;
  forces[0] = SupportForce();
  forces[0].load = std::max(0.0, at.least - at.n.dot(motion.a));
  motion.a += forces[0].load * at.n;
  return true;
}
}  // namespace

bool findForces(const ContactProblem& problem, BallAcceleration& motion, SupportForces& forces)
{
  if (onOneSmooth(problem, motion, forces)) return true;
  for (std::size_t i = 0; i < problem.count; ++i)
    if (problem.mode[i].slip != Resistance::None) count(Law::Friction);
  if (allHold(withLoads(problem, nullptr, 0.0), SupportForces(), false, motion, forces)) return true;
  const double scale = scaleOf(problem);
  motion = problem.free;
  for (std::size_t i = 0; i < problem.count; ++i) forces[i] = SupportForce();
  PicardIteration picard{problem, motion, forces};
  for (int i = 0; i < kMaxIterations; ++i)
  {
    picard.iteration();
    if (picard.change <= kConverged * (scale + picard.largest)) return true;
    if ((i == 20 || i == 100) && polishForces(problem, motion, forces)) return true;
    // Iterations that come to the border of what can be held do so without end.
    if (i == kPatience &&
        allHold(withLoads(problem, &forces, kContactRounding * scale), SupportForces(), true, motion, forces))
      return true;
    if (!(picard.change < 1e9 * scale)) return false;
  }
  return picard.change <= kGoodEnough * scale;
}

std::array<SupportMode, kMaxSupports> modesOf(const ContactProblem& problem, const BallAcceleration& motion,
                                              const SupportForces& forces)
{
  std::array<SupportMode, kMaxSupports> modes = problem.mode;
  const double slack = kContactRounding * scaleOf(problem);
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
      mode.slip = kindOf(force.friction.norm(), frictionLimit(law, force.load), slipRate(at, motion).norm(), slack);
      if (mode.slip == Resistance::Slips) mode.slip_direction = -force.friction.normalized();
    }
    if (mode.roll == Resistance::Holds)
    {
      mode.roll = kindOf(force.roll.norm(), rollLimit(law, problem.k, force.load), rollRate(at, motion).norm(), slack);
      if (mode.roll == Resistance::Slips) mode.roll_direction = -force.roll.normalized();
    }
    if (mode.spin == Resistance::Holds)
    {
      mode.spin =
          kindOf(std::abs(force.spin), spinLimit(law, problem.k, force.load), std::abs(spinRate(at, motion)), slack);
      mode.spin_direction = -std::copysign(1.0, force.spin);
    }
  }
  return modes;
}
}  // namespace ping_pong
