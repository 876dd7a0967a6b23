#include "validation_models.h"

#include <limits>

#include "ping_pong_sim/constants.h"

namespace ping_pong
{
namespace
{
Forces withLaws(double C_D, LiftLaw::Kind kind, double slope_or_constant, double saturation = 0.0)
{
  Forces forces = defaultForces();
  forces.drag_law.constant = C_D;
  forces.lift_law.kind = kind;
  forces.lift_law.slope = slope_or_constant;
  forces.lift_law.constant = slope_or_constant;
  forces.lift_law.saturation = saturation;
  return forces;
}

Surface withoutFriction(Surface surface)
{
  surface.friction = 0.0;
  return surface;
}
}  // namespace

Forces defaultForces()
{
  Forces forces;
  forces.gravity = Vector3d(0.0, 0.0, -kStandardGravity);
  forces.drag = forces.magnus = true;
  return forces;
}

Forces completeForces()
{
  Forces forces = defaultForces();
  forces.buoyancy = forces.added_mass = true;
  forces.spin_decay = 0.15;
  return forces;
}

Surface defaultTable()
{
  Surface table;
  table.restitution = 0.98;
  table.restitution_slope = 0.02;
  table.friction = 0.24;
  return table;
}

Forces spinDragForces(double C_D_without_spin)
{
  Forces forces = defaultForces();
  forces.buoyancy = true;
  const double full = forces.drag_law.constant;
  forces.drag_law.reynolds = {1e4};  // any
  forces.drag_law.spin_ratio = {0.0, 0.2};
  forces.drag_law.values = {C_D_without_spin, full};
  return forces;
}

Surface surfaceWith(double restitution, double slope, double friction, double tangential)
{
  Surface table;
  table.restitution = restitution;
  table.restitution_slope = slope;
  table.friction = friction;
  table.tangential_restitution = tangential;
  return table;
}

Scene tableScene(const Forces& forces, const Surface& table, double tolerance)
{
  Scene scene;
  scene.forces = forces;
  scene.tolerance = tolerance;
  scene.materials = {"ball", "table"};
  scene.surfaces = SurfaceTable(2);
  scene.surfaces.set(0, 1, table);
  Body plane;
  plane.name = "table";
  plane.shapes.resize(1);
  plane.shapes[0].kind = ShapeKind::HalfSpace;
  plane.shapes[0].material = 1;
  scene.bodies.push_back(plane);
  scene.balls.resize(1);
  return scene;
}

std::vector<FlightChoice> flightChoices()
{
  const Surface table = defaultTable();
  Forces no_magnus = defaultForces(), no_drag = defaultForces(), vacuum = defaultForces(), buoyant = defaultForces();
  no_magnus.magnus = no_drag.drag = vacuum.magnus = vacuum.drag = false;
  buoyant.buoyancy = true;
  using Kind = LiftLaw::Kind;
  return {
      {"default", "C_D .53, C_L = .333 * 7.3 S/(1 + 7.3 S); table e = .98 - .02 v_n, mu .24", defaultForces(), table},
      {"with buoyancy", "default and buoyancy", buoyant, table},
      {"complete", "default and buoyancy, added mass, spin decay .15 /s", completeForces(), table},
      {"no Magnus", "default without Magnus force", no_magnus, table},
      {"no drag", "default without drag", no_drag, table},
      {"vacuum", "gravity alone", vacuum, table},
      {"no friction", "default, smooth table", defaultForces(), withoutFriction(table)},
      {"e .905", "default, table e = .905 (the rule's drop test), mu .24", defaultForces(), surfaceWith(0.905, 0.0, 0.24, 0.0)},
      {"S/(1+2S)", "C_D .44, C_L = S/(1 + 2 S)", withLaws(0.44, Kind::Saturating, 1.0, 2.0), table},
      {"Tebbe", "C_D .40, C_L = .6 S; table e .93, mu .25", withLaws(0.40, Kind::Linear, 0.6), surfaceWith(0.93, 0.0, 0.25, 0.0)},
      {"MuJoCo", "C_D .47, C_L = 1.33 S; table e .93, mu .25", withLaws(0.47, Kind::Linear, 1.33),
       surfaceWith(0.93, 0.0, 0.25, 0.0)},
      {"Ace", "C_D .55, C_L = .267 at any spin", withLaws(0.55, Kind::Constant, 0.267), table},
      {"spin drag", "default and buoyancy, C_D .33 without spin to .53 at S .2", spinDragForces(0.33), table},
      {"spin drag, its table", "the same; table e = 1 - .02 v_n, mu .24, e_t .15", spinDragForces(0.33),
       surfaceWith(1.0, 0.02, 0.24, 0.15)},
  };
}

std::vector<RubberChoice> rubberChoices()
{
  const double e = 0.917, slope = 0.0217, grips = std::numeric_limits<double>::infinity();
  return {
      {"default", "e = .917 - .0217 v_n, e_t .70, grips", surfaceWith(e, slope, grips, 0.70)},
      {"constant e", "e .77, e_t .70, grips", surfaceWith(0.77, 0.0, grips, 0.70)},
      {"Nakashima", "e .81, e_t .76, grips", surfaceWith(0.81, 0.0, grips, 0.76)},
      {"rolls off", "e = .917 - .0217 v_n, e_t 0, grips", surfaceWith(e, slope, grips, 0.0)},
      {"slides", "e = .917 - .0217 v_n, e_t 0, mu .25 as on the table", surfaceWith(e, slope, 0.25, 0.0)},
      {"no friction", "e = .917 - .0217 v_n, smooth", surfaceWith(e, slope, 0.0, 0.0)},
  };
}
}  // namespace ping_pong
