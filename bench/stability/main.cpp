// Measures the stability map: every situation with every method and step, and tunnelling over speed and step, as CSV.
#include <cstdio>
#include <fstream>
#include <iostream>

#include "cases.h"
#include "random_main.h"
#include "situations.h"

namespace ping_pong::stability
{
namespace
{
const std::vector<double> kSteps = {1e-2, 1e-3, 1e-4};                                      // [s]
const std::vector<double> kShotSteps = {1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0, 1e-3, 1e-4};  // [s]
const std::vector<double> kSpeeds = {1.0, 5.0, 10.0, 25.0, 40.0, 100.0, 200.0};             // [m/s]

std::vector<double> stepsOf(Method method)
{
  return method == Method::Exact ? std::vector<double>{1e-3} : kSteps;  // it does not look at them
}

void writeMap(std::ostream& out)
{
  out << "case,title,measures,bound,reason,method,step_s,value,passes\n";
  for (const Case& each : cases())
    for (const Method method : kMethods)
      for (const double step : stepsOf(method))
      {
        const double value = each.value(method, step);
        out << each.name << ",\"" << each.title << "\",\"" << each.measures << "\"," << each.bound << ",\""
            << each.reason << "\"," << name(method) << ',' << step << ',' << value << ',' << each.passes(value) << '\n';
        std::cerr << '.' << std::flush;
      }
}

void writeShots(std::ostream& out)
{
  out << "method,step_s,speed_m_s,missed,wrong_side\n";
  for (const Method method :
       {Method::EulerSemiImplicit, Method::Exact})  // at constant speed the sampled methods are one
    for (const double step : kShotSteps)
      for (const double speed : kSpeeds)
      {
        const Shots shots = shootAtPlate(method, step, 0.014, speed);
        out << name(method) << ',' << step << ',' << speed << ',' << shots.missed << ',' << shots.wrong_side << '\n';
      }
}

bool write(const std::string& path, void (*writer)(std::ostream&))
{
  std::ofstream file(path);
  file.precision(6);
  writer(file);
  file.close();
  if (!file) std::cerr << path << ": cannot be written\n";
  return static_cast<bool>(file);
}
}  // namespace
}  // namespace ping_pong::stability

int main(int argc, char** argv)
{
  using namespace ping_pong::stability;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() != 1) return randomMain(arguments);
  const std::string directory = arguments[0];
  const bool written = write(directory + "/stability.csv", writeMap) &&
                       write(directory + "/tunnelling.csv", writeShots) &&
                       write(directory + "/random.csv", writeRandom);
  std::cerr << '\n';
  return written ? 0 : 1;
}
