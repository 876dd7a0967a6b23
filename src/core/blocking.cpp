#include <algorithm>
#include <cmath>
#include <limits>

#include "ping_pong_sim/drive.h"
#include "ping_pong_sim/separation.h"

namespace ping_pong
{
namespace
{
// A paddle nearer than this touches. Thin enough not to be seen, thick enough that a turning paddle takes few steps.
constexpr double kBand = 1e-4;  // [m]
// Overlap (a table was moved onto the paddle) is undone at this rate and no faster than this speed.
constexpr double kPushOutTime = 0.02;   // [s]
constexpr double kPushOutSpeed = 1.0;   // [m/s]
constexpr double kShortest = 1e-5;      // a motion cut shorter than this stops instead [s]
constexpr double kForever = std::numeric_limits<double>::infinity();
constexpr int kMaxLooks = 64;
constexpr int kMaxProjections = 16;

struct Pair
{
  const Shape* mine;
  const Shape* other;
  Pose X_WO;  // of the obstacle
};

// Speed of any point of the body over [0, h] is at most this.
struct SpeedBound
{
  double linear, angular, reach;

  SpeedBound(const std::vector<Shape>& shapes, const BodyMotion& motion, double h)
    : linear(motion.twist.v.norm() + h * motion.a_WB.norm())
    , angular(motion.twist.w.norm() + h * motion.alpha_WB.norm())
    , reach(0.0)
  {
    for (const Shape& shape : shapes) reach = std::max(reach, shape.p_BS.norm() + boundingRadius(shape));
  }
  double rotation() const { return angular * reach; }
};

std::vector<Pair> pairsInReach(const std::vector<Shape>& shapes, const BodyMotion& motion, double h,
                               const std::vector<Obstacle>& obstacles)
{
  const SpeedBound bound(shapes, motion, h);
  const double travel = (bound.linear + bound.rotation()) * h + 2.0 * kBand;
  std::vector<Pair> pairs;
  for (const Shape& mine : shapes)
    for (const Obstacle& obstacle : obstacles)
      for (const Shape& other : *obstacle.shapes)
      {
        const Vector3d p_WM = motion.pose.q * mine.p_BS + motion.pose.p;
        const Vector3d p_OM = obstacle.pose.q.conjugate() * (p_WM - obstacle.pose.p);
        if (proximity(other, p_OM).distance - boundingRadius(mine) < travel)
          pairs.push_back({&mine, &other, obstacle.pose});
      }
  return pairs;
}

// Touching now: takes out of velocity and acceleration what goes into the surface. True if something had to go.
bool bendAway(const Separation& at, double band, BodyMotion& motion)
{
  if (at.gap > band) return false;
  const double wanted = at.gap < 0.0 ? std::min(kPushOutSpeed, -at.gap / kPushOutTime) : 0.0;
  const Vector3d arm = at.p_WC - motion.pose.p;
  const double rate = at.n_W.dot(motion.twist.v + motion.twist.w.cross(arm));
  const double rate_change = at.n_W.dot(motion.a_WB + motion.alpha_WB.cross(arm));
  const bool closing = rate < wanted - 1e-12;
  const bool pressing = rate < wanted + 1e-12 && rate_change < -1e-9;
  if (closing) motion.twist.v += (wanted - rate) * at.n_W;
  if (closing || pressing) motion.a_WB -= std::min(rate_change, 0.0) * at.n_W;
  return closing || pressing;
}

void stop(BodyMotion& motion)
{
  motion.twist = Twist();
  motion.a_WB.setZero();
  motion.alpha_WB.setZero();
}

bool bendAwayFromAll(const std::vector<Pair>& pairs, double band, BodyMotion& motion)
{
  for (int i = 0; i < kMaxProjections; ++i)
  {
    bool bent = false;
    for (const Pair& pair : pairs)
      bent |= bendAway(separation(*pair.mine, motion.pose, *pair.other, pair.X_WO), band, motion);
    if (!bent) return i > 0;
  }
  stop(motion);  // wedged
  return true;
}

// How long after s the gap along this axis stays above what is left of it for now.
double safeFor(const Separation& at, const BodyMotion& motion, double s, double h,
               const SpeedBound& bound)
{
  if (at.gap < 0.0) return kForever;  // the push-out takes care
  const double slack = at.gap > kBand ? at.gap - 0.5 * kBand : 0.5 * at.gap;
  const double closing = -at.n_W.dot(motion.twist.v + s * motion.a_WB);
  const double closing_later = closing - (h - s) * at.n_W.dot(motion.a_WB);
  const double speed = std::max({closing, closing_later, 0.0}) + bound.rotation();
  return speed > 0.0 ? slack / speed : kForever;
}

// Latest time up to which the motion keeps clear.
double clearUntil(const std::vector<Shape>& shapes, const BodyMotion& motion, double h, const std::vector<Pair>& pairs)
{
  const SpeedBound bound(shapes, motion, h);
  double s = 0.0;
  for (int look = 0; look < kMaxLooks && s < h; ++look)
  {
    const Pose now = motion.poseAt(s);
    double step = h - s;
    for (const Pair& pair : pairs)
    {
      const Separation at = separation(*pair.mine, now, *pair.other, pair.X_WO);
      step = std::min(step, safeFor(at, motion, s, h, bound));
    }
    if (s > 0.0 && step < kShortest && step < h - s) return s;
    s += step;
  }
  return std::min(s, h);
}
}  // namespace

BlockedMotion stopAtObstacles(const std::vector<Shape>& shapes, const BodyMotion& motion, double h,
                              const std::vector<Obstacle>& obstacles)
{
  BlockedMotion result{motion, h, false};
  const std::vector<Pair> pairs = pairsInReach(shapes, motion, h, obstacles);
  if (pairs.empty()) return result;
  // A fast paddle just above the band would meet the surface at once: then treat it as touching from a little further.
  for (const double band : {kBand, 4.0 * kBand, 16.0 * kBand})
  {
    result.blocked |= bendAwayFromAll(pairs, band, result.motion);
    result.duration = clearUntil(shapes, result.motion, h, pairs);
    if (result.duration >= h) return result;
    result.blocked = true;
    if (result.duration > kShortest) return result;
  }
  stop(result.motion);
  result.duration = h;
  return result;
}
}  // namespace ping_pong
