#include "random_main.h"

#include <iostream>
#include <map>

#include "scene_files.h"
#include "watched.h"

namespace ping_pong::stability
{
namespace
{
constexpr std::uint64_t kScenesOfEachMethod = 320;  // 20 of each category
}  // namespace

RandomReport runRandom(const RandomOptions& options, const RandomListener& listener)
{
  RandomReport report;
  std::map<std::uint64_t, std::string> waiting;  // lines of scenes that are done before an earlier one
  std::uint64_t next = options.first, done = 0;
  const auto told = [&](std::uint64_t index, const Verdict& verdict)
  {
    report.add(categoryOf(index), verdict);
    waiting[index] = verdict.failed() ? failureLine(options.seed, index, verdict) : std::string();
    for (; !waiting.empty() && waiting.begin()->first == next; ++next)
    {
      if (!waiting.begin()->second.empty()) listener.fails(waiting.begin()->second);
      waiting.erase(waiting.begin());
    }
    listener.done(static_cast<double>(++done) / static_cast<double>(options.count), report.failed());
  };
  watched(
      {options.first, options.count, options.processes, options.patience},
      [&](std::uint64_t index) { return judge(randomScene(options.seed, index), options.method, options.dt); }, told);
  return report;
}

int randomMain(const RandomOptions& options)
{
  try
  {
    if (!options.dump.empty()) dumpScene(randomScene(options.seed, options.first), options.dump);
  }
  catch (const std::exception& error)
  {
    std::cerr << "stability: " << error.what() << '\n';
    return 2;
  }
  Progress progress("stability");
  const auto fails = [&](const std::string& line)
  {
    progress.clear();
    std::cout << line << std::endl;  // at once, for who waits for it
  };
  const auto done = [&](double part, std::size_t failed)
  { progress.show(part, (std::to_string(failed) + " failed").c_str()); };
  const RandomReport report = runRandom(options, {fails, done});
  progress.clear();
  report.print(std::cout);
  return report.failed() == 0 ? 0 : 1;
}

void writeRandom(std::ostream& out, const PartDone& done)
{
  out << "method,category,scenes,check,says,broken\n";
  double before = 0.0;  // methods that are done
  for (const Method method : kMethods)
  {
    RandomOptions options;
    options.count = kScenesOfEachMethod;
    options.method = method;
    options.patience = 2.0;
    const auto methods_done = [&](double part, std::size_t) { done((before + part) / kMethods.size()); };
    runRandom(options, {[](const std::string&) {}, methods_done}).write(out, name(method));
    ++before;
  }
}
}  // namespace ping_pong::stability
