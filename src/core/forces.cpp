#include "ping_pong_sim/forces.h"

#include <algorithm>
#include <cmath>

namespace ping_pong
{
namespace
{
// Index of the interval of `nodes` that holds x, and how far x is along it; clamped to the ends.
struct Place
{
  std::size_t index;
  double part;
};

Place placeIn(const std::vector<double>& nodes, double x)
{
  if (nodes.size() < 2 || x <= nodes.front()) return {0, 0.0};
  if (x >= nodes.back()) return {nodes.size() - 2, 1.0};
  const auto above = std::upper_bound(nodes.begin(), nodes.end(), x);
  const std::size_t i = static_cast<std::size_t>(above - nodes.begin()) - 1;
  return {i, (x - nodes[i]) / (nodes[i + 1] - nodes[i])};
}

double tableLift(const LiftLaw& law, double S)
{
  if (S <= law.spin_ratio.front()) return law.values.front() / law.spin_ratio.front();
  const Place at = placeIn(law.spin_ratio, S);
  const std::size_t next = std::min(at.index + 1, law.values.size() - 1);
  return ((1.0 - at.part) * law.values[at.index] + at.part * law.values[next]) / S;
}
}  // namespace

double DragLaw::at(double reynolds_number, double spin_ratio_now) const
{
  if (values.empty()) return constant;
  const Place row = placeIn(reynolds, reynolds_number);
  const Place column = placeIn(spin_ratio, spin_ratio_now);
  const std::size_t columns = spin_ratio.size();
  const std::size_t next_row = std::min(row.index + 1, reynolds.size() - 1);
  const std::size_t next_column = std::min(column.index + 1, columns - 1);
  const auto between = [&](std::size_t r) {
    return (1.0 - column.part) * values[r * columns + column.index] + column.part * values[r * columns + next_column];
  };
  return (1.0 - row.part) * between(row.index) + row.part * between(next_row);
}

double LiftLaw::perSpinRatio(double S) const
{
  switch (kind)
  {
    case Kind::Linear:
      return slope;
    case Kind::Saturating:
      return slope / (1.0 + saturation * S);
    case Kind::Constant:
      return constant / S;
    case Kind::Table:
      break;
  }
  return tableLift(*this, S);
}

double airDensity(double temperature, double altitude)
{
  constexpr double kPressure = 101325.0;     // p0 [Pa]
  constexpr double kSeaTemperature = 288.15; // T0 of the standard atmosphere [K]
  constexpr double kLapse = 0.0065;          // L [K/m]
  constexpr double kExponent = 5.2559;       // g M / (R L)
  constexpr double kGasConstant = 287.05;    // R / M of dry air [J/(kg K)]
  const double pressure = kPressure * std::pow(1.0 - kLapse * altitude / kSeaTemperature, kExponent);
  return pressure / (kGasConstant * temperature);
}

FlightModel::FlightModel(const Forces& forces, const BallParams& ball) : forces_(forces), radius_(ball.radius)
{
  const double area = M_PI * ball.radius * ball.radius;
  const double displaced = forces.air_density * 4.0 / 3.0 * area * ball.radius;  // mass of the displaced air [kg]
  const double inertial = ball.mass + (forces.added_mass ? 0.5 * displaced : 0.0);
  const double heavy = ball.mass - (forces.buoyancy ? displaced : 0.0);
  gravity_ = heavy / inertial * forces.gravity;
  drag_ = forces.drag ? 0.5 * forces.air_density * area / inertial : 0.0;
  lift_ = forces.magnus ? 0.5 * forces.air_density * area * ball.radius / inertial : 0.0;
}

Vector3d FlightModel::acceleration(const Vector3d& v_WB, const Vector3d& w_WB) const
{
  if (constant()) return gravity_;
  const Vector3d u = v_WB - forces_.wind;
  const double speed = u.norm();
  if (speed == 0.0) return gravity_;  // no flow: neither drag nor lift, whatever the spin
  const double S = radius_ * w_WB.norm() / speed;
  Vector3d a = gravity_;
  if (forces_.drag)
    a -= drag_ * forces_.drag_law.at(2.0 * radius_ * speed / forces_.air_viscosity, S) * speed * u;
  if (forces_.magnus && S > 0.0) a += lift_ * forces_.lift_law.perSpinRatio(S) * w_WB.cross(u);
  return a;
}

double FlightModel::rate(const Vector3d& v_WB, const Vector3d& w_WB) const
{
  const Vector3d u = v_WB - forces_.wind;
  const double speed = u.norm() + 0.1 * gravity_.norm();  // it will be that fast soon
  const double spin = w_WB.norm();
  const double turn = spin > 0.0 ? lift_ * forces_.lift_law.perSpinRatio(radius_ * spin / speed) * spin : 0.0;
  return 2.0 * drag_ * speed + turn + 1e-3;
}
}  // namespace ping_pong
