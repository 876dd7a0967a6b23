// A match without ROS: two computer players, an umpire and a world, as fast as the processor goes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/umpire.h"
#include "ping_pong_sim/world.h"
#include "play/player.h"

namespace ping_pong
{
struct MatchSetup
{
  std::shared_ptr<const Scene> scene;  ///< table, net, and a paddle at each end
  game::Rules rules;                ///< players of a headless match keep their ends: rules.change_ends has to be false
  std::array<int, 2> levels{5, 5};  ///< of A, at the -x end, and of B
  std::array<play::Style, 2> styles{play::Style::Mixed, play::Style::Mixed};
  std::uint64_t seed = 1;  ///< the same setup, the same match
  game::Player first_server = game::Player::A;
  double tick = 0.01;           ///< between two commands [s]
  double pause = 0.8;           ///< between rallies [s]
  double time_limit = 36000.0;  ///< a match that is not over by then stays undecided [s]
};

struct MatchResult
{
  std::optional<game::Player> winner;     ///< nobody: the time limit was reached
  std::vector<std::array<int, 2>> games;  ///< points of each game
  game::Score score;                      ///< at the end
  std::size_t strokes = 0;                ///< of rallies that were no lets
  double time = 0.0;                      ///< simulated [s]
  std::array<std::size_t, 2> services{};  ///< by A and by B
  std::array<std::size_t, 2> faults{};    ///< services of A and of B that were not good
};

class HeadlessMatch
{
public:
  /// Throws std::invalid_argument, in one line: no court in the scene, a level or rules that are none.
  explicit HeadlessMatch(const MatchSetup& setup);

  /// One tick. False: the match is over.
  bool advance();
  /// To the end.
  MatchResult play();

  const World& world() const { return world_; }
  const game::Umpire& umpire() const { return umpire_; }
  MatchResult result() const;
  /// What was called since this was last asked.
  std::vector<game::Call> takeCalls();

private:
  void movePlayers();
  void serveIfDue();
  void note(const game::Call& call);

  MatchSetup setup_;
  World world_;
  game::Umpire umpire_;
  std::array<std::size_t, 2> paddle_;  ///< index of the body, by index(Player)
  std::vector<play::Player> players_;  ///< by index(Player)
  std::vector<game::Call> calls_;
  std::optional<BallId> ball_;
  double idle_since_ = 0.0;  ///< no ball is in play since then [s]
  MatchResult result_;
};
}  // namespace ping_pong
