#include "resting/at_once.h"

#include <algorithm>

namespace ping_pong
{
bool any(const Grips& grips)
{
  return std::any_of(grips.begin(), grips.end(), [](const Grip& grip) { return grip.slip || grip.roll || grip.spin; });
}

Grips allThatIsRough(const ConstrainedBall& constrained)
{
  Grips grips;
  for (std::size_t i = 0; i < constrained.count; ++i) grips[i].slip = constrained.surface[i].law->friction > 0.0;
  return grips;
}

namespace
{
// Rounds fall by a constant factor each, the nearer to 1 the more parallel two normals are; rubbing may also jam the ball, which
// shows as rounds that do not end.
constexpr int kGripRounds = 1000;
constexpr int kRubbingRounds = 200;

// One round over all supports; returns the largest change of a speed.
double gripRound(const ConstrainedBall& constrained, const Grips& grips, const ContactProblem* modes, double t,
                 BallMotion& ball)
{
  double change = 0.0;
  for (std::size_t i = 0; i < constrained.count; ++i)
  {
    SupportPoint at = supportPoint(constrained.surface[i], ball, constrained.radius, t);
    const double push = -(grips[i].contact ? at.rate : std::min(at.rate, 0.0));
    Vector3d f = Vector3d::Zero();
    if (grips[i].slip)
      f = -at.slip / (1.0 + 1.0 / constrained.k);
    else if (modes && modes->mode[i].slip == Resistance::Slips)
      f = -push * constrained.surface[i].law->friction * modes->mode[i].slip_direction;
    ball.v += f + push * at.n;
    ball.s -= at.n.cross(f) / constrained.k;
    change = std::max({change, f.norm(), grips[i].contact ? std::abs(push) : 0.0});
    if (!grips[i].roll && !grips[i].spin) continue;
    at = supportPoint(constrained.surface[i], ball, constrained.radius, t);
    const Vector3d turn =
        (grips[i].roll ? at.roll : Vector3d(Vector3d::Zero())) + (grips[i].spin ? at.spin : 0.0) * at.n;
    ball.s -= turn;
    change = std::max(change, turn.norm());
  }
  return change;
}

bool gripIn(int rounds, const ConstrainedBall& constrained, const Grips& grips, const ContactProblem* modes, double t,
            BallMotion& ball)
{
  const double none = 1e-3 * noSpeed(ball), most = 1e3 * (1.0 + ball.v.norm() + ball.s.norm());
  for (int round = 0; round < rounds; ++round)
  {
    const double change = gripRound(constrained, grips, modes, t, ball);
    if (change <= none) return true;
    if (!(change < most)) return false;
  }
  return false;
}
}  // namespace

void gripAtOnce(const ConstrainedBall& constrained, const Grips& grips, const ContactProblem* modes, double t,
                BallMotion& ball)
{
  if (!any(grips)) return;
  BallMotion gripped = ball;
  // What goes on slipping rubs as much more as its contact is pressed more; where that jams the ball it is left out.
  if (!modes || !gripIn(kRubbingRounds, constrained, grips, modes, t, gripped))
  {
    gripped = ball;
    gripIn(kGripRounds, constrained, grips, nullptr, t, gripped);
  }
  ball = gripped;
}

bool strikeAll(const ConstrainedBall& constrained, double t, BallMotion& ball, SupportForces& impulses)
{
  ContactProblem problem;
  problem.count = constrained.count;
  problem.k = constrained.k;
  problem.free = {ball.v, ball.s};
  for (std::size_t i = 0; i < constrained.count; ++i)
  {
    problem.law[i] = constrained.surface[i].law;
    SupportPoint& at = problem.at[i] = supportPoint(constrained.surface[i], ball, constrained.radius, t);
    at.least = at.n.dot(ball.v) - at.rate;
    at.slip_bias = at.slip - tangential(ball.v, at.n) + ball.s.cross(at.n);
    if (problem.law[i]->friction > 0.0) problem.mode[i].slip = Resistance::Holds;
  }
  BallAcceleration after;
  if (!findForces(problem, after, impulses)) return false;
  ball.v = after.a;
  ball.s = after.b;
  return true;
}
}  // namespace ping_pong
