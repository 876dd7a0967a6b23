// Reads the measured data of test/data.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "ping_pong_sim/ball.h"

namespace ping_pong
{
/// A file is missing or a row cannot be read; what() is one line.
class DataError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Positions of one ball over time; the table's surface is z = 0.
struct Flight
{
  std::string name;
  bool no_spin = false;             ///< the launcher's wheels ran alike
  double bounce = -1.0;             ///< time of the bounce [s]; negative: none
  double noise = 0.0;               ///< rms per coordinate [m]
  std::vector<double> times;        ///< [s], the first is 0
  std::vector<Vector3d> positions;  ///< [m]
};

/// One rebound from a racket at rest with normal +z.
struct Rebound
{
  BallState before, after;
};

/// The state in which a real shot left the racket; the table's surface is z = 0.
struct Launch
{
  std::string kind;  ///< serve or rally
  BallState state;
};

std::vector<Flight> readFlights(const std::string& data);
std::vector<Rebound> readRebounds(const std::string& data);
std::vector<Launch> readLaunches(const std::string& data);
}  // namespace ping_pong
