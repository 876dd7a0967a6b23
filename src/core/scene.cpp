#include "ping_pong_sim/scene.h"

#include <stdexcept>

namespace ping_pong
{
const char* name(Method method)
{
  switch (method)
  {
    case Method::EulerExplicit:
      return "euler_explicit";
    case Method::EulerSemiImplicit:
      return "euler_semi_implicit";
    case Method::Verlet:
      return "verlet";
    case Method::Rk4:
      return "rk4";
    case Method::Rk4Located:
      return "rk4_located";
    case Method::Exact:
      return "exact";
  }
  return "unknown";
}

std::string methodNames()
{
  std::string names;
  for (const Method method : kMethods) names += (names.empty() ? "" : ", ") + std::string(name(method));
  return names;
}

Method methodFromName(const std::string& text)
{
  for (const Method method : kMethods)
    if (text == name(method)) return method;
  throw std::invalid_argument("expected one of: " + methodNames());
}
}  // namespace ping_pong
