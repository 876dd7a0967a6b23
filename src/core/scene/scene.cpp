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
    case Method::Impulse:
      return "impulse";
    case Method::Exact:
      return "exact";
    case Method::Auto:
      return "auto";
  }
  return "unknown";
}

std::string methodNames()
{
  std::string names;
  for (const Method method : kMethods) names += std::string(name(method)) + ", ";
  return names + name(Method::Auto);
}

Method methodFromName(const std::string& text)
{
  for (const Method method : kMethods)
    if (text == name(method)) return method;
  if (text == name(Method::Auto)) return Method::Auto;
  throw std::invalid_argument("expected one of: " + methodNames());
}
}  // namespace ping_pong
