// How far long work is: one line on a terminal, rewritten in place. Nothing where standard error goes elsewhere.
#pragma once

#include <unistd.h>

#include <chrono>
#include <functional>
#include <string>

namespace ping_pong
{
/// Called with the part of a work that is done, from 0 to 1.
using PartDone = std::function<void(double)>;

class Progress
{
public:
  /// @param what  is worked at; the line begins with it
  explicit Progress(std::string what, int terminal = STDERR_FILENO);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// May be called as often as one likes: it writes a few times a second. Time left is told as if the rest went as fast.
  /// @param part  that is done, from 0 to 1
  void show(double part, const char* note = "");
  /// For a stretch of the work, of which it is told what part is done. The progress must outlive it.
  PartDone stretch(double from, double to, std::string note = "");
  /// Empties the line, before something else is written to the terminal.
  void clear();

private:
  double seconds() const;

  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  const std::string what_;
  const int terminal_;
  const bool shows_;
  double shown_ = 0.0;    ///< when the line was written last, after the start [s]
  bool written_ = false;  ///< there is a line to clear
};

/// "40 s", "12 min", "3 h 20 min"
std::string roughTime(double seconds);
}  // namespace ping_pong
