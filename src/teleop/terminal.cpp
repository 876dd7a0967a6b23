#include "terminal.h"

#include <poll.h>
#include <unistd.h>

#include <cctype>

namespace ping_pong
{
namespace
{
constexpr char kEscape = 27;
constexpr char kDelete = 127;  ///< what most terminals send for backspace

bool isWaiting(double seconds)
{
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, static_cast<int>(1e3 * seconds)) > 0;
}
}  // namespace

Terminal::Terminal() : is_terminal_(tcgetattr(STDIN_FILENO, &before_) == 0)
{
  if (!is_terminal_) return;
  termios raw = before_;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);  // signals stay: Ctrl-C ends the program
  tcsetattr(STDIN_FILENO, TCSANOW, &raw);
}

Terminal::~Terminal()
{
  if (is_terminal_) tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

std::optional<Key> Terminal::read(double seconds)
{
  if (!isWaiting(seconds)) return std::nullopt;
  char letter = 0;
  if (::read(STDIN_FILENO, &letter, 1) != 1)
  {
    open_ = false;
    return std::nullopt;
  }
  if (letter == kEscape)  // the rest of a sequence means nothing here
  {
    while (isWaiting(0.0) && ::read(STDIN_FILENO, &letter, 1) == 1)
    {
    }
    return std::nullopt;
  }
  if (letter == kDelete) return kBackspace;
  if (letter == '\r') return kEnter;
  return std::tolower(static_cast<unsigned char>(letter));
}
}  // namespace ping_pong
