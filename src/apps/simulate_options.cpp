#include "simulate_options.h"

#include <getopt.h>

#include "../core/scene/text_input.h"
#include "ping_pong_sim/scene_loader.h"

namespace ping_pong
{
namespace
{
constexpr double kMaxRows = 1e12;  ///< far beyond any disk, and rows stay exactly countable

const option kOptions[] = {
    {"duration", required_argument, nullptr, 'd'},
    {"rate", required_argument, nullptr, 'r'},
    {"method", required_argument, nullptr, 'm'},
    {"dt", required_argument, nullptr, 't'},
    {"tolerance", required_argument, nullptr, 'e'},
    {"seed", required_argument, nullptr, 's'},
    {"balls", required_argument, nullptr, 'b'},
    {"threads", required_argument, nullptr, 'n'},
    {"contacts", required_argument, nullptr, 'c'},
    {"commands", required_argument, nullptr, 'k'},
    {"help", no_argument, nullptr, 'h'},
    {nullptr, 0, nullptr, 0},
};

[[noreturn]] void fail(const std::string& option, const std::string& value, const std::string& expected)
{
  throw UsageError(option + ": " + value + ": expected " + expected);
}

double positive(const std::string& option, const std::string& text)
{
  double number = 0.0;
  if (!parseNumber(text, number) || !(number > 0.0)) fail(option, text, "a finite number > 0");
  return number;
}

double toleranceFrom(const std::string& text)
{
  double number = 0.0;
  if (!parseNumber(text, number) || !(number >= kMinTolerance && number <= kMaxTolerance))
    fail("--tolerance", text, rangeText(kMinTolerance, kMaxTolerance));
  return number;
}

std::string fileName(const std::string& option, const std::string& text)
{
  if (text.empty()) fail(option, "nothing", "a file name");
  return text;
}

std::uint64_t seedFrom(const std::string& text)
{
  std::uint64_t seed = 0;
  if (!parseInteger(text, seed)) fail("--seed", text, "an integer >= 0");
  return seed;
}

std::size_t countFrom(const std::string& option, const std::string& text, std::size_t most)
{
  std::uint64_t count = 0;
  if (!parseInteger(text, count) || count < 1 || count > most)
    fail(option, text, "an integer from 1 to " + std::to_string(most));
  return count;
}

Method methodFrom(const std::string& text)
{
  try
  {
    return methodFromName(text);
  }
  catch (const std::invalid_argument& error)
  {
    throw UsageError("--method: " + text + ": " + error.what());
  }
}

void apply(int letter, const std::string& value, const std::string& word, SimulateOptions& options)
{
  switch (letter)
  {
    case 'd':
      options.duration = positive("--duration", value);
      break;
    case 'r':
      options.rate = positive("--rate", value);
      break;
    case 'm':
      options.method = methodFrom(value);
      break;
    case 't':
      options.dt = positive("--dt", value);
      break;
    case 'e':
      options.tolerance = toleranceFrom(value);
      break;
    case 's':
      options.seed = seedFrom(value);
      break;
    case 'b':
      options.balls = countFrom("--balls", value, kMaxBalls);
      break;
    case 'n':
      options.threads = countFrom("--threads", value, kMaxThreads);
      break;
    case 'c':
      options.contacts_path = fileName("--contacts", value);
      break;
    case 'k':
      options.commands_path = fileName("--commands", value);
      break;
    case 'h':
      options.help = true;
      break;
    case ':':
      fail(word, "nothing", "a value after it");
    default:
      fail(word, "unknown option", "one of those that --help lists");
  }
}

void checkComplete(const SimulateOptions& options)
{
  if (options.scene_path.empty()) fail("SCENE.yaml", "missing", "the scene file to run; see --help");
  if (!options.duration) fail("--duration", "missing", "the simulated time [s]");
  if (*options.duration * options.rate > kMaxRows) fail("--rate", "too many rows", "at most 1e12 rows");
}
}  // namespace

const std::string kSimulateHelp =
    "usage: simulate SCENE.yaml --duration T [options]\n"
    "Runs a scene and writes the state of each ball as CSV to standard output, from t = 0, and a summary to standard\n"
    "error. SI units, radians; frame `world`.\n"
    "  --duration T      simulated time [s], required\n"
    "  --rate R          rows per second and ball [Hz], default 100; row k is at k / R\n"
    "  --method M        instead of the scene's: " +
    methodNames() +
    "\n"
    "  --dt H            longest step of all methods but `exact` [s], instead of the scene's\n"
    "  --tolerance E     position error that `exact` may have after a rally [m], instead of the scene's\n"
    "  --seed N          of random patterns, instead of the scene's\n"
    "  --balls N         of the random pattern, instead of the scene's; its room grows or shrinks with them\n"
    "  --threads N       that share a crowd, instead of the scene's; the output is the same for any number\n"
    "  --contacts FILE   writes each impact as CSV to FILE\n"
    "  --commands FILE   moves paddles by the commands in this CSV file, each at its time; config/commands/README.md\n"
    "  --help            this text\n"
    "Exit status: 0 the run is whole; 1 output could not be written; 2 bad input; 3 the world reported a problem.\n";

SimulateOptions parseSimulateOptions(int argc, char** argv)
{
  SimulateOptions options;
  opterr = 0;  // one line of our own instead
  int letter = 0;
  while ((letter = getopt_long(argc, argv, ":", kOptions, nullptr)) != -1)
    apply(letter, optarg != nullptr ? optarg : "", argv[optind - 1], options);
  if (options.help) return options;
  if (optind < argc) options.scene_path = argv[optind];
  if (optind + 1 < argc) fail(argv[optind + 1], "second scene", "one scene file");
  checkComplete(options);
  return options;
}
}  // namespace ping_pong
