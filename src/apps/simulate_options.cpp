#include "simulate_options.h"

#include "ping_pong_sim/scene_loader.h"

namespace ping_pong
{
namespace
{
constexpr double kMaxRows = 1e12;  ///< far beyond any disk, and rows stay exactly countable

OptionGroup whatToRun(SimulateOptions& options)
{
  return {"Run",
          {{"SCENE.yaml", "", "the scene file to run", into(options.scene_path, fileName), kRequired},
           {"--duration", "T", "the simulated time [s]", into(options.duration, positiveNumber), kRequired},
           {"--commands", "FILE",
            "moves paddles by the commands in this CSV file, each at its time;\nconfig/commands/README.md",
            into(options.commands_path, fileName)}}};
}

OptionGroup whatToWrite(SimulateOptions& options)
{
  return {"Output",
          {{"--rate", "R", "rows per second and ball [Hz]; row k is at k / R", into(options.rate, positiveNumber)},
           {"--contacts", "FILE", "writes each impact as CSV to FILE", into(options.contacts_path, fileName)}}};
}

OptionGroup insteadOfTheScene(SimulateOptions& options)
{
  return {"Instead of the scene's own",
          {{"--method", "M", "one of " + methodNames(), into(options.method, methodName)},
           {"--dt", "H", "longest step of all methods but `exact` [s]", into(options.dt, positiveNumber)},
           {"--tolerance", "E", "position error that `exact` may have after a rally [m]",
            into(options.tolerance, numberWithin(kMinTolerance, kMaxTolerance))},
           {"--seed", "N", "of random patterns", into(options.seed, integerWithin(0))},
           {"--balls", "N", "of the random pattern; its room grows or shrinks with them",
            into(options.balls, integerWithin(1, kMaxBalls))},
           {"--threads", "N", "that share a crowd; the output is the same for any number",
            into(options.threads, integerWithin(1, kMaxThreads))}}};
}
}  // namespace

SimulateOptions parseSimulateOptions(int argc, char** argv)
{
  SimulateOptions options;
  const CommandLine line = {
      "simulate",
      "Runs a scene and writes the state of each ball as CSV to standard output, from t = 0, and a summary to "
      "standard\n"
      "error. SI units, radians; frame `world`.",
      {whatToRun(options), whatToWrite(options), insteadOfTheScene(options)},
      "Exit status: 0 the run is whole; 1 output could not be written; 2 bad input; 3 the world reported a problem."};
  options.help = parse(line, argc, argv);
  if (!options.help && options.duration * options.rate > kMaxRows)
    refuse("--rate", "too many rows", "at most 1e12 rows");
  return options;
}
}  // namespace ping_pong
