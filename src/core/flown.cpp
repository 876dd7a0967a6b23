#include "flown.h"

#include "count.h"
#include "parabola.h"

namespace ping_pong
{
namespace
{
using Piece = IslandWork::Piece;

constexpr std::uint16_t kMostPieces = 32;  // of a ball in a window; from then on it may have been anywhere near

// The path that a ball is on, as a piece that is as long as the window.
Piece lastPiece(const WorldState& world, const Window& window, std::size_t i)
{
  const Segment& path = world.balls[i].path;
  return {asParabola(path), window.end, world.islands.last_piece[i], 0, isParabola(path)};
}

bool meet(const Piece& a, const Piece& b, double reach)
{
  const double from = std::max(a.path.start, b.path.start);
  const double until = std::min(a.until, b.until);
  if (from > until) return false;
  if (!a.parabola || !b.parabola || a.path.half_a != b.path.half_a) return true;
  count(Law::PairSearch);
  return firstContact(a.path, b.path, reach, from, until).found();
}

bool asLittleIsKnown(const Piece& piece, const Segment& path)
{
  return !piece.parabola && !isParabola(path);
}

// Paths that nothing has bent in this window are searched whatever they are.
bool meetOnWholePaths(const WorldState& world, const Window& window, std::size_t i, std::size_t k)
{
  const BallRecord &a = world.balls[i], &b = world.balls[k];
  const double from = std::max(a.path.start, b.path.start);
  return firstContact(a.path, a.params.radius, b.path, b.params.radius, from, window.end).time < kNever;
}
}  // namespace

void noteFlown(WorldState& world, const Window& window, std::size_t i, double t)
{
  IslandRecords& islands = world.islands;
  IslandWork& work = *window.work;
  const BallRecord& ball = world.balls[i];
  islands.swept[i].add(CoarseBox(boxOf(ball, window.start, t)));
  const std::uint32_t last = islands.last_piece[i];
  std::uint16_t count = 1;
  if (last != IslandRecords::kNoEntry)
  {
    Piece& before = work.pieces[IslandRecords::indexOf(last)];  // whoever runs a ball on has noted what it has flown
    if (asLittleIsKnown(before, ball.path) || before.count == kMostPieces)
    {
      before.parabola = false;
      before.until = t;
      return;
    }
    count = static_cast<std::uint16_t>(before.count + 1);
  }
  islands.last_piece[i] = IslandRecords::entry(work, work.pieces.size());
  work.pieces.push_back({asParabola(ball.path), t, last, count, isParabola(ball.path)});
}

void forgetFlown(IslandRecords& islands, std::size_t i)
{
  islands.swept[i] = CoarseBox();
  islands.last_piece[i] = IslandRecords::kNoEntry;
}

void noteLast(WorldState& world, const Window& window, std::size_t i)
{
  world.islands.swept[i].add(CoarseBox(boxOf(world.balls[i], window.start, window.end)));
}

bool metInFlight(const WorldState& world, const Window& window, std::size_t i, std::size_t k)
{
  const IslandRecords& islands = world.islands;
  const auto next = [&](Piece& piece)
  {
    const std::uint32_t earlier = piece.earlier;
    if (earlier == IslandRecords::kNoEntry) return false;
    piece = islands.piece(earlier);
    return true;
  };
  if (islands.last_piece[i] == IslandRecords::kNoEntry && islands.last_piece[k] == IslandRecords::kNoEntry)
    return meetOnWholePaths(world, window, i, k);
  const double reach = world.balls[i].params.radius + world.balls[k].params.radius;
  Piece mine = lastPiece(world, window, i);
  do
  {
    Piece other = lastPiece(world, window, k);
    do
      if (meet(mine, other, reach)) return true;
    while (next(other));
  } while (next(mine));
  return false;
}
}  // namespace ping_pong
