#include "quiet_time.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace ping_pong::bench
{
namespace
{
constexpr double kHardly = 0.005;  // of the total
}  // namespace

void QuietTime::add(const std::vector<double>& ticks)
{
  if (least_.empty()) least_ = ticks;
  if (ticks.size() != least_.size()) throw std::runtime_error("runs of different lengths do not do the same work");
  for (std::size_t k = 0; k < ticks.size(); ++k) least_[k] = std::min(least_[k], ticks[k]);
  totals_.push_back(std::accumulate(least_.begin(), least_.end(), 0.0));
}

double QuietTime::mostOf(std::size_t ticks) const
{
  double most = 0.0;
  for (auto part = least_.begin(); least_.end() - part >= static_cast<std::ptrdiff_t>(ticks);
       part += static_cast<std::ptrdiff_t>(ticks))
    most = std::max(most, std::accumulate(part, part + static_cast<std::ptrdiff_t>(ticks), 0.0));
  return most;
}

bool QuietTime::settled() const
{
  return runs() > enough_ && totals_[runs() - 1 - enough_] - total() < kHardly * total();
}
}  // namespace ping_pong::bench
