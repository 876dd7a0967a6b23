// A terminal that gives single keys, and is itself again afterwards.
#pragma once

#include <termios.h>

#include <optional>

#include "key_table.h"

namespace ping_pong
{
class Terminal
{
public:
  Terminal();
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// False at the end of the input, or if it is no terminal that can be set up (then keys come as from a file).
  bool open() const { return open_; }
  /// The next key; nothing if none comes within `seconds`, or for one that has no code of ours (an arrow).
  std::optional<Key> read(double seconds);

private:
  bool is_terminal_;
  bool open_ = true;
  termios before_{};
};
}  // namespace ping_pong
