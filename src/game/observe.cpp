#include "game/observe.h"

#include "game/net_touch.h"

namespace ping_pong::game
{
namespace
{
bool differ(const Pose& a, const Pose& b)
{
  constexpr double kMoved = 1e-9;  // [m], and of a quaternion's parts
  return (a.p - b.p).norm() > kMoved || (a.q.coeffs() - b.q.coeffs()).norm() > kMoved;
}

void lookAtTable(const World& world, Umpire& umpire)
{
  const Pose X_WB = world.bodyPose(umpire.court().table);
  if (differ(umpire.court().X_WB, X_WB)) umpire.tableMoved(world.time(), X_WB);
}

void lookAtRackets(const World& world, Umpire& umpire)
{
  for (const End end : {End::Minus, End::Plus})
    if (inPlay(umpire.phase()) && racketTouchesNet(world, umpire.court(), end))
      umpire.racketTouchedNet(world.time(), end);
}

void lookAtBall(const World& world, Umpire& umpire)
{
  if (!inPlay(umpire.phase())) return umpire.clock(world.time());  // a ball in the hand may not be in the world yet
  const BallId ball = *umpire.ball();
  const std::size_t found = world.findBall(ball);
  if (found == kNone)
    umpire.let(world.time(), "ball " + std::to_string(ball) + " is gone");
  else
    umpire.ballAt(world.time(), world.ballState(found));
}
}  // namespace

void observe(const World& world, Umpire& umpire)
{
  for (const Contact& contact : world.contacts()) umpire.contact(contact);
  lookAtTable(world, umpire);
  lookAtRackets(world, umpire);
  lookAtBall(world, umpire);
}
}  // namespace ping_pong::game
