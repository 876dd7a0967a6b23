// Named flight laws and contact laws from the literature and from measurements, for scenes that do not list numbers.
#pragma once

#include <string>
#include <vector>

#include "ping_pong_sim/scene.h"

namespace ping_pong
{
/// Drag and Magnus of one source, all in the normalisation of forces.h.
struct FlightPreset
{
  const char* name;
  DragLaw drag;
  LiftLaw lift;
  const char* source;
};

struct SurfacePreset
{
  const char* name;
  Surface surface;
  const char* source;
};

/// The first is the default.
const std::vector<FlightPreset>& flightPresets();
const std::vector<SurfacePreset>& surfacePresets();

/// Null if no preset has this name.
const FlightPreset* findFlightPreset(const std::string& name);
const SurfacePreset* findSurfacePreset(const std::string& name);

/// "a, b, c": for complaints.
std::string flightPresetNames();
std::string surfacePresetNames();
}  // namespace ping_pong
