#include "assistance.h"

#include <algorithm>
#include <cmath>

namespace ping_pong
{
namespace
{
constexpr double kGravity = 9.81;       ///< [m/s^2]
constexpr double kRadius = 0.02;        ///< of a ball [m]
constexpr double kHalf = 1.37;          ///< length of one half of the table [m]
constexpr double kTableBounce = 0.87;   ///< part of the normal speed that a bounce leaves
constexpr double kTableGrip = 0.8;      ///< part of the speed along the table that it leaves
constexpr double kRubberBounce = 0.78;  ///< part of the normal speed that the blade gives back
constexpr double kFlightTime = 0.5;     ///< of a return, to the middle of the other half [s]
constexpr double kLowest = -0.3;        ///< below this nobody reaches a ball [m]
constexpr double kSteepest = 1.0;       ///< of the blade's normal against x [rad]
const Eigen::Vector3d kTarget(1.55 * kHalf, 0.0, kRadius);
const Eigen::Vector3d kServe(5.0, 0.0, -1.0);  ///< of the ball, so that it bounces on both halves [m/s]
constexpr double kLowServe = 0.10;             ///< a thrown ball is met at the hand's height, but not below this [m]
constexpr double kHighServe = 0.35;            ///< nor above this [m]
constexpr double kBlade = 0.03;                ///< from the blade's centre to that of a ball that touches it [m]
const Eigen::Vector3d kBody(0.0, 0.0, -0.45);  ///< where the forearm comes from, seen from the net [m]

struct Meeting
{
  Eigen::Vector3d p, v;
  double in;  ///< [s]
};

void fly(Meeting& ball, double t)
{
  ball.p += t * ball.v + 0.5 * t * t * Eigen::Vector3d(0, 0, -kGravity);
  ball.v.z() -= kGravity * t;
  ball.in += t;
}

// When the parabola next comes down to the table's surface.
double timeToTable(const Meeting& ball)
{
  const double height = std::max(ball.p.z() - kRadius, 0.0);
  return (ball.v.z() + std::sqrt(ball.v.z() * ball.v.z() + 2.0 * kGravity * height)) / kGravity;
}

// The ball at the plane x = depth: after its bounce, if it still has one before it.
std::optional<Meeting> meet(const BallSight& sight, double depth)
{
  Meeting ball{sight.p, sight.v, 0.0};
  if (ball.v.x() > -0.5 || ball.p.x() < depth) return std::nullopt;
  const double down = timeToTable(ball);
  const double x = ball.p.x() + down * ball.v.x();
  if (ball.p.z() > 0.0 && x > std::max(0.0, depth))
  {
    if (x > kHalf) return std::nullopt;  // its bounce here is not the next
    fly(ball, down);
    ball.v = Eigen::Vector3d(kTableGrip * ball.v.x(), kTableGrip * ball.v.y(), -kTableBounce * ball.v.z());
  }
  fly(ball, (depth - ball.p.x()) / ball.v.x());
  if (ball.p.z() < kLowest) return std::nullopt;
  return ball;
}
// A ball thrown up at this end, to be served, on its way down.
std::optional<Meeting> thrown(const BallSight& sight, double hand_height)
{
  const bool at_hand = sight.p.x() < 0.1 && sight.p.x() > -0.8 && sight.v.head<2>().norm() < 0.8;
  const double height = sight.p.z() - std::clamp(hand_height, kLowServe, kHighServe);
  if (!at_hand || height < 0.0) return std::nullopt;
  Meeting ball{sight.p, sight.v, 0.0};
  fly(ball, (sight.v.z() + std::sqrt(sight.v.z() * sight.v.z() + 2.0 * kGravity * height)) / kGravity);
  return ball;
}

Eigen::Vector3d returnOf(const Meeting& ball)
{
  Eigen::Vector3d out = (kTarget - ball.p) / kFlightTime;
  out.z() += 0.5 * kGravity * kFlightTime;
  return out;
}
}  // namespace

Eigen::Quaterniond heldAt(const Eigen::Vector3d& p, const Eigen::Vector3d& normal)
{
  Eigen::Vector3d tip = p - kBody;
  tip.x() = 0.0;
  tip -= tip.dot(normal) * normal;
  if (tip.norm() < 1e-3) tip = normal.unitOrthogonal();
  Eigen::Matrix3d axes;
  axes.col(0) = normal.normalized();
  axes.col(2) = tip.normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return Eigen::Quaterniond(axes);
}

std::optional<Help> mirrorHelp(const BallSight& ball, const Followed& hand)
{
  const std::optional<Meeting> service = thrown(ball, hand.p.z());
  const std::optional<Meeting> here = service ? service : meet(ball, hand.p.x());
  if (!here) return std::nullopt;
  const Eigen::Vector3d out = service ? kServe : returnOf(*here);
  Eigen::Vector3d normal = (out - here->v).normalized();
  const double angle = std::acos(std::clamp(normal.x(), -1.0, 1.0));
  if (angle > kSteepest)
  {
    const Eigen::Vector3d across = Eigen::Vector3d(0.0, normal.y(), normal.z()).normalized();
    normal = std::cos(kSteepest) * Eigen::Vector3d::UnitX() + std::sin(kSteepest) * across;
  }
  Help help;
  help.q = heldAt(hand.p, normal);
  help.depth = service ? here->p.x() - kBlade : hand.p.x();
  help.v = normal * ((out.dot(normal) + kRubberBounce * here->v.dot(normal)) / (1.0 + kRubberBounce));
  help.in = here->in;
  return help;
}
}  // namespace ping_pong
