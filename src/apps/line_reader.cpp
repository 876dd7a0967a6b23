#include "line_reader.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

namespace ping_pong
{
namespace
{
/// Why the file cannot be read line by line; empty if it can, as far as is known before it is opened.
std::string notRegular(const std::string& path)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (error) return error.message();
  if (std::filesystem::is_directory(status)) return "a directory";
  return std::filesystem::is_regular_file(status) ? "" : "a pipe or a device";
}
}  // namespace

LineReader::LineReader(const std::string& path, std::string key) : key_(std::move(key)), at_{path, 1}
{
  const std::string expected = "a regular file that can be read";
  const std::string reason = notRegular(path);
  if (!reason.empty()) failLoad(at_, key_, reason, expected);
  errno = 0;
  file_.open(path, std::ios::binary);
  if (!file_) failLoad(at_, key_, errno != 0 ? std::strerror(errno) : "not readable", expected);
}

bool LineReader::next(std::string& line)
{
  char text[kMaxLineSize];
  file_.getline(text, sizeof text);
  if (file_.eof() && file_.gcount() == 0) return false;
  at_.line = ++count_;
  if (file_.bad()) failLoad(at_, key_, "not readable", "a regular file that can be read");
  if (file_.fail())
    failLoad(at_, key_, "a longer line", "at most " + std::to_string(kMaxLineSize - 1) + " bytes in a line");
  if (count_ > kMaxLines) failLoad(at_, key_, "more lines", "at most " + std::to_string(kMaxLines) + " lines");
  line.assign(text, static_cast<std::size_t>(file_.gcount()) - (file_.eof() ? 0 : 1));
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return true;
}
}  // namespace ping_pong
