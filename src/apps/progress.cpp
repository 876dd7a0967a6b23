#include "progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace ping_pong
{
namespace
{
constexpr double kShownEvery = 0.5;        // [s]; work that takes less shows nothing
constexpr std::size_t kMostColumns = 79;   // a line that wraps could not be rewritten
constexpr char kEmptyLine[] = "\r\033[K";  // to its beginning, erase to its end

void put(int terminal, const std::string& text)
{
  const ssize_t written = ::write(terminal, text.data(), text.size());
  (void)written;  // a terminal that is gone needs no progress
}
}  // namespace

std::string roughTime(double seconds)
{
  const long whole = std::lround(std::min(seconds, 1e9));
  if (whole < 100) return std::to_string(whole) + " s";
  const long minutes = (whole + 30) / 60;
  if (minutes < 100) return std::to_string(minutes) + " min";
  return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

Progress::Progress(std::string what, int terminal)
    : what_(std::move(what)), terminal_(terminal), shows_(isatty(terminal) != 0)
{
}

void Progress::show(double part, const char* note)
{
  if (!shows_ || seconds() - shown_ < kShownEvery) return;
  shown_ = seconds();
  part = std::clamp(part, 0.0, 1.0);
  std::string line = what_ + ": " + std::to_string(static_cast<int>(100.0 * part)) + " %";
  if (part > 0.0) line += ", " + roughTime(shown_ * (1.0 - part) / part) + " left";
  if (*note != '\0') line += std::string(", ") + note;
  put(terminal_, kEmptyLine + line.substr(0, kMostColumns));
  written_ = true;
}

PartDone Progress::stretch(double from, double to, std::string note)
{
  return [this, from, to, note = std::move(note)](double part) { show(from + (to - from) * part, note.c_str()); };
}

void Progress::clear()
{
  if (written_) put(terminal_, kEmptyLine);
  written_ = false;
}

double Progress::seconds() const
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}
}  // namespace ping_pong
