#include "crowd_run.h"

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

#include "companion.h"
#include "ping_pong_sim/state_hash.h"
#include "ping_pong_sim/world.h"
#include "processors.h"

namespace ping_pong::bench
{
namespace
{
constexpr int kLooks = 10;
constexpr double kRest = 0.01;  // slower is rest [m/s]

double now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A line of /proc/self/status, in bytes.
double memory(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.compare(0, key.size(), key) == 0) return 1024.0 * std::stod(line.substr(key.size() + 1));
  throw std::runtime_error("no " + key + " in /proc/self/status");
}

/// How much memory the process has taken at most since it began, but for what is taken between pause() and resume().
class PeakMemory
{
public:
  PeakMemory()
  {
    resume();
    before_ = memory("VmRSS:");
  }
  void pause() { peak_ = std::max(peak_, memory("VmHWM:") - before_); }
  void resume()
  {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5;  // the peak begins anew
  }
  double bytes() const { return peak_; }

private:
  double before_ = 0.0, peak_ = 0.0;
};

/// Our world with what only it can tell.
class OurCrowd : public Engine
{
public:
  explicit OurCrowd(std::shared_ptr<const Scene> scene) : world_(std::move(scene))
  {
    world_.keepContacts(false);  // counted only: nobody reads them here, and no other engine is asked for a list
  }
  void drive(std::size_t, const Twist&) override {}
  void advance(double duration) override
  {
    const StepStatus status = world_.advance(duration);
    contacts += static_cast<double>(status.contacts);
    events += static_cast<double>(status.events);
  }
  BallState ballState(std::size_t ball) const override { return world_.ballState(ball); }
  std::uint64_t hash() const { return stateHash(world_); }

  double contacts = 0.0, events = 0.0;

private:
  World world_;
};

std::shared_ptr<const Scene> sceneOf(const CrowdPoint& point, const CrowdScene& crowd, std::size_t balls)
{
  Scene scene = crowdOf(crowd, balls);
  if (point.engine->name == "ping_pong_sim") scene.method = methodFromName(point.variant);
  scene.dt = point.step;
  scene.threads = point.threads;
  return std::make_shared<const Scene>(std::move(scene));
}

class Run
{
public:
  Run(const CrowdPoint& point, const CrowdScene& crowd, std::size_t balls, const CrowdEffort& effort, std::size_t ticks)
      : crowd_(crowd),
        effort_(effort),
        exactly_(ticks),
        begin_(now()),
        shared_(sceneOf(point, crowd, balls)),
        scene_(*shared_),
        states_(balls)
  {
    const double start = now();
    if (point.engine->name == "ping_pong_sim")
      engine_ = std::make_unique<OurCrowd>(shared_);
    else
      engine_ = point.engine->make(scene_, point.variant, point.step);
    ours_ = dynamic_cast<OurCrowd*>(engine_.get());
    if (point.companion) companion_ = std::make_unique<Companion>(shared_);
    result_.start = now() - start;
    giveProcessors();
    measure();
    result_.wall = now() - begin_;
  }
  const CrowdResult& result() const { return result_; }
  const std::vector<double>& ticks() const { return ticks_; }

private:
  void measure()
  {
    const double energy = look().energy;
    for (double t = 0.0; t < crowd_.warm_up - 0.5 * kTick; t += kTick) tick();
    if (ours_) ours_->contacts = ours_->events = 0.0;
    const auto longest = static_cast<std::size_t>(std::lround(crowd_.longest / kTick));
    const std::size_t most = exactly_ > 0 ? exactly_ : longest;
    double spent = 0.0;
    while (ticks_.size() < most)
    {
      ticks_.push_back(tick());
      spent += ticks_.back();
      if (ticks_.size() % std::max<std::size_t>(1, longest / kLooks) == 0 || crowd_.rests) lookForRest(simulated());
      if (exactly_ > 0) continue;
      if (now() - begin_ > effort_.most) break;
      if (crowd_.steady && spent > effort_.steady) break;
    }
    result_.simulated = simulated();
    result_.done =
        crowd_.steady || ticks_.size() == most || (crowd_.enough > 0.0 && simulated() >= crowd_.enough - 0.5 * kTick);
    const Soundness end = look();
    result_.bytes = memory_.bytes();
    result_.energy_change = end.energy / energy - 1.0;
    result_.escaped = static_cast<double>(end.escaped);
    if (!ours_) return;
    result_.contacts = ours_->contacts / result_.simulated;
    result_.events = ours_->events / result_.simulated;
    result_.hash = ours_->hash();
  }

