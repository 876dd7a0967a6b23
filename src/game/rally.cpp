#include "game/rally.h"

namespace ping_pong::game
{
const char* name(Phase phase)
{
  switch (phase)
  {
    case Phase::BeforeService:
      return "before service";
    case Phase::InHand:
      return "in hand";
    case Phase::Toss:
      return "toss";
    case Phase::ServiceStruck:
      return "service struck";
    case Phase::ServiceBounced:
      return "service bounced";
    case Phase::ReturnStruck:
      return "return struck";
    case Phase::InCourt:
      return "in court";
    case Phase::RallyOver:
      return "rally over";
    case Phase::GameOver:
      return "game over";
    case Phase::MatchOver:
      break;
  }
  return "match over";
}

void Rally::begin(const RallySetup& setup)
{
  setup_ = setup;
  toss_.begin(setup.server, setup.radius);
  phase_ = rules_.toss ? Phase::InHand : Phase::Toss;
  striker_ = setup.server;
  strokes_ = returns_ = 0;
  net_touched_ = touched_since_ = lying_ = false;
  touch_time_ = stroke_time_ = setup.time;
  before_.reset();
}

void Rally::feed(const RallySetup& setup)
{
  begin(setup);
  phase_ = Phase::ServiceStruck;
}

Rally::Decision Rally::thrown(const BallSample& sample)
{
  phase_ = Phase::Toss;
  touch_time_ = sample.time;
  if (const auto broken = toss_.leave(court_, rules_, sample)) return fault(sample.time, broken->law, broken->what);
  return std::nullopt;
}

Rally::Decision Rally::touched(const Touch& touch)
{
  if (touch.part == Part::Ball && inPlay(phase_))
    return let(touch.time, "2.9.2.4", "another ball touched the ball in play");
  before_.reset();
  touch_time_ = touch.time;
  lying_ = false;
  switch (phase_)
  {
    case Phase::InHand:
    case Phase::Toss:
      return onToss(touch);
    case Phase::ServiceStruck:
      return onServiceStruck(touch);
    case Phase::ServiceBounced:
      return onServiceBounced(touch);
    case Phase::ReturnStruck:
      return onReturnStruck(touch);
    case Phase::InCourt:
      return onInCourt(touch);
    default:
      return std::nullopt;
  }
}

Rally::Decision Rally::onReturnStruck(const Touch& touch)
{
  if (touch.part == Part::Racket) return touch.end == striker_ ? secondTouchByStriker(touch) : touchedByOpponent(touch);
  touched_since_ = true;
  if (touch.part == Part::Net) return std::nullopt;  // 2.7.1
  if (touch.part == Part::Court && touch.end != striker_) return landed(touch);
  if (touch.part == Part::Court)
    return pointAgainst(striker_, touch.time, "2.10.1.2",
                        who(striker_) + "'s return touched " + who(striker_) + "'s own court");
  return pointAgainst(striker_, touch.time, "2.10.1.2",
                      who(striker_) + "'s return touched " + court_.nameOf(touch) + " before the opponent's court");
}

Rally::Decision Rally::onInCourt(const Touch& touch)
{
  const End receiver = other(striker_);
  if (touch.part == Part::Net) return std::nullopt;
  if (touch.part == Part::Racket && touch.end == receiver)
  {
    struckBy(receiver, touch.time, Phase::ReturnStruck);
    return std::nullopt;
  }
  if (touch.part == Part::Racket)
    return pointAgainst(striker_, touch.time, "2.10.1.7", who(striker_) + " struck the ball twice in succession");
  if (touch.part == Part::Court && touch.end == receiver)
    return pointAgainst(receiver, touch.time, "2.10.1.3", "the ball touched " + who(receiver) + "'s court twice");
  const std::string what = touch.part == Part::Court ? who(striker_) + "'s court" : court_.nameOf(touch);
  return pointAgainst(receiver, touch.time, "2.10.1.3",
                      "the ball touched " + what + " before " + who(receiver) + " struck it");
}

void Rally::struckBy(End end, double time, Phase next)
{
  striker_ = end;
  stroke_time_ = time;
  touched_since_ = false;
  phase_ = next;
  ++strokes_;
}

// 2.10.1.7. A ball that stays on the rubber, or rattles between blade and rubber, is struck once.
Rally::Decision Rally::secondTouchByStriker(const Touch& touch)
{
  if (!touched_since_ && strokes_ > 0 && touch.time - stroke_time_ <= rules_.double_hit) return std::nullopt;
  return pointAgainst(striker_, touch.time, "2.10.1.7", who(striker_) + " struck the ball twice in succession");
}

// The opponent touches a ball that has not touched the opponent's court: 2.5.8 and 2.10.1.6, unless it was out already.
Rally::Decision Rally::touchedByOpponent(const Touch& touch)
{
  const End opponent = other(striker_);
  if (court_.mayStillLand(touch.p_TB, touch.v_TB, setup_.radius))
    return pointAgainst(opponent, touch.time, "2.10.1.6",
                        who(opponent) + " obstructed the ball: it had not touched " + who(opponent) + "'s court");
  return notReached(touch.time, "was out when " + who(opponent) + " touched it", "2.10.1.4");
}

// A good service or return (2.6.3, 2.7.1); the thirteenth of the receiver scores (2.15.4).
Rally::Decision Rally::landed(const Touch& touch)
{
  phase_ = Phase::InCourt;
  const End receiver = other(setup_.server);
  if (striker_ != receiver || ++returns_ < rules_.expedite_returns || !setup_.expedite) return std::nullopt;
  return pointAgainst(setup_.server, touch.time, "2.15.4",
                      who(receiver) + " made " + std::to_string(returns_) + " good returns");
}

Rally::Decision Rally::racketTouchedNet(double time, End end) const
{
  if (!inPlay(phase_)) return std::nullopt;
  return pointAgainst(end, time, "2.10.1.10", who(end) + "'s racket touched the net assembly");
}

Rally::Decision Rally::movedPlayingSurface(double time, End end) const
{
  if (!inPlay(phase_)) return std::nullopt;
  return pointAgainst(end, time, "2.10.1.9", who(end) + " moved the playing surface");
}

Verdict Rally::fault(double time, const char* law, const std::string& what) const
{
  return {CallKind::Fault, time, other(setup_.server), law, who(setup_.server) + " " + what};
}

Verdict Rally::pointAgainst(End loser, double time, const char* law, const std::string& what) const
{
  return {CallKind::Point, time, other(loser), law, what};
}

Verdict Rally::let(double time, const char* law, const std::string& reason) const
{
  return {CallKind::Let, time, End::Minus, law, reason};
}
}  // namespace ping_pong::game
