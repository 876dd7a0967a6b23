// A scene: what is in the world, which forces and contact laws act, and which method runs it. It names all that is computed.
#pragma once

#include <string>
#include <vector>

#include "ping_pong_sim/ball.h"
#include "ping_pong_sim/body.h"

namespace ping_pong
{
/// How to evolve and how to detect; see docs/physics.md.
enum class Method
{
  EulerExplicit,      ///< x += v h; v += a h; contacts at step ends
  EulerSemiImplicit,  ///< v += a h; x += v h; contacts at step ends
  Exact               ///< closed-form flight, contacts located and handled event by event
};

struct Forces
{
  Vector3d gravity = Vector3d::Zero();  ///< expressed in W [m/s^2]; zero if the scene does not list it
};

/// What happens when two materials meet.
struct Surface
{
  double restitution = 1.0;  ///< e: normal speed after / before, 0 to 1
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
  Method method = Method::Exact;
  double dt = 1e-3;  ///< longest step of the fixed-step methods [s]
};

const char* name(Method method);
/// Throws std::invalid_argument that lists the known names.
Method methodFromName(const std::string& text);
}  // namespace ping_pong
