#include "scene/text_input.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "ping_pong_sim/scene_loader.h"

namespace ping_pong
{
namespace
{
constexpr std::size_t kMaxFileSize = 16u << 20;  ///< [bytes]; a device such as /dev/zero has no end
constexpr std::size_t kMaxValueSize = 100;       ///< [bytes] of a value that a message repeats

/// Control characters become spaces, so that a message stays one line.
std::string oneLine(std::string text)
{
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return text;
}

std::string shortened(const std::string& value)
{
  if (value.empty()) return "\"\"";
  return value.size() <= kMaxValueSize ? value : value.substr(0, kMaxValueSize) + "...";
}

bool madeOf(const std::string& text, const char* characters)
{
  return !text.empty() && text.find_first_not_of(characters) == std::string::npos;
}
}  // namespace

void failLoad(const FileLine& at, const std::string& key, const std::string& value, const std::string& expected)
{
  throw LoadError(oneLine(at.file + ":" + std::to_string(at.line) + ": " + key + ": " + shortened(value) +
                          ": expected " + expected));
}

std::string readFile(const std::string& path)
{
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text;
  char block[4096];
  while (file && text.size() <= kMaxFileSize)
  {
    file.read(block, sizeof block);
    text.append(block, static_cast<std::size_t>(file.gcount()));
  }
  if (text.size() > kMaxFileSize) throw std::runtime_error("larger than 16 MiB");
  if (!file.eof()) throw std::runtime_error(errno != 0 ? std::strerror(errno) : "not readable");
  return text;
}

bool parseNumber(const std::string& text, double& number)
{
  // The stream would also skip blanks and stop early; strtod would follow the locale.
  if (!madeOf(text, "+-.0123456789eE")) return false;
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double parsed = 0.0;
  stream >> parsed;
  if (stream.fail() || stream.peek() != std::istringstream::traits_type::eof() || !std::isfinite(parsed)) return false;
  number = parsed;
  return true;
}

bool parseInteger(const std::string& text, std::uint64_t& number)
{
  if (!madeOf(text, "0123456789")) return false;
  std::uint64_t parsed = 0;
  for (const char c : text)
  {
    const auto digit = static_cast<std::uint64_t>(c - '0');
    if (parsed > (std::numeric_limits<std::uint64_t>::max() - digit) / 10) return false;
    parsed = 10 * parsed + digit;
  }
  number = parsed;
  return true;
}

bool parseNumbers(const std::string& text, std::size_t count, std::vector<double>& numbers)
{
  std::vector<double> parsed;
  for (std::size_t begin = 0; (begin = text.find_first_not_of(' ', begin)) != std::string::npos;)
  {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    double number = 0.0;
    if (!parseNumber(text.substr(begin, end - begin), number)) return false;
    parsed.push_back(number);
    begin = end;
  }
  if (parsed.size() != count) return false;
  numbers = parsed;
  return true;
}

std::string numberText(double number)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << number;
  return text.str();
}

std::string rangeText(double low, double high)
{
  return "a number from " + numberText(low) + " to " + numberText(high);
}

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words) text += text.empty() ? word : ", " + word;
  return text;
}
}  // namespace ping_pong
