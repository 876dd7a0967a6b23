// The umpire: watches one ball in play, calls points and lets by the ITTF laws, and keeps the score. See docs/game.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/call.h"
#include "game/rally.h"
#include "ping_pong_sim/ball.h"
#include "ping_pong_sim/world.h"

namespace ping_pong::game
{
/// A ball that a player is about to serve, or that a launcher has fed.
struct Service
{
  BallId ball = 0;
  double radius = kBallRadius;   ///< of the ball [m]
  std::optional<Player> server;  ///< who serves; nobody: whose turn it is
};

/// Told in order of time [s]: contacts of a tick, then the state of the ball at its end (observe() does all of that). Whatever
/// comes in another order, or after time has gone back, is dropped, and a rally that is on becomes a let. Positions and
/// velocities are in the world frame W. After a point nothing counts until the next service.
class Umpire
{
public:
  /// Throws std::invalid_argument where checkRules() does.
  Umpire(const Court& court, const Rules& rules, Player first_server = Player::A);

  /// Forgets score, expedite system and rally. A stands at the -x end again.
  void newMatch(double time, Player first_server = Player::A);

  // A ball comes into play. Refused, with nothing changed: out of turn, with a ball in play, after the match.
  Refusal putInPlay(double time,
                    const Service& service);            ///< it rests on the server's palm; with `relaxed` it is in play
  Refusal thrown(double time, const BallState& state);  ///< it leaves the palm, with this velocity
  Refusal feed(double time, const Service& service);  ///< a launcher has served; only where service_court is not asked

  // What happens.
  void contact(const Contact& contact);              ///< of any ball
  void ballAt(double time, const BallState& state);  ///< the ball in play
  void clock(double time);                           ///< nothing else happened until then
  void racketTouchedNet(double time, End end);       ///< 2.10.1.10
  /// The table stands at X_WB now. By a player: 2.10.1.9; by nobody: a let.
  void tableMoved(double time, const Pose& X_WB, std::optional<Player> by = std::nullopt);

  // From outside. Refused where there is nothing to stop.
  Refusal let(double time, const std::string& reason, const char* law = "2.9.2.4");
  Refusal receiverNotReady(double time);  ///< 2.9.1.2: until the receiver's racket has touched the ball
  Refusal requestExpedite(double time);   ///< 2.15.1: both players ask for it
  Refusal forfeit(double time, Player loser,
                  const std::string& reason);  ///< of the match; `reason` follows the name of `loser`

  Phase phase() const { return rally_.phase(); }
  const Score& score() const { return score_.score(); }
  const std::vector<std::array<int, 2>>& finishedGames() const { return score_.finishedGames(); }
  Player playerAt(End end) const { return score_.playerAt(end); }
  End endOf(Player player) const { return score_.endOf(player); }
  const Court& court() const { return rally_.court(); }
  const Rules& rules() const { return rules_; }
  /// The ball in hand or in play.
  std::optional<BallId> ball() const;

  /// All that was called since takeCalls() was last asked, in order.
  const std::vector<Call>& calls() const { return calls_; }
  std::vector<Call> takeCalls();

private:
  bool timeRuns(double time);
  void expediteIfDue(double time);
  void introduceExpedite(double time, const std::string& why);
  Refusal mayServe(const Service& service) const;
  RallySetup setupOf(double time, const Service& service) const;
  BallSample sampleOf(double time, const BallState& state) const;
  void decide(const std::optional<Verdict>& verdict);
  void callLet(double time, const std::string& law, const std::string& reason);
  void callPoint(const Verdict& verdict);
  void call(double time, CallKind kind, const std::string& law, const std::string& reason,
            std::optional<Player> winner = std::nullopt);

  Rules rules_;
  Rally rally_;
  MatchScore score_;
  std::vector<Call> calls_;
  double time_ = 0.0;                  // of what was told last [s]
  std::optional<double> game_start_;   // first service of this game [s]
  std::optional<Player> last_server_;  // of the rally before, in this game (2.15.3)
  bool received_ = false;              // the receiver's racket has touched the ball of this rally
};
}  // namespace ping_pong::game
