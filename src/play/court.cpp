#include "court.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ping_pong::play
{
namespace
{
constexpr double kLevel = 1e-6;  // of the table's z from the vertical [rad]

std::size_t indexOf(const std::vector<Body>& bodies, const std::string& name)
{
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].name == name && bodies[i].kind == BodyKind::Static) return i;
  throw std::invalid_argument("scene: no static body \"table\": expected a table to play on");
}

std::size_t boxOf(const Scene& scene, const Body& body, const std::string& material)
{
  for (std::size_t i = 0; i < body.shapes.size(); ++i)
    if (scene.materials.at(body.shapes[i].material) == material && body.shapes[i].kind == ShapeKind::Box) return i;
  return kNone;
}
}  // namespace

Court::Court(const Scene& scene, End end) : table_(indexOf(scene.bodies, "table"))
{
  const Body& body = scene.bodies[table_];
  surface_ = boxOf(scene, body, "table");
  if (surface_ == kNone)
    throw std::invalid_argument("body \"table\": no box of material \"table\": expected a playing surface");
  if (!((body.pose.q * Vector3d::UnitZ()).z() > 1.0 - 0.5 * kLevel * kLevel))
    throw std::invalid_argument("body \"table\": tilted: expected a level table");
  const Shape& top = body.shapes[surface_];
  material_ = top.material;
  half_length_ = top.half_size.x();
  half_width_ = top.half_size.y();
  const double height = top.p_BS.z() + top.half_size.z();
  const std::size_t net = boxOf(scene, body, "net");
  if (net != kNone) net_height_ = body.shapes[net].p_BS.z() + body.shapes[net].half_size.z() - height;
  X_WO_.p = body.pose.p + body.pose.q * Vector3d(top.p_BS.x(), top.p_BS.y(), height);
  X_WO_.q = end == End::A ? body.pose.q : Quaterniond(body.pose.q * Quaterniond(0.0, 0.0, 0.0, 1.0));
}

End endOfPaddle(const Scene& scene, const std::string& paddle)
{
  const Court court(scene, End::A);
  for (const Body& body : scene.bodies)
    if (body.name == paddle && body.kind == BodyKind::Kinematic)
      return court.toOwn(body.pose).p.x() < 0.0 ? End::A : End::B;
  throw std::invalid_argument("scene '" + scene.name + "': no paddle '" + paddle + "'");
}

BallState Court::toOwn(const BallState& state) const
{
  return {X_WO_.toB(state.p_WB), X_WO_.q.conjugate() * state.q_WB, turnedToOwn(state.v_WB), turnedToOwn(state.w_WB)};
}

BallState Court::toWorld(const BallState& state) const
{
  return {X_WO_.q * state.p_WB + X_WO_.p, X_WO_.q * state.q_WB, turnedToWorld(state.v_WB), turnedToWorld(state.w_WB)};
}

Scene Court::ownScene(const Scene& scene, const BallParams& ball) const
{
  Scene own = scene;
  own.forces.gravity = turnedToOwn(scene.forces.gravity);
  own.forces.wind = turnedToOwn(scene.forces.wind);
  own.bodies.clear();
  for (const Body& body : scene.bodies)
  {
    if (body.kind != BodyKind::Static) continue;
    own.bodies.push_back(body);
    own.bodies.back().pose = toOwn(body.pose);
  }
  BallState start;  // somewhere free, until the first ball is seen
  start.p_WB.z() = 1.0;
  own.balls = {{ball, start}};
  own.method = Method::Exact;
  own.threads = 1;
  return own;
}
}  // namespace ping_pong::play
