// Numbers from the rules of table tennis. Sources: ITTF Laws of Table Tennis 2.1-2.4 and technical leaflets T1, T3.
#pragma once

namespace ping_pong
{
constexpr double kStandardGravity = 9.80665;  ///< g [m/s^2]; scenes may use another

constexpr double kBallRadius = 0.020;  ///< r [m], law 2.3.1
constexpr double kBallMass = 2.7e-3;   ///< m [kg], law 2.3.2

constexpr double kShellInertia = 2.0 / 3.0;  ///< I / (m r^2) of a thin shell, as a ball of 40 mm with a wall of 0.4 mm
constexpr double kSolidInertia = 2.0 / 5.0;  ///< I / (m r^2) of a solid sphere

constexpr double kTableLength = 2.74;  ///< along x [m], law 2.1.1
constexpr double kTableWidth = 1.525;  ///< along y [m]
constexpr double kTableHeight = 0.76;  ///< playing surface above the floor [m]
constexpr double kNetHeight = 0.1525;  ///< above the playing surface [m], law 2.2.3
}  // namespace ping_pong
