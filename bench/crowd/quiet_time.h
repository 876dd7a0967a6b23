// What work costs on a machine that has nothing else to do, measured on one that has.
#pragma once

#include <cstddef>
#include <vector>

namespace ping_pong::bench
{
/// Wall times of a run tick by tick, over several runs that do the same work every time: whoever else wants the machine only
/// adds to them, so of each tick the least time counts.
class QuietTime
{
public:
  /// @param enough  runs in a row that hardly lower the total, for it to have settled
  explicit QuietTime(std::size_t enough = 5) : enough_(enough) {}
  /// @param ticks  of one more run, as many as of those before [s]
  void add(const std::vector<double>& ticks);

  std::size_t runs() const { return totals_.size(); }
  std::size_t ticks() const { return least_.size(); }
  double total() const { return totals_.empty() ? 0.0 : totals_.back(); }  ///< [s]
  /// Of the costliest part of so many ticks, counted from the first one; 0 if there is no whole part [s].
  double mostOf(std::size_t ticks) const;
  bool settled() const;

private:
  std::size_t enough_;
  std::vector<double> least_;   // of each tick [s]
  std::vector<double> totals_;  // after each run [s]
};
}  // namespace ping_pong::bench
