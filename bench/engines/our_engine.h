// This simulator on the chart.
#pragma once

#include "engine.h"

namespace ping_pong::bench
{
/// Variants: every method that the library knows.
EngineKind ourEngine();

/// The variant's "step" is a tolerance [m], not a length of time.
bool takesTolerance(const std::string& engine, const std::string& variant);
}  // namespace ping_pong::bench
