#include "resting/constrained_piece.h"

#include <algorithm>
#include <cmath>

#include "evolve/gauss_points.h"
#include "resting/slip_turning.h"

namespace ping_pong
{
namespace
{
constexpr int kMaxIterations = 40;          // a piece that needs more is tried again, shorter
constexpr double kFirstTry = 5e-3;          // from the second piece on the one before tells [s]
constexpr double kLongestPiece = 0.1;       // what may end it is looked for at a few places only [s]
constexpr double kBeforeRest = 0.9;         // of the time until a slip ends: its direction may change fast at the end
constexpr double kEndOfBisection = 1e-13;   // [s]
constexpr double kInsideTolerance = 2e-11;  // [m]
constexpr int kLooks = 4;                   // at a piece, for what ends it

using Places = Eigen::Matrix<double, kNodes, 3>;

void layThrough(const Rates& rates, double h, double radius, Segment& path)
{
  const Rates b = gaussPoints().to_powers * rates;
  path.degree = kNodes + 1;
  HigherCoefficients& higher = path.higher.make();
  SpinCoefficients& spin = higher.spin.make();
  double power = 1.0;  // h^k, as the coefficients are of tau = s / h
  for (int k = 0; k < kNodes; ++k, power *= h)
  {
    path.coefficient(k + 2) = b.row(k).head<3>().transpose() / (power * (k + 1) * (k + 2));
    const Vector3d w = b.row(k).tail<3>().transpose() / (power * (k + 1) * radius);
    if (k == 0)
      higher.alpha_WB = w;
    else
      spin.c[k - 1] = w;
  }
  path.end = path.start + h;
}

// Error of a piece as a part of what is allowed. The path within it must not leave the surface; what is wrong at its end lasts,
// but there Gauss points of order 2 N leave the square of what they leave within: see errorOf() of gauss_points.h.
double excessOf(const Rates& rates, double h, double tolerance)
{
  constexpr double kSafety = 16.0;
  const Eigen::Matrix<double, 4, 6> b = gaussPoints().to_last * rates;
  const double before = std::max(b.row(0).norm(), b.row(1).norm()), last = std::max(b.row(2).norm(), b.row(3).norm());
  if (!(last > 0.0)) return 0.0;
  const double fall = std::min(1.0, std::sqrt(last / before));  // from one coefficient to the next
  const double next = std::max(b.row(3).norm(), fall * last);
  const double inside = h * h * next * kShareOfLast<kNodes>;
  const double lasting = std::min(1.0, kSafety * std::pow(fall, kNodes)) * h * next * kRally;
  return std::max(inside / std::min(tolerance, kInsideTolerance), lasting / tolerance);
}

// One piece of length h; false if its error is above the tolerance, or the iteration does not end. `excess` is error / tolerance.
bool collocate(const ConstrainedBall& constrained, const Decision& decision, const BallMotion& ball, double t, double h,
               double tolerance, Segment& path, double& excess)
{
  const GaussPoints<kNodes>& points = gaussPoints();
  Eigen::Matrix<double, 1, 6> start, first;
  start << ball.v.transpose(), ball.s.transpose();
  first << decision.motion.a.transpose(), decision.motion.b.transpose();
  Rates rates = first.replicate<kNodes, 1>();
  Speeds speeds = (h * (points.integral * rates)).rowwise() + start;
  const double rounding = 1e-15 * (start.norm() + h * first.norm());
  double before = 0.0;
  SlipTurning turning{constrained, decision, t, h};
  for (int iteration = 0;; ++iteration)
  {
    const Places places =
        (h * points.nodes * ball.v.transpose() + (h * h) * (points.double_integral * rates.leftCols<3>())).rowwise() +
        ball.p.transpose();
    for (int i = 0; i < kNodes; ++i)
    {
      const BallMotion at{places.row(i).transpose(), speeds.row(i).head<3>().transpose(),
                          speeds.row(i).tail<3>().transpose()};
      rates.row(i) = turning.ratesAt(i, at);
    }
    const auto led = [&] { return Speeds((h * (points.integral * rates)).rowwise() + start); };
    turning.correct(led() - speeds, rates);
    const Speeds next = led();
    const double change = (next - speeds).cwiseAbs().maxCoeff();
    speeds = next;
    if (change * std::min(1.0, change / before) <= 0.01 * tolerance || change <= rounding) break;
    if (iteration == kMaxIterations || !(change < 1e6) || (iteration > 6 && change > before))
    {
      excess = 1e6;
      return false;
    }
    before = change;
  }
  excess = excessOf(rates, h, tolerance);
  if (!(excess <= 1.0)) return false;
  layThrough(rates, h, constrained.radius, path);
  return true;
}

BallMotion motionOn(const Segment& path, double s, double radius)
{
  return {path.position(s), path.velocity(s), radius * path.spin(s)};
}

bool onAllFeatures(const ConstrainedBall& constrained, const Vector3d& p_WB, double t)
{
  for (std::size_t i = 0; i < constrained.count; ++i)
  {
    const SupportSurface& surface = constrained.surface[i];
    const Vector3d p_BQ = surface.still ? p_WB : surface.motion->poseAt(t - surface.motion->start).toB(p_WB);
    if (!onFeature(*surface.shape, surface.feature, p_BQ)) return false;
  }
  return true;
}

// First time on the piece, from its start, at which it no longer holds; h if it does to its end.
double holdsFor(const ConstrainedBall& constrained, const Decision& decided, const Segment& path, double h)
{
  const auto holds = [&](double s)
  {
    const BallMotion ball = motionOn(path, s, constrained.radius);
    return onAllFeatures(constrained, ball.p, path.start + s) && modesHold(constrained, decided, ball, path.start + s);
  };
  for (int look = 1; look <= kLooks; ++look)
  {
    double after = h * look / kLooks;
    if (holds(after)) continue;
    for (double before = h * (look - 1) / kLooks; after - before > kEndOfBisection + 1e-16 * path.start;)
    {
      const double middle = 0.5 * (before + after);
      if (middle <= before || middle >= after) break;
      (holds(middle) ? before : after) = middle;
    }
    return after;
  }
  return h;
}
}  // namespace

void layConstrainedPiece(const ConstrainedBall& constrained, const Decision& decision, const BallMotion& ball, double t,
                         double longest, double tolerance, double shortest, Segment& path)
{
  HigherCoefficients& higher = path.higher.make();
  SpinCoefficients& spin = higher.spin.make();
  double h = std::min(spin.next_piece > 0.0 ? spin.next_piece : kFirstTry, kLongestPiece);
  double wanted = h;  // if nothing else ends it
  h = std::max(std::min({h, longest, kBeforeRest * slipsFor(decision)}), std::min(shortest, longest));
  double excess = 1.0;
  while (!collocate(constrained, decision, ball, t, h, tolerance, path, excess))
  {
    if (h <= shortest)  // nothing smooth is left to follow: the motion of this instant, for a moment
    {
      layThrough((Eigen::Matrix<double, 1, 6>() << decision.motion.a.transpose(), decision.motion.b.transpose())
                     .finished()
                     .replicate<kNodes, 1>(),
                 h, constrained.radius, path);
      break;
    }
    h = std::max(shortest, h * std::max(0.1, 0.8 * std::pow(excess, -1.0 / (kNodes + 2))));
    wanted = 0.0;
  }
  const double grown = h * std::min(3.0, 0.8 * std::pow(std::max(excess, 1e-8), -1.0 / (kNodes + 3)));
  const double held_for = h <= shortest ? h : std::max(holdsFor(constrained, decision, path, h), shortest);
  // After the last look, what ended it tells little of the next piece.
  spin.next_piece = held_for < h ? kFirstTry : std::max(grown, wanted);
  path.end = t + held_for;
}
}  // namespace ping_pong
