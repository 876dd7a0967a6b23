// Measures the stability map: every situation with every method and step, and tunnelling over speed and step, as CSV.
#include <cstdio>
#include <fstream>
#include <iostream>

#include "apps/command_line.h"
#include "apps/progress.h"
#include "cases.h"
#include "options.h"
#include "situations.h"

namespace ping_pong::stability
{
namespace
{
const std::vector<double> kSteps = {1e-2, 1e-3, 1e-4};                                      // [s]
const std::vector<double> kShotSteps = {1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0, 1e-3, 1e-4};  // [s]
const std::vector<double> kSpeeds = {1.0, 5.0, 10.0, 25.0, 40.0, 100.0, 200.0};             // [m/s]
constexpr double kMapPart = 0.65;  // of the time that all files take; the shots take next to none

std::vector<double> stepsOf(Method method)
{
  return method == Method::Exact ? std::vector<double>{1e-3} : kSteps;  // it does not look at them
}

void writeMap(std::ostream& out, const PartDone& done)
{
  double cases_done = 0.0;
  out << "case,title,measures,bound,reason,method,step_s,value,passes\n";
  for (const Case& each : cases())
  {
    for (const Method method : kMethods)
      for (const double step : stepsOf(method))
      {
        const double value = each.value(method, step);
        out << each.name << ",\"" << each.title << "\",\"" << each.measures << "\"," << each.bound << ",\""
            << each.reason << "\"," << name(method) << ',' << step << ',' << value << ',' << each.passes(value) << '\n';
      }
    done(++cases_done / static_cast<double>(cases().size()));
  }
}

void writeShots(std::ostream& out, const PartDone&)
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

struct File
{
  const char* name;
  void (*write)(std::ostream&, const PartDone&);
  double from, to;   ///< of the time that all of them take
  const char* what;  ///< while it is written
};

const std::vector<File> kFiles = {{"stability.csv", writeMap, 0.0, kMapPart, "map"},
                                  {"tunnelling.csv", writeShots, kMapPart, kMapPart, "shots"},
                                  {"random.csv", writeRandom, kMapPart, 1.0, "random scenes"}};

bool write(const std::string& directory, const File& each, Progress& progress)
{
  const std::string path = directory + '/' + each.name;
  std::ofstream file(path);
  file.precision(6);
  each.write(file, progress.stretch(each.from, each.to, each.what));
  file.close();
  progress.clear();
  if (!file) std::cerr << path << ": cannot be written\n";
  return static_cast<bool>(file);
}

int mapMain(const std::string& directory)
{
  Progress progress("stability");
  for (const File& file : kFiles)
    if (!write(directory, file, progress)) return 1;
  return 0;
}

int run(int argc, char** argv)
{
  const Options options = optionsFrom(argc, argv);
  if (options.help) return writeHelp(*options.help) ? 0 : 1;
  return options.directory.empty() ? randomMain(options.random) : mapMain(options.directory);
}
}  // namespace
}  // namespace ping_pong::stability

int main(int argc, char** argv)
{
  try
  {
    return ping_pong::stability::run(argc, argv);
  }
  catch (const ping_pong::UsageError& error)
  {
    std::cerr << "stability: " << error.what() << '\n';
    return 2;
  }
}
