#include "random_main.h"

#include <unistd.h>

#include <chrono>
#include <iostream>
#include <map>
#include <stdexcept>
#include <thread>

#include "../../src/core/scene/text_input.h"
#include "scene_files.h"
#include "watched.h"

namespace ping_pong::stability
{
namespace
{
constexpr std::uint64_t kScenesOfEachMethod = 320;  // 20 of each category
constexpr double kShownEvery = 0.5;                 // [s]

const char* const kUsage =
    "usage: stability DIRECTORY   writes stability.csv, tunnelling.csv and random.csv there\n"
    "       stability --random N [--seed S] [--first K] [--method M] [--dt H] [--patience SECONDS] [--processes P] "
    "[--dump FOLDER]\n"
    "         runs and judges N random scenes from number K on; exit code 1 if any fails. --dump writes scene K as "
    "files\n";

class Progress
{
public:
  explicit Progress(std::uint64_t count) : count_(count), shows_(isatty(STDERR_FILENO) != 0) {}
  void step(std::size_t failed)
  {
    ++done_;
    if (!shows_ || (seconds() - shown_ < kShownEvery && done_ < count_)) return;
    shown_ = seconds();
    const double left = shown_ / static_cast<double>(done_) * static_cast<double>(count_ - done_);
    std::cerr << '\r' << done_ << " of " << count_ << ", " << failed << " failed, " << std::lround(left) << " s left   "
              << (done_ == count_ ? "\n" : "") << std::flush;
  }

private:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  const std::uint64_t count_;
  const bool shows_;
  std::uint64_t done_ = 0;
  double shown_ = 0.0;
};

std::uint64_t integerFrom(const std::string& option, const std::string& text)
{
  std::uint64_t number = 0;
  if (!parseInteger(text, number)) throw std::invalid_argument(option + ": " + text + ": expected an integer >= 0");
  return number;
}

double positiveFrom(const std::string& option, const std::string& text)
{
  double number = 0.0;
  if (!parseNumber(text, number) || !(number > 0.0))
    throw std::invalid_argument(option + ": " + text + ": expected a number > 0");
  return number;
}

void set(RandomOptions& options, const std::string& option, const std::string& value)
{
  if (option == "--random")
    options.count = integerFrom(option, value);
  else if (option == "--seed")
    options.seed = integerFrom(option, value);
  else if (option == "--first")
    options.first = integerFrom(option, value);
  else if (option == "--method")
    options.method = methodFromName(value);
  else if (option == "--dt")
    options.dt = positiveFrom(option, value);
  else if (option == "--patience")
    options.patience = positiveFrom(option, value);
  else if (option == "--processes")
    options.processes = static_cast<unsigned>(std::max<std::uint64_t>(1, integerFrom(option, value)));
  else if (option == "--dump")
    options.dump = value;
  else
    throw std::invalid_argument("unknown option " + option);
}
}  // namespace

RandomOptions randomOptions(const std::vector<std::string>& arguments)
{
  RandomOptions options;
  options.processes = std::max(1u, std::thread::hardware_concurrency());
  for (std::size_t i = 0; i < arguments.size(); i += 2)
  {
    if (i + 1 == arguments.size()) throw std::invalid_argument(arguments[i] + ": expected a value");
    set(options, arguments[i], arguments[i + 1]);
  }
  return options;
}

RandomReport runRandom(const RandomOptions& options, bool print_failures)
{
  RandomReport report;
  Progress progress(options.count);
  std::map<std::uint64_t, std::string> waiting;  // lines of scenes that are done before an earlier one
  std::uint64_t next = options.first;
  const auto told = [&](std::uint64_t index, const Verdict& verdict)
  {
    report.add(categoryOf(index), verdict);
    waiting[index] = verdict.failed() ? failureLine(options.seed, index, verdict) + '\n' : std::string();
    for (; !waiting.empty() && waiting.begin()->first == next; ++next)
    {
      if (print_failures) std::cout << waiting.begin()->second << std::flush;
      waiting.erase(waiting.begin());
    }
    progress.step(report.failed());
  };
  watched(
      {options.first, options.count, options.processes, options.patience},
      [&](std::uint64_t index) { return judge(randomScene(options.seed, index), options.method, options.dt); }, told);
  return report;
}

int randomMain(const std::vector<std::string>& arguments)
{
  RandomOptions options;
  try
  {
    options = randomOptions(arguments);
    if (!options.dump.empty()) dumpScene(randomScene(options.seed, options.first), options.dump);
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n' << kUsage;
    return 2;
  }
  const RandomReport report = runRandom(options, true);
  report.print(std::cout);
  return report.failed() == 0 ? 0 : 1;
}

void writeRandom(std::ostream& out)
{
  out << "method,category,scenes,check,says,broken\n";
  for (const Method method : kMethods)
  {
    RandomOptions options = randomOptions({});
    options.count = kScenesOfEachMethod;
    options.method = method;
    options.patience = 2.0;
    runRandom(options, false).write(out, name(method));
    std::cerr << '.' << std::flush;
  }
}
}  // namespace ping_pong::stability
