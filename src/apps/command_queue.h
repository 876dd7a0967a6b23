// Commands that wait for their time.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "command_file.h"
#include "ping_pong_sim/world.h"

namespace ping_pong
{
class CommandQueue
{
public:
  /// @param commands  in order of time, as readCommands() returns them
  explicit CommandQueue(std::vector<TimedCommand> commands) : commands_(std::move(commands)) {}

  /// Of the next command; infinity if there is none [s].
  double nextTime() const
  {
    return given_ < commands_.size() ? commands_[given_].time : std::numeric_limits<double>::infinity();
  }
  /// Gives the world, which has come to that time, all commands of nextTime(): of several for one paddle the last one holds.
  void give(World& world)
  {
    for (const double now = nextTime(); given_ < commands_.size() && nextTime() == now; ++given_)
      world.command(commands_[given_].body, commands_[given_].command);
  }

  std::size_t given() const { return given_; }
  std::size_t size() const { return commands_.size(); }

private:
  std::vector<TimedCommand> commands_;
  std::size_t given_ = 0;
};
}  // namespace ping_pong
