#include "validation_models.h"

#include <limits>

#include "ping_pong_sim/constants.h"
#include "scene/presets.h"

namespace ping_pong
{
namespace
{
Forces airOf(const char* preset)
{
  Forces forces;
  forces.gravity = Vector3d(0.0, 0.0, -kStandardGravity);
  forces.drag = forces.magnus = forces.buoyancy = true;
  forces.drag_law = findFlightPreset(preset)->drag;
  forces.lift_law = findFlightPreset(preset)->lift;
  return forces;
}

Surface lawOf(const char* preset)
{
  return findSurfacePreset(preset)->surface;
}

Surface withoutFriction(Surface surface)
{
  surface.friction = 0.0;
  return surface;
}
}  // namespace

Forces defaultForces()
{
  return airOf("table_rally");
}

Forces completeForces()
{
  Forces forces = defaultForces();
  forces.added_mass = true;
  forces.spin_decay = 0.15;
  return forces;
}

Surface defaultTable()
{
  return lawOf("table_match");
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
  const Surface table = defaultTable(), nakashima = surfaceWith(0.93, 0.0, 0.25, 0.0);
  Forces no_magnus = defaultForces(), no_drag = defaultForces(), vacuum = defaultForces(),
         no_buoyancy = defaultForces();
  no_magnus.magnus = no_drag.drag = vacuum.magnus = vacuum.drag = vacuum.buoyancy = no_buoyancy.buoyancy = false;
  return {
      {"default",
       "C_D .33 without spin to .53, C_L = .333 * 7.3 S/(1 + 7.3 S), buoyancy; table e = .99 - .02 v_n, mu .24, e_t "
       ".15",
       defaultForces(), table},
      {"no buoyancy", "default without buoyancy", no_buoyancy, table},
      {"complete", "default and added mass, spin decay .15 /s", completeForces(), table},
      {"no Magnus", "default without Magnus force", no_magnus, table},
      {"no drag", "default without drag", no_drag, table},
      {"vacuum", "gravity alone", vacuum, table},
      {"no friction", "default, smooth table", defaultForces(), withoutFriction(table)},
      {"e .905", "default, table e = .905 (the rule's drop test), mu .25", defaultForces(), lawOf("table_ittf")},
      {"rigid table", "default, table e = .98 - .02 v_n, mu .24: the fit to another table", defaultForces(),
       lawOf("table_rigid")},
      {"its own table", "default, table e = 1 - .02 v_n, mu .24, e_t .15", defaultForces(),
       surfaceWith(1.0, 0.02, 0.24, 0.15)},
      {"constant drag", "C_D .53 at any spin, lift as the default", airOf("table_rally_constant_drag"), table},
      {"S/(1+2S)", "C_D .44, C_L = S/(1 + 2 S)", airOf("half_saturating"), table},
      {"Tebbe", "C_D .40, C_L = .6 S; table e .93, mu .25", airOf("tebbe"), nakashima},
      {"MuJoCo", "C_D .47, C_L = 1.33 S; table e .93, mu .25", airOf("mujoco_deepmind"), nakashima},
      {"Ace", "C_D .55, C_L = .267 at any spin", airOf("ace"), table},
  };
}

std::vector<RubberChoice> rubberChoices()
{
  const Surface rubber = lawOf("rubber_inverted");
  const double grips = std::numeric_limits<double>::infinity();
  Surface rolls = rubber, slides = rubber;
  rolls.tangential_restitution = slides.tangential_restitution = 0.0;
  slides.friction = 0.25;
  return {
      {"default", "e = .917 - .0217 v_n, e_t .70, grips", rubber},
      {"constant e", "e .77, e_t .70, grips", surfaceWith(0.77, 0.0, grips, 0.70)},
      {"Nakashima", "e .81, e_t .76, grips", surfaceWith(0.81, 0.0, grips, 0.76)},
      {"rolls off", "e = .917 - .0217 v_n, e_t 0, grips", rolls},
      {"slides", "e = .917 - .0217 v_n, e_t 0, mu .25 as on the table", slides},
      {"no friction", "e = .917 - .0217 v_n, smooth", withoutFriction(rolls)},
  };
}
}  // namespace ping_pong