  /// What it took [s]. Of two worlds: each of them, if the quicker processor did some of the slower one's work.
  double tick()
  {
    if (companion_) companion_->begin(kTick);
    const double start = now();
    engine_->advance(kTick);
    const double its = now() - start;
    return companion_ ? 2.0 / (1.0 / its + 1.0 / companion_->end()) : its;
  }

  double simulated() const { return kTick * static_cast<double>(ticks_.size()); }

  // The memory that looking takes is not the engine's.
  Soundness look()
  {
    memory_.pause();
    for (std::size_t i = 0; i < states_.size(); ++i) states_[i] = engine_->ballState(i);
    const Soundness found = soundnessOf(scene_, states_);
    result_.overlap = std::max(result_.overlap, found.overlap);
    memory_.resume();
    return found;
  }

  void lookForRest(double t)
  {
    const bool rests = look().fastest < kRest;
    if (!rests) result_.rest_after = -1.0;
    if (rests && result_.rest_after < 0.0) result_.rest_after = t;
  }

  const CrowdScene& crowd_;
  const CrowdEffort& effort_;
  std::size_t exactly_;  // ticks
  double begin_;
  std::shared_ptr<const Scene> shared_;
  const Scene& scene_;
  std::vector<BallState> states_;
  std::unique_ptr<Engine> engine_;
  OurCrowd* ours_ = nullptr;
  std::unique_ptr<Companion> companion_;
  std::vector<double> ticks_;
  PeakMemory memory_;  // from here on: what loading took is not the engine's
  CrowdResult result_;
};

// Any number of bytes through a pipe; false if the other end is gone.
bool put(int end, const void* bytes, std::size_t count)
{
  const char* from = static_cast<const char*>(bytes);
  for (ssize_t written; count > 0; from += written, count -= static_cast<std::size_t>(written))
    if ((written = write(end, from, count)) <= 0) return false;
  return true;
}

bool get(int end, void* bytes, std::size_t count)
{
  char* to = static_cast<char*>(bytes);
  for (ssize_t had; count > 0; to += had, count -= static_cast<std::size_t>(had))
    if ((had = read(end, to, count)) <= 0) return false;
  return true;
}

bool tell(int end, const CrowdResult& result, const std::vector<double>& ticks)
{
  const std::size_t count = ticks.size();
  return put(end, &result, sizeof result) && put(end, &count, sizeof count) &&
         put(end, ticks.data(), count * sizeof(double));
}

// Of a process that ended before it had told all: not done.
CrowdRun hear(int end)
{
  CrowdRun run;
  std::size_t count = 0;
  bool heard = get(end, &run.result, sizeof run.result) && get(end, &count, sizeof count);
  if (heard) run.ticks.resize(count);
  heard = heard && get(end, run.ticks.data(), count * sizeof(double));
  return heard ? run : CrowdRun();
}
}  // namespace

CrowdRun measureCrowd(const CrowdPoint& point, const CrowdScene& crowd, std::size_t balls, const CrowdEffort& effort,
                      std::size_t ticks)
{
  int pipe_ends[2];
  if (pipe(pipe_ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0)
  {
    alarm(static_cast<unsigned>(2.0 * effort.most) + 1);  // one tick alone may take for ever
    bool told = false;
    try
    {
      const Run run(point, crowd, balls, effort, ticks);
      told = tell(pipe_ends[1], run.result(), run.ticks());
    }
    catch (const std::exception&)
    {
    }
    _exit(told ? 0 : 1);
  }
  close(pipe_ends[1]);
  const CrowdRun run = hear(pipe_ends[0]);
  close(pipe_ends[0]);
  waitpid(child, nullptr, 0);
  return run;
}
}  // namespace ping_pong::bench
