#include "options.h"

#include <algorithm>
#include <limits>

#include "apps/command_line.h"

namespace ping_pong::stability
{
namespace
{
unsigned processes(const std::string& text)
{
  return static_cast<unsigned>(
      std::max<std::uint64_t>(1, integerWithin(0, std::numeric_limits<unsigned>::max())(text)));
}

OptionGroup which(RandomOptions& options)
{
  return {
      "Which scenes",
      {{"--random", "N", "runs and judges N of them; exit code 1 if any fails", into(options.count, integerWithin(0))},
       {"--seed", "S", "of all their numbers", into(options.seed, integerWithin(0))},
       {"--first", "K", "number of the first", into(options.first, integerWithin(0))},
       {"--dump", "FOLDER", "writes scene K as scene.yaml and URDF files for `simulate`",
        into(options.dump, anyText)}}};
}

OptionGroup how(RandomOptions& options)
{
  return {"How they run",
          {{"--method", "M", "one of " + methodNames(), into(options.method, methodName)},
           {"--dt", "H", "longest step of methods with steps [s]", into(options.dt, positiveNumber)},
           {"--patience", "SECONDS", "with one scene, then it counts as hung", into(options.patience, positiveNumber)},
           {"--processes", "P", "that share the scenes", into(options.processes, processes)}}};
}
}  // namespace

Options optionsFrom(int argc, char** argv)
{
  Options options;
  const OptionGroup map = {"Map",
                           {{"DIRECTORY", "", "the map: writes stability.csv, tunnelling.csv and random.csv there",
                             into(options.directory, anyText)}}};
  const CommandLine line = {
      "stability",
      "Measures where methods fail, as a map. Without DIRECTORY: runs random scenes of one ball with contacts under\n"
      "friction and load, and tells which of them break what always holds.",
      {map, which(options.random), how(options.random)}};
  options.help = parse(line, argc, argv);
  if (!options.help && !options.directory.empty() && argc > 2)
    refuse(options.directory, "beside options", "no options beside the map's folder: they are those of random scenes");
  return options;
}
}  // namespace ping_pong::stability
