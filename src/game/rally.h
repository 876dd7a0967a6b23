// One rally, from the ball in the server's hand to a point or a let: the state machine of the umpire, without any score.
#pragma once

#include <optional>
#include <string>

#include "game/call.h"
#include "game/court.h"
#include "game/phase.h"
#include "game/toss.h"

namespace ping_pong::game
{
/// How a rally ended.
struct Verdict
{
  CallKind kind = CallKind::Point;  ///< Point, Fault or Let
  double time = 0.0;                ///< [s]
  End winner = End::Minus;          ///< unless it is a let
  const char* law = "";
  std::string reason;
};

/// Who plays the rally, and with what.
struct RallySetup
{
  double time = 0.0;  ///< of its beginning [s]
  BallId ball = 0;
  double radius = kBallRadius;                  ///< of the ball [m]
  End server = End::Minus;                      ///< where the server stands
  PlayersAtEnds players{Player::A, Player::B};  ///< for sentences
  bool expedite = false;                        ///< the receiver's returns are counted (2.15.4)
};

class Rally
{
public:
  Rally(const Court& court, const Rules& rules) : court_(court), rules_(rules) {}

  Phase phase() const { return phase_; }
  BallId ball() const { return setup_.ball; }
  double radius() const { return setup_.radius; }
  int strokes() const { return strokes_; }
  const Court& court() const { return court_; }
  void moveTable(const Pose& X_WB) { court_.moveTable(X_WB); }

  void begin(const RallySetup& setup);                        ///< InHand, or Toss where no toss is asked
  void feed(const RallySetup& setup);                         ///< ServiceStruck by no racket
  void end(Phase over = Phase::RallyOver) { phase_ = over; }  ///< decided, here or elsewhere

  // Each is told in order of time, and answers as soon as the rally is decided.
  std::optional<Verdict> thrown(const BallSample& sample);
  std::optional<Verdict> touched(const Touch& touch);
  /// Where the ball is at the end of a tick.
  std::optional<Verdict> seen(const BallSample& sample);
  std::optional<Verdict> racketTouchedNet(double time, End end) const;     ///< 2.10.1.10
  std::optional<Verdict> movedPlayingSurface(double time, End end) const;  ///< 2.10.1.9, by the player at that end

private:
  using Decision = std::optional<Verdict>;

  Decision onToss(const Touch& touch);
  Decision onServiceStruck(const Touch& touch);
  Decision onServiceBounced(const Touch& touch);
  Decision onReturnStruck(const Touch& touch);
  Decision onInCourt(const Touch& touch);

  Decision secondTouchByStriker(const Touch& touch);
  Decision touchedByOpponent(const Touch& touch);
  Decision landed(const Touch& touch);
  void struckBy(End end, double time, Phase next);

  Decision passedThroughNet(const BallSample& sample) const;
  Decision passedEndLine(const BallSample& sample) const;
  Decision lost(const BallSample& sample);
  Decision notReached(double time, const std::string& what, const char* law = "2.10.1.2") const;
  bool lies(const BallSample& sample) const;

  Verdict fault(double time, const char* law, const std::string& what) const;
  Verdict pointAgainst(End loser, double time, const char* law, const std::string& what) const;
  Verdict let(double time, const char* law, const std::string& reason) const;
  std::string who(End end) const { return name(setup_.players[index(end)]); }

  Court court_;
  Rules rules_;
  RallySetup setup_;
  Toss toss_;
  Phase phase_ = Phase::BeforeService;
  End striker_ = End::Minus;    // struck last
  int strokes_ = 0;             // the service included
  int returns_ = 0;             // good ones of the receiver
  double stroke_time_ = 0.0;    // first touch of the last stroke [s]
  bool touched_since_ = false;  // something since the last stroke
  bool net_touched_ = false;    // by the service
  double touch_time_ = 0.0;     // of the last touch, whatever it was [s]
  double lies_since_ = 0.0;     // if lying_ [s]
  bool lying_ = false;
  std::optional<BallSample> before_;  // sample before, if nothing was touched since
};
}  // namespace ping_pong::game
