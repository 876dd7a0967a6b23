// Islands: balls that meet in a window, and those that they meet then, run together.
#pragma once

#include <algorithm>

#include "windows/window_state.h"

namespace ping_pong
{
/// Keeps the ball as it is at the start of the window; nothing if that has been done.
void save(WorldWithWindows& world, IslandWork& work, std::size_t i);

/// Runs all islands of the list, and lists those that have to run again, joined with others.
void runIslandsOnce(WorldWithWindows& world, const WorkerWindow& window);

/// The window with the records of this worker.
inline WorkerWindow ofWorker(WorldWithWindows& world, WorkerWindow window, std::size_t worker)
{
  window.records = window.work = &world.islands.work[worker];
  return window;
}

/// Calls action(world, its window, a worker's lists) for the lists of each worker, by this one or another.
template <class Action>
void eachList(WorldWithWindows& world, const WorkerWindow& window, const Action& action)
{
  world.workers.each(world.islands.work.size(), 1,
                     [&](std::size_t begin, std::size_t end, std::size_t worker)
                     {
                       for (std::size_t l = begin; l < end; ++l)
                         action(world, ofWorker(world, window, worker), world.islands.work[l]);
                     });
}

/// Calls action(entry) for all entries; kAhead before, ahead(entry): what that fetches has come by then.
template <std::size_t kAhead = 3, class Entry, class Ahead, class Action>
void eachPrefetched(const Entry* entries, std::size_t count, const Ahead& ahead, const Action& action)
{
  for (std::size_t c = 0; c < std::min(kAhead, count); ++c) ahead(entries[c]);
  for (std::size_t c = 0; c < count; ++c)
  {
    if (c + kAhead < count) ahead(entries[c + kAhead]);
    action(entries[c]);
  }
}
}  // namespace ping_pong
