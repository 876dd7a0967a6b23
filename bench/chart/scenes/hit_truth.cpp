#include "hit_truth.h"

#include <cmath>

namespace ping_pong::bench
{
namespace
{
constexpr Real kClose = 1e-9L;  // from here on Newton's method finds the contact [m]

struct Nearest
{
  Real gap = 0.0L;
  Vector3r n = Vector3r::Zero();  // from the box to the ball
};

class Hit
{
public:
  explicit Hit(const HitTask& task) : task_(task) {}

  TrueState ballAt(const TrueState& from, Real s) const
  {
    const Vector3r a(0, 0, -task_.g);
    return {from.p + s * from.v + 0.5L * s * s * a, from.v + s * a, from.w};
  }

  // First time in [t, duration] at which a ball that is at `from` at time `begun` touches; negative if it does not.
  // The gap changes no faster than `bound`, so no step jumps over a contact.
  Real touch(const TrueState& from, Real begun, Real t) const
  {
    const Real end = task_.duration;
    const Real bound = from.v.norm() + task_.g * end + task_.v.norm() + task_.w.norm() * task_.half_size.norm();
    for (Real gap = nearest(from, begun, t).gap; gap > kClose; gap = nearest(from, begun, t).gap)
    {
      t += gap / bound;
      if (t > end) return -1.0L;
    }
    return polished(from, begun, t);
  }

  TrueState bounced(TrueState ball, Real t) const
  {
    const Real r = task_.ball.radius, k = task_.ball.inertia;
    const Vector3r n = nearest(ball, t, t).n;
    const Vector3r contact = ball.p - r * n;
    const Vector3r surface = task_.v + task_.w.cross(contact - (task_.p + t * task_.v));
    const Vector3r relative = ball.v + ball.w.cross(-r * n) - surface;
    const Real closing = -n.dot(relative);
    const Vector3r slip = relative + closing * n;
    const Real normal = (1.0L + task_.restitution) * closing;  // impulse per mass
    Vector3r rub = -k / (1.0L + k) * slip;
    if (rub.norm() > task_.friction * normal) rub *= task_.friction * normal / rub.norm();
    ball.v += normal * n + rub;
    ball.w += (-r * n).cross(rub) / (k * r * r);
    return ball;
  }

private:
  Nearest nearest(const TrueState& from, Real begun, Real t) const
  {
    const Real angle = task_.w.norm() * t;
    Eigen::Quaternion<Real> q = task_.q;
    if (angle != 0.0L) q = Eigen::AngleAxis<Real>(angle, task_.w.normalized()) * q;
    const Vector3r local = q.conjugate() * (ballAt(from, t - begun).p - task_.p - t * task_.v);
    const Vector3r inside = local.cwiseMax(-task_.half_size).cwiseMin(task_.half_size);
    const Vector3r away = local - inside;
    const Real distance = away.norm();
    return {distance - task_.ball.radius, q * Vector3r(away / distance)};
  }

  Real polished(const TrueState& from, Real begun, Real t) const
  {
    constexpr Real kDifference = 1e-6L;
    for (int i = 0; i < 6; ++i)
    {
      const Real rate = (nearest(from, begun, t + kDifference).gap - nearest(from, begun, t - kDifference).gap) /
                        (2.0L * kDifference);
      t -= nearest(from, begun, t).gap / rate;
    }
    return t;
  }

  const HitTask& task_;
};
}  // namespace

std::optional<TruePath> hitTruth(const HitTask& task)
{
  constexpr Real kParted = 1e-3L;  // after the hit, when the search for a second one begins [s]
  const Hit hit(task);
  const Real t = hit.touch(task.start, 0.0L, 0.0L);
  if (t < 0.0L || t > task.duration - 2.0L * kParted) return std::nullopt;
  const TrueState after = hit.bounced(hit.ballAt(task.start, t), t);
  if (hit.touch(after, t, t + kParted) >= 0.0L) return std::nullopt;
  TruePath path;
  path.events = {t};
  for (long i = 1; i <= std::lround(task.duration / task.sample_period); ++i)
  {
    const Real at = static_cast<Real>(i) * task.sample_period;
    path.samples.push_back(at < t ? hit.ballAt(task.start, at) : hit.ballAt(after, at - t));
  }
  return path;
}
}  // namespace ping_pong::bench
