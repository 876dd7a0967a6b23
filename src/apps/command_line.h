// Command lines: options in groups, with their defaults in --help; a bad one is refused in one line.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "option_value.h"

namespace ping_pong
{
/// Bad command line; what() is one line.
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Throws UsageError "OPTION: VALUE: expected EXPECTED".
[[noreturn]] void refuse(const std::string& option, const std::string& value, const std::string& expected);

struct Option
{
  std::string name;        ///< "--rate"; without dashes: the argument that has no name before it, as the help calls it
  std::string value_name;  ///< as the help calls it; empty: a flag, or an argument
  std::string help;
  OptionValue value;
  bool required = false;
};

constexpr bool kRequired = true;

struct OptionGroup
{
  std::string title;
  std::vector<Option> options;
};

struct CommandLine
{
  std::string program, about;
  std::vector<OptionGroup> groups;
  std::string footer = "";  ///< of the help
};

/// Hands each option its value, in the order of the words; the last one of a name counts. `--name VALUE` and `--name=VALUE`
/// are the same, and a name may be cut short where no other one begins so. Throws UsageError.
/// @return  the text of --help, if it is asked for
std::optional<std::string> parse(const CommandLine& line, int argc, const char* const* argv);

/// Writes it to standard output. False: that failed.
bool writeHelp(const std::string& help);
}  // namespace ping_pong
