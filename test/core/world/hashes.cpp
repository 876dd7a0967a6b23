// Prints hashes of what comes out of a few scenes: built at two levels of optimisation, the tests compare them.
#include <cinttypes>

#include "ping_pong_sim/state_hash.h"
#include "testing/crowd_scenes.h"

namespace ping_pong
{
namespace
{
void print(const char* what, Scene scene, Method method, double duration)
{
  scene.method = method;
  World world(scene);
  if (const std::size_t paddle = world.findBody("paddle"); paddle != kNone)
    world.command(paddle, velocityCommand({0.5, 0.2, 0}, {0, 1.0, 0}));
  std::size_t contacts = 0;
  for (double t = 0.0; t < duration; t += 0.02) contacts += world.advance(0.02).contacts;
  std::printf("%s, %s: %zu contacts, state %016" PRIx64 "\n", what, name(method), contacts, stateHash(world));
}
}  // namespace
}  // namespace ping_pong

int main()
{
  using namespace ping_pong;
  print("gas", gasOf(200), Method::Exact, 0.3);
  print("pour", pourOf(150), Method::Exact, 0.8);
  for (const Method method : kMethods) print("air", airOf(40), method, 0.6);
  return 0;
}
