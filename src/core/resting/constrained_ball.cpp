#include "resting/constrained_ball.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/law_counter.h"
#include "resting/constrained_forces.h"

namespace ping_pong
{
namespace
{
constexpr double kNoSpeed = 1e-12;    // rounding of speeds near 1 m/s [m/s]
constexpr double kMostStopped = 1e2;  // faster than this times the grip time nothing is stopped within it [m/s^2]
constexpr int kRounds = 4;            // of decisions: each lets something slip that could not be stopped
constexpr double kParts = 1e-8;       // a surface that carries nothing is left at this speed [m/s]

// A resistance before it is known what it can do.
struct Candidate
{
  Resistance kind = Resistance::None;
  bool stops = false;  // moves, but may be stopped within the grip time
};

Candidate candidateOf(bool named, double speed, double none, double grip_time)
{
  if (!named) return {};
  if (speed <= none) return {Resistance::Holds, false};
  if (speed <= kMostStopped * grip_time) return {Resistance::Holds, true};
  return {Resistance::Slips, false};
}

struct Candidates
{
  Candidate slip, roll, spin;
};

Candidates candidatesAt(const Surface& law, const SupportPoint& at, double none, double grip_time)
{
  const bool rough = law.friction > 0.0;
  const bool always =
      law.friction == std::numeric_limits<double>::infinity();  // what a grip has left of slip is rounding
  return {candidateOf(rough, always ? 0.0 : at.slip.norm(), none, grip_time),
          candidateOf(rough && law.rolling_resistance > 0.0, at.roll.norm(), none, grip_time),
          candidateOf(rough && law.spin_friction > 0.0, std::abs(at.spin), none, grip_time)};
}

Vector3d directionOf(const Vector3d& x)
{
  return x.normalized();
}
double directionOf(double x)
{
  return x < 0.0 ? -1.0 : 1.0;
}

// One resistance of one support: where it is found in the problem, and whether it may be stopped.
template <class Value>
struct Channel
{
  Resistance& kind;
  Value& direction;
  Value& bias;
  const Value& value;
  bool stops;

