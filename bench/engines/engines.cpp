#include "engine.h"
#include "our_engine.h"
#ifdef BENCH_PEERS
#include "peers/peers.h"
#endif

namespace ping_pong::bench
{
namespace
{
std::vector<EngineKind> allKinds()
{
  std::vector<EngineKind> kinds{ourEngine()};
#ifdef BENCH_PEERS
  for (const EngineKind& peer : peerKinds()) kinds.push_back(peer);
#endif
  return kinds;
}
}  // namespace

const std::vector<EngineKind>& engineKinds()
{
  static const std::vector<EngineKind> kinds = allKinds();
  return kinds;
}
}  // namespace ping_pong::bench
