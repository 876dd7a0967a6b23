// Collocation at Gauss-Legendre points: a polynomial through values at N points, its integrals, and what it leaves out.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace ping_pong
{
/// N Gauss-Legendre points of (0, 1), and the polynomial of degree N - 1 through the values at them.
/// Source: Hairer, Norsett, Wanner, "Solving Ordinary Differential Equations I" (1993), II.7.
template <int N>
struct GaussPoints
{
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;
  static constexpr int kLast = N < 6 ? 3 : 4;  // Legendre coefficients that tell of the error

  Vector nodes;
  Matrix to_powers;                         // values at the nodes -> coefficients of tau^k
  Matrix integral;                          // values at the nodes -> their integral from 0 to each node
  Matrix double_integral;                   // the same of the integral
  Eigen::Matrix<double, kLast, N> to_last;  // values at the nodes -> last Legendre coefficients

  GaussPoints()
  {
    Vector weights;
    for (int i = 0; i < N; ++i)
    {
      const double x = legendreRoot(i);
      const double slope = legendre(N, x).second;
      nodes[i] = 0.5 * (1.0 - x);
      weights[i] = 1.0 / ((1.0 - x * x) * slope * slope);  // Abramowitz and Stegun 25.4.29, for an interval of length 1
    }
    Matrix powers, integrated, twice;
    for (int i = 0; i < N; ++i)
      for (int k = 0; k < N; ++k)
      {
        powers(i, k) = std::pow(nodes[i], k);
        integrated(i, k) = std::pow(nodes[i], k + 1) / (k + 1);
        twice(i, k) = std::pow(nodes[i], k + 2) / ((k + 1) * (k + 2));
      }
    to_powers = powers.inverse();
    integral = integrated * to_powers;
    double_integral = twice * to_powers;
    for (int k = 0; k < kLast; ++k)
      for (int i = 0; i < N; ++i)
      {
        const int degree = N - kLast + k;
        to_last(k, i) = (2.0 * degree + 1.0) * weights[i] * legendre(degree, 2.0 * nodes[i] - 1.0).first;
      }
  }

  // P_n(x) and its derivative.
  static std::pair<double, double> legendre(int n, double x)
  {
    double p0 = 1.0, p1 = x;
    if (n == 0) return {1.0, 0.0};
    for (int k = 2; k <= n; ++k)
    {
      const double p2 = ((2.0 * k - 1.0) * x * p1 - (k - 1.0) * p0) / k;
      p0 = p1;
      p1 = p2;
    }
    return {p1, n * (x * p1 - p0) / (x * x - 1.0)};
  }

  // Newton on P_N from Chebyshev's guess (Abramowitz and Stegun 22.16.6).
  static double legendreRoot(int i)
  {
    double x = std::cos(M_PI * (i + 0.75) / (N + 0.5));
    for (int iteration = 0; iteration < 20; ++iteration)
    {
      const auto [value, slope] = legendre(N, x);
      x -= value / slope;
    }
    return x;
  }
};

/// Where Legendre coefficients fall fast, the error is this part of the last one or less.
template <int N>
constexpr double kShareOfLast = N < 6 ? 2e-2 : 1e-2;
constexpr double kRally = 1.0;  // an error of the velocity lasts so long [s]

/// Error that a piece of length h leaves of the position a second later [m]. Smooth accelerations have Legendre coefficients
/// that fall as rho^k: the next ones hardly count, and at the end of the piece, where Gauss points are of order 2 N, still
/// less. Where they do not fall (the ball turns round at no air speed, or passes a node of a table) as much as the last ones
/// is left out, at the end as well.
/// @param a  accelerations at the nodes, a row each [m/s^2]
template <int N, class Rows>
double errorOf(const Rows& a, double h, const GaussPoints<N>& points)
{
  constexpr int last = GaussPoints<N>::kLast - 1;
  const Eigen::Matrix<double, last + 1, Rows::ColsAtCompileTime> b = points.to_last * a;
  const double b0 = b.row(0).squaredNorm(), b2 = b.row(last - 1).squaredNorm(), b3 = b.row(last).squaredNorm();
  const double before = last == 3 ? std::max(b0, b.row(1).squaredNorm()) : b0;
  const double fall = std::max(b2, b3);
  if (!(fall > 0.0)) return 0.0;
  const double rho2 = std::min(1.0, last == 3 ? std::sqrt(fall / before) : fall / before);
  const double rough = std::min(1.0, 16.0 * rho2 * rho2);  // 1 from rho = 1/2 on
  return h * std::sqrt(std::max(b3, rho2 * b2)) * (std::max(kShareOfLast<N>, rough) * h + rough * rough * kRally);
}
}  // namespace ping_pong
