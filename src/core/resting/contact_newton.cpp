#include "resting/contact_newton.h"

#include <Eigen/QR>
#include <cmath>

#include "resting/contact_equations.h"

namespace ping_pong
{
namespace
{
constexpr int kMaxRounds = 20;      // a bound: near the answer each doubles the digits
constexpr double kMet = 1e-14;      // what is left, as a part of the scale of accelerations and forces
constexpr double kNoPivot = 1e-12;  // forces that hold each other stay as they are

// x - projection(x - w(x)) and its derivative, row by row.
struct Remainder
{
  const ContactProblem& problem;
  const Unknowns& x;
  const Unknowns& w;     // accelerations against what is wanted
  const Square& matrix;  // dw/dx
  Unknowns value;
  Square slope;

  Remainder(const ContactProblem& its_problem, const Unknowns& forces, const Unknowns& accelerations,
            const Square& its_matrix)
      : problem(its_problem),
        x(forces),
        w(accelerations),
        matrix(its_matrix),
        value(forces.size()),
        slope(forces.size(), forces.size())
  {
    int next = 0;
    for (std::size_t i = 0; i < problem.count; ++i)
    {
      const SupportMode& mode = problem.mode[i];
      const Surface& law = *problem.law[i];
      const int load = next;
      addLoad(next++);
      if (mode.slip == Resistance::Holds)
        addLimited<2>(next, load, frictionLimit(law, 1.0), 1.0 / (1.0 + 1.0 / problem.k));
      if (mode.roll == Resistance::Holds) addLimited<2>(next, load, rollLimit(law, problem.k, 1.0), 1.0);
      if (mode.spin == Resistance::Holds) addLimited<1>(next, load, spinLimit(law, problem.k, 1.0), 1.0);
    }
  }

  void keep(int row)
  {
    value[row] = x[row];
    slope.row(row).setZero();
    slope(row, row) = 1.0;
  }

  void addLoad(int row)
  {
    if (x[row] - w[row] <= 0.0) return keep(row);
    value[row] = w[row];
    slope.row(row) = matrix.row(row);
  }

  // Within `coefficient` times the load.
  template <int kSize>
  void addLimited(int& next, int load, double coefficient, double compliance)
  {
    using Part = Eigen::Matrix<double, kSize, 1>;
    const int row = next;
    next += kSize;
    if (x[load] <= 0.0)
    {
      for (int i = 0; i < kSize; ++i) keep(row + i);
      return;
    }
    const Part wanted = x.segment<kSize>(row) - compliance * w.segment<kSize>(row);
    const double size = wanted.norm(), limit = coefficient * x[load];
    if (size <= limit)
    {
      value.segment<kSize>(row) = compliance * w.segment<kSize>(row);
      slope.middleRows<kSize>(row) = compliance * matrix.middleRows<kSize>(row);
      return;
    }
    const Part along = wanted / size;
    const Eigen::Matrix<double, kSize, kSize> turns =
        limit / size * (Eigen::Matrix<double, kSize, kSize>::Identity() - along * along.transpose());
    value.segment<kSize>(row) = x.segment<kSize>(row) - limit * along;
    slope.middleRows<kSize>(row) = compliance * turns * matrix.middleRows<kSize>(row);
    slope.block<kSize, kSize>(row, row) += Eigen::Matrix<double, kSize, kSize>::Identity() - turns;
    slope.block<kSize, 1>(row, load) -= coefficient * along;
  }
};
}  // namespace

bool polishForces(const ContactProblem& given, BallAcceleration& motion, SupportForces& forces)
{
  ContactProblem problem = given;
  for (std::size_t i = 0; i < problem.count; ++i) problem.mode[i].loaded = true;
  const ContactEquations equations(problem);
  const Square matrix = equations.matrix();
  const double scale = scaleOf(problem);
  Unknowns x = unknownsOf(problem, forces);
  Eigen::CompleteOrthogonalDecomposition<Square> solver;
  solver.setThreshold(kNoPivot);
  for (int round = 0; round < kMaxRounds; ++round)
  {
    const Unknowns w = -equations.missing(problem, x);
    const Remainder remainder(problem, x, w, matrix);
    const double left = remainder.value.norm();
    if (left <= kMet * (scale + x.norm()))
    {
      motion = equations.motion(problem, x);
      forces = forcesOf(problem, x);
      return true;
    }
    if (!(left < 1e9 * scale)) return false;
    solver.compute(remainder.slope);
    x -= solver.solve(remainder.value);
  }
  return false;
}
}  // namespace ping_pong
