// Accelerations at the nodes of a constrained piece, with friction that turns with the slip.
//
// A slow slip u turns fast: a change of it by du across turns friction by du / |u|. Iterations with the friction of the last
// round (Picard) then only converge on pieces shorter than |u| / (mu g), and a slip that has just begun would be
// followed in pieces of microseconds. Newton's method on the angles alone, one per slipping resistance and node, has no such
// limit; all else is left to the iteration.
#pragma once

#include "evolve/gauss_points.h"
#include "resting/constrained_ball.h"

namespace ping_pong
{
inline constexpr int kNodes = 8;
using Rates = Eigen::Matrix<double, kNodes, 6>;   ///< (a, b) at the nodes, a row each
using Speeds = Eigen::Matrix<double, kNodes, 6>;  ///< (v, s) at the nodes

const GaussPoints<kNodes>& gaussPoints();

/// Of one piece.
class SlipTurning
{
public:
  /// @param decision  at the start t of the piece: its modes hold all along
  /// @param h         length of the piece [s]
  SlipTurning(const ConstrainedBall& constrained, const Decision& decision, double t, double h)
      : constrained_(constrained), decision_(decision), t_(t), h_(h)
  {
  }

  /// (a, b) under the modes of the start, with friction against the motion at this node.
  Eigen::Matrix<double, 1, 6> ratesAt(int node, const BallMotion& ball);

  /// Newton's step on the angles of friction.
  /// @param missed  what the rates make of the speeds, less those with which ratesAt() found them
  /// @param rates   of all nodes; friction in them is turned as the speeds to which they lead would have it
  void correct(const Speeds& missed, Rates& rates) const;

private:
  static constexpr int kMost = 4;  // angles at a node: of more, the first
  // How one angle turns with the speeds, and what turning does to the rates.
  struct Angle
  {
    Eigen::Matrix<double, 6, 1> of_speeds, to_rates;
  };

  void addAngle(int node, const ContactProblem& problem, const Eigen::Matrix<double, 6, 1>& rates, std::size_t support,
                bool of_roll, double size);

  const ConstrainedBall& constrained_;
  const Decision& decision_;
  double t_, h_;
  std::array<std::array<Angle, kMost>, kNodes> angles_;
  int count_ = 0;  // at each node
};
}  // namespace ping_pong
