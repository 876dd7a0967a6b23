// Looking further ahead than a window: where ticks are short, the grid and the pairs of balls that may meet are found once for
// several windows. In between only those are looked at whose path changes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/aabb.h"

namespace ping_pong
{
struct BallRecord;
struct WorldWithWindows;
struct WorkerWindow;
struct IslandWork;
class Glances;

/// Two balls meet at this time if neither changes its path before. Whoever takes it looks again.
struct Meeting
{
  float time;                                   ///< no later than that [s]
  std::uint32_t first, second;                  ///< indices of balls
  std::uint16_t first_version, second_version;  ///< of their paths: the last bits
};

struct Outlook
{
  double start = 0.0, end = 0.0;                              ///< [s]
  std::size_t near_pairs = 0, pair_searches = 0, events = 0;  ///< since it began
};

/// Contains the ball on the path that it is on, from `from` on, until `to` or the end of the path.
Box boxAhead(const BallRecord& ball, double from, double to);

/// Forgets what has been foreseen; whom balls meet from the start of this window to the end of its outlook will be noted.
void beginOutlook(WorldWithWindows& world, const WorkerWindow& window);

/// Notes that balls i and k have met in this window, or that on the paths that they are on they will meet until its outlook
/// ends, if so.
void lookAtPair(const WorldWithWindows& world, const WorkerWindow& window, std::uint32_t i, std::uint32_t k);

/// Does so for these balls, whose paths have changed, and all that are near one of them. With those of its own island a ball has
/// met what there was to meet: of them only what comes after the window is noted.
void lookAround(WorldWithWindows& world, const WorkerWindow& window, const std::uint32_t* balls, std::size_t count);

/// Who meets in this window, as far as it has been foreseen, goes into another list.
void takeMeetings(IslandWork& list, const Glances& glances, double end);

/// Those of them who do, on the paths that they are on, are noted as having met.
void lookAtMeetings(const WorldWithWindows& world, const WorkerWindow& window, const std::vector<Meeting>& meetings);

/// At the end of a window: looks for whom those in this list meet next who were thought to have met someone but have not.
void lookAhead(WorldWithWindows& world, const WorkerWindow& window, const IslandWork& list);

/// Ends the outlook with this window if too many have changed.
void endIfManyChanged(WorldWithWindows& world, const WorkerWindow& window);
}  // namespace ping_pong
