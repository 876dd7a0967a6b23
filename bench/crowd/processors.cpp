#include "processors.h"

#include <sched.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace ping_pong::bench
{
namespace
{
cpu_set_t allowedNow()
{
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) != 0) throw std::runtime_error("sched_getaffinity: no answer");
  return set;
}

// Before threads have been given one each.
const cpu_set_t& allowed()
{
  static const cpu_set_t set = allowedNow();
  return set;
}

std::vector<int> allowedProcessors()
{
  std::vector<int> all;
  for (int processor = 0; processor < CPU_SETSIZE; ++processor)
    if (CPU_ISSET(processor, &allowed())) all.push_back(processor);
  return all;
}

std::vector<pid_t> threads()
{
  std::vector<pid_t> all;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task"))
    all.push_back(std::stoi(task.path().filename()));
  std::sort(all.begin(), all.end());
  return all;
}

/// False if the thread has ended: one that has been joined is listed a little longer.
bool let(pid_t thread, const cpu_set_t& set)
{
  if (sched_setaffinity(thread, sizeof set, &set) == 0) return true;
  if (errno != ESRCH) throw std::runtime_error("sched_setaffinity: refused");
  return false;
}
}  // namespace

std::size_t processors()
{
  return allowedProcessors().size();
}

void giveProcessors()
{
  const std::vector<int> its = allowedProcessors();
  std::size_t given = 0;
  for (const pid_t thread : threads())
  {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(its[given % its.size()], &one);
    given += let(thread, one);
  }
}

void takeProcessorsBack()
{
  for (const pid_t thread : threads()) let(thread, allowed());
}
}  // namespace ping_pong::bench
