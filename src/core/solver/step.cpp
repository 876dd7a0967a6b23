// The step of method `impulse`.
#include <algorithm>
#include <cmath>

#include "base/law_counter.h"
#include "evolve/flight.h"
#include "evolve/integrators.h"
#include "solver/slabs.h"
#include "solver/squeezed_in_solver.h"

namespace ping_pong
{
namespace
{
constexpr double kFastest = 1e8;        // [m/s]
constexpr double kNoImpact = 1e-9;      // slower is no impact: without any force [m/s],
constexpr double kImpactInSteps = 2.0;  // and else what gravity adds in so many steps
constexpr std::uint32_t kLastCount =
    1u << 31;  // a step that begins above this counts anew: days of steps, and it must not wrap

void accelerate(WorldWithSolver& world)
{
  Pile& pile = world.pile;
  if (pile.a.empty()) return;
  for (std::size_t i = 0; i < pile.movers.size(); ++i)
  {
    const Mover& mover = pile.movers[i];
    if (mover.asleep) continue;
    pile.a[i] = pile.kinds[mover.kind].model.acceleration(mover.v, pile.w[i]);
    if ((mover.v + pile.h * pile.a[i]).norm() < kFastest) continue;
    pile.a[i].setZero();  // the step is too long for the drag: the ball goes straight on
    world.status.not_finite = true;
  }
}

double reachOf(const Body& body)
{
  double reach = 0.0;
  for (const Shape& shape : body.shapes) reach = std::max(reach, shape.p_BS.norm() + shape.half_size.norm());
  return reach;
}

// Bodies that move are linked with all balls nearby, in every step.
void linkMovingBodies(WorldWithSolver& world)
{
  Pile& pile = world.pile;
  pile.moving.clear();
  for (std::size_t b = 0; b < world.bodies.size(); ++b)
  {
    const BodyRecord& body = world.bodies[b];
    if (!body.moving) continue;
    const BodyFrame frame = frameAt(body.motion, pile.start - body.motion.start);
    const double size = reachOf(body.body);
    const double way = pile.h * (frame.v_WB.norm() + frame.w_WB.norm() * size + 0.5 * pile.h * frame.a_WB.norm());
    for (std::uint32_t i = 0; i < pile.movers.size(); ++i)
    {
      const double near = size + pile.radius(i) + way + pile.h * pile.movers[i].v.norm() + pile.margin;
      if ((pile.movers[i].p - frame.p_WB).squaredNorm() > near * near) continue;
      for (std::size_t s = 0; s < body.body.shapes.size(); ++s)
        pile.moving.push_back({i, Pile::kEndOfChain, static_cast<std::uint16_t>(b), static_cast<std::uint16_t>(s)});
    }
  }
}

void turn(Pile& pile, std::size_t i)
{
  Mover& mover = pile.movers[i];
  Vector3d& w = pile.w[i];
  const double left = pile.h - mover.clock;
  mover.clock = 0.0;
  mover.impacts = 0;
  if (w.isZero(0.0)) return;
  const double decay = pile.kinds[mover.kind].model.spinDecay();
  pile.turn[i] += decay > 0.0 ? turnIn(w, decay, left) : Vector3d(left * w);
  if (decay > 0.0) w *= std::exp(-decay * pile.h);
}

// The rest of the forces acts where nothing carries the ball: velocity Verlet in free flight.
void endStep(Pile& pile, PileShare& share)
{
  for (const std::uint32_t i : share.awake)
  {
    Mover& mover = pile.movers[i];
    const Vector3d p = pile.movers[i].p + pile.h * mover.v;
    Vector3d v = mover.v;
    mover.loaded = (pile.pushed[i] & Pile::kCarried) != 0;
    mover.half_owed = !mover.was_loaded && mover.loaded;
    if (!mover.was_loaded && !mover.loaded)
    {
      const Vector3d predicted = v + (0.5 * pile.h) * pile.flightAcceleration(i);
      v += (0.5 * pile.h) * (pile.a.empty() ? pile.flightAcceleration(i)
                                            : pile.kinds[mover.kind].model.acceleration(predicted, pile.w[i]));
    }
    if (!(v.squaredNorm() < kFastest * kFastest) || !p.allFinite())  // the ball keeps its last finite state
    {
      share.not_finite = true;
      mover.clock = 0.0;
      mover.impacts = 0;
      continue;
    }
    pile.movers[i].p = p;
    mover.v = v;
    mover.calm = mover.loaded && v.squaredNorm() < 0.25 * pile.least_impact * pile.least_impact;
    turn(pile, i);
    if (pile.pushed[i] & Pile::kTouched) pile.untouched[i] = 0.0f;
    pile.untouched[i] += static_cast<float>(pile.h);
    const Eigen::Vector3f way = (p - pile.home[i]).cast<float>();
    const bool there = (way - pile.anchor[i]).squaredNorm() < kPlace * kPlace;
    pile.still[i] = there ? pile.still[i] + static_cast<float>(pile.h) : 0.0f;
    if (!there) pile.anchor[i] = way;
  }
}

// Impulses of the last step are a guide for one of another length in its proportion.
void setLength(Pile& pile, double h)
{
  if (pile.h == h) return;
  const float ratio = pile.h > 0.0 ? static_cast<float>(h / pile.h) : 0.0f;
  for (Lanes& push : pile.pushes) push *= ratio;
  for (BodyLink& link : pile.bodies) link.push *= ratio;
  pile.h = h;
}

// What was noted on the counter is long ago. Between steps nobody asks for more.
void restartCounter(Pile& pile)
{
  pile.counter = 1;
  for (Mover& mover : pile.movers) mover.stamp = 0;
  std::fill(pile.swept.begin(), pile.swept.end(), 0u);
  for (PileShare& share : pile.shares) share.changed = 0;
}

void step(WorldWithSolver& world, double start, double end, double h)
{
  Pile& pile = world.pile;
  if (pile.counter > kLastCount) restartCounter(pile);
  setLength(pile, h);
  pile.start = start;
  pile.end = end;
  for (PileShare& share : pile.shares) share.squeezed = 0;
  pile.least_impact = std::max(kNoImpact, kImpactInSteps * world.scene.forces.gravity.norm() * h);
  pile.step_mark = pile.counter + 1;
  accelerate(world);
  linkMovingBodies(world);
  updateLinks(world);
  if (!pile.anyAwake() && pile.moving.empty()) return;
  if (!pile.moving.empty()) keepPlaces(pile);
  resolveImpacts(world);
  solveContacts(world);
  findPressing(pile);
  eachShare(world, [&](PileShare& share) { takeContacts(world, share); });
  if (pile.pressing > 0.0) limitEnergies(pile);
  eachShare(world, [&](PileShare& share) { endStep(pile, share); });
  if (pile.pressing > 0.0) findSqueezed(world);
  settlePile(world);
}
}  // namespace

void takeTurn(Pile& pile, std::size_t slot)
{
  const Vector3d turn = pile.turn[slot];
  if (turn.isZero(0.0)) return;
  Quaterniond& q = pile.q[slot];
  pile.turn[slot].setZero();
  const double x = 0.25 * turn.squaredNorm();  // of half the angle, squared
  if (x > 1e-2)
  {
    q = turned(q, turn, 1.0);
    return;
  }
  count(Law::Orientation);
  // Taylor series: the next terms are below 1e-17.
  const double sine = 1.0 + x * (-1.0 / 6 + x * (1.0 / 120 + x * (-1.0 / 5040 + x * (1.0 / 362880 - x / 39916800))));
  const double cosine = 1.0 + x * (-1.0 / 2 + x * (1.0 / 24 + x * (-1.0 / 720 + x * (1.0 / 40320 - x / 3628800))));
  const Vector3d axis = (0.5 * sine) * turn;
  q = Quaterniond(cosine, axis.x(), axis.y(), axis.z()) * q;
  q.coeffs() *= 1.5 - 0.5 * q.squaredNorm();  // back to length 1
}

void runPile(WorldWithSolver& world, double start, double end, double longest_step)
{
  Pile& pile = world.pile;
  if (pile.ball.empty()) return;
  const double duration = end - start;
  const long steps =
      std::max(1L, std::lround(std::ceil(duration / shortEnough(world, start, end, longest_step) - 1e-9)));
  const double h = duration / static_cast<double>(steps);
  const auto startOf = [&](long i) { return i == steps ? end : start + h * static_cast<double>(i); };
  for (long i = 0; i < steps && !pile.ball.empty(); ++i)
  {
    step(world, startOf(i), startOf(i + 1), h);
    if (i + 1 < steps) takeOutSqueezed(world);
  }
  if (pile.ball.empty()) return;
  updateActive(world);
  eachShare(world,
            [&](PileShare& share)
            {
              for (const std::uint32_t i : share.awake)
              {
                storeBall(world, i, end);
                world.balls[pile.ball[i]].wake();
              }
            });
  takeOutSqueezed(world);  // last: slots of others change
  for (PileShare& share : pile.shares)
  {
    world.status.squeezed += share.squeezed;
    world.status.not_finite |= share.not_finite;
    share.not_finite = false;
  }
}
}  // namespace ping_pong
