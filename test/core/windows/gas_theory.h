// What kinetic theory says of smooth hard spheres in a cube with hard, smooth walls. Sources: docs/physics.md, "Crowds as a gas".
#pragma once

#include <cmath>

namespace ping_pong
{
/// Per mass: the temperature `t` is the variance of a velocity component [m^2/s^2], pressures and forces are per mass of a ball.
struct GasTheory
{
  double balls = 0.0;     ///< N
  double diameter = 0.0;  ///< d [m]
  double edge = 0.0;      ///< L, of the cube [m]
  double density = 0.0;   ///< n, of balls far from the walls [1/m^3]
  double fill = 0.0;      ///< eta = pi n d^3 / 6

  /// Density in the middle: near walls balls are excluded from a layer of d/2 and gathered beyond it; scaled-particle theory
  /// gives N = n ((L - d)^3 + 6 (L - d)^2 (d/2) 3 eta / (1 + 2 eta)).
  GasTheory(double its_balls, double its_diameter, double its_edge)
      : balls(its_balls), diameter(its_diameter), edge(its_edge)
  {
    const double inner = edge - diameter;
    for (int i = 0; i < 100; ++i)
    {
      const double layer = 1.5 * diameter * fill / (1.0 + 2.0 * fill);
      density = balls / (inner * inner * inner + 6.0 * inner * inner * layer);
      fill = 0.52359877559829887 * density * diameter * diameter * diameter;
    }
  }

  /// Z = p / (n T), Carnahan and Starling 1969.
  double compressibility() const
  {
    const double free = 1.0 - fill;
    return (1.0 + fill + fill * fill - fill * fill * fill) / (free * free * free);
  }
  /// Of the gas against a hard wall, scaled-particle theory (Reiss et al. 1960).
  double surfaceTension(double t) const
  {
    const double free = 1.0 - fill;
    return t * 0.47746482927568601 * fill * (2.0 + fill) / (free * free * diameter * diameter);
  }
  /// Force on one face: p L^2 less the tension of the four faces beside it; the last term is the ideal gas's at the edges.
  double force(double t) const
  {
    return density * t * compressibility() * edge * edge - 4.0 * edge * surfaceTension(t) +
           density * t * diameter * diameter;
  }
  /// Hits between balls per second, Enskog's: the virial theorem with the force above, and T^(1/2) pi^(1/2) as the mean change of
  /// velocity in a hit. Without walls it is N/2 4 n d^2 chi (pi T)^(1/2), chi = (Z - 1) / (4 eta).
  double hitRate(double t) const
  {
    return 3.0 * (force(t) * (edge - diameter) - balls * t) / (diameter * std::sqrt(3.14159265358979324 * t));
  }
};
}  // namespace ping_pong
