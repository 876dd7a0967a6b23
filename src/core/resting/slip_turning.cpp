#include "resting/slip_turning.h"

#include <Eigen/LU>

namespace ping_pong
{
namespace
{
constexpr double kSmallTurn = 1e-6;  // [rad], for a difference quotient
constexpr double kBegun = 1e-12;     // a slip that has hardly begun keeps the direction in which it begins [m/s]

// Turns the direction of what slips; returns the size of the motion by which it is known, 0 if it does not slip.
double turnAlong(Resistance kind, const Vector3d& value, Vector3d& direction)
{
  if (kind != Resistance::Slips) return 0.0;
  const Vector3d toward = value + kBegun * direction;
  direction = toward.normalized();
  return toward.norm();
}

Eigen::Matrix<double, 6, 1> stacked(const Vector3d& a, const Vector3d& b)
{
  Eigen::Matrix<double, 6, 1> both;
  both << a, b;
  return both;
}
}  // namespace

const GaussPoints<kNodes>& gaussPoints()
{
  static const GaussPoints<kNodes> points;
  return points;
}

Eigen::Matrix<double, 1, 6> SlipTurning::ratesAt(int node, const BallMotion& ball)
{
  const ContactProblem& start = decision_.problem;
  ContactProblem problem = problemAt(constrained_, ball, t_ + h_ * gaussPoints().nodes[node]);
  std::array<double, kMaxSupports> slips{}, rolls{};
  for (std::size_t i = 0; i < problem.count; ++i)
  {
    SupportPoint& at = problem.at[i];
    SupportMode& mode = problem.mode[i];
    mode = start.mode[i];
    slips[i] = turnAlong(mode.slip, at.slip, mode.slip_direction);
    rolls[i] = turnAlong(mode.roll, at.roll, mode.roll_direction);
    // What rounding, or a stop, has left of speeds that are held at zero ends with the piece.
    if (mode.slip == Resistance::Holds) at.slip_bias += start.at[i].slip / h_;
    if (mode.roll == Resistance::Holds) at.roll_bias += start.at[i].roll / h_;
    if (mode.spin == Resistance::Holds) at.spin_bias += start.at[i].spin / h_;
  }
  const BallAcceleration now = accelerationInModes(problem, decision_.forces);
  const Eigen::Matrix<double, 6, 1> rates = stacked(now.a, now.b);
  count_ = 0;
  for (std::size_t i = 0; i < problem.count; ++i)
  {
    if (slips[i] > 0.0) addAngle(node, problem, rates, i, false, slips[i]);
    if (rolls[i] > 0.0) addAngle(node, problem, rates, i, true, rolls[i]);
  }
  return rates.transpose();
}

void SlipTurning::addAngle(int node, const ContactProblem& problem, const Eigen::Matrix<double, 6, 1>& rates,
                           std::size_t support, bool of_roll, double size)
{
  if (count_ == kMost) return;
  ContactProblem turned = problem;
  SupportMode& mode = turned.mode[support];
  Vector3d& direction = of_roll ? mode.roll_direction : mode.slip_direction;
  const Vector3d along = direction, across = problem.at[support].n.cross(along);
  direction += kSmallTurn * across;
  const BallAcceleration then = accelerationInModes(turned, decision_.forces);
  Angle& angle = angles_[node][count_++];
  // slip = (v - s x n - u)_t: across it, across.v + along.s
  angle.of_speeds = of_roll ? stacked(Vector3d::Zero(), across / size) : stacked(across / size, along / size);
  angle.to_rates = (stacked(then.a, then.b) - rates) / kSmallTurn;
}

void SlipTurning::correct(const Speeds& missed, Rates& rates) const
{
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kNodes * kMost, kNodes * kMost>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kNodes * kMost, 1>;
  const int each = count_, all = kNodes * each;
  if (all == 0) return;
  Square matrix = Square::Identity(all, all);
  Column turns(all);
  for (int row = 0; row < all; ++row)
  {
    const int i = row / each;
    const Angle& angle = angles_[i][row % each];
    turns[row] = missed.row(i).dot(angle.of_speeds);
    for (int column = 0; column < all; ++column)
    {
      const int j = column / each;
      matrix(row, column) -=
          h_ * gaussPoints().integral(i, j) * angle.of_speeds.dot(angles_[j][column % each].to_rates);
    }
  }
  turns = matrix.partialPivLu().solve(turns).eval();
  for (int row = 0; row < all; ++row)
    rates.row(row / each) += turns[row] * angles_[row / each][row % each].to_rates.transpose();
}
}  // namespace ping_pong
