// What a random scene is judged by, and what was found.
#pragma once

#include <array>
#include <cstdint>

namespace ping_pong::stability
{
enum class Check
{
  Events,    ///< few of them once the ball no longer bounces
  Storm,     ///< never more than a computer can do
  Depth,     ///< in no solid at the end of a tick
  Through,   ///< on the way between two ends of ticks neither
  Gain,      ///< no energy out of nothing
  Loss,      ///< none lost where nothing takes it
  Slip,      ///< none where friction always grips
  Law,       ///< forces and torques of surfaces obey their laws
  Rest,      ///< what holds still goes on holding still
  State,     ///< finite, orientation of length 1
  Record,    ///< contacts listed as counted, in order, in the tick, without a gain
  Seam,      ///< flush faces are one face
  SameBits,  ///< from the same scene
  Squeezed,  ///< only where a body moves against another one
  Hung,      ///< did not end in time
  Crashed,   ///< ended the process
  Count
};

constexpr std::size_t kChecks = static_cast<std::size_t>(Check::Count);

struct CheckText
{
  const char* name;
  const char* value;  ///< what is measured, with its unit
  const char* says;
};

const CheckText& textOf(Check check);

/// The worst that was seen against its bound.
struct Finding
{
  double value = 0.0, bound = 0.0;
  double time = 0.0;  ///< first beyond the bound [s]
  bool broken = false;
  std::uint32_t looks = 0;  ///< how often it was looked at; faults: found
};

/// Plain data: it comes from another process.
struct Verdict
{
  std::array<Finding, kChecks> findings;
  double quiet_events = 0.0;  ///< events per second since the last real bounce; below zero: it bounces all the time
  double deepest = 0.0;       ///< [m]
  double gain = 0.0;          ///< of energy, part of what the ball had
  double coarse = -1.0,
         fine = -1.0;  ///< how far `impulse` was off with longer and shorter steps [m]; below zero: not compared

  Finding& of(Check check) { return findings[static_cast<std::size_t>(check)]; }
  const Finding& of(Check check) const { return findings[static_cast<std::size_t>(check)]; }
  bool failed() const
  {
    for (const Finding& finding : findings)
      if (finding.broken) return true;
    return false;
  }
  /// Not finite is worse than any bound.
  void note(Check check, double value, double bound, double time)
  {
    Finding& finding = of(check);
    ++finding.looks;
    const bool broken = !(value <= bound);
    const bool worse = !(value / bound <= (finding.bound > 0.0 ? finding.value / finding.bound : 0.0));
    if (broken && !finding.broken) finding.time = time;
    finding.broken |= broken;
    if (!worse) return;
    finding.value = value;
    finding.bound = bound;
  }
  /// A fault that has no size.
  void fault(Check check, double time) { note(check, 1.0, 0.5, time); }
};
}  // namespace ping_pong::stability
