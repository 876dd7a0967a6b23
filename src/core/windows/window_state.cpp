#include "windows/window_state.h"

#include "base/prefault.h"

namespace ping_pong
{
void IslandRecords::reserve(std::size_t balls, std::size_t workers)
{
  broad_phase.reserve(balls, workers);
  cache.reserve(balls);
  const std::size_t predicted = 2048 + 8 * balls;  // 64 balls may all be near each other
  for (std::vector<std::uint32_t>* list : {&found, &near}) takeMemory(*list, predicted);
  takeMemory(near_boxes, balls);
  ends.reserve(workers);
  takeMemory(order, 256 + 8 * balls);
  work.resize(workers);
  for (std::uint32_t worker = 0; worker < workers; ++worker)
  {
    IslandWork& its = work[worker];
    its.worker = worker;
    its.saved.reserve(balls);
    takeMemory(its.busy, balls);
    for (std::vector<std::uint32_t>* list : {&its.due, &its.due_now}) takeMemory(*list, balls);
    takeMemory(its.added, predicted);
    its.deferred.resize(workers);
    for (std::vector<BroadPhase::Addition>& deferred : its.deferred) takeMemory(deferred, predicted / workers);
    takeMemory(its.near.entries, 32768);
    takeMemory(its.near.ends, 16);
    takeMemory(its.deflected, balls);
    takeMemory(its.members, balls);
    takeMemory(its.to_hand_off, balls);
    takeMemory(its.met, predicted);
    takeMemory(its.apart, 256);
    takeMemory(its.roots, predicted);
    takeMemory(its.predicted, predicted);
    takeMemory(its.due_contacts, predicted);
    takeMemory(its.pieces, 2048 + 4 * balls);
    if (worker == 0) continue;  // it writes to the world's lists
    takeMemory(its.contacts, 256 + 8 * balls);
    takeMemory(its.provenances, 256 + 8 * balls);
  }
}
}  // namespace ping_pong
