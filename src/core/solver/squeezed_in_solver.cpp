#include "solver/squeezed_in_solver.h"

#include <algorithm>
#include <cmath>

#include "solver/seams.h"
#include "state/free_space.h"
#include "state/squeeze.h"

namespace ping_pong
{
namespace
{
constexpr double kPartOfRadius = 0.25;  // way of a body in a step, of the radius of a ball near it;
constexpr double kMostPieces = 64.0;    // but no more steps than this instead of one
constexpr double kOneContact =
    1e-3;  // hits sooner after each other are one: a contact of a real ball lasts as long [s]
constexpr double kFlees =
    8.0;  // times the speed of a body: two surfaces press no ball out faster. Planes tilted by 1 / 8
constexpr double kElastic = 2.0;  // the same for balls that others press on: what an elastic hit by the body gives
constexpr double kDeep = 1e-4;    // overlap that there is no room for [m],
constexpr double kPartOfWay =
    0.5;  // and this part of the way of the body, where an iteration that was cut short may leave it

double sizeOf(const Body& body)
{
  double size = 0.0;
  for (const Shape& shape : body.shapes) size = std::max(size, shape.p_BS.norm() + shape.half_size.norm());
  return size;
}

// The least radius of balls that a body may come near until `end`; infinite if there are none.
double leastRadiusNear(const Pile& pile, const Vector3d& p_WB, double reach, double duration)
{
  double least = kNever;
  for (std::size_t i = 0; i < pile.movers.size(); ++i)
  {
    const double radius = pile.radius(i), near = reach + radius + duration * pile.movers[i].v.norm();
    if ((pile.movers[i].p - p_WB).squaredNorm() < near * near) least = std::min(least, radius);
  }
  return least;
}

const BodyLink& linkOf(const Pile& pile, const BodyTouch& touch)
{
  return touch.moving ? pile.moving[touch.link] : pile.bodies[touch.link];
}

// Twice a kinetic energy by the mass, that of the spin with it [m^2/s^2].
double energyOf(const BallParams& ball, const Vector3d& v, const Vector3d& w)
{
  return v.squaredNorm() + ball.inertia * ball.radius * ball.radius * w.squaredNorm();
}

// What contacts have added to the energy of a ball beyond what a body that presses accounts for; negative if they have taken some.
double excessOf(const Pile& pile, std::size_t i)
{
  const BallParams& ball = pile.params(i);
  const Change& change = pile.changes[i];
  const Vector3d &v = pile.movers[i].v, &w = pile.w[i];
  const Vector3d v_before = v - change.v.head<3>().cast<double>();
  const Vector3d w_before = w - change.rim.head<3>().cast<double>() / ball.radius;
  const double now = energyOf(ball, v, w), before = energyOf(ball, v_before, w_before);
  if (now <= before) return now - before;
  const double of_body = ((pile.pushed[i] & Pile::kTouched) != 0 ? kElastic : kFlees) * pile.pressing;
  return std::max(now - std::max(before, of_body * of_body), 0.0);
}

bool presses(const PileShare& share, const BodyTouch& touch)
{
  return share.body_batches[touch.place.batch()].normal[touch.place.lane()] > 0.0f;
}

// Deeper than before and than the contacts of this step may leave it.
bool hasNoRoom(const WorldWithSolver& world, const BodyTouch& touch)
{
  const Pile& pile = world.pile;
  const std::uint32_t i = touch.ball;
  const BodyLink& link = linkOf(pile, touch);
  const double radius = pile.radius(i);
  const double overlap = radius - nearestOf(world, link, pile.movers[i].p, pile.h).distance;
  if (overlap <= kDeep) return false;
  const bool others = (pile.pushed[i] & Pile::kTouched) != 0;
  const double left = others ? kPartOfWay * pile.h * pile.pressing : 0.0;
  return overlap > kDeep + left && overlap > radius - nearestOf(world, link, pile.places[i], 0.0).distance;
}
}  // namespace

double shortEnough(const WorldWithSolver& world, double start, double end, double longest)
{
  const double duration = end - start, most = std::min(longest, duration);
  double least = kNever, h = longest;
  for (const BallKind& kind : world.pile.kinds) least = std::min(least, kind.params.radius);
  for (const BodyRecord& body : world.bodies)
  {
    if (!body.moving) continue;
    const BodyFrame frame = frameAt(body.motion, start - body.motion.start);
    const double size = sizeOf(body.body),
                 speed = frame.v_WB.norm() + frame.w_WB.norm() * size + duration * frame.a_WB.norm();
    if (speed * most <= kPartOfRadius * least) continue;
    const double radius = leastRadiusNear(world.pile, frame.p_WB, size + duration * speed, duration);
    if (radius < kNever) h = std::min(h, std::max(kPartOfRadius * radius / speed, most / kMostPieces));
  }
  return h;
}

void keepPlaces(Pile& pile)
{
  for (std::size_t i = 0; i < pile.movers.size(); ++i) pile.places[i] = pile.movers[i].p;
}

bool takesAlong(Pile& pile, const BodyLink& link, double t)
{
  Throw& last = pile.throws[link.ball];
  const double now = pile.start + t;
  const bool again = (last.other || last.body != link.body) && now - last.time < kOneContact;
  last = {now, link.body, again};
  return again;
}

void limitImpulse(const BallParams& ball, const BallState& before, double speed, BallState& after, Vector3d& impulse)
{
  const double rim = ball.inertia * ball.radius * ball.radius;  // energies are in (m/s)^2
  const auto product = [rim](const Vector3d& v, const Vector3d& w, const Vector3d& v2, const Vector3d& w2)
  { return v.dot(v2) + rim * w.dot(w2); };
  const double had = product(before.v_WB, before.w_WB, before.v_WB, before.w_WB);
  const double room = std::max(speed * speed - had, 0.0);
  const Vector3d dv = after.v_WB - before.v_WB, dw = after.w_WB - before.w_WB;
  const double a = product(dv, dw, dv, dw),
               b = product(before.v_WB, before.w_WB, dv, dw);  // a part of the change adds (a part + 2 b) part
  if (a + 2.0 * b <= room) return;
  const double part = std::clamp((std::sqrt(b * b + a * room) - b) / a, 0.0, 1.0);
  after.v_WB = before.v_WB + part * dv;
  after.w_WB = before.w_WB + part * dw;
  impulse *= part;
}

void noteOther(Pile& pile, std::uint32_t ball)
{
  pile.throws[ball].other = true;
}

void findPressing(Pile& pile)
{
  pile.pressing = 0.0;
  if (pile.moving.empty()) return;
  for (const PileShare& share : pile.shares)
    for (const BodyTouch& touch : share.body_touches)
      if (touch.moving && presses(share, touch)) pile.pressing = std::max(pile.pressing, touch.u.norm());
}

void limitEnergies(Pile& pile)
{
  double lost = 0.0, gained = 0.0;
  for (std::size_t i = 0; i < pile.movers.size(); ++i)
  {
    const double excess = pile.params(i).mass * excessOf(pile, i);
    (excess > 0.0 ? gained : lost) += std::abs(excess);
  }
  if (gained <= lost) return;
  for (std::size_t i = 0; i < pile.movers.size(); ++i)
  {
    const double excess = excessOf(pile, i);
    if (excess <= 0.0) continue;
    Vector3d &v = pile.movers[i].v, &w = pile.w[i];
    const double part = std::sqrt(1.0 - (1.0 - lost / gained) * excess / energyOf(pile.params(i), v, w));
    v *= part;
    w *= part;
  }
}

void findSqueezed(WorldWithSolver& world)
{
  Pile& pile = world.pile;
  for (const PileShare& share : pile.shares)
    for (const BodyTouch& touch : share.body_touches)
      if (hasNoRoom(world, touch)) pile.squeezed.push_back({pile.ball[touch.ball], pile.places[touch.ball]});
  const auto before = [](const SqueezedBall& a, const SqueezedBall& b) { return a.ball < b.ball; };
  const auto same = [](const SqueezedBall& a, const SqueezedBall& b) { return a.ball == b.ball; };
  std::sort(pile.squeezed.begin(), pile.squeezed.end(), before);
  pile.squeezed.erase(std::unique(pile.squeezed.begin(), pile.squeezed.end(), same), pile.squeezed.end());
}

void takeOutSqueezed(WorldWithSolver& world)
{
  Pile& pile = world.pile;
  for (const SqueezedBall& ball : pile.squeezed)
  {
    BallRecord& record = world.balls[ball.ball];
    storeBall(world, slotOf(pile, ball.ball), pile.end);
    dropFromPile(pile, ball.ball);
    BallState state = record.stateAt(pile.end);
    state.p_WB = ball.p_WB;
    state.w_WB.setZero();
    pushOutOfStill(world, state.p_WB, record.params().radius);
    squeeze(world, record, state, pile.end);
  }
  pile.squeezed.clear();
}
}  // namespace ping_pong
