#include "crowd_options.h"

#include "apps/command_line.h"

namespace ping_pong::bench
{
namespace
{
constexpr std::uint64_t kMostRounds = 1000000;  // years

OptionGroup whatToMeasure(CrowdOptions& options)
{
  const OptionValue one_more = {[&options](const std::string& text) { options.scenes.push_back(text); }};
  return {
      "What is measured",
      {{"--scene", "NAME", "this scene alone; again for a second one", one_more},
       {"--variant", "NAME", "of this simulator alone, this method: exact or impulse", into(options.variant, anyText)},
       {"--balls", "N", "this number of balls alone; 0: ever more of them", into(options.balls, numberNotNegative)},
       {"--companion", "", "`exact` beside another world, too; runs with near and with far processors apart",
        flag(options.companion)}}};
}

OptionGroup howLong(CrowdOptions& options)
{
  return {"Effort",
          {{"--quick", "", "up to 1000 balls, short runs, one round", flag(options.quick)},
           {"--rounds", "N", "runs of each point; fewer where times have settled",
            into(options.rounds, integerWithin(0, kMostRounds))}}};
}

OptionGroup whereTo(CrowdOptions& options)
{
  return {"Results",
          {{"--out", "FILE", "the CSV file to write", into(options.out, fileName), kRequired},
           {"--commit", "NAME", "that the results say they come from", into(options.commit, anyText)}}};
}
}  // namespace

CrowdOptions crowdOptions(int argc, char** argv)
{
  CrowdOptions options;
  const CommandLine line = {"crowd",
                            "Measures what a ball of a crowd costs, against the number of balls.",
                            {whatToMeasure(options), howLong(options), whereTo(options)}};
  options.help = parse(line, argc, argv);
  return options;
}
}  // namespace ping_pong::bench
