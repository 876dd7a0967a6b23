// Forces on a ball in flight. A scene lists them by name; what it does not list is not computed.
#pragma once

#include <vector>

#include "ping_pong_sim/ball.h"

namespace ping_pong
{
/// C_D, with |F_D| = (1/2) rho A C_D u^2, u the speed through the air:
/// C_D = without_spin + (with_spin - without_spin) S^2 / (S^2 + half_at^2), S = r w / u. Source: docs/physics.md.
struct DragLaw
{
  double without_spin = 0.33;
  double with_spin = 0.53;
  double half_at = 1.0 / 15.0;  ///< spin ratio at which half of the way is gone, > 0
  /// Optional table instead, bilinear between its nodes and constant outside: rows by Reynolds number 2 r u / nu, columns by
  /// spin ratio.
  std::vector<double> reynolds, spin_ratio, values;

  static DragLaw constant(double C_D);
  double at(double reynolds_number, double spin_ratio_now) const;
  bool feelsSpin() const { return values.empty() ? with_spin != without_spin : spin_ratio.size() > 1; }
};

/// C_L(S), with |F_M| = (1/2) rho A C_L u^2 for spin across the flight. Papers normalise differently: docs/physics.md.
struct LiftLaw
{
  enum class Kind
  {
    Linear,      ///< C_L = slope S
    Saturating,  ///< C_L = slope S / (1 + saturation S)
    Constant,    ///< C_L = constant for any spin
    Table        ///< C_L(S) linear between nodes, constant beyond the last, 0 at S = 0
  };
  Kind kind = Kind::Saturating;
  double slope = 0.333 * 7.3;  ///< dC_L/dS at S = 0
  double saturation = 7.3;
  double constant = 0.267;
  std::vector<double> spin_ratio, values;  ///< Table: nodes with S > 0, increasing

  /// C_L(S) / S: what multiplies (1/2) rho A r (w x u) |u| / |u|; finite at S = 0 but for Kind::Constant.
  double perSpinRatio(double S) const;
};

struct Forces
{
  Vector3d gravity = Vector3d::Zero();  ///< expressed in W [m/s^2]; zero if the scene does not list it
  bool drag = false;
  bool magnus = false;
  bool buoyancy = false;
  bool added_mass = false;           ///< half of the displaced air moves with the ball
  double spin_decay = 0.0;           ///< lambda: dw/dt = -lambda w [1/s]
  Vector3d wind = Vector3d::Zero();  ///< velocity of the air [m/s]
  double air_density = 1.2041;       ///< rho at 20 C, 101325 Pa [kg/m^3]
  double air_viscosity = 1.516e-5;   ///< nu, kinematic, for the Reynolds number [m^2/s]
  DragLaw drag_law;
  LiftLaw lift_law;

  bool dependOnVelocity() const { return drag || magnus; }
};

/// Density of dry air, ideal gas and ICAO standard atmosphere: rho = p M / (R T), p = p0 (1 - L h / T0)^5.2559 [kg/m^3].
/// @param temperature  [K], at the place itself
/// @param altitude     above sea level [m]
double airDensity(double temperature, double altitude);

/// The forces on one ball with all that does not change in flight worked out.
class FlightModel
{
public:
  /// N vectors, one a row: components lie side by side in memory.
  template <int N>
  using Rows = Eigen::Matrix<double, N, 3>;
  template <int N>
  using Column = Eigen::Array<double, N, 1>;

  FlightModel(const Forces& forces, const BallParams& ball);
  /// dv/dt = g' - k_D C_D |u| u + k_L C_L/S (w x u), u = v - wind [m/s^2], all expressed in W.
  Vector3d acceleration(const Vector3d& v_WB, const Vector3d& w_WB) const;
  /// The same at N velocities at once.
  /// @param fade  spin at each of them as a part of w_WB
  template <int N>
  Rows<N> accelerations(const Rows<N>& v_WB, const Vector3d& w_WB, const Column<N>& fade) const;
  /// Where the acceleration is constant, flight has a closed form.
  bool constant() const { return !forces_->dependOnVelocity(); }
  /// Velocity through the air [m/s].
  Vector3d throughAir(const Vector3d& v_WB) const { return v_WB - forces_->wind; }
  /// Laws from tables have a kink at each node: between kinks this number stays the same. 0 without tables.
  std::size_t smoothRegion(const Vector3d& v_WB, const Vector3d& w_WB) const;
  bool smooth() const { return forces_->drag_law.values.empty() && forces_->lift_law.kind != LiftLaw::Kind::Table; }
  double spinDecay() const { return forces_->spin_decay; }
  /// Rate at which the acceleration changes the velocity at this state: 1 / time scale [1/s].
  double rate(const Vector3d& v_WB, const Vector3d& w_WB) const;

private:
  double rimSpeed(const Vector3d& w_WB) const;
  template <int N>
  Column<N> dragFactors(const Column<N>& speed, const Column<N>& speed2, const Column<N>& rim) const;
  template <int N>
  Column<N> liftFactors(const Column<N>& speed, const Column<N>& rim) const;

  const Forces* forces_;
  double radius_;
  Vector3d gravity_;  ///< with buoyancy and added mass [m/s^2]
  double drag_;       ///< rho A / (2 m') [1/m]
  double lift_;       ///< rho A r / (2 m')
  bool spin_ratio_;   ///< a law depends on S
};
}  // namespace ping_pong
