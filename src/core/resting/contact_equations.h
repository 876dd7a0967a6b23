// The equations of a ball on its supports: what each load, friction and resistance does to its motion.
#pragma once

#include <Eigen/Core>

#include "resting/contact_problem.h"

namespace ping_pong
{
inline constexpr int kMostUnknowns = 6 * kMaxSupports;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMostUnknowns, kMostUnknowns>;
using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMostUnknowns, 1>;
using Effect = Eigen::Matrix<double, 6, 1>;  ///< on (a, b)
using Effects = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, kMostUnknowns>;

/// Of the loaded supports of a problem. The unknowns of each, in this order: its load, with all resistances that slip; then
/// friction (2), rolling resistance (2) and spin friction (1), as far as they hold.
struct ContactEquations
{
  Effects rows, columns;  ///< row.(a, b) = wanted; a column is what one unknown does
  Unknowns wanted;
  int count = 0;

  explicit ContactEquations(const ContactProblem& problem);
  BallAcceleration motion(const ContactProblem& problem, const Unknowns& forces) const;
  /// What is missing of the wanted accelerations under these forces.
  Unknowns missing(const ContactProblem& problem, const Unknowns& forces) const;
  Square matrix() const { return rows.leftCols(count).transpose() * columns.leftCols(count); }

private:
  void add(const Effect& row, double its_wanted, const Effect& column);
  void addSupport(const ContactProblem& problem, std::size_t i);
};

/// Directions in which the tangential unknowns of a support are counted.
std::array<Vector3d, 2> tangentsOf(const Vector3d& n);

/// How many a loaded support has.
int unknownsAt(const ContactProblem& problem, std::size_t i);
Unknowns unknownsOf(const ContactProblem& problem, const SupportForces& forces);
/// The forces of support i among the unknowns, from `next` on, which goes on to those of the next support.
SupportForce forceOf(const ContactProblem& problem, std::size_t i, const Unknowns& forces, int& next);
/// Of all supports; those that are not loaded have none.
SupportForces forcesOf(const ContactProblem& problem, const Unknowns& forces);
}  // namespace ping_pong
