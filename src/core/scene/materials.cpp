#include "scene/materials.h"

#include <algorithm>

namespace ping_pong
{
std::size_t findMaterial(const std::vector<std::string>& materials, const std::string& name)
{
  const auto found = std::find(materials.begin(), materials.end(), name);
  return found == materials.end() ? kNone : static_cast<std::size_t>(found - materials.begin());
}

MaterialId internMaterial(std::vector<std::string>& materials, const std::string& name)
{
  const std::size_t found = findMaterial(materials, name);
  if (found != kNone) return static_cast<MaterialId>(found);
  materials.push_back(name);
  return static_cast<MaterialId>(materials.size() - 1);
}
}  // namespace ping_pong
