#include "flown.h"

#include "count.h"
#include "parabola.h"

namespace ping_pong
{
namespace
{
using Piece = IslandRecords::Piece;

// The path that a ball is on, as a piece that is as long as the window.
Piece lastPiece(const WorldState& world, const Window& window, std::size_t i)
{
  const Segment& path = world.balls[i].path;
  return {asParabola(path), window.end, world.islands.last_piece[i], isParabola(path)};
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

// Room for another piece, with something left for the first pieces of other balls.
bool hasRoom(const IslandRecords& islands)
{
  return islands.pieces.size() + islands.last_piece.size() < islands.pieces.capacity();
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
  BallRecord& ball = world.balls[i];
  ball.swept.add(boxOf(ball, window.start, t));
  const std::uint32_t last = islands.last_piece[i];
  if (last != IslandRecords::kNoPiece && (asLittleIsKnown(islands.pieces[last], ball.path) || !hasRoom(islands)))
  {
    islands.pieces[last].parabola = false;
    islands.pieces[last].until = t;
    return;
  }
  islands.pieces.push_back({asParabola(ball.path), t, last, isParabola(ball.path)});
  islands.last_piece[i] = static_cast<std::uint32_t>(islands.pieces.size() - 1);
}

void forgetFlown(WorldState& world, std::size_t i)
{
  world.balls[i].swept = Box();
  world.islands.last_piece[i] = IslandRecords::kNoPiece;
}

bool metInFlight(const WorldState& world, const Window& window, std::size_t i, std::size_t k)
{
  const IslandRecords& islands = world.islands;
  const auto next = [&](Piece& piece) {
    const std::uint32_t earlier = piece.earlier;
    if (earlier == IslandRecords::kNoPiece) return false;
    piece = islands.pieces[earlier];
    return true;
  };
  if (islands.last_piece[i] == IslandRecords::kNoPiece && islands.last_piece[k] == IslandRecords::kNoPiece)
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
