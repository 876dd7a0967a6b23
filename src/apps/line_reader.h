// Lines of a text file one by one, however long the file: a line and the number of lines are bounded.
#pragma once

#include <fstream>
#include <string>

#include "scene/text_input.h"

namespace ping_pong
{
constexpr std::size_t kMaxLineSize = 4096;  ///< [bytes], its end included
constexpr int kMaxLines = 1000000;

/// All complaints are LoadErrors that name file and line.
class LineReader
{
public:
  /// @param key  what the file is for, as complaints call it
  /// Opens a regular file only: a pipe could make the reader wait, a device has no end.
  LineReader(const std::string& path, std::string key);

  /// The next line without its end, be that \n or \r\n; false after the last one.
  bool next(std::string& line);
  /// Of the last line; 1 before the first.
  const FileLine& at() const { return at_; }

private:
  std::string key_;
  FileLine at_;
  std::ifstream file_;
  int count_ = 0;
};
}  // namespace ping_pong
