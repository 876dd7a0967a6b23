// What an option does with the text that follows it: numbers within bounds, names, flags.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

#include "ping_pong_sim/scene.h"

namespace ping_pong
{
/// A value is none of those expected.
struct Unexpected
{
  std::string expected;
};

struct OptionValue
{
  std::function<void(const std::string& text)> take;  ///< throws Unexpected
  std::string standard = "";                          ///< what counts without the option, for the help; empty: nothing
};

// Readers: text in, value out, or Unexpected.
double positiveNumber(const std::string& text);
double numberNotNegative(const std::string& text);
std::function<double(const std::string&)> numberWithin(double low, double high);
std::function<std::uint64_t(const std::string&)> integerWithin(
    std::uint64_t low, std::uint64_t high = std::numeric_limits<std::uint64_t>::max());
std::string anyText(const std::string& text);
std::string fileName(const std::string& text);  ///< not empty
Method methodName(const std::string& text);

// As the help tells them.
std::string standardText(double number);
template <class Integer, std::enable_if_t<std::is_integral_v<Integer>, int> = 0>
std::string standardText(Integer number)
{
  return std::to_string(number);
}
std::string standardText(const std::string& text);
std::string standardText(Method method);
template <class Value>
std::string standardText(const std::optional<Value>& value)
{
  return value ? standardText(*value) : std::string();
}

/// Puts what the reader makes of the text into the target, whose value now is the default.
template <class Target, class Reader>
OptionValue into(Target& target, Reader read)
{
  return {[&target, read](const std::string& text) { target = static_cast<Target>(read(text)); }, standardText(target)};
}

/// Sets a flag.
OptionValue flag(bool& target);
}  // namespace ping_pong
