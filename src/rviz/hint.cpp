#include "hint.h"

#include <algorithm>

namespace ping_pong_sim
{
namespace
{
bool rallyGoesOn(const Score& score)
{
  // Between a service and the end of its rally; all other states wait for somebody.
  for (const char* waiting : {"before", "hand", "over", "Over", "Before", "Hand"})
  {
    if (score.state.find(waiting) != std::string::npos) return false;
  }
  return true;
}

std::string matchHint(const Score& score, int player)
{
  const std::string level = player >= 0 ? "     + -: opponent's level" : "";
  if (score.winner >= 0) return "M: new match" + level;
  if (rallyGoesOn(score)) return "";
  if (score.server == player) return "Enter: serve" + level + "     M: new match";
  return score.players[score.server == 0 ? 0 : 1] + " serves" + level + "     M: new match";
}

std::string playHint(const HandsState& hands)
{
  if (hands.mouse) return "mouse: move the paddle     left button: drive     right button: push     wheel: tilt";
  return "W A S D Q E: move " + hands.selected + "     P: play with the mouse";
}
}  // namespace

std::string hintLine(const SimStatus* status, const HandsState* hands, const Score* score, bool ball_in_play)
{
  if (status == nullptr || hands == nullptr) return "";
  if (hands->help) return "H: hide the keys";
  if (status->paused) return "Space: go on     N: one step";
  if (score != nullptr)
  {
    const std::string hint = matchHint(*score, hands->player);
    return hint.empty() && score->rally < 2 && hands->player >= 0 ? playHint(*hands) : hint;
  }
  const bool table = std::count(status->furniture.begin(), status->furniture.end(), "table") > 0;
  if (status->paddles.empty())
    return ball_in_play || !table ? "Space: pause     H: keys" : "Backspace: again     Enter: launch a ball";
  if (table && !ball_in_play) return "Enter: launch a ball     Backspace: again";
  return hands->selected.empty() ? "5: take the paddle" : playHint(*hands);
}
}  // namespace ping_pong_sim
