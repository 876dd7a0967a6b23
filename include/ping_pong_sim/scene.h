// A scene: what is in the world, which forces and contact laws act, and which method runs it. It names all that is computed.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "ping_pong_sim/ball.h"
#include "ping_pong_sim/body.h"
#include "ping_pong_sim/forces.h"

namespace ping_pong
{
/// How to evolve and how to detect; see docs/physics.md.
enum class Method
{
  EulerExplicit,      ///< x += v h; v += a h; contacts at step ends
  EulerSemiImplicit,  ///< v += a h; x += v h; contacts at step ends
  Verlet,             ///< velocity Verlet; contacts at step ends
  Rk4,                ///< classic Runge-Kutta; contacts at step ends
  Rk4Located,         ///< classic Runge-Kutta; contacts located inside the step, as in `exact`
  Impulse,            ///< velocity Verlet; impacts located inside the step, contacts that carry load solved together
  Exact,              ///< closed form or polynomials of controlled error; contacts located and handled event by event
  Auto                ///< the cheapest of the others that meets the scene's tolerance, see choose_method.h
};

/// All that can run, from the simplest to the best: a World resolves Auto to one of them.
constexpr std::array<Method, 7> kMethods = {Method::EulerExplicit, Method::EulerSemiImplicit, Method::Verlet,
                                            Method::Rk4,           Method::Rk4Located,        Method::Impulse,
                                            Method::Exact};

/// Contacts are found where they happen, and balls come to rest; else they are looked for at step ends only.
/// @param method  not Auto, which may come to either
constexpr bool locatesContacts(Method method)
{
  return method == Method::Rk4Located || method == Method::Impulse || method == Method::Exact;
}

/// What happens when two materials meet. What a scene does not name stays at the default and is not computed.
struct Surface
{
  double restitution = 1.0;             ///< e at vanishing speed: normal speed after / before, 0 to 1
  double restitution_slope = 0.0;       ///< e falls by this per normal speed, never below 0 [s/m]
  double friction = 0.0;                ///< Coulomb mu; 0: smooth; infinity: always grips
  double tangential_restitution = 0.0;  ///< e_t of a gripping contact, -1 to 1: slip after / before, reversed
  double rolling_resistance = 0.0;      ///< deceleration of a rolling ball / (load / m)
  double spin_friction = 0.0;           ///< torque against spin about the normal / (r load)

  double restitutionAt(double closing_speed) const
  {
    const double e = restitution - restitution_slope * closing_speed;
    return e > 0.0 ? e : 0.0;
  }
};

/// Contact law of each pair of materials, looked up by index.
class SurfaceTable
{
public:
  SurfaceTable() = default;
  explicit SurfaceTable(std::size_t materials) : materials_(materials), table_(materials * materials) {}
  const Surface& at(MaterialId a, MaterialId b) const { return table_[a * materials_ + b]; }
  void set(MaterialId a, MaterialId b, const Surface& surface)
  {
    table_[a * materials_ + b] = surface;
    table_[b * materials_ + a] = surface;
  }

private:
  std::size_t materials_ = 0;
  std::vector<Surface> table_;
};

struct SceneBall
{
  BallParams params;
  BallState state;
};

struct Scene
{
  std::string name;
  std::string path;  ///< file it was loaded from; empty if built in code
  Forces forces;
  std::vector<std::string> materials;  ///< names, by MaterialId
  SurfaceTable surfaces;
  std::vector<Body> bodies;  ///< the floor, if any, is the static body "floor" with one HalfSpace
  std::vector<SceneBall> balls;
  Method method = Method::Auto;
  double dt = 1e-3;  ///< longest step of all methods but `exact`, which steps piles with it, at most 2 ms [s]
  double tolerance =
      1e-6;  ///< of `exact` where the path has no closed form: position error over a rally of about a second [m]
  std::size_t threads = 1;  ///< that share the work on a crowd; the result is the same for any number
};

const char* name(Method method);
/// All names, from the simplest to the best, then auto, with a comma between them.
std::string methodNames();
/// Throws std::invalid_argument that lists the known names.
Method methodFromName(const std::string& text);
}  // namespace ping_pong
