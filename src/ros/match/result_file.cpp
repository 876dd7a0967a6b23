#include "result_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace ping_pong_sim
{
namespace
{
// A name may have any character.
std::string quoted(const std::string& text)
{
  std::string out = "\"";
  for (const char c : text)
  {
    if (c == '"' || c == '\\') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out + '"';
}
}  // namespace

void writeResult(const std::string& file, const ping_pong::game::Umpire& umpire,
                 const std::array<std::string, 2>& players, double time)
{
  const ping_pong::game::Score& score = umpire.score();
  std::ofstream out(file);
  out << "rules: " << umpire.rules().name << "\nbest_of: " << umpire.rules().games << "\nplayers: ["
      << quoted(players[0]) << ", " << quoted(players[1]) << "]\nwinner: ";
  if (score.winner)
    out << quoted(players[index(*score.winner)]) << '\n';
  else
    out << "null\n";
  out << "games:  # points of each\n";
  for (const std::array<int, 2>& game : umpire.finishedGames()) out << "  - [" << game[0] << ", " << game[1] << "]\n";
  out << "games_won: [" << score.games[0] << ", " << score.games[1] << "]\nrallies: " << score.rallies
      << "\nlongest_rally: " << score.best_rally << "  # strokes\ntime: " << time << "  # of the world [s]\n";
  out.flush();
  if (!out) throw std::runtime_error(file + ": " + std::strerror(errno) + ": expected a file that can be written");
}
}  // namespace ping_pong_sim
