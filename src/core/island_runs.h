// Islands: balls that meet in a window, and those that they meet then, run together.
#pragma once

#include "exact_method.h"

namespace ping_pong
{
/// Keeps the ball as it is at the start of the window; nothing if that has been done.
void save(WorldState& world, IslandWork& work, std::size_t i);

/// Those who met are of one island now; its root stands in the list of islands that have to run.
void uniteWhoMet(WorldState& world);

/// Runs all islands of the list, and lists those that have to run again, joined with others.
void runIslandsOnce(WorldState& world, const Window& window);

/// The window with the records of this worker.
inline Window ofWorker(WorldState& world, Window window, std::size_t worker)
{
  window.records = window.work = &world.islands.work[worker];
  return window;
}

/// Calls action(world, its window, entry) for all entries of a list of balls or islands.
template <class Action>
void eachOf(const std::vector<std::uint32_t>& list, WorldState& world, const Window& window, const Action& action)
{
  constexpr std::size_t kAtATime = 8;
  world.workers.each(list.size(), kAtATime,
                     [&](std::size_t begin, std::size_t end, std::size_t worker)
                     {
                       const Window its = ofWorker(world, window, worker);
                       for (std::size_t c = begin; c < end; ++c) action(world, its, list[c]);
                     });
}
}  // namespace ping_pong
