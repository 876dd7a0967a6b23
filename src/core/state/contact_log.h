// The list of contacts of a tick.
#pragma once

#include "state/world_state.h"

namespace ping_pong
{
/// Counts a contact: a new record at the end of the list, to be filled in place, or nullptr if none are kept.
inline Contact* newContact(Records& records, std::size_t i)
{
  records.origins.push_back({static_cast<std::uint32_t>(i), records.run});
  ++records.status.contacts;
  return records.keep_contacts ? &records.contacts.emplace_back() : nullptr;
}

/// What an impact changes of a ball.
struct Impact
{
  const Vector3d& p_WB;
  const Vector3d& v_before;
  const Vector3d& v_after;
  const Vector3d& w_before;
  const Vector3d& w_after;
};

/// A ball, the i-th of the world, has hit a body.
/// @param n_W  normal of the surface, towards the ball
/// @param u  velocity of the touched point of the body
/// @return  the record, or nullptr if none are kept
inline Contact* recordBodyContact(Records& records, const BallRecord& ball, std::size_t i, const Event& event,
                                  const Impact& impact, const Vector3d& n_W, const Vector3d& u, double t)
{
  Contact* contact = newContact(records, i);
  if (!contact) return nullptr;
  contact->time = t;
  contact->ball = ball.id;
  contact->body = event.other;
  contact->shape = event.shape;
  contact->p_WC = impact.p_WB - ball.params().radius * n_W;
  contact->n_W = n_W;
  contact->v_before = impact.v_before;
  contact->v_after = impact.v_after;
  contact->w_before = impact.w_before;
  contact->w_after = impact.w_after;
  contact->v_other = u;
  contact->impulse = ball.params().mass * (impact.v_after - impact.v_before);
  return contact;
}
}  // namespace ping_pong
