#include "verdict.h"

namespace ping_pong::stability
{
const CheckText& textOf(Check check)
{
  static const std::array<CheckText, kChecks> texts = {{
      {"events", "events after the last real bounce", "few events once the ball no longer bounces"},
      {"storm", "events per simulated second", "no storm of events"},
      {"depth", "depth in a solid [m]", "in no solid at the end of a tick"},
      {"through", "depth of the centre on the way [m]", "through no solid within a tick"},
      {"gain", "energy per mass gained [J/kg]", "no energy out of nothing"},
      {"loss", "energy per mass lost [J/kg]", "no energy lost where nothing takes it"},
      {"slip", "slip where friction always grips [m/s]", "no slip where friction always grips"},
      {"law", "force or torque against the law, as a part", "forces and torques of surfaces obey their laws"},
      {"rest", "speed out of rest [m/s]", "what holds still goes on holding still"},
      {"state", "fault", "state finite, orientation of length 1, at rest means no speed"},
      {"record", "fault", "contacts listed as counted, ordered, inside the tick, without a gain"},
      {"seam", "distance from the path on one board [m]", "flush faces are one face"},
      {"same_bits", "fault", "the same bits from the same scene"},
      {"squeezed", "fault", "squeezed only where a body moves against another one"},
      {"hung", "fault", "an end in time"},
      {"crashed", "fault", "no end of the process"},
  }};
  return texts[static_cast<std::size_t>(check)];
}
}  // namespace ping_pong::stability
