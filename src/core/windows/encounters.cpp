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
template <class Look>
bool anyPieceLeft(const WorldWithWindows& world, std::size_t i, const Look& look)
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
  const Glance& glance = world.islands.glances[i];
  const GlanceKind& kind = world.islands.glances.kindOf(glance);
  if (kind.how == GlanceKind::How::Flies) return {viewOf(glance, kind), window.end, true};
  const Segment& path = world.balls[i].path;
  return {ParabolaView(path), window.end, isParabola(path)};
}

double radiusOf(const WorldWithWindows& world, std::size_t i)
{
  const GlanceKind& kind = world.islands.glances.kindOf(world.islands.glances[i]);
  return kind.how == GlanceKind::How::Flies ? kind.radius : world.balls[i].params().radius;
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

// On paths that both, or one of them, have left. Few have: whoever asks for the others is quicker without this in between.
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

// Whoever comes near has to expect the ball until then.
void forgetPath(Piece& piece, double until)
{
  piece.parabola = false;
  piece.until = until;
}

[[gnu::noinline]] double meetingOnPaths(const BallRecord& a, const BallRecord& b, double until)
{
  if (a.away() || b.away() || (a.path.degree == 0 && b.path.degree == 0)) return kNever;
  const double from = std::max(a.path.start, b.path.start);
  const double to = std::min({until, a.path.end, b.path.end});
  return firstContact(a.path, a.params().radius, b.path, b.params().radius, from, to).time;
}

// See firstMeeting(): asked for every two balls that come near each other.
[[gnu::always_inline]] inline double meeting(const WorldWithWindows& world, std::size_t i, std::size_t k, double until)
{
  const Glances& glances = world.islands.glances;
  const Glance &a = glances[i], &b = glances[k];
  const GlanceKind &kind_a = glances.kindOf(a), &kind_b = glances.kindOf(b);
  const bool fly = kind_a.how == GlanceKind::How::Flies && kind_b.how == GlanceKind::How::Flies;
  if (!fly || (a.kind != b.kind && kind_a.half_a != kind_b.half_a))
    return meetingOnPaths(world.balls[i], world.balls[k], until);
  count(Law::PairSearch);
  return firstContact(viewOf(a, kind_a), viewOf(b, kind_b), kind_a.radius + kind_b.radius, std::max(a.start, b.start),
                      until)
      .time;
}
class WindowLog final : public FlightLog
{
public:
  WindowLog(WorldWithWindows& its_world, const WorkerWindow& its_window) : world(its_world), window(its_window) {}
  void flown(std::size_t i, double t) override;
  void flownInBox(std::size_t i, const Box& box, double t) override;
  void met(std::size_t i, std::size_t k) override { world.islands.busy(i).met = world.islands.busy(k).met = true; }

private:
  WorldWithWindows& world;
  const WorkerWindow& window;
};

void WindowLog::flown(std::size_t i, double t)
{
  IslandRecords& islands = world.islands;
  IslandWork& work = *window.work;
  const BallRecord& ball = world.balls[i];
  islands.busy(i).swept.add(CoarseBox(boxOf(ball, window.start, t)));
  const std::uint32_t last = islands.busy(i).piece;
  std::uint16_t count = 1;
  if (last != IslandRecords::kNoEntry)
  {
    Piece& before = work.pieces[IslandRecords::indexOf(last)];  // whoever runs a ball on has noted what it has flown
    if (asLittleIsKnown(before, ball.path) || before.count == kMostPieces) return forgetPath(before, t);
    count = static_cast<std::uint16_t>(before.count + 1);
  }
  islands.busy(i).piece = IslandRecords::entry(work, work.pieces.size());
  work.pieces.push_back({asParabola(ball.path), t, last, count, isParabola(ball.path)});
}

void WindowLog::flownInBox(std::size_t i, const Box& box, double t)
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

void forgetFlown(IslandRecords& islands, std::size_t i)
{
  IslandWork::Busy& busy = islands.busy(i);
  busy.swept = CoarseBox();
  busy.piece = IslandRecords::kNoEntry;
}

void noteLast(WorldWithWindows& world, const WorkerWindow& window, std::size_t i)
{
  IslandRecords& islands = world.islands;
  const bool bent = islands.busy(i).piece != IslandRecords::kNoEntry;
  islands.busy(i).swept.add(CoarseBox(boxAhead(world.balls[i], window.start, window.outlook)));
  islands.busy(i).next_event = islands.glances.lookAt(world.balls[i], i, bent);
}

double firstMeeting(const WorldWithWindows& world, std::size_t i, std::size_t k, double until)
{
  return meeting(world, i, k, until);
}

Encounter encounterOf(const WorldWithWindows& world, const WorkerWindow& window, std::size_t i, std::size_t k)
{
  const Glances& glances = world.islands.glances;
  if ((glances[i].bent || glances[k].bent) && metBefore(world, window, i, k)) return {true, kNever};
  const double next = meeting(world, i, k, window.outlook);
  return {next <= window.end, next};
}
}  // namespace ping_pong
