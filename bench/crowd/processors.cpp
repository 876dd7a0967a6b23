#include "processors.h"

#include <sched.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace ping_pong::bench
{
namespace
{
std::vector<int> allowedProcessors()
{
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) != 0) throw std::runtime_error("sched_getaffinity: no answer");
  std::vector<int> all;
  for (int processor = 0; processor < CPU_SETSIZE; ++processor)
    if (CPU_ISSET(processor, &set)) all.push_back(processor);
  return all;
}

std::vector<pid_t> threads()
{
  std::vector<pid_t> all;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) all.push_back(std::stoi(task.path().filename()));
  std::sort(all.begin(), all.end());
  return all;
}
}  // namespace

void giveProcessors()
{
  const std::vector<int> processors = allowedProcessors();
  const std::vector<pid_t> all = threads();
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(processors[k % processors.size()], &one);
    if (sched_setaffinity(all[k], sizeof one, &one) != 0) throw std::runtime_error("sched_setaffinity: refused");
  }
}
}  // namespace ping_pong::bench
