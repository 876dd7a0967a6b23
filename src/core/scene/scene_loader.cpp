#include "ping_pong_sim/scene_loader.h"

#include <filesystem>
#include <stdexcept>

#include "scene/load_balls.h"
#include "scene/load_bodies.h"
#include "scene/load_forces.h"
#include "scene/load_surfaces.h"
#include "scene/materials.h"
#include "scene/yaml_reader.h"

namespace ping_pong
{
namespace
{
Method readMethod(const Field& field)
{
  const std::string text = field.text();
  try
  {
    return methodFromName(text);
  }
  catch (const std::invalid_argument& error)
  {
    const std::string reason = error.what(), prefix = "expected ";
    field.fail(reason.compare(0, prefix.size(), prefix) == 0 ? reason.substr(prefix.size()) : reason);
  }
}
}  // namespace

Scene loadScene(const std::string& path, const LoadOptions& options)
{
  const Map map(readYaml(path),
                {"name", "forces", "floor", "bodies", "balls", "surfaces", "method", "dt", "tolerance", "threads"});
  Scene scene;
  scene.path = path;
  scene.name = std::filesystem::path(path).stem().string();
  scene.materials = {kBallMaterial};
  if (const Field* f = map.find("name")) scene.name = f->text();
  if (const Field* f = map.find("forces")) scene.forces = readForces(*f);
  if (const Field* f = map.find("method")) scene.method = readMethod(*f);
  if (const Field* f = map.find("dt")) scene.dt = f->positive();
  if (const Field* f = map.find("tolerance")) scene.tolerance = f->within(kMinTolerance, kMaxTolerance);
  if (const Field* f = map.find("threads")) scene.threads = f->count(kMaxThreads);
  readBodies(map, crowdGrowth(map, options), scene);
  readBalls(map, options, scene);
  readSurfaces(map, scene);
  return scene;
}
}  // namespace ping_pong
