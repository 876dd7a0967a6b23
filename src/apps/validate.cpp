// Compares the models with measurements, and tells what each effect is worth.
#include <cstdio>
#include <exception>
#include <optional>
#include <string>

#include "command_line.h"
#include "validate_parts.h"

namespace ping_pong
{
namespace
{
constexpr double kFlightsPart = 0.48;  // of the time; the constants take the rest, and all else a second or two

struct Options
{
  std::string data = "test/data";
  std::string scene = "config/scenes/rally.yaml";
  std::string out = ".";
  bool check = false;
  std::optional<std::string> help;  ///< asked for: nothing else counts
};

Options optionsFrom(int argc, char** argv)
{
  Options options;
  const OptionGroup input = {
      "Input",
      {{"--data", "DIR", "measured rebounds, flights and launches", into(options.data, anyText)},
       {"--scene", "FILE", "the rally that tells what the air costs", into(options.scene, anyText)}}};
  const OptionGroup output = {
      "Output",
      {{"--out", "DIR", "the folder for the CSV files", into(options.out, anyText)},
       {"--check", "", "writes none: holds the models to their bounds, in a few seconds", flag(options.check)}}};
  const CommandLine line = {"validate",
                            "Compares the models with measurements, and tells what each effect is worth.",
                            {input, output},
                            "Exit status: 0 all is well; 1 a model is outside its bounds; 2 bad input."};
  options.help = parse(line, argc, argv);
  return options;
}

bool within(const char* what, double value, double bound)
{
  const bool good = value <= bound;
  std::printf("%-6s %-66s %8.3f  (at most %g)\n", good ? "ok" : "FAILED", what, value, bound);
  return good;
}

const FlightChoice& choiceNamed(const std::vector<FlightChoice>& choices, const std::string& name)
{
  for (const FlightChoice& choice : choices)
    if (choice.name == name) return choice;
  throw DataError(name + ": no such model");
}

bool checkRubber(const std::string& data)
{
  const std::vector<RubberScore> scores = scoreRubber(readRebounds(data));
  bool good = within("default rubber: rms of velocity components [m/s]", scores.front().speed, 0.30);
  good &= within("default rubber: rms of spin [rad/s]", scores.front().spin, 22.0);
  for (std::size_t i = 1; i < scores.size(); ++i)
    good &= within(("default rubber against: " + scores[i].choice.name + ", spin error ratio").c_str(),
                   scores.front().spin / scores[i].spin, 1.05);
  return good;
}

bool checkFlights(const std::string& data)
{
  const std::vector<Flight> flights = readFlights(data);
  const std::vector<FlightChoice> choices = flightChoices();
  const std::vector<FlightScore> standard = scoreFlights(flights, choiceNamed(choices, "default"), true);
  const std::vector<FlightScore> vacuum = scoreFlights(flights, choiceNamed(choices, "vacuum"), true);
  bool good = within("default: misfit before the bounce / noise", medianBefore(standard, true), 1.5);
  good &= within("default: misfit through the bounce / noise", medianThrough(standard, true), 3.0);
  good &= within("default against vacuum: before the bounce, ratio",
                 medianBefore(standard, true) / medianBefore(vacuum, true), 0.2);
  good &= within("default against vacuum: through the bounce, ratio",
                 medianThrough(standard, true) / medianThrough(vacuum, true), 0.2);
  return good;
}

void writeAll(const Options& options)
{
  Progress progress("validate");
  const std::vector<Rebound> rebounds = readRebounds(options.data);
  writeRubber(rebounds, scoreRubber(rebounds), options.out);
  const std::vector<Flight> flights = readFlights(options.data);
  writeFlights(flights, options.out, progress.stretch(0.0, kFlightsPart, "flights"));
  writeChoiceOfConstants(flights, options.out, progress.stretch(kFlightsPart, 1.0, "constants"));
  writeOmissions(readLaunches(options.data), options.out);
  writeRallyCosts(options.scene, options.out);
}

int run(int argc, char** argv)
{
  const Options options = optionsFrom(argc, argv);
  if (options.help) return writeHelp(*options.help) ? 0 : 2;
  if (!options.check)
  {
    writeAll(options);
    return 0;
  }
  const bool rubber = checkRubber(options.data), flights = checkFlights(options.data);
  return rubber && flights ? 0 : 1;
}
}  // namespace
}  // namespace ping_pong

int main(int argc, char** argv)
{
  try
  {
    return ping_pong::run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "validate: %s\n", error.what());
    return 2;
  }
}
