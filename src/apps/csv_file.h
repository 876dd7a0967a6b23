// A CSV file that notices when writing fails: a full disk, a closed pipe.
#pragma once

#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "ping_pong_sim/types.h"

namespace ping_pong
{
/// Output could not be written; what() is one line.
class OutputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class CsvFile
{
public:
  /// Standard output.
  CsvFile();
  /// Throws OutputError if the file cannot be opened.
  explicit CsvFile(const std::string& path);
  ~CsvFile();
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;

  void text(const char* text);
  void number(double value);  ///< 17 significant digits: reading it gives the same bits
  void integer(std::uint64_t value);
  void vector(const Vector3d& value);
  void endRow();
  /// Everything has reached its destination, or OutputError.
  void close();

private:
  void separate();
  [[noreturn]] void fail() const;

  std::FILE* file_;
  std::string name_;
  bool row_begun_ = false;
};
}  // namespace ping_pong
