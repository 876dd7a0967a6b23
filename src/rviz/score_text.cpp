#include <cmath>
#include <cstdio>

#include "score_image.h"

namespace ping_pong_sim
{
namespace
{
std::string headline(const UmpireCall& call, const std::string& name)
{
  switch (call.kind)
  {
    case UmpireCall::POINT:
      return "Point to " + name;
    case UmpireCall::LET:
      return "Let";
    case UmpireCall::GAME:
      return "Game to " + name;
    case UmpireCall::MATCH:
      return name + " wins the match";
    case UmpireCall::ENDS:
      return "Change ends";
    case UmpireCall::FAULT:
      return "Fault, point to " + name;
    case UmpireCall::EXPEDITE:
      return "Expedite";
    default:
      return "";
  }
}
}  // namespace

std::string callText(const UmpireCall& call, const Score& score)
{
  const bool somebody = call.winner == 0 || call.winner == 1;
  std::string text = headline(call, somebody ? score.players[static_cast<std::size_t>(call.winner)] : "nobody");
  if (!call.reason.empty()) text += (text.empty() ? "" : ": ") + call.reason;
  if (!call.law.empty()) text += "  (" + call.law + ")";
  return text;
}

std::string strokeText(const Score& score)
{
  char text[160];
  int n = std::snprintf(text, sizeof text, "%u stroke%s   best %u", score.rally, score.rally == 1 ? "" : "s",
                        score.best_rally);
  if (score.rally > 0 && n > 0)
    std::snprintf(text + n, sizeof text - static_cast<std::size_t>(n), "   %.1f m/s   %.0f turns/s", score.stroke_speed,
                  std::abs(score.stroke_spin) / (2.0 * M_PI));
  return text;
}
}  // namespace ping_pong_sim
