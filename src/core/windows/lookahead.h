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
class BallCache;

/// Two balls meet at this time if neither changes its path before. It is searched again when it is due.
struct PredictedContact
{
  float time;                                   ///< no later than that [s]
  std::uint32_t first, second;                  ///< indices of balls
  std::uint16_t first_version, second_version;  ///< of their paths: the last bits
};

struct Lookahead
{
  double start = 0.0, end = 0.0;                              ///< [s]
  std::size_t near_pairs = 0, pair_searches = 0, events = 0;  ///< since it began
};

/// Contains the ball on the path that it is on, from `from` on, until `to` or the end of the path.
Box boxAhead(const BallRecord& ball, double from, double to);

/// Forgets all predictions; whom balls meet from the start of this window to the end of its lookahead will be noted.
void beginLookahead(WorldWithWindows& world, const WorkerWindow& window);

/// Notes that balls i and k have met in this window, or that on the paths that they are on they will meet until its lookahead
/// ends, if so.
void predictPair(const WorldWithWindows& world, const WorkerWindow& window, std::uint32_t i, std::uint32_t k);

/// Does so for these balls, whose paths have changed, and all that are near one of them. With those of its own island a ball has
/// met what there was to meet: of them only what comes after the window is noted.
void predictAround(WorldWithWindows& world, const WorkerWindow& window, const std::uint32_t* balls, std::size_t count);

/// Who meets in this window, as far as it is predicted, goes into another list.
void takeDueContacts(IslandWork& list, const BallCache& cache, double end);

/// Those of them who do, on the paths that they are on, are noted as having met.
void checkDueContacts(const WorldWithWindows& world, const WorkerWindow& window,
                      const std::vector<PredictedContact>& predicted);

/// At the end of a window: looks for whom those in this list meet next who were thought to have met someone but have not.
void predictUnhit(WorldWithWindows& world, const WorkerWindow& window, const IslandWork& list);

/// Ends the lookahead with this window if too many have changed.
void endIfManyChanged(WorldWithWindows& world, const WorkerWindow& window);
}  // namespace ping_pong
