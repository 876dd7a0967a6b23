#include <algorithm>
#include <cmath>
#include <limits>

#include "base/law_counter.h"
#include "ping_pong_sim/forces.h"

namespace ping_pong
{
namespace
{
// Index of the interval of `nodes` that holds x, and how far x is along it; clamped to the ends.
struct TableCell
{
  std::size_t index;
  double part;
};

TableCell cellIn(const std::vector<double>& nodes, double x)
{
  if (nodes.size() < 2 || x <= nodes.front()) return {0, 0.0};
  if (x >= nodes.back()) return {nodes.size() - 2, 1.0};
  const auto above = std::upper_bound(nodes.begin(), nodes.end(), x);
  const std::size_t i = static_cast<std::size_t>(above - nodes.begin()) - 1;
  return {i, (x - nodes[i]) / (nodes[i + 1] - nodes[i])};
}

double tableLift(const LiftLaw& law, double S)
{
  count(Law::LiftTable);
  if (S <= law.spin_ratio.front()) return law.values.front() / law.spin_ratio.front();
  const TableCell at = cellIn(law.spin_ratio, S);
  const std::size_t next = std::min(at.index + 1, law.values.size() - 1);
  return ((1.0 - at.part) * law.values[at.index] + at.part * law.values[next]) / S;
}
}  // namespace

DragLaw DragLaw::constant(double C_D)
{
  DragLaw law;
  law.without_spin = law.with_spin = C_D;
  return law;
}

double DragLaw::at(double reynolds_number, double spin_ratio_now) const
{
  const double S2 = spin_ratio_now * spin_ratio_now;
  if (values.empty()) return without_spin + (with_spin - without_spin) * S2 / (S2 + half_at * half_at);
  count(Law::DragTable);
  const TableCell row = cellIn(reynolds, reynolds_number);
  const TableCell column = cellIn(spin_ratio, spin_ratio_now);
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
  constexpr double kPressure = 101325.0;      // p0 [Pa]
  constexpr double kSeaTemperature = 288.15;  // T0 of the standard atmosphere [K]
  constexpr double kLapse = 0.0065;           // L [K/m]
  constexpr double kExponent = 5.2559;        // g M / (R L)
  constexpr double kGasConstant = 287.05;     // R / M of dry air [J/(kg K)]
  const double pressure = kPressure * std::pow(1.0 - kLapse * altitude / kSeaTemperature, kExponent);
  return pressure / (kGasConstant * temperature);
}

FlightModel::FlightModel(const Forces& forces, const BallParams& ball) : forces_(&forces), radius_(ball.radius)
{
  count(Law::FlightModel);
  const double area = M_PI * ball.radius * ball.radius;
  const double displaced = forces.air_density * 4.0 / 3.0 * area * ball.radius;  // mass of the displaced air [kg]
  const double inertial = ball.mass + (forces.added_mass ? 0.5 * displaced : 0.0);
  const double heavy = ball.mass - (forces.buoyancy ? displaced : 0.0);
  gravity_ = heavy / inertial * forces.gravity;
  drag_ = forces.drag ? 0.5 * forces.air_density * area / inertial : 0.0;
  spin_ratio_ =
      (forces.drag && forces.drag_law.feelsSpin()) || (forces.magnus && forces.lift_law.kind != LiftLaw::Kind::Linear);
  lift_ = forces.magnus ? 0.5 * forces.air_density * area * ball.radius / inertial : 0.0;
}

// r w, or 0 where no law asks for the spin ratio.
EIGEN_STRONG_INLINE double FlightModel::rimSpeed(const Vector3d& w_WB) const
{
  if (!spin_ratio_) return 0.0;
  count(Law::SpinRatio);
  return radius_ * w_WB.norm();
}

// k_D C_D |u| for speeds through the air, their squares and surface speeds r w [1/s]. Without air speed there is no drag. (The
// quotient is of squares: it does not wait for the root.)
template <int N>
EIGEN_STRONG_INLINE FlightModel::Column<N> FlightModel::dragFactors(const Column<N>& speed, const Column<N>& speed2,
                                                                    const Column<N>& rim) const
{
  count(Law::Drag, N);
  const DragLaw& law = forces_->drag_law;
  if (law.values.empty())
  {
    if (law.with_spin == law.without_spin) return drag_ * law.without_spin * speed;
    const Column<N> rim2 = rim * rim;
    const Column<N> way = rim2 / (rim2 + law.half_at * law.half_at * speed2 + std::numeric_limits<double>::min());
    return drag_ * (law.without_spin + (law.with_spin - law.without_spin) * way) * speed;
  }
  Column<N> factors;
  for (int i = 0; i < N; ++i)
  {
    const double reynolds = 2.0 * radius_ * speed[i] / forces_->air_viscosity;
    factors[i] = speed[i] > 0.0 ? drag_ * law.at(reynolds, rim[i] / speed[i]) * speed[i] : 0.0;
  }
  return factors;
}

// k_L C_L / S. Without air speed or spin there is no lift.
template <int N>
EIGEN_STRONG_INLINE FlightModel::Column<N> FlightModel::liftFactors(const Column<N>& speed, const Column<N>& rim) const
{
  count(Law::Lift, N);
  const LiftLaw& law = forces_->lift_law;
  if (law.kind == LiftLaw::Kind::Linear) return Column<N>::Constant(lift_ * law.slope);
  if (law.kind == LiftLaw::Kind::Saturating)
    return lift_ * law.slope * speed / (speed + law.saturation * rim + std::numeric_limits<double>::min());
  Column<N> factors;
  for (int i = 0; i < N; ++i)
    factors[i] = speed[i] > 0.0 && rim[i] > 0.0 ? lift_ * law.perSpinRatio(rim[i] / speed[i]) : 0.0;
  return factors;
}

template <int N>
FlightModel::Rows<N> FlightModel::accelerations(const Rows<N>& v_WB, const Vector3d& w_WB, const Column<N>& fade) const
{
  const Vector3d& wind = forces_->wind;
  const Column<N> x = v_WB.col(0).array() - wind.x();
  const Column<N> y = v_WB.col(1).array() - wind.y();
  const Column<N> z = v_WB.col(2).array() - wind.z();
  const Column<N> speed2 = x * x + y * y + z * z;
  const Column<N> speed = speed2.sqrt();
  const Column<N> rim = rimSpeed(w_WB) * fade;
  Rows<N> a = gravity_.transpose().template replicate<N, 1>();
  if (forces_->drag)
  {
    const Column<N> k = dragFactors<N>(speed, speed2, rim);
    a.col(0).array() -= k * x;
    a.col(1).array() -= k * y;
    a.col(2).array() -= k * z;
  }
  if (forces_->magnus)
  {
    const Column<N> k = liftFactors<N>(speed, rim) * fade;
    a.col(0).array() += k * (w_WB.y() * z - w_WB.z() * y);
    a.col(1).array() += k * (w_WB.z() * x - w_WB.x() * z);
    a.col(2).array() += k * (w_WB.x() * y - w_WB.y() * x);
  }
  return a;
}

template FlightModel::Rows<4> FlightModel::accelerations<4>(const Rows<4>&, const Vector3d&, const Column<4>&) const;
template FlightModel::Rows<6> FlightModel::accelerations<6>(const Rows<6>&, const Vector3d&, const Column<6>&) const;
template FlightModel::Rows<8> FlightModel::accelerations<8>(const Rows<8>&, const Vector3d&, const Column<8>&) const;

Vector3d FlightModel::acceleration(const Vector3d& v_WB, const Vector3d& w_WB) const
{
  if (constant())
  {
    count(Law::ConstantAcceleration);
    return gravity_;
  }
  const Vector3d u = v_WB - forces_->wind;
  const Column<1> speed2(u.squaredNorm());
  const Column<1> speed = speed2.sqrt();
  const Column<1> rim(rimSpeed(w_WB));
  Vector3d a = gravity_;
  if (forces_->drag) a -= dragFactors<1>(speed, speed2, rim)[0] * u;
  if (forces_->magnus) a += liftFactors<1>(speed, rim)[0] * w_WB.cross(u);
  return a;
}

std::size_t FlightModel::smoothRegion(const Vector3d& v_WB, const Vector3d& w_WB) const
{
  const auto below = [](const std::vector<double>& nodes, double x)
  { return static_cast<std::size_t>(std::upper_bound(nodes.begin(), nodes.end(), x) - nodes.begin()); };
  const double speed = (v_WB - forces_->wind).norm();
  const double S = rimSpeed(w_WB) / speed;
  std::size_t region = 0;
  if (forces_->drag && !forces_->drag_law.values.empty())
  {
    const DragLaw& law = forces_->drag_law;
    region = below(law.reynolds, 2.0 * radius_ * speed / forces_->air_viscosity) * (law.spin_ratio.size() + 1) +
             below(law.spin_ratio, S);
  }
  if (forces_->magnus && forces_->lift_law.kind == LiftLaw::Kind::Table)
    region = region * (forces_->lift_law.spin_ratio.size() + 1) + below(forces_->lift_law.spin_ratio, S);
  return region;
}

double FlightModel::rate(const Vector3d& v_WB, const Vector3d& w_WB) const
{
  const Vector3d u = v_WB - forces_->wind;
  const Column<1> speed(u.norm() + 0.1 * gravity_.norm());  // it will be that fast soon
  const Column<1> rim(rimSpeed(w_WB));
  double rate = 1e-3;
  if (forces_->drag) rate += 2.0 * dragFactors<1>(speed, speed * speed, rim)[0];
  if (forces_->magnus) rate += liftFactors<1>(speed, rim)[0] * w_WB.norm();
  return rate;
}
}  // namespace ping_pong
