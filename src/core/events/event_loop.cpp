#include "events/event_loop.h"

#include "events/bounce_run.h"
#include "events/predict.h"
#include "events/resolve_event.h"
#include "resting/plan_path.h"

namespace ping_pong
{
namespace
{
// A tick ends, and says so, where more happens in it: about a second of work, and for one ball 10 ms.
constexpr std::size_t kEventsPerAdvance = 1000000;
constexpr std::size_t kEventsPerBall = 10000;

constexpr double kFromTheStart = -kNever;

// --- predictions ---

void predictBalls(WorldState& world, const Window& window, std::size_t i, double resume = kFromTheStart)
{
  if (world.balls[i].transient) world.balls[i].transient->ball = Event();
  for (std::size_t m = 0; m < window.count; ++m)
    if (window.members[m] != i) predictBall(world, i, window.members[m], resume, window.end, *window.records);
}

void predictBodies(WorldState& world, const Window& window, std::size_t i, double t)
{
  predictStill(world, i, t);
  if (world.any_moving) predictMoving(world, i, t, window.smooth_until);
}

// Searches on from the horizon of a prediction, or anew for one that is void; false if the next event of ball i is neither.
bool predictAgain(WorldState& world, const Window& window, std::size_t i)
{
  const BallRecord& ball = world.balls[i];
  const Event& event = nextEvent(ball);
  const bool at_horizon = event.kind == Event::Kind::Horizon;
  if (!at_horizon && stillTrue(world, event)) return false;
  const double t = event.time;
  // Only what is void is searched for anew: the other answer keeps its bits.
  if (ball.transient && &event == &ball.transient->ball)
    predictBalls(world, window, i, at_horizon ? t : kFromTheStart);
  else
    predictBodies(world, window, i, t);
  return true;
}

// The commonest events have a closed form of all three steps; false if the next event of ball i is none of these.
bool bounceAlone(WorldState& world, const Window& window, std::size_t i)
{
  const BallRecord& ball = world.balls[i];
  if (&nextEvent(ball) != &ball.next || !runBounces(world, window, i)) return false;
  if (window.count > 1) predictBalls(world, window, i);
  return true;
}

// --- the three steps of an event ---

// The next event of ball i, with the states to which its balls have come on their paths by then.
DueEvent evolve(const WorldState& world, std::size_t i)
{
  const Event event = nextEvent(world.balls[i]);  // a copy: the original goes when the path does
  const BallState state = world.balls[i].stateAt(event.time);
  if (event.kind != Event::Kind::HitBall) return {event, {i, kNone}, 1, {state, BallState()}};
  return {event, {i, event.other}, 2, {state, world.balls[event.other].stateAt(event.time)}};
}

// New paths from the states that resolve() has left, and the events to come on them.
void detect(WorldState& world, const Window& window, const DueEvent& due)
{
  const double t = due.event.time;
  for (std::size_t k = 0; k < due.count; ++k)
  {
    if (window.log) window.log->leavesPath(due.balls[k], t);
    planPath(world, world.balls[due.balls[k]], due.states[k], t, window.smooth_until);
  }
  for (std::size_t k = 0; k < due.count; ++k)
  {
    predictBodies(world, window, due.balls[k], t);
    if (window.count > 1) predictBalls(world, window, due.balls[k]);
  }
}

// The ball of the next event, or kNone if there is none until the window ends.
std::size_t earliestBall(const WorldState& world, const Window& window)
{
  std::size_t first = kNone;
  double time = kNever;
  for (std::size_t m = 0; m < window.count; ++m)
  {
    const double its = nextEvent(world.balls[window.members[m]]).time;
    if (its >= time) continue;
    time = its;
    first = window.members[m];
  }
  return time <= window.end ? first : kNone;
}
}  // namespace

bool runTogether(WorldState& world, const Window& window)
{
  StepStatus& status = window.records->status;
  const std::size_t limit = kEventsPerAdvance + kEventsPerBall * world.balls.size();
  const std::size_t last = status.events + limit - std::min(limit, world.status.events);
  std::size_t events = 0;
  for (std::size_t i = earliestBall(world, window); i != kNone; i = earliestBall(world, window))
  {
    if (++events > window.most_events) return false;
    if (++status.events > last)
    {
      status.event_limit = true;
      return true;
    }
    if (bounceAlone(world, window, i) || predictAgain(world, window, i)) continue;
    DueEvent due = evolve(world, i);
    resolve(world, window, due);
    detect(world, window, due);
  }
  return true;
}
}  // namespace ping_pong
