#include "contact_law.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>

namespace ping_pong::stability
{
namespace
{
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Columns = Eigen::Matrix<double, 6, Eigen::Dynamic>;

constexpr double kGrips = 1e-7;     // less slip is none, beside what the tolerance permits [m/s]
constexpr double kSlides = 1e-4;    // more is sliding [m/s]
constexpr double kRolls = 1e-4;     // slower one cannot tell where to [m/s]
constexpr double kSteady = 0.9999;  // cosine between directions at both ends
constexpr int kTries = 200;

// One contact: the directions of its force and torque per mass, and what limits them.
struct Contact6
{
  Eigen::Index first = 0;  // its column of the load; two of friction follow if it grips
  bool grips = false;
  double friction = 0.0;
};

struct Way
{
  Vector3d direction = Vector3d::Zero();
  bool none = false;    // nothing moves
  bool steady = false;  // it moves, and in one direction
};

Way wayOf(const Vector3d& a, const Vector3d& b, double none, double some)
{
  Way way;
  way.none = a.norm() <= none && b.norm() <= none;
  way.steady = a.norm() > some && b.norm() > some && a.dot(b) > kSteady * a.norm() * b.norm();
  if (way.steady) way.direction = (a + b).normalized();
  return way;
}

// Force f at the touching point: on the velocity, and on k r w.
Vector6d pushAt(const Vector3d& n, const Vector3d& f)
{
  Vector6d push;
  push << f, -n.cross(f);
  return push;
}

class Explanation
{
public:
  Explanation(const Scene& scene, const Moment& before, const Moment& after)
      : scene_(scene), before_(before), after_(after), none_(kGrips + scene.tolerance), ball_(scene.balls[0].params)
  {
  }

  std::optional<double> leftOver();

private:
  const Surface& lawOf(const Touch& touch) const
  {
    return scene_.surfaces.at(ball_.material, scene_.bodies[touch.of.body].shapes[touch.of.shape].material);
  }
  bool add(std::size_t i);
  bool addResistance(const Surface& law, std::size_t i, const Vector3d& n);
  Vector6d felt(double spin_decay) const;
  double unexplained(const Vector6d& felt) const;
  double worstLimit(const Eigen::VectorXd& forces) const;

