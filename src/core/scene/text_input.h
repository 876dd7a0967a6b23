// What the readers of scenes, URDF files and command lines share: files, numbers, complaints.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ping_pong
{
/// A place in a file that a complaint is about.
struct FileLine
{
  std::string file;
  int line = 1;  ///< first line is 1
};

/// Throws LoadError "FILE:LINE: KEY: VALUE: expected EXPECTED", on one line whatever the value contains.
[[noreturn]] void failLoad(const FileLine& at, const std::string& key, const std::string& value,
                           const std::string& expected);

/// Whole text of a file. Throws std::runtime_error with the reason if it cannot be read, or is larger than 16 MiB.
std::string readFile(const std::string& path);

// Numbers as YAML and URDF write them, with a decimal point whatever the locale. False: not such a number, or out of
// range. Infinity and NaN have no spelling here.
bool parseNumber(const std::string& text, double& number);
bool parseInteger(const std::string& text, std::uint64_t& number);
/// Exactly `count` numbers with spaces between them.
bool parseNumbers(const std::string& text, std::size_t count, std::vector<double>& numbers);

/// With six digits, and a decimal point whatever the locale.
std::string numberText(double number);

/// "a number from LOW to HIGH"
std::string rangeText(double low, double high);

/// "a, b, c"
std::string joined(const std::vector<std::string>& words);
}  // namespace ping_pong
