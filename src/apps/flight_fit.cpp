#include "flight_fit.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "ping_pong_sim/world.h"

namespace ping_pong
{
namespace
{
using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1>;
using Jacobian = Eigen::MatrixXd;

constexpr double kSpinUnit = 100.0;   // [rad/s]; so that all unknowns have about the same weight
constexpr double kDifference = 1e-4;  // for derivatives
constexpr int kMostSteps = 60;
constexpr double kTolerance = 1e-7;  // of the forward model [m]

BallState stateOf(const Unknowns& x)
{
  BallState state;
  state.p_WB = x.head<3>();
  state.v_WB = x.segment<3>(3);
  if (x.size() == 9) state.w_WB = kSpinUnit * x.tail<3>();
  return state;
}

class Problem
{
public:
  Problem(const Flight& flight, std::size_t samples, const FlightChoice& model)
      : flight_(flight), samples_(samples), scene_(tableScene(model.forces, model.table, kTolerance))
  {
  }

  // Measured - model, three numbers a sample.
  Eigen::VectorXd residuals(const Unknowns& x)
  {
    scene_.balls[0].state = stateOf(x);
    World world(scene_);
    Eigen::VectorXd r(3 * samples_);
    for (std::size_t i = 0; i < samples_; ++i)
    {
      if (flight_.times[i] > world.time()) world.advance(flight_.times[i] - world.time());
      r.segment<3>(3 * i) = flight_.positions[i] - world.ballState(0).p_WB;
    }
    return r;
  }

  Jacobian derivatives(const Unknowns& x)
  {
    Jacobian J(3 * samples_, x.size());
    for (int k = 0; k < x.size(); ++k)
    {
      Unknowns more = x, less = x;
      more[k] += kDifference;
      less[k] -= kDifference;
      J.col(k) = (residuals(more) - residuals(less)) / (2.0 * kDifference);
    }
    return J;
  }

private:
  const Flight& flight_;
  std::size_t samples_;
  Scene scene_;
};

// Velocity at the first sample from a parabola through the first tenth of a second.
Unknowns firstGuess(const Flight& flight, std::size_t samples, bool spin)
{
  Unknowns x = Unknowns::Zero(spin ? 9 : 6);
  const std::size_t few = std::min<std::size_t>(samples, 18);
  Eigen::MatrixXd powers(few, 3), positions(few, 3);
  for (std::size_t i = 0; i < few; ++i)
  {
    powers.row(i) << 1.0, flight.times[i], flight.times[i] * flight.times[i];
    positions.row(i) = flight.positions[i].transpose();
  }
  const Eigen::Matrix3d normal = powers.transpose() * powers;
  const Eigen::Matrix3d c = normal.ldlt().solve(powers.transpose() * positions);
  x.head<3>() = c.row(0).transpose();
  x.segment<3>(3) = c.row(1).transpose();
  return x;
}

double descend(Problem& problem, Unknowns& x)
{
  Eigen::VectorXd r = problem.residuals(x);
  double damping = 1e-3;
  for (int step = 0; step < kMostSteps && damping < 1e9; ++step)
  {
    const Jacobian J = problem.derivatives(x);
    const Eigen::MatrixXd A = J.transpose() * J;
    const Eigen::VectorXd b = -J.transpose() * r;
    double gain = 0.0;
    for (; damping < 1e9; damping *= 8.0)
    {
      Eigen::MatrixXd damped = A;
      damped.diagonal() += damping * (A.diagonal() + Eigen::VectorXd::Constant(x.size(), 1e-6 * A.trace()));
      const Unknowns next = x + damped.ldlt().solve(b);
      const Eigen::VectorXd r_next = problem.residuals(next);
      if (!(r_next.squaredNorm() < r.squaredNorm())) continue;
      gain = 1.0 - r_next.squaredNorm() / r.squaredNorm();
      x = next;
      r = r_next;
      damping = std::max(1e-7, damping / 8.0);
      break;
    }
    if (gain < 1e-7) break;
  }
  return r.squaredNorm();
}
}  // namespace

FlightFit fitFlight(const Flight& flight, std::size_t samples, const FlightChoice& model, bool spin)
{
  Problem problem(flight, samples, model);
  const Unknowns guess = firstGuess(flight, samples, spin);
  Unknowns best = guess;
  double least = std::numeric_limits<double>::infinity();
  for (const double start : {0.0, -1.5, 1.5})  // spin about y to begin with: back, top
  {
    if (!spin && start != 0.0) break;
    Unknowns x = guess;
    if (spin) x[7] = start;
    const double sum = descend(problem, x);
    if (sum < least) best = x;
    least = std::min(least, sum);
  }
  FlightFit fit;
  fit.start = stateOf(best);
  fit.misfit = std::sqrt(least / (3.0 * samples));
  const Eigen::VectorXd r = problem.residuals(best);
  for (std::size_t i = 0; i < samples; ++i) fit.residuals.push_back(r.segment<3>(3 * i));
  return fit;
}
}  // namespace ping_pong
