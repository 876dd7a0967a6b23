#include "peers.h"

namespace ping_pong::bench
{
std::vector<EngineKind> peerKinds()
{
  return {bulletKind(), odeKind(), dartKind(), mujocoKind(), simbodyKind()};
}
}  // namespace ping_pong::bench
