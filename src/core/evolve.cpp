#include "ping_pong_sim/evolve.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace ping_pong
{
namespace
{
Segment startOf(const BallState& state, double start)
{
  Segment path;
  path.start = start;
  path.c[0] = state.p_WB;
  path.c[1] = state.v_WB;
  path.q_WB = state.q_WB;
  path.w_WB = state.w_WB;
  return path;
}

// Collocation at N Gauss-Legendre points of (0, 1): the polynomial of degree N - 1 through the accelerations there.
template <int N>
struct Points
{
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;
  Vector nodes;
  Matrix to_powers;    // accelerations at the nodes -> coefficients of tau^k
  Matrix integral;     // accelerations at the nodes -> their integral from 0 to each node
  double leading = 1;  // leading coefficient of the shifted Legendre polynomial of degree N - 1

  Points()
  {
    for (int i = 0; i < N; ++i) nodes[i] = 0.5 * (1.0 - legendreRoot(i));
    Matrix powers, integrated;
    for (int i = 0; i < N; ++i)
      for (int k = 0; k < N; ++k)
      {
        powers(i, k) = std::pow(nodes[i], k);
        integrated(i, k) = std::pow(nodes[i], k + 1) / (k + 1);
      }
    to_powers = powers.inverse();
    integral = integrated * to_powers;
    for (int k = 1; k < N; ++k) leading *= (N - 1.0 + k) / k;  // (2 (N - 1))! / ((N - 1)!)^2
  }

  // Newton on P_N from Chebyshev's guess (Abramowitz and Stegun 22.16.6).
  static double legendreRoot(int i)
  {
    double x = std::cos(M_PI * (i + 0.75) / (N + 0.5));
    for (int iteration = 0; iteration < 20; ++iteration)
    {
      double p0 = 1.0, p1 = x;
      for (int k = 2; k <= N; ++k)
      {
        const double p2 = ((2.0 * k - 1.0) * x * p1 - (k - 1.0) * p0) / k;
        p0 = p1;
        p1 = p2;
      }
      x -= p1 * (x * x - 1.0) / (N * (x * p1 - p0));
    }
    return x;
  }
};

// Errors seen are this part of the last coefficient's share, times a reserve of ten.
constexpr double kShareOfLast = 1e-2;
constexpr int kMaxSweeps = 40;
constexpr double kLongestPiece = 1.0;  // [s]

// One piece of length h; false if the share of the last Legendre coefficient in the position is above the tolerance. What is
// left out is smaller, and smaller still at the end of the piece, where Gauss points are of order 2 N: pieces join without
// adding up. `excess` is error / tolerance.
template <int N>
bool collocate(const FlightModel& model, double h, double tolerance, Segment& path, double& excess)
{
  static const Points<N> points;
  using Vectors = Eigen::Matrix<double, 3, N>;
  Vectors a = Vectors::Zero();
  Vectors v, w;
  const Vector3d v0 = path.c[1];
  const Vector3d a0 = model.acceleration(v0, path.w_WB);
  for (int i = 0; i < N; ++i)
  {
    v.col(i) = v0 + h * points.nodes[i] * a0;
    w.col(i) = path.spin(h * points.nodes[i]);
  }
  // Picard sweeps: each gains one power of h times the rate of the flow.
  double change = kLongestPiece;
  const double enough = std::max(0.01 * tolerance, 1e-15 * v0.norm());
  for (int sweep = 0; change > enough; ++sweep)
  {
    if (sweep == kMaxSweeps || !(change < 1e6))
    {
      excess = 1e6;
      return false;
    }
    for (int i = 0; i < N; ++i) a.col(i) = model.acceleration(v.col(i), w.col(i));
    const Vectors next = (h * a * points.integral.transpose()).colwise() + v0;
    change = (next - v).cwiseAbs().maxCoeff();
    v = next;
  }
  const Vectors b = a * points.to_powers.transpose();
  excess = kShareOfLast * h * h * b.col(N - 1).norm() / points.leading / tolerance;
  if (excess > 1.0) return false;
  path.degree = N + 1;
  double power = h;  // h^2 / h^k, as the coefficients are of tau = s / h
  for (int k = 0; k < N; ++k)
  {
    path.c[k + 2] = b.col(k) * h / power / ((k + 1) * (k + 2));
    power *= h;
  }
  path.end = path.start + h;
  return true;
}

template <int N>
void flyThroughAir(const FlightModel& model, double tolerance, Segment& path, double& step)
{
  double h = step > 0.0 ? step : 0.5 * std::pow(tolerance, 1.0 / N) / model.rate(path.c[1], path.w_WB);
  double excess = 1.0;
  for (h = std::min(h, kLongestPiece); !collocate<N>(model, h, tolerance, path, excess);)
    h *= std::max(0.1, 0.8 * std::pow(excess, -1.0 / N));
  step = h * std::min(2.0, 0.8 * std::pow(std::max(excess, 1e-6), -1.0 / N));
}
}  // namespace

Segment flyParabola(const BallState& state, double start, const Vector3d& a)
{
  Segment path = startOf(state, start);
  path.degree = 2;
  path.c[2] = 0.5 * a;
  return path;
}

Segment fly(const BallState& state, double start, const FlightModel& model, double tolerance, double& step)
{
  Segment path = startOf(state, start);
  path.spin_decay = model.spinDecay();
  if (model.constant())
  {
    path.degree = 2;
    path.c[2] = 0.5 * model.acceleration(state.v_WB, state.w_WB);
  }
  else if (tolerance > 1e-5)
    flyThroughAir<4>(model, tolerance, path, step);
  else
    flyThroughAir<8>(model, tolerance, path, step);
  return path;
}

Quaterniond turned(const Quaterniond& q, const Vector3d& w, double s)
{
  const double speed = w.norm();
  if (speed == 0.0 || s == 0.0) return q;
  const Vector3d axis = w / speed;
  const double half = 0.5 * speed * s;
  const Quaterniond turn(std::cos(half), std::sin(half) * axis.x(), std::sin(half) * axis.y(),
                         std::sin(half) * axis.z());
  return (turn * q).normalized();
}
}  // namespace ping_pong
