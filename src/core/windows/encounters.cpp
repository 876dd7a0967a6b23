#include "windows/encounters.h"

#include "base/law_counter.h"
#include "detect/ball_ball.h"

namespace ping_pong
{
namespace
{
using Piece = IslandWork::Piece;

// Of a ball's flight in the window: noted, or the path that it is on now.
struct View
{
  ParabolaView path;
  double until;
  bool parabola;
};

constexpr std::uint16_t kMostPieces = 32;  // of a ball in a window; from then on it may have been anywhere near

// Calls look(piece) for every piece that a ball has left, the last one first, until one answers yes.
template <class GapSample>
bool anyPieceLeft(const WorldWithWindows& world, std::size_t i, const GapSample& look)
{
  for (std::uint32_t entry = world.islands.lastPiece(i); entry != IslandRecords::kNoEntry;)
  {
    const Piece& piece = world.islands.piece(entry);
    if (look(View{ParabolaView(piece.path), piece.until, piece.parabola})) return true;
    entry = piece.earlier;
  }
  return false;
}

View onItsPath(const WorldWithWindows& world, const WorkerWindow& window, std::size_t i)
{
  const CachedBall& cached = world.islands.cache[i];
  const CachedType& type = world.islands.cache.typeOf(cached);
  if (type.how == CachedType::How::Flies) return {viewOf(cached, type), window.end, true};
  const Segment& path = world.balls[i].path;
  return {ParabolaView(path), window.end, isParabola(path)};
}

double radiusOf(const WorldWithWindows& world, std::size_t i)
{
  const CachedType& type = world.islands.cache.typeOf(world.islands.cache[i]);
  return type.how == CachedType::How::Flies ? type.radius : world.balls[i].params().radius;
}

bool meet(const View& a, const View& b, double reach)
{
  const double from = std::max(a.path.start, b.path.start);
  const double until = std::min(a.until, b.until);
  if (from > until) return false;
  if (!a.parabola || !b.parabola || a.path.half_a != b.path.half_a) return true;
  count(Law::PairSearch);
  return firstContact(a.path, b.path, reach, from, until).found();
}

// On paths that both, or one of them, have left. Few have: questions about the others are quicker without this in between.
[[gnu::noinline]] bool metBefore(const WorldWithWindows& world, const WorkerWindow& window, std::size_t i,
                                 std::size_t k)
{
  const double reach = radiusOf(world, i) + radiusOf(world, k);
  const View my_last = onItsPath(world, window, i), its_last = onItsPath(world, window, k);
  const auto meetsK = [&](const View& mine)
  { return anyPieceLeft(world, k, [&](const View& other) { return meet(mine, other, reach); }); };
  return meetsK(my_last) ||
         anyPieceLeft(world, i, [&](const View& mine) { return meet(mine, its_last, reach) || meetsK(mine); });
}

bool asLittleIsKnown(const Piece& piece, const Segment& path)
{
  return !piece.parabola && !isParabola(path);
}

// A ball that comes near has to expect this one until then.
void forgetPath(Piece& piece, double until)
{
  piece.parabola = false;
  piece.until = until;
}

[[gnu::noinline]] double pairContactOnPaths(const BallRecord& a, const BallRecord& b, double until)
{
  if (a.away() || b.away() || (a.path.degree == 0 && b.path.degree == 0)) return kNever;
  const double from = std::max(a.path.start, b.path.start);
  const double to = std::min({until, a.path.end, b.path.end});
  return firstContact(a.path, a.params().radius, b.path, b.params().radius, from, to).time;
}

// See firstPairContact(): asked for every two balls that come near each other.
[[gnu::always_inline]] inline double pairContact(const WorldWithWindows& world, std::size_t i, std::size_t k,
                                                 double until)
{
  const BallCache& cache = world.islands.cache;
  const CachedBall &a = cache[i], &b = cache[k];
  const CachedType &type_a = cache.typeOf(a), &type_b = cache.typeOf(b);
  const bool fly = type_a.how == CachedType::How::Flies && type_b.how == CachedType::How::Flies;
  if (!fly || (a.type != b.type && type_a.half_a != type_b.half_a))
    return pairContactOnPaths(world.balls[i], world.balls[k], until);
  count(Law::PairSearch);
  return firstContact(viewOf(a, type_a), viewOf(b, type_b), type_a.radius + type_b.radius, std::max(a.start, b.start),
                      until)
      .time;
}
class WindowLog final : public FlightLog
{
public:
  WindowLog(WorldWithWindows& its_world, const WorkerWindow& its_window) : world(its_world), window(its_window) {}
  void leavesPath(std::size_t i, double t) override;
  void flewInBox(std::size_t i, const Box& box, double t) override;
  void met(std::size_t i, std::size_t k) override { world.islands.busy(i).met = world.islands.busy(k).met = true; }

private:
  WorldWithWindows& world;
  const WorkerWindow& window;
};

void WindowLog::leavesPath(std::size_t i, double t)
{
  IslandRecords& islands = world.islands;
  IslandWork& work = *window.work;
  const BallRecord& ball = world.balls[i];
  islands.busy(i).swept.add(CoarseBox(boxOf(ball, window.start, t)));
  const std::uint32_t last = islands.busy(i).piece;
  std::uint16_t count = 1;
  if (last != IslandRecords::kNoEntry)
  {
    Piece& before =
        work.pieces[IslandRecords::indexOf(last)];  // the worker that goes on with a ball has logged its flight
    if (asLittleIsKnown(before, ball.path) || before.count == kMostPieces) return forgetPath(before, t);
    count = static_cast<std::uint16_t>(before.count + 1);
  }
  islands.busy(i).piece = IslandRecords::entry(work, work.pieces.size());
  work.pieces.push_back({asParabola(ball.path), t, last, count, isParabola(ball.path)});
}

void WindowLog::flewInBox(std::size_t i, const Box& box, double t)
{
  world.islands.busy(i).swept.add(CoarseBox(box));
  forgetPath(window.work->pieces[IslandRecords::indexOf(world.islands.busy(i).piece)], t);
}

}  // namespace

bool runLogged(WorldWithWindows& world, const WorkerWindow& window)
{
  WindowLog log(world, window);
  Window logged = window;
  logged.log = &log;
  return runTogether(world, logged);
}

void clearFlightLog(IslandRecords& islands, std::size_t i)
{
  IslandWork::Busy& busy = islands.busy(i);
  busy.swept = CoarseBox();
  busy.piece = IslandRecords::kNoEntry;
}

void noteLast(WorldWithWindows& world, const WorkerWindow& window, std::size_t i)
{
  IslandRecords& islands = world.islands;
  const bool left_path = islands.busy(i).piece != IslandRecords::kNoEntry;
  islands.busy(i).swept.add(CoarseBox(boxAhead(world.balls[i], window.start, window.lookahead)));
  islands.busy(i).next_event = islands.cache.read(world.balls[i], i, left_path);
}

double firstPairContact(const WorldWithWindows& world, std::size_t i, std::size_t k, double until)
{
  return pairContact(world, i, k, until);
}

PairOutcome outcomeOf(const WorldWithWindows& world, const WorkerWindow& window, std::size_t i, std::size_t k)
{
  const BallCache& cache = world.islands.cache;
  if ((cache[i].left_path || cache[k].left_path) && metBefore(world, window, i, k)) return {true, kNever};
  const double next = pairContact(world, i, k, window.lookahead);
  return {next <= window.end, next};
}
}  // namespace ping_pong
