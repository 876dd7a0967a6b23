#include "rally.h"

#include <algorithm>
#include <cmath>

namespace ping_pong_sim
{
namespace
{
constexpr double kFaintest = 0.15;  ///< change of normal speed of an impact worth telling [m/s]

bool isFloor(const ping_pong::Body& body)
{
  return body.kind == ping_pong::BodyKind::Static && body.urdf_path.empty();
}
}  // namespace

void Rally::observe(const ping_pong::World& world, const std::function<bool(std::size_t body)>& is_played)
{
  for (const ping_pong::Contact& contact : world.contacts())
  {
    if (std::abs((contact.v_after - contact.v_before).dot(contact.n_W)) < kFaintest) continue;
    last_ = contact;
    if (!contact.with_ball) observe(world, contact, is_played);
  }
}

void Rally::observe(const ping_pong::World& world, const ping_pong::Contact& contact,
                    const std::function<bool(std::size_t body)>& is_played)
{
  const ping_pong::Body& body = world.body(contact.body);
  if (body.kind == ping_pong::BodyKind::Kinematic)
  {
    if (!is_played(contact.body)) return;
    hits_ = ball_ == contact.ball ? hits_ + 1 : 1;
    ball_ = contact.ball;
    best_ = std::max(best_, hits_);
  }
  else if (isFloor(body) && ball_ == contact.ball)
  {
    ball_.reset();
    hits_ = 0;
  }
}
}  // namespace ping_pong_sim
