// The part of a rally that is the service: ITTF law 2.6, and the let of 2.9.1.1.
#include "game/rally.h"

namespace ping_pong::game
{
Rally::Decision Rally::onToss(const Touch& touch)
{
  const End server = setup_.server;
  const bool racket = touch.part == Part::Racket;
  if (racket && touch.end == server)
  {
    const BallSample struck{touch.time, touch.p_TB, touch.v_TB, 0.0};
    struckBy(server, touch.time, Phase::ServiceStruck);
    if (const auto broken = toss_.strike(court_, rules_, struck)) return fault(touch.time, broken->law, broken->what);
    return std::nullopt;
  }
  if (phase_ == Phase::InHand) return std::nullopt;  // not in play yet
  if (racket) return let(touch.time, "2.9.2.4", who(touch.end) + " disturbed the service: the racket touched the ball");
  return fault(touch.time, "2.6.2", "did not strike the ball before it touched " + court_.nameOf(touch));
}

Rally::Decision Rally::onServiceStruck(const Touch& touch)
{
  const End server = setup_.server;
  if (touch.part == Part::Racket) return touch.end == server ? secondTouchByStriker(touch) : touchedByOpponent(touch);
  touched_since_ = true;
  if (touch.part == Part::Court && touch.end == server)
  {
    phase_ = Phase::ServiceBounced;
    return std::nullopt;
  }
  if (!rules_.service_court && touch.part == Part::Net) return std::nullopt;
  if (!rules_.service_court && touch.part == Part::Court) return landed(touch);
  const std::string what = touch.part == Part::Court ? who(touch.end) + "'s court" : court_.nameOf(touch);
  return fault(touch.time, "2.6.3", "served onto " + what + " before " + who(server) + "'s court");
}

Rally::Decision Rally::onServiceBounced(const Touch& touch)
{
  const End server = setup_.server;
  if (touch.part == Part::Net)
  {
    net_touched_ = true;
    return std::nullopt;
  }
  const bool let_due = net_touched_ && rules_.net_let;
  if (touch.part == Part::Racket && touch.end == server) return secondTouchByStriker(touch);
  if (touch.part == Part::Racket)
  {
    const bool obstructed = court_.mayStillLand(touch.p_TB, touch.v_TB, setup_.radius);
    if (let_due && obstructed)
      return let(touch.time, "2.9.1.1",
                 who(server) + "'s service touched the net assembly and " + who(touch.end) + " obstructed it");
    return touchedByOpponent(touch);
  }
  if (touch.part == Part::Court && touch.end != server)
  {
    if (let_due) return let(touch.time, "2.9.1.1", who(server) + "'s service touched the net assembly");
    return landed(touch);
  }
  if (touch.part == Part::Court) return fault(touch.time, "2.6.3", "served onto the own court twice");
  return fault(touch.time, "2.6.3", "served onto " + court_.nameOf(touch) + ", not the receiver's court");
}
}  // namespace ping_pong::game
