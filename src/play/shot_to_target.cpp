#include "shot_to_target.h"

#include <Eigen/LU>
#include <cmath>

namespace ping_pong::play
{
namespace
{
constexpr int kMaxSteps = 16;         // of Broyden's method; it takes 4 to 7
constexpr int kMaxLonger = 12;        // tries with a longer flight
constexpr int kMaxFailures = 2;       // of them without a solution
constexpr double kLonger = 1.08;      // each by so much
constexpr double kGood = 1e-6;        // residual [m], and time by kTimeScale
constexpr double kTimeScale = 1.0;    // what a second of flight time counts as [m/s]
constexpr double kProbe = 1e-3;       // for the first Jacobian [m/s]
constexpr double kLongestStep = 4.0;  // of the velocity in one step [m/s]

/// Residual of a velocity; nothing where there is no landing to compare with.
using Residual = std::function<std::optional<Vector3d>(const Vector3d& v)>;

// Inverse Jacobian by differences; false if the residual is not there or it is singular.
bool probe(const Residual& residual, const Vector3d& v, const Vector3d& at_v, Matrix3d& inverse)
{
  Matrix3d jacobian;
  for (int i = 0; i < 3; ++i)
  {
    const std::optional<Vector3d> beside = residual(v + kProbe * Vector3d::Unit(i));
    if (!beside) return false;
    jacobian.col(i) = (*beside - at_v) / kProbe;
  }
  bool invertible = false;
  jacobian.computeInverseWithCheck(inverse, invertible);
  return invertible;
}

// Half as far until there is a landing at all.
std::optional<Vector3d> backtrack(const Residual& residual, const Vector3d& from, Vector3d& step)
{
  for (int i = 0; i < 6; ++i, step *= 0.5)
    if (const std::optional<Vector3d> there = residual(from + step)) return there;
  return std::nullopt;
}

std::optional<Vector3d> solve(const Residual& residual, Vector3d v)
{
  std::optional<Vector3d> now = residual(v);
  Matrix3d inverse;
  if (!now || !probe(residual, v, *now, inverse)) return std::nullopt;
  bool fresh = true;
  for (int i = 0; i < kMaxSteps; ++i)
  {
    if (now->norm() < kGood) return v;
    Vector3d step = -inverse * *now;
    if (!step.allFinite()) return std::nullopt;
    if (step.norm() > kLongestStep) step *= kLongestStep / step.norm();
    const std::optional<Vector3d> next = backtrack(residual, v, step);
    if (!next) return std::nullopt;
    const Vector3d change = *next - *now;
    const bool slow = next->norm() > 0.5 * now->norm();
    v += step;
    now = next;
    if (slow && !fresh)
    {
      if (!probe(residual, v, *now, inverse)) return std::nullopt;
      fresh = true;
      continue;
    }
    fresh = false;
    const Vector3d gone = inverse * change;  // Sherman and Morrison
    const double scale = step.dot(gone);
    if (std::abs(scale) > 1e-12 * step.squaredNorm()) inverse += (step - gone) * (step.transpose() * inverse) / scale;
  }
  return std::nullopt;
}

BallState leaving(const Vector3d& p, const Vector3d& v, const SpinOf& spin)
{
  BallState out;
  out.p_WB = p;
  out.v_WB = v;
  out.w_WB = spin(v);
  return out;
}

Vector3d parabolaGuess(const Vector3d& from, const Vector3d& to, double time)
{
  constexpr double kDrag = 1.1;  // what air takes of the way, roughly
  constexpr double kFall = 9.8;  // [m/s^2]; where gravity is another the solver finds out
  Vector3d v = kDrag * (to - from) / time;
  v.z() = (to.z() - from.z()) / time + 0.5 * kFall * time;
  return v;
}
}  // namespace

std::optional<AimedShot> shotToTarget(const Flyer& flyer, const Vector3d& p, const SpinOf& spin, const ShotWish& wish,
                                      const Vector3d& guess)
{
  AimedShot shot;
  double time = wish.flight_time;
  const Residual miss = [&](const Vector3d& v) -> std::optional<Vector3d>
  {
    const BallState out = leaving(p, v, spin);
    const std::optional<Arc> arc = flyDownTo(flyer, out, wish.target.z());
    if (!arc) return std::nullopt;
    shot = {out, *arc};
    const Vector3d off = arc->landing.p_WB - wish.target;
    return Vector3d(off.x(), off.y(), kTimeScale * (arc->duration - time));
  };
  Vector3d v = guess.isZero() ? parabolaGuess(p, wish.target, time) : guess;
  int failures = 0;
  for (int i = 0; i < kMaxLonger && time <= wish.longest_time && failures < kMaxFailures; ++i, time *= kLonger)
  {
    const std::optional<Vector3d> found = solve(miss, v);
    v = found ? *found : parabolaGuess(p, wish.target, time * kLonger);
    failures += !found;
    if (!found) continue;
    miss(v);  // fills the shot
    if (shot.arc.over_net >= wish.least_over_net && shot.arc.over_edge >= wish.least_over_edge) return shot;
  }
  return std::nullopt;
}

std::optional<AimedShot> serveToTarget(const Flyer& flyer, const Vector3d& p, const SpinOf& spin,
                                       const TableBounce& bounce_off, const ServeWish& wish)
{
  AimedShot shot;
  const double height = wish.target.z();
  const Residual miss = [&](const Vector3d& v) -> std::optional<Vector3d>
  {
    const BallState out = leaving(p, v, spin);
    const std::optional<Arc> first = flyDownTo(flyer, out, height);
    if (!first) return std::nullopt;
    BallState off = first->landing;
    bounce_off(off);
    const std::optional<Arc> second = flyDownTo(flyer, off, height);
    if (!second) return std::nullopt;
    shot = {out, *first, second->landing.p_WB};
    shot.arc.over_net = second->over_net;
    const Vector3d beside = second->landing.p_WB - wish.target;
    return Vector3d(beside.x(), beside.y(), first->landing.p_WB.x() - wish.own_bounce);
  };
  Vector3d first = wish.target;
  first.x() = wish.own_bounce;
  const double time = (wish.own_bounce - p.x()) / wish.speed_guess;
  Vector3d v = parabolaGuess(p, first, time);
  v.y() = wish.speed_guess * (wish.target.y() - p.y()) / (wish.target.x() - p.x());
  const std::optional<Vector3d> found = solve(miss, v);
  if (!found || !miss(*found)) return std::nullopt;
  const bool passes = std::isfinite(shot.arc.over_net) && shot.arc.over_net >= wish.least_over_net;
  if (!passes || shot.arc.over_edge < height) return std::nullopt;
  return shot;
}
}  // namespace ping_pong::play
