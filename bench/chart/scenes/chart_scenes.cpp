#include <cmath>
#include <cstdlib>

#include "chart_scene.h"

namespace ping_pong::bench
{
namespace
{
// The double nearest to digit x 10^exponent: a product of powers would not be it.
double decimal(int digit, int exponent)
{
  return std::strtod((std::to_string(digit) + "e" + std::to_string(exponent)).c_str(), nullptr);
}

std::vector<double> series(const std::vector<int>& digits, double from, double to)
{
  std::vector<double> result;
  for (int exponent = static_cast<int>(std::ceil(std::log10(from))); decimal(9, exponent) >= to; --exponent)
    for (const int digit : digits)
    {
      const double value = decimal(digit, exponent);
      if (value <= from * 1.0000001 && value >= to * 0.9999999) result.push_back(value);
    }
  return result;
}
}  // namespace

std::vector<double> oneTwoFive(double from, double to)
{
  return series({5, 2, 1}, from, to);
}
std::vector<double> decades(double from, double to)
{
  return series({1}, from, to);
}

std::vector<ChartScene> chartScenes()
{
  return {vacuumFlight(), airFlight(),        bouncing(),  elastic666(), inelastic666(), dropToRest(),
          spinBounce(),   spinBounceVacuum(), ballInBox(), paddleHit(),  rally()};
}
}  // namespace ping_pong::bench