  void begin(const Candidate& candidate, double grip_time)
  {
    kind = candidate.kind;
    stops = candidate.stops;
    if (kind == Resistance::Slips) direction = directionOf(value);
    if (stops) bias += value / grip_time;
  }
  // It moves on: it cannot be stopped.
  bool detachFrom(Resistance found, double grip_time)
  {
    if (!stops || found != Resistance::Slips) return false;
    kind = Resistance::Slips;
    direction = directionOf(value);
    bias -= value / grip_time;
    stops = false;
    return true;
  }
};

Channel<Vector3d> slipOf(ContactProblem& problem, std::size_t i, bool stops)
{
  return {problem.mode[i].slip, problem.mode[i].slip_direction, problem.at[i].slip_bias, problem.at[i].slip, stops};
}
Channel<Vector3d> rollOf(ContactProblem& problem, std::size_t i, bool stops)
{
  return {problem.mode[i].roll, problem.mode[i].roll_direction, problem.at[i].roll_bias, problem.at[i].roll, stops};
}
Channel<double> spinOf(ContactProblem& problem, std::size_t i, bool stops)
{
  return {problem.mode[i].spin, problem.mode[i].spin_direction, problem.at[i].spin_bias, problem.at[i].spin, stops};
}

Grips beginModes(ContactProblem& problem, double none, double grip_time)
{
  Grips stops;
  for (std::size_t i = 0; i < problem.count; ++i)
  {
    const Candidates candidates = candidatesAt(*problem.law[i], problem.at[i], none, grip_time);
    slipOf(problem, i, false).begin(candidates.slip, grip_time);
    rollOf(problem, i, false).begin(candidates.roll, grip_time);
    spinOf(problem, i, false).begin(candidates.spin, grip_time);
    stops[i] = {candidates.slip.stops, candidates.roll.stops, candidates.spin.stops, false};
  }
  return stops;
}

// Lets go of what could not be stopped; true if there was any.
bool detachFrom(ContactProblem& problem, const std::array<SupportMode, kMaxSupports>& found, Grips& stops,
                double grip_time)
{
  bool any = false;
  for (std::size_t i = 0; i < problem.count; ++i)
  {
    auto slip = slipOf(problem, i, stops[i].slip);
    any |= slip.detachFrom(found[i].slip, grip_time);
    auto roll = rollOf(problem, i, stops[i].roll);
    any |= roll.detachFrom(found[i].roll, grip_time);
    auto spin = spinOf(problem, i, stops[i].spin);
    any |= spin.detachFrom(found[i].spin, grip_time);
    stops[i] = {slip.stops, roll.stops, spin.stops, false};
  }
  return any;
}

// What holds, if any of it has to be stopped first: the rest must go on to hold while that is done.
Grips heldIfAnyStops(const ContactProblem& problem, const Grips& stops)
{
  Grips constrained;
  bool any = false;
  for (std::size_t i = 0; i < problem.count; ++i)
  {
    const SupportMode& mode = problem.mode[i];
    if (!mode.loaded) continue;
    constrained[i] = {mode.slip == Resistance::Holds, mode.roll == Resistance::Holds, mode.spin == Resistance::Holds,
                      true};
    any |= stops[i].slip || stops[i].roll || stops[i].spin;
  }
  return any ? constrained : Grips();
}

void countResistances(const ContactProblem& problem)
{
  for (std::size_t i = 0; i < problem.count; ++i)
  {
    if (problem.mode[i].roll != Resistance::None) count(Law::RollingResistance);
    if (problem.mode[i].spin != Resistance::None) count(Law::SpinFriction);
  }
}

// A resistance that slips is used up after this time, at its present rate.
double usedUpAfter(double speed, double rate)
{
  return rate < 0.0 ? -speed / rate : kNever;
}
}  // namespace

ConstrainedBall constrainedBall(const WorldState& world, const BallRecord& ball, const Vector3d& p_WB, double t)
{
  ConstrainedBall constrained{ball.model(), ball.params().radius, ball.params().inertia, ball.supports.count(), {}};
  for (std::size_t i = 0; i < constrained.count; ++i)
  {
    const Supports::Surface& support = ball.supports[i];
    const BodyRecord& body = world.bodies[support.body];
    SupportSurface& surface = constrained.surface[i];
    surface.shape = &body.shapes()[support.shape];
    surface.law = &world.surface(ball, *surface.shape);
    surface.motion = &body.frame();
    surface.still = !body.moving;
    surface.turning = body.moving && body.motion.turning();
    surface.feature = featureAt(*surface.shape, body.seenFrom(p_WB, t));
    surface.flat = flat(*surface.shape, surface.feature);
  }
  return constrained;
}

BallMotion motionOf(const BallState& state, double radius)
{
  return {state.p_WB, state.v_WB, radius * state.w_WB};
}

ContactProblem problemAt(const ConstrainedBall& constrained, const BallMotion& ball, double t)
{
  ContactProblem problem;
  problem.count = constrained.count;
  problem.k = constrained.k;
  problem.free.a = constrained.model.acceleration(ball.v, ball.s / constrained.radius);
  problem.free.b = -constrained.model.spinDecay() * ball.s;
  for (std::size_t i = 0; i < constrained.count; ++i)
  {
    problem.law[i] = constrained.surface[i].law;
    problem.at[i] = supportPoint(constrained.surface[i], ball, constrained.radius, t);
  }
  return problem;
}

bool movesSlowly(const ContactProblem& problem, const BallMotion& ball, double grip_time)
{
  for (std::size_t i = 0; i < problem.count; ++i)
  {
    const Candidates candidates = candidatesAt(*problem.law[i], problem.at[i], noSpeed(ball), grip_time);
    if (candidates.slip.stops || candidates.roll.stops || candidates.spin.stops) return true;
  }
  return false;
}

Decision decide(const ConstrainedBall& constrained, const BallMotion& ball, double t, double grip_time)
{
  Decision decision{problemAt(constrained, ball, t), {}, {}, {}};
  ContactProblem& problem = decision.problem;
  Grips stops = beginModes(problem, noSpeed(ball), grip_time);
  countResistances(problem);
  for (int round = 0; round < kRounds; ++round)
  {
    decision.answered = findForces(problem, decision.motion, decision.forces);
    const std::array<SupportMode, kMaxSupports> found = modesOf(problem, decision.motion, decision.forces);
    if (detachFrom(problem, found, stops, grip_time)) continue;
    problem.mode = found;
    break;
  }
  decision.stops = heldIfAnyStops(problem, stops);
  return decision;
}

bool modesHold(const ConstrainedBall& constrained, const Decision& decided, const BallMotion& ball, double t)
{
  ContactProblem problem = problemAt(constrained, ball, t);
  for (std::size_t i = 0; i < constrained.count; ++i)
  {
    // What carries no load may carry one now.
    SupportMode& mode = problem.mode[i];
    mode = decided.problem.mode[i];
    if (!mode.loaded && constrained.surface[i].law->friction > 0.0) mode.slip = Resistance::Holds;
    const SupportPoint& at = problem.at[i];
    if (!mode.loaded && at.rate > kParts) return false;
    if (mode.slip == Resistance::Slips && at.slip.norm() > noSpeed(ball)) mode.slip_direction = at.slip.normalized();
    if (mode.roll == Resistance::Slips && at.roll.norm() > noSpeed(ball)) mode.roll_direction = at.roll.normalized();
    if (mode.spin == Resistance::Slips && mode.spin_direction * at.spin < -noSpeed(ball)) return false;  // turned round
  }
  BallAcceleration motion;
  SupportForces forces;
  // Where supports hold each other there are many answers: the modes hold as long as one of these has them.
  if (allHold(problem, decided.forces, true, motion, forces)) return true;
  if (!findForces(problem, motion, forces)) return false;
  const std::array<SupportMode, kMaxSupports> found = modesOf(problem, motion, forces);
  for (std::size_t i = 0; i < constrained.count; ++i)
    if (!found[i].sameAs(decided.problem.mode[i])) return false;
  return true;
}

double slipsFor(const Decision& decision)
{
  const ContactProblem& problem = decision.problem;
  const BallAcceleration& motion = decision.motion;
  double first = kNever;
  for (std::size_t i = 0; i < problem.count; ++i)
  {
    const SupportPoint& at = problem.at[i];
    const SupportMode& mode = problem.mode[i];
    if (mode.slip == Resistance::Slips)
      first = std::min(first, usedUpAfter(at.slip.norm(), mode.slip_direction.dot(slipRate(at, motion))));
    if (mode.roll == Resistance::Slips)
      first = std::min(first, usedUpAfter(at.roll.norm(), mode.roll_direction.dot(rollRate(at, motion))));
    if (mode.spin == Resistance::Slips)
      first = std::min(first, usedUpAfter(std::abs(at.spin), mode.spin_direction * spinRate(at, motion)));
  }
  return first;
}

Grips allThatAlwaysGrips(const Decision& decision, const BallMotion& ball)
{
  const ContactProblem& problem = decision.problem;
  Grips slipping;
  for (std::size_t i = 0; i < problem.count; ++i)
  {
    const bool always = problem.law[i]->friction == std::numeric_limits<double>::infinity();
    slipping[i].slip = problem.mode[i].loaded && always && problem.at[i].slip.norm() > noSpeed(ball);
  }
  return heldIfAnyStops(problem, slipping);
}

double noSpeed(const BallMotion& ball)
{
  return kNoSpeed * (1.0 + ball.v.norm() + ball.s.norm());
}
}  // namespace ping_pong
