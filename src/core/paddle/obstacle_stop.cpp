#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/separating_axis.h"
#include "paddle/paddle_drive.h"

namespace ping_pong
{
namespace
{
// A paddle nearer than this touches. Thin enough not to be seen, thick enough that a turning paddle takes few steps.
constexpr double kBand = 1e-4;  // [m]
// Overlap (a table was moved onto the paddle) is undone at this rate and no faster than this speed, until this gap.
constexpr double kKeepGap = 0.25 * kBand;  // [m]
constexpr double kPushOutTime = 0.02;      // [s]
constexpr double kPushOutSpeed = 1.0;      // [m/s]
constexpr double kSlowest = 1e-12;         // closing slower than this is none [m/s]
constexpr double kShortest = 1e-5;         // a motion cut shorter than this stops instead [s]
constexpr double kForever = std::numeric_limits<double>::infinity();
constexpr int kMaxSamples = 64;  // the motion ends where they end, and goes on with the next one
constexpr int kMaxProjections = 16;

// Speed of any point of the body over [0, h] is at most this.
struct SpeedBound
{
  double linear, angular, reach;

  SpeedBound(const std::vector<Shape>& shapes, const BodyMotion& motion, double h)
      : linear(motion.twist.v.norm() + h * motion.a_WB.norm()),
        angular(motion.twist.w.norm() + h * motion.alpha_WB.norm()),
        reach(0.0)
  {
    for (const Shape& shape : shapes) reach = std::max(reach, shape.p_BS.norm() + boundingRadius(shape));
  }
  double rotation() const { return angular * reach; }
};

void findPairsInReach(const std::vector<Shape>& shapes, const BodyMotion& motion, double h,
                      const std::vector<Obstacle>& obstacles, std::vector<ShapePair>& pairs)
{
  const SpeedBound bound(shapes, motion, h);
  // Bending a motion adds to its speed what its points lose against the surface.
  const double travel = 2.0 * (bound.linear + bound.rotation()) * h + 20.0 * kBand;
  pairs.clear();
  for (const Shape& mine : shapes)
    for (const Obstacle& obstacle : obstacles)
      for (const Shape& other : *obstacle.shapes)
      {
        const Vector3d p_WM = motion.pose.q * mine.p_BS + motion.pose.p;
        const Vector3d p_OM = obstacle.pose.toB(p_WM);
        if (proximity(other, p_OM).distance - boundingRadius(mine) < travel)
          pairs.push_back({&mine, &other, obstacle.pose});
      }
}

// Touching now: takes out of velocity and acceleration what would go into the surface by the end of the motion. True if
// something had to go.
bool bendAway(const Separation& at, double band, double h, BodyMotion& motion)
{
  if (at.gap > band) return false;
  const double wanted = at.gap < kKeepGap ? std::min(kPushOutSpeed, (kKeepGap - at.gap) / kPushOutTime) : 0.0;
  const Vector3d arm = at.p_WC - motion.pose.p;
  const double rate = at.n_W.dot(motion.twist.v + motion.twist.w.cross(arm));
  const double rate_change = at.n_W.dot(motion.a_WB + motion.alpha_WB.cross(arm));
  const double missing = wanted - rate;
  const double missing_at_end = missing - h * rate_change;
  if (missing < kSlowest && missing_at_end < kSlowest) return false;
  if (missing > 0.0) motion.twist.v += missing * at.n_W;
  const double still_missing = missing_at_end - std::max(missing, 0.0);
  if (still_missing > 0.0) motion.a_WB += still_missing / h * at.n_W;
  return true;
}

void stop(BodyMotion& motion)
{
  motion.twist = Twist();
  motion.a_WB.setZero();
  motion.alpha_WB.setZero();
}

bool bendAwayFromAll(const std::vector<ShapePair>& pairs, double band, double h, BodyMotion& motion)
{
  for (int i = 0; i < kMaxProjections; ++i)
  {
    bool bent = false;
    for (const ShapePair& pair : pairs)
      bent |= bendAway(separation(*pair.mine, motion.pose, *pair.other, pair.X_WO), band, h, motion);
    if (!bent) return i > 0;
  }
  stop(motion);  // wedged
  return true;
}

// How long after s the gap along this axis stays above what is left of it for now.
double safeFor(const Separation& at, const BodyMotion& motion, double s, double h, const SpeedBound& bound)
{
  const double slack = at.gap > kBand ? at.gap - 0.5 * kBand : std::max(0.5 * at.gap, 0.0);
  const double closing = -at.n_W.dot(motion.twist.v + s * motion.a_WB);
  const double closing_later = closing - (h - s) * at.n_W.dot(motion.a_WB);
  const double speed = std::max({closing, closing_later, 0.0}) + bound.rotation();
  return speed > 0.0 ? slack / speed : kForever;
}

// Latest time up to which the motion keeps clear.
double clearUntil(const std::vector<Shape>& shapes, const BodyMotion& motion, double h,
                  const std::vector<ShapePair>& pairs)
{
  const SpeedBound bound(shapes, motion, h);
  double s = 0.0;
  for (int sample = 0; sample < kMaxSamples && s < h; ++sample)
  {
    const Pose now = motion.poseAt(s);
    double step = h - s;
    for (const ShapePair& pair : pairs)
    {
      const Separation at = separation(*pair.mine, now, *pair.other, pair.X_WO);
      step = std::min(step, safeFor(at, motion, s, h, bound));
    }
    if (step < kShortest && step < h - s) return s;
    s += step;
  }
  return std::min(s, h);
}
// Bends the motion away from all pairs; true if it is then clear for a time worth moving.
bool bentIsClear(const std::vector<Shape>& shapes, const std::vector<ShapePair>& pairs, double band, double h,
                 BlockedMotion& result)
{
  result.blocked |= bendAwayFromAll(pairs, band, h, result.motion);
  result.duration = clearUntil(shapes, result.motion, h, pairs);
  result.blocked |= result.duration < h;
  return result.duration >= h || result.duration > kShortest;
}
}  // namespace

BlockedMotion stopAtObstacles(const std::vector<Shape>& shapes, const BodyMotion& motion, double h,
                              const std::vector<Obstacle>& obstacles, std::vector<ShapePair>& near)
{
  BlockedMotion result{motion, h, false};
  findPairsInReach(shapes, motion, h, obstacles, near);
  if (near.empty()) return result;
  // A fast paddle just above the band would meet the surface at once: then treat it as touching from a little further.
  // Where a turn drives it in, the turn gives way before the slide.
  for (const double band : {kBand, 4.0 * kBand, 16.0 * kBand})
    if (bentIsClear(shapes, near, band, h, result)) return result;
  result.motion.twist.w.setZero();
  result.motion.alpha_WB.setZero();
  if (bentIsClear(shapes, near, kBand, h, result)) return result;
  stop(result.motion);
  result.duration = h;
  return result;
}
}  // namespace ping_pong
