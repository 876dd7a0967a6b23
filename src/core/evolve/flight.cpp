#include "evolve/flight.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/law_counter.h"
#include "evolve/gauss_points.h"

namespace ping_pong
{
namespace
{
void startAt(const BallState& state, double start, Segment& path)
{
  path.start = start;
  path.end = std::numeric_limits<double>::infinity();
  path.c[0] = state.p_WB;
  path.c[1] = state.v_WB;
  path.q_WB = state.q_WB;
  path.w_WB = state.w_WB;
}

void bendBy(const Vector3d& a, Segment& path)
{
  path.degree = 2;
  path.c[2] = 0.5 * a;
}

void giveHigherCoefficients(double spin_decay, Segment& path)
{
  HigherCoefficients& higher = path.higher.make();
  higher.pending_rotation.setZero();
  higher.alpha_WB.setZero();
  higher.spin.reset();
  higher.spin_decay = spin_decay;
}

constexpr double kIterationsShare = 0.1;  // of the tolerance, left to the iteration
constexpr int kMaxIterations = 40;        // a piece that needs more is tried again, shorter
constexpr double kLongestPiece = 1.0;  // more than a ball flies over a table: bounds of its acceleration stay tight [s]
constexpr double kFirstTry = 3.0;      // length of the first piece, by tolerance^(1/(N+1)) / rate of the flow
constexpr double kNoKink = std::numeric_limits<double>::infinity();  // [s]

// Velocities at the nodes to begin with: of the piece that was too long, or from a0 and how the acceleration changes along it.
template <int N>
typename FlightModel::Rows<N> firstGuess(const FlightModel& model, const Segment& path, double h,
                                         const GaussPoints<N>& points)
{
  typename FlightModel::Rows<N> v;
  if (path.degree == N + 1)
  {
    for (int i = 0; i < N; ++i) v.row(i) = path.velocity(h * points.nodes[i]).transpose();
    return v;
  }
  const Vector3d& v0 = path.c[1];
  const Vector3d a0 = model.acceleration(v0, path.w_WB);
  const Vector3d half_change = model.acceleration(v0 + 0.5 * h * a0, path.w_WB) - a0;
  const auto s = points.nodes;
  for (int c = 0; c < 3; ++c) v.col(c) = v0[c] + h * s.array() * (a0[c] + half_change[c] * s.array());
  return v;
}

// The polynomial through the accelerations at the nodes.
template <int N>
void layThrough(const typename FlightModel::Rows<N>& a, double h, const GaussPoints<N>& points, Segment& path)
{
  const typename FlightModel::Rows<N> b = points.to_powers * a;
  path.degree = N + 1;
  double power = h;  // h^2 / h^k, as the coefficients are of tau = s / h
  for (int k = 0; k < N; ++k)
  {
    path.coefficient(k + 2) = b.row(k).transpose() * (h / power / ((k + 1) * (k + 2)));
    power *= h;
  }
  path.end = path.start + h;
}

// One piece of length h; false if its error is above the tolerance. `excess` is error / tolerance.
template <int N>
bool collocate(const FlightModel& model, double h, double tolerance, Segment& path, double& excess)
{
  static const GaussPoints<N> points;
  using Rows = FlightModel::Rows<N>;
  const Vector3d& v0 = path.c[1];
  FlightModel::Column<N> fade = FlightModel::Column<N>::Ones();
  count(N == 4 ? Law::Collocation5 : N == 6 ? Law::Collocation7 : Law::Collocation9);
  const double spin_decay = model.spinDecay();
  if (spin_decay > 0.0) count(Law::SpinDecay, N);
  if (spin_decay > 0.0) fade = (-spin_decay * h * points.nodes.array()).exp();
  Rows v = firstGuess<N>(model, path, h, points);
  Rows a;
  // Picard iterations: each gains one power of h times the rate of the flow.
  const double rounding = 1e-15 * v0.norm();
  double before = 0.0;
  for (int iteration = 0;; ++iteration)
  {
    a = model.accelerations<N>(v, path.w_WB, fade);
    const Rows next = (h * (points.integral * a)).rowwise() + v0.transpose();
    const double change = (next - v).cwiseAbs().maxCoeff();
    v = next;
    // The next iteration would change the velocity by about change^2 / before, and that the position after a second.
    if (change * std::min(1.0, change / before) <= kIterationsShare * tolerance || change <= rounding) break;
    if (iteration == kMaxIterations || !(change < 1e6))
    {
      path.degree = 0;
      excess = 1e6;
      return false;
    }
    before = change;
  }
  excess = errorOf<N>(a, h, points) / tolerance;
  layThrough<N>(a, h, points, path);
  return excess <= 1.0;
}

constexpr double kCostOfATurn = 1e-4;  // more than a piece across such a turn is ever wrong by [m]
constexpr double kTooSoon = 1e-7;      // a kink that close to the start is the one that the last piece ended at [s]

// First time on the piece at which `beyond` is true, which is false at its start: to 1e-12 s, if some sample sees it.
template <typename Beyond>
double firstBeyond(const Beyond& beyond, double h, int looks)
{
  for (int i = 1; i <= looks; ++i)
  {
    double after = h * i / looks;
    if (!beyond(after)) continue;
    for (double before = h * (i - 1) / looks; after - before > 1e-12;)
    {
      const double middle = 0.5 * (before + after);
      (beyond(middle) ? after : before) = middle;
    }
    return after > kTooSoon ? after : kNoKink;
  }
  return kNoKink;
}

// Where on this piece a law from a table has its first kink.
double firstNode(const FlightModel& model, const Segment& path)
{
  constexpr int kLooks = 16;
  const auto region = [&](double s) { return model.smoothRegion(path.velocity(s), path.spin(s)); };
  const double h = path.end - path.start;
  const std::size_t here = region(std::min(kTooSoon, h));
  return firstBeyond([&](double s) { return region(s) != here; }, h, kLooks);
}

// Where on this piece the ball turns round at hardly any air speed: drag, as |u| u, has a kink there, or nearly one.
double sharpTurn(const FlightModel& model, const Segment& path)
{
  constexpr double kSharp = 0.1;
  const double h = path.end - path.start;
  const double change = h * path.acceleration(0.0).norm();
  // It cannot become slower than half of this sum less its change on the way.
  const double speeds = model.throughAir(path.c[1]).norm() + model.throughAir(path.velocity(h)).norm();
  if (speeds > (1.0 + 2.0 * kSharp) * change) return kNoKink;
  const auto gains = [&](double s) { return model.throughAir(path.velocity(s)).dot(path.acceleration(s)) > 0.0; };
  if (gains(kTooSoon) || !gains(h)) return kNoKink;
  const double turn = firstBeyond(gains, h, 1);
  const double speed = turn < h ? model.throughAir(path.velocity(turn)).norm() : kNoKink;
  return speed < kSharp * h * path.acceleration(turn).norm() ? turn : kNoKink;
}

double firstKink(const FlightModel& model, const Segment& path, double tolerance)
{
  const double turn = tolerance < kCostOfATurn ? sharpTurn(model, path) : kNoKink;
  return model.smooth() ? turn : std::min(turn, firstNode(model, path));
}

template <int N>
void flyThroughAir(const FlightModel& model, double tolerance, Segment& path)
{
  constexpr int kCuts = 8;
  double& next_piece = path.higher->next_piece;
  double h =
      next_piece > 0.0 ? next_piece : kFirstTry * std::pow(tolerance, 1.0 / (N + 1)) / model.rate(path.c[1], path.w_WB);
  h = std::min(h, kLongestPiece);
  path.degree = 0;
  double excess = 1.0;
  for (int cuts = 0;;)
  {
    if (!collocate<N>(model, h, tolerance, path, excess))
    {
      h *= std::max(0.1, 0.8 * std::pow(excess, -1.0 / (N + 2)));
      continue;
    }
    const double kink = cuts++ < kCuts ? firstKink(model, path, tolerance) : kNoKink;
    if (kink >= h * (1.0 - 1e-9)) break;
    h = kink;
  }
  // Near the tolerance the error grows with h^(N + 1) to h^(2 N), as `rough` sets in: a piece too long costs as much as two.
  next_piece = h * std::min(3.0, 0.8 * std::pow(std::max(excess, 1e-6), -1.0 / (N + 3)));
}
}  // namespace

Segment flyParabola(const BallState& state, double start, const Vector3d& a)
{
  Segment path;
  startAt(state, start, path);
  bendBy(a, path);
  return path;
}

void fly(const BallState& state, double start, const FlightModel& model, double tolerance, Segment& path)
{
  startAt(state, start, path);
  if (model.constant() && model.spinDecay() == 0.0)
    path.higher.reset();
  else
    giveHigherCoefficients(model.spinDecay(), path);
  if (model.constant()) return bendBy(model.acceleration(state.v_WB, state.w_WB), path);
  const int degree = pieceDegree(tolerance);
  if (degree == 5)
    flyThroughAir<4>(model, tolerance, path);
  else if (degree == 7)
    flyThroughAir<6>(model, tolerance, path);
  else
    flyThroughAir<8>(model, tolerance, path);
  path.boundAcceleration();
}

Quaterniond turned(const Quaterniond& q, const Vector3d& w, double s)
{
  const double speed = w.norm();
  if (speed == 0.0 || s == 0.0) return q;
  count(Law::Orientation);
  const Vector3d axis = w / speed;
  const double half = 0.5 * speed * s;
  const Quaterniond turn(std::cos(half), std::sin(half) * axis.x(), std::sin(half) * axis.y(),
                         std::sin(half) * axis.z());
  return (turn * q).normalized();
}
}  // namespace ping_pong
