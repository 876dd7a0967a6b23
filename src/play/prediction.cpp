#include "prediction.h"

#include <algorithm>
#include <cmath>

namespace ping_pong::play
{
namespace
{
constexpr double kStep = 0.010;  // between samples [s]; with it the cubic is off by (a''/384) kStep^4, 5e-9 m at 20 m/s
constexpr double kHorizon = 3.0;  // a lob takes 2 s to its second bounce [s]
constexpr double kFarAway = 8.0;  // from the table, along or across: nobody plays there [m]
constexpr std::size_t kRoom = 512;

BallState between(const PathSample& a, const PathSample& b, double time)
{
  const double h = b.time - a.time;
  if (!(h > 0.0)) return b.state;
  const double s = (time - a.time) / h, s2 = s * s, s3 = s2 * s;
  const Vector3d way = b.state.p_WB - a.state.p_WB;
  BallState state = a.state;
  state.p_WB =
      a.state.p_WB + (3.0 * s2 - 2.0 * s3) * way + h * ((s3 - 2.0 * s2 + s) * a.state.v_WB + (s3 - s2) * b.state.v_WB);
  state.v_WB =
      (6.0 * (s - s2) / h) * way + (3.0 * s2 - 4.0 * s + 1.0) * a.state.v_WB + (3.0 * s2 - 2.0 * s) * b.state.v_WB;
  state.w_WB = a.state.w_WB + s * (b.state.w_WB - a.state.w_WB);
  return state;
}
}  // namespace

Prediction::Prediction(const Scene& scene, const Court& court, const BallParams& ball)
    : radius_(ball.radius), world_(court.ownScene(scene, ball))
{
  table_ = world_.findBody("table");
  surface_ = court.surface();
  samples_.reserve(kRoom);
  bounces_.reserve(16);
}

Touched Prediction::touchedBy(const Contact& contact) const
{
  if (contact.body != table_) return Touched::Other;
  if (contact.shape == surface_)
  {
    const bool on_top = contact.n_W.z() > 0.5 && contact.p_WC.z() > -1e-3;
    return !on_top ? Touched::Other : contact.p_WC.x() < 0.0 ? Touched::OwnHalf : Touched::OtherHalf;
  }
  return contact.p_WC.z() > 0.0 ? Touched::Net : Touched::Other;
}

void Prediction::predict(double time, const BallState& state)
{
  forget();
  if (world_.setBallState(world_.ballId(0), state)) return;
  const double offset = time - world_.time();
  add(time, state);
  bool over = false;
  for (int i = 1; i * kStep <= kHorizon && !over; ++i)
  {
    world_.advance(kStep);
    for (const Contact& contact : world_.contacts())
    {
      if (bounces_.size() == bounces_.capacity()) return;
      const double when = contact.time + offset;
      BallState at = world_.ballState(0);
      at.p_WB = contact.p_WC + radius_ * contact.n_W;
      at.v_WB = contact.v_before;
      at.w_WB = contact.w_before;
      add(when, at);
      at.v_WB = contact.v_after;
      at.w_WB = contact.w_after;
      add(when, at);
      bounces_.push_back({when, at.p_WB, touchedBy(contact)});
      over |= bounces_.back().touched == Touched::Other;
    }
    const BallState now = world_.ballState(0);
    add(world_.time() + offset, now);
    over |= now.p_WB.cwiseAbs().head<2>().maxCoeff() > kFarAway || world_.resting(0);
  }
}

BallState Prediction::at(double time) const
{
  if (time >= end()) return samples_.back().state;
  const auto after = std::upper_bound(samples_.begin(), samples_.end(), time,
                                      [](double t, const PathSample& sample) { return t < sample.time; });
  return after == samples_.begin() ? samples_.front().state : between(*(after - 1), *after, time);
}
}  // namespace ping_pong::play
