// The models that `validate` compares: the default, what is left of it when something is taken out, and published ones.
#pragma once

#include <string>
#include <vector>

#include "ping_pong_sim/scene.h"

namespace ping_pong
{
struct FlightChoice
{
  std::string name;  ///< short, for tables and plots
  std::string what;  ///< one line
  Forces forces;
  Surface table;
};

struct RubberChoice
{
  std::string name;
  std::string what;
  Surface rubber;
};

/// Gravity, buoyancy, drag and Magnus force with the default constants, as in scene `rally`.
Forces defaultForces();
/// The default, added mass and spin decay: what omissions are measured against.
Forces completeForces();
Surface defaultTable();
/// e at vanishing speed, its fall per speed [s/m], mu, e_t.
Surface surfaceWith(double restitution, double slope, double friction, double tangential);

/// One ball above an infinite table at z = 0. @param tolerance  of `exact` [m]
Scene tableScene(const Forces& forces, const Surface& table, double tolerance);

/// The first one is the default.
std::vector<FlightChoice> flightChoices();
std::vector<RubberChoice> rubberChoices();
}  // namespace ping_pong