  const Scene& scene_;
  const Moment& before_;
  const Moment& after_;
  double none_;  // [m/s]
  const BallParams& ball_;
  Columns columns_ = Columns(6, 0);
  std::vector<Contact6> contacts_;
};

void append(Columns& columns, const Vector6d& column)
{
  columns.conservativeResize(6, columns.cols() + 1);
  columns.rightCols<1>() = column;
}

// What the surfaces did: per mass, without the forces of the air.
Vector6d Explanation::felt(double spin_decay) const
{
  const double h = after_.time - before_.time;
  const Vector3d v = 0.5 * (before_.ball.v_WB + after_.ball.v_WB), w = 0.5 * (before_.ball.w_WB + after_.ball.w_WB);
  const Vector3d a = (after_.ball.v_WB - before_.ball.v_WB) / h;
  const Vector3d alpha = (after_.ball.w_WB - before_.ball.w_WB) / h + spin_decay * w;
  Vector6d all;
  all << a - FlightModel(scene_.forces, ball_).acceleration(v, w), ball_.inertia * ball_.radius * alpha;
  return all;
}

// Torques that a single gripping contact has besides; they go with its load.
bool Explanation::addResistance(const Surface& law, std::size_t i, const Vector3d& n)
{
  if (law.rolling_resistance == 0.0 && law.spin_friction == 0.0) return true;
  if (before_.touching.size() > 1 || before_.touching[i].turns) return false;
  const auto over = [&](const Moment& moment) -> Vector3d { return moment.ball.v_WB - moment.touching[i].u_WC; };
  const Way rolling = wayOf(over(before_), over(after_), 0.0, kRolls);
  const Way turning = wayOf(n.dot(before_.ball.w_WB) * n, n.dot(after_.ball.w_WB) * n, 0.0, kRolls);
  if ((law.rolling_resistance > 0.0 && !rolling.steady) || (law.spin_friction > 0.0 && !turning.steady)) return false;
  const Vector3d torque = (1.0 + ball_.inertia) * law.rolling_resistance * n.cross(rolling.direction) +
                          law.spin_friction * turning.direction;
  columns_.col(contacts_[0].first).tail<3>() -= torque;
  return true;
}

// False where one cannot tell.
bool Explanation::add(std::size_t i)
{
  const Touch &from = before_.touching[i], &to = after_.touching[i];
  const Surface& law = lawOf(from);
  const Vector3d n = (from.n_W + to.n_W).normalized();
  const Way slip =
      wayOf(slipOf(from, before_.ball, ball_.radius), slipOf(to, after_.ball, ball_.radius), none_, kSlides);
  Contact6 contact;
  contact.first = columns_.cols();
  contact.friction = law.friction;
  contact.grips = law.friction > 0.0 && slip.none;
  contacts_.push_back(contact);
  if (law.friction == 0.0)
  {
    append(columns_, pushAt(n, n));
    return true;
  }
  if (contact.grips)
  {
    const Vector3d t = n.unitOrthogonal();
    append(columns_, pushAt(n, n));
    append(columns_, pushAt(n, t));
    append(columns_, pushAt(n, n.cross(t)));
    return addResistance(law, i, n);
  }
  if (!slip.steady || !std::isfinite(law.friction)) return false;
  if (law.rolling_resistance > 0.0 || law.spin_friction > 0.0) return false;
  append(columns_, pushAt(n, n - law.friction * slip.direction));
  return true;
}

// By how much loads pull, and frictions are more than they can be.
double Explanation::worstLimit(const Eigen::VectorXd& forces) const
{
  double worst = 0.0;
  for (const Contact6& contact : contacts_)
  {
    const double load = forces[contact.first];
    worst = std::max(worst, -load);
    if (contact.grips && std::isfinite(contact.friction))
      worst = std::max(worst, forces.segment<2>(contact.first + 1).norm() - contact.friction * std::max(load, 0.0));
  }
  return worst;
}

double Explanation::unexplained(const Vector6d& felt) const
{
  const Eigen::JacobiSVD<Columns> svd(columns_, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Index rank = (svd.singularValues().array() > 1e-6).count(), free = columns_.cols() - rank;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(columns_.cols());
  for (Eigen::Index k = 0; k < rank; ++k)
    forces += svd.matrixU().col(k).dot(felt) / svd.singularValues()[k] * svd.matrixV().col(k);
  const double rest = (columns_ * forces - felt).norm();
  if (free == 0) return std::max(rest, worstLimit(forces));
  if (free > 1) return rest;
  // Two gripping contacts can push against each other: any such push will do that keeps the limits, which are convex in
  // it.
  const Eigen::VectorXd push = svd.matrixV().col(rank);
  double low = -1e3 * felt.norm(), high = -low;
  for (int i = 0; i < kTries; ++i)
  {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    if (worstLimit(forces + a * push) < worstLimit(forces + b * push))
      high = b;
    else
      low = a;
  }
  return std::max(rest, worstLimit(forces + low * push));
}

std::optional<double> Explanation::leftOver()
{
  if (before_.touching.empty() || !sameTouches(before_, after_)) return std::nullopt;
  for (std::size_t i = 0; i < before_.touching.size(); ++i)
    if (!add(i)) return std::nullopt;
  const Vector6d without = felt(0.0), with = felt(scene_.forces.spin_decay);
  const double scale = with.norm() + scene_.forces.gravity.norm();
  // Air slows the spin of a ball in contact, too; that this is left out is allowed.
  return std::min(unexplained(with), unexplained(without)) / scale;
}
}  // namespace

std::optional<double> againstTheLaw(const Scene& scene, const Moment& before, const Moment& after)
{
  return Explanation(scene, before, after).leftOver();
}
}  // namespace ping_pong::stability
