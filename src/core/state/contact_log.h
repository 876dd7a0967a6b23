// The list of contacts of a tick: the one way in which all methods fill it.
#pragma once

#include "state/world_state.h"

namespace ping_pong
{
/// What a ball has hit: a shape of a body, or another ball.
struct HitObject
{
  std::size_t body = kNone, shape = kNone;
  bool is_ball = false;
  BallId ball = 0;

  static HitObject shapeOf(std::size_t body, std::size_t shape) { return {body, shape}; }
  static HitObject ballOf(BallId id) { return {kNone, kNone, true, id}; }
};

/// One impact of a ball.
struct Impact
{
  double time;           ///< [s]
  const Vector3d& n_W;   ///< unit normal of what was hit, towards the ball
  const Vector3d& u;     ///< velocity of the touched point of it, before [m/s]
  const Vector3d& p_WB;  ///< [m]
  const Vector3d& v_before;
  const Vector3d& v_after;
  const Vector3d& w_before;
  const Vector3d& w_after;
  const Vector3d& impulse;  ///< on the ball [N s]
};

/// Counts a contact of a ball, the i-th of the world, and adds it to the list, if one is kept.
[[gnu::always_inline]] inline void recordContact(Records& records, const BallRecord& ball, std::size_t i,
                                                 const HitObject& other, const Impact& impact)
{
  records.provenances.push_back({static_cast<std::uint32_t>(i), records.run});
  ++records.status.contacts;
  if (!records.keep_contacts) return;
  Contact& contact = records.contacts.emplace_back();
  contact.time = impact.time;
  contact.ball = ball.id;
  contact.with_ball = other.is_ball;
  contact.other_ball = other.ball;
  contact.body = other.body;
  contact.shape = other.shape;
  contact.p_WC = impact.p_WB - ball.params().radius * impact.n_W;
  contact.n_W = impact.n_W;
  contact.v_before = impact.v_before;
  contact.v_after = impact.v_after;
  contact.w_before = impact.w_before;
  contact.w_after = impact.w_after;
  contact.v_other = impact.u;
  contact.impulse = impact.impulse;
}

/// What a change of its velocity takes [N s].
inline Vector3d impulseOf(const BallRecord& ball, const Vector3d& v_before, const Vector3d& v_after)
{
  return ball.params().mass * (v_after - v_before);
}
}  // namespace ping_pong
