#include "windows/window_state.h"

#include "base/prefault.h"

namespace ping_pong
{
void IslandRecords::reserve(std::size_t balls, std::size_t workers)
{
  broad_phase.reserve(balls, workers);
  glances.reserve(balls);
  const std::size_t meetings = 2048 + 8 * balls;  // 64 balls may all be near each other
  for (std::vector<std::uint32_t>* list : {&found, &near}) takeMemory(*list, meetings);
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
    for (std::vector<std::uint32_t>* list : {&its.due, &its.turn}) takeMemory(*list, balls);
    takeMemory(its.added, meetings);
    its.announced.resize(workers);
    for (std::vector<BroadPhase::Addition>& announced : its.announced) takeMemory(announced, meetings / workers);
    takeMemory(its.near.entries, 32768);
    takeMemory(its.near.ends, 16);
    takeMemory(its.thrown, balls);
    takeMemory(its.members, balls);
    takeMemory(its.crowded, balls);
    takeMemory(its.met, meetings);
    takeMemory(its.apart, 256);
    takeMemory(its.roots, meetings);
    takeMemory(its.meetings, meetings);
    takeMemory(its.due_meetings, meetings);
    takeMemory(its.pieces, 2048 + 4 * balls);
    if (worker == 0) continue;  // it writes to the world's lists
    takeMemory(its.contacts, 256 + 8 * balls);
    takeMemory(its.origins, 256 + 8 * balls);
  }
}
}  // namespace ping_pong
