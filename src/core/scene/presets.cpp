#include "scene/presets.h"

#include <limits>

#include "scene/text_input.h"

namespace ping_pong
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();

LiftLaw linear(double slope)
{
  LiftLaw law;
  law.kind = LiftLaw::Kind::Linear;
  law.slope = slope;
  return law;
}

LiftLaw saturating(double slope, double saturation)
{
  LiftLaw law;
  law.slope = slope;
  law.saturation = saturation;
  return law;
}

LiftLaw constant(double coefficient)
{
  LiftLaw law;
  law.kind = LiftLaw::Kind::Constant;
  law.constant = coefficient;
  return law;
}

/// Restitution at vanishing speed, its fall per speed, friction, tangential restitution.
Surface surface(double e, double slope, double mu, double e_t)
{
  Surface law;
  law.restitution = e;
  law.restitution_slope = slope;
  law.friction = mu;
  law.tangential_restitution = e_t;
  return law;
}

template <class Preset>
const Preset* findIn(const std::vector<Preset>& presets, const std::string& name)
{
  for (const Preset& preset : presets)
    if (name == preset.name) return &preset;
  return nullptr;
}

template <class Preset>
std::string namesOf(const std::vector<Preset>& presets)
{
  std::vector<std::string> names;
  for (const Preset& preset : presets) names.push_back(preset.name);
  return joined(names);
}
}  // namespace

const std::vector<FlightPreset>& flightPresets()
{
  static const std::vector<FlightPreset> presets = {
      {"table_rally", DragLaw(), LiftLaw(),
       "C_D with spin and C_L: measured arcs with known spin, 3 to 15 m/s; C_D without spin: measured arcs of a "
       "launcher at "
       "4.6 m/s (docs/validation.md)"},
      {"table_rally_constant_drag", DragLaw::constant(0.53), LiftLaw(),
       "fit to measured table-tennis arcs with known spin, 3 to 15 m/s: median misfit 3 mm over whole arcs"},
      {"half_saturating", DragLaw::constant(0.44), saturating(1.0, 2.0),
       "smooth-sphere drag; C_L = S / (1 + 2 S), Stepanek 1988 (tennis), 1 / (2.022 + 0.981 / S), to 1 %"},
      {"tebbe", DragLaw::constant(0.40), linear(0.6),
       "Tebbe et al., table-tennis robot, Tuebingen: C_D 0.4, C_L = 0.6 S"},
      {"mujoco_deepmind", DragLaw::constant(0.47), linear(1.33),
       "google-deepmind/competitive_robot_table_tennis in MuJoCo: blunt drag 0.235 without the 1/2; Magnus after "
       "MuJoCo's "
       "added mass"},
      {"ace", DragLaw::constant(0.55), constant(0.267), "Sony AI, Ace 2026, analytic baseline: constant C_L"},
  };
  return presets;
}

const std::vector<SurfacePreset>& surfacePresets()
{
  static const std::vector<SurfacePreset> presets = {
      {"table_match", surface(0.99, 0.02, 0.24, 0.15),
       "between table_rigid and 31 bounces on another match table, which ask for e = 1 - 0.02 v (docs/validation.md)"},
      {"table_rigid", surface(0.98, 0.02, 0.24, 0.0),
       "fit to 1 558 measured oblique bounces with spin on a match table"},
      {"table_ittf", surface(0.905, 0.0, 0.25, 0.0),
       "ITTF leaflet T1: dropped from 30 cm it rises about 23 cm, in air; friction: Nakashima et al. 2010"},
      {"rubber_inverted", surface(0.917, 0.0217, kInfinity, 0.70),
       "gossardt/tt_rackets, racket 01: inverted rubber on an offensive blade; no sliding seen up to J_t / J_n = 0.63"},
      {"net", surface(0.1, 0.0, 0.3, 0.0), "guess: a net takes most of the speed"},
      {"floor", surface(0.8, 0.0, 0.4, 0.0), "guess: hard floor"},
      {"wall", surface(0.8, 0.0, 0.4, 0.0), "guess: hard wall"},
  };
  return presets;
}

const FlightPreset* findFlightPreset(const std::string& name)
{
  return findIn(flightPresets(), name);
}
const SurfacePreset* findSurfacePreset(const std::string& name)
{
  return findIn(surfacePresets(), name);
}

std::string flightPresetNames()
{
  return namesOf(flightPresets());
}
std::string surfacePresetNames()
{
  return namesOf(surfacePresets());
}
}  // namespace ping_pong
