#include "option_value.h"

#include <stdexcept>

#include "scene/text_input.h"

namespace ping_pong
{
double positiveNumber(const std::string& text)
{
  double number = 0.0;
  if (!parseNumber(text, number) || !(number > 0.0)) throw Unexpected{"a finite number > 0"};
  return number;
}

double numberNotNegative(const std::string& text)
{
  double number = 0.0;
  if (!parseNumber(text, number) || !(number >= 0.0)) throw Unexpected{"a finite number >= 0"};
  return number;
}

std::function<double(const std::string&)> numberWithin(double low, double high)
{
  return [low, high](const std::string& text)
  {
    double number = 0.0;
    if (!parseNumber(text, number) || !(number >= low && number <= high)) throw Unexpected{rangeText(low, high)};
    return number;
  };
}

std::function<std::uint64_t(const std::string&)> integerWithin(std::uint64_t low, std::uint64_t high)
{
  return [low, high](const std::string& text)
  {
    std::uint64_t number = 0;
    if (parseInteger(text, number) && number >= low && number <= high) return number;
    const std::string least = std::to_string(low);
    if (high == std::numeric_limits<std::uint64_t>::max()) throw Unexpected{"an integer >= " + least};
    throw Unexpected{"an integer from " + least + " to " + std::to_string(high)};
  };
}

std::string anyText(const std::string& text)
{
  return text;
}

std::string fileName(const std::string& text)
{
  if (text.empty()) throw Unexpected{"a file name"};
  return text;
}

Method methodName(const std::string& text)
{
  try
  {
    return methodFromName(text);
  }
  catch (const std::invalid_argument&)
  {
    throw Unexpected{"one of: " + methodNames()};
  }
}

std::string standardText(double number)
{
  return numberText(number);
}

std::string standardText(const std::string& text)
{
  return text;
}

std::string standardText(Method method)
{
  return name(method);
}

OptionValue flag(bool& target)
{
  return {[&target](const std::string&) { target = true; }};
}
}  // namespace ping_pong
