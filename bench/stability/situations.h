// Situations in which simple methods fail, each a small experiment with a number for an answer. Tests and the stability
// map share them. `dt` is the longest step; `exact` does not look at it.
#pragma once

#include <vector>

#include "testing/scene_builder.h"

namespace ping_pong::stability
{
// --- plates.cpp: fast balls, thin plates ---

struct Shots
{
  double missed = 0.0;      ///< part of the shots that flew through
  double wrong_side = 0.0;  ///< part that touched and was pushed out behind
};

/// Shots down at a horizontal plate, from places spread evenly over the way of one step.
Shots shootAtPlate(Method method, double dt, double thickness, double speed, int count = 200);

/// The same from one place: `phase` (0 to 1) of a step's way further off. The middle of the plate is z = 0.
World shotAtPlate(Method method, double dt, double thickness, double speed, double phase, double restitution = 1.0);

// --- moving_bodies.cpp: the surface has to be where it is, and as fast as it is, at the instant of the hit ---

constexpr double kBladeTurn = 60.0;        // [rad/s]
constexpr double kBladeThickness = 0.006;  // [m]
constexpr double kBladeRestitution = 0.8;

/// A blade of 0.2 m turns about the z axis at an end of its own; the ball waits on the y axis, `lever` from the origin.
World turningBlade(Method method, double dt, double lever);

/// Velocity of that ball after the hit, relative to the closed form (1 + e) w s n: worst of 50 levers; infinite if it
/// was missed.
double turningBladeError(Method method, double dt);

struct Orbit
{
  std::size_t hits = 0;
  double time = 0.0;   ///< worst error of the instants of the first 50 hits [s]
  double speed = 0.0;  ///< worst error of the speed after them [m/s]
};

/// A ball on a vibrating paddle for 50 periods, on the orbit of one period: paddle speed (g T/2)(1 - e)/(1 + e) at the
/// hit.
Orbit vibratingPaddle(Method method, double dt);

struct Closing
{
  std::size_t hits = 0, expected = 0;
  double speed = 0.0;  ///< relative error of the velocity at the end
  double place = 0.0;  ///< error of the place at the end [m]
};

/// An elastic ball between a wall and one that comes nearer: every hit of that one adds twice its speed.
Closing closingWalls(Method method, double dt);

// --- rest.cpp ---

/// Error of the instant at which a ball dropped from 0.3 m with e = 0.9 comes to rest [s]; infinite if it never does.
double endOfBouncing(Method method, double dt);

/// Greatest speed of a ball that lies on a table, over 60 s [m/s].
double restingJitter(Method method, double dt);

/// A ball waits on a table for 1000 s, then another is dropped next to it. How far they are 1 s later from where they
/// would be without the waiting [m].
double waiting(Method method, double dt);

/// The same for a bounce 1e6 m from the origin, over 2 s [m].
double farAway(Method method, double dt);

// --- lines.cpp: balls on a line ---

/// Balls `gap` apart on the x axis, the first `incoming` of them thrown at the rest with 1 m/s from 0.1 m away.
SceneBuilder cradle(int balls, int incoming, double gap, double restitution = 1.0, Method method = Method::Exact,
                    double dt = 1e-3);

/// Worst error of a place [m] or speed [m/s] over gaps of 0, 1 nm, 1 um and 1 mm with one, two and three of five balls
/// thrown, from either end of the list.
double cradleError(Method method, double dt);

/// Galperin 2003: a heavy ball pushes a light one at a wall; mass ratio 100^n makes the first n + 1 digits of pi.
std::size_t galperinHits(Method method, double dt, double mass_ratio);

/// Three balls with e = 0.05, which meet infinitely often in finite time: worst difference from their common velocity
/// in the end [m/s]; infinite if the work was.
double collapseError(Method method, double dt);

// --- features.cpp: corners, edges, hair's breadths ---

/// Worst velocity after a right angle was hit in the middle, under 1 to 89 degrees, walls listed in either order [m/s].
double twoWallsError(Method method, double dt);

/// Balls that hit the edge and the corner of a box from many heights: worst velocity, relative to the closed form.
double edgeError(Method method, double dt);

/// Parabolas that clear the edge of a net by 1 um or touch it by 1 um: how many of 100 are called wrongly.
int wrongNetCalls(Method method, double dt);

/// Balls that start in touch with a wall or a ball, closing in, receding or moving along: how many of 5 go wrong.
int wrongTouchingStarts(Method method, double dt);

// --- overlap.cpp ---

/// Greatest speed of a ball that starts 15 mm deep in a table [m/s].
double overlapAtStart(Method method, double dt);

/// How deep a ball gets into a table on which a paddle presses it until 28 mm are left of its 40 [m]; infinite if it is
/// lost or not finite.
double squeezeDepth(Method method, double dt);

// --- air.cpp ---

/// Drag on a ball at 10 000 m/s for 0.1 s: relative error of v0/(1 + k v0 t).
double fastDragError(Method method, double dt);

/// A spin of 2000 rad/s and no speed, or hardly any, for each lift law without gravity: greatest speed after 1 s [m/s].
double spinWithoutSpeed(Method method, double dt);

/// The Magnus force alone turns a ball on a circle and does no work: relative change of its speed after one turn.
double magnusCircleError(Method method, double dt);
}  // namespace ping_pong::stability
