#include "game/rules.h"

#include <limits>
#include <sstream>
#include <stdexcept>

namespace ping_pong::game
{
namespace
{
Rules relaxedRules()
{
  Rules rules;
  rules.name = "relaxed";
  rules.toss = rules.service_place = rules.change_ends = false;
  rules.games = 1;
  return rules;
}

Rules rallyRules()
{
  Rules rules = relaxedRules();
  rules.name = "rally";
  rules.keep_score = rules.service_court = rules.net_let = false;
  rules.expedite_after = std::numeric_limits<double>::infinity();
  return rules;
}

template <typename Value>
void expect(bool good, const char* key, Value value, const char* expected)
{
  if (good) return;
  std::ostringstream text;
  text << "rules: " << key << ": " << value << ": expected " << expected;
  throw std::invalid_argument(text.str());
}
}  // namespace

Rules rulesPreset(const std::string& name)
{
  if (name == "ittf") return Rules();
  if (name == "relaxed") return relaxedRules();
  if (name == "rally") return rallyRules();
  throw std::invalid_argument("unknown rules '" + name + "': expected one of " + rulesPresetNames());
}

std::string rulesPresetNames()
{
  return "ittf, relaxed, rally";
}

void checkRules(const Rules& rules)
{
  expect(rules.points_per_game >= 1 && rules.points_per_game <= 1000, "points_per_game", rules.points_per_game,
         "1 to 1000");
  expect(rules.lead >= 1 && rules.lead <= rules.points_per_game, "lead", rules.lead, "1 to points_per_game");
  expect(rules.games >= 1 && rules.games <= 99 && rules.games % 2 == 1, "games", rules.games, "an odd number, 1 to 99");
  expect(rules.services >= 1, "services", rules.services, "1 or more");
  expect(rules.change_ends_at >= 1, "change_ends_at", rules.change_ends_at, "1 or more");
  expect(rules.toss_height >= 0.0, "toss_height", rules.toss_height, "0 or more [m]");
  expect(rules.toss_tilt >= 0.0, "toss_tilt", rules.toss_tilt, "0 or more [rad]");
  expect(rules.toss_spin >= 0.0, "toss_spin", rules.toss_spin, "0 or more [rad/s]");
  expect(rules.double_hit >= 0.0, "double_hit", rules.double_hit, "0 or more [s]");
  expect(rules.expedite_after > 0.0, "expedite_after", rules.expedite_after, "more than 0 [s]");
  expect(rules.expedite_returns >= 1, "expedite_returns", rules.expedite_returns, "1 or more");
  expect(rules.patience > 0.0, "patience", rules.patience, "more than 0 [s]");
  expect(rules.reach > 0.0, "reach", rules.reach, "more than 0 [m]");
}
}  // namespace ping_pong::game
