#include "ping_pong_sim/scene.h"

#include <stdexcept>
#include <utility>

namespace ping_pong
{
namespace
{
constexpr std::pair<Method, const char*> kMethods[] = {
    {Method::EulerExplicit, "euler_explicit"},
    {Method::EulerSemiImplicit, "euler_semi_implicit"},
    {Method::Exact, "exact"},
};
}  // namespace

const char* name(Method method)
{
  for (const auto& [known, text] : kMethods)
    if (known == method) return text;
  return "unknown";
}

Method methodFromName(const std::string& text)
{
  std::string known_names;
  for (const auto& [method, known] : kMethods)
  {
    if (text == known) return method;
    known_names += known_names.empty() ? known : std::string(", ") + known;
  }
  throw std::invalid_argument("expected one of: " + known_names);
}
}  // namespace ping_pong
