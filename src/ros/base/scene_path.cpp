#include "scene_path.h"

namespace ping_pong_sim
{
std::string scenePath(const std::string& directory, const std::string& scene)
{
  const bool is_path = scene.find('/') != std::string::npos || scene.find(".yaml") != std::string::npos;
  return is_path || directory.empty() ? scene : directory + "/" + scene + ".yaml";
}
}  // namespace ping_pong_sim
