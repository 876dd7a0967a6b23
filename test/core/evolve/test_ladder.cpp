// The ladder of methods: order in the air and through bounces, states between steps, time reversal.
#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "testing/air_shots.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
constexpr int kShots = 64;  // single paths are lucky: errors are root mean squares over so many
const Surface kTable{0.93, 0.0, 0.25};

struct Rung
{
  Method method;
  double order;          // in the air
  double bounced_order;  // through bounces
  double step;           // [s], small enough to show the order, large enough to stay above rounding
};

void PrintTo(const Rung& rung, std::ostream* out)
{
  *out << name(rung.method);
}

class Ladder : public testing::TestWithParam<Rung>
{
};

INSTANTIATE_TEST_SUITE_P(Methods, Ladder,
                         testing::Values(Rung{Method::EulerExplicit, 1, 1, 4e-3},
                                         Rung{Method::EulerSemiImplicit, 1, 1, 4e-3}, Rung{Method::Verlet, 2, 1, 8e-3},
                                         Rung{Method::Rk4, 4, 1, 16e-3}, Rung{Method::Rk4Located, 4, 4, 16e-3}),
                         [](const auto& info) { return std::string(name(info.param.method)); });

Scene sceneOf(const BallState& shot, Method method, double dt, bool floor)
{
  SceneBuilder builder(method, dt);
  if (floor) builder.floor();
  Scene scene = builder.ball(shot.p_WB, shot.v_WB).build();
  scene.balls[0].state = shot;
  scene.forces = fullAir(LiftLaw::Kind::Saturating);
  scene.surfaces.set(0, 1, kTable);
  return scene;
}

std::vector<BallState> shots()
{
  std::mt19937 random(4);
  std::vector<BallState> list(kShots);
  for (BallState& shot : list) shot = randomShot(random);
  return list;
}

double rms(const std::function<double(std::size_t)>& error)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < kShots; ++i) sum += error(i) * error(i);
  return std::sqrt(sum / kShots);
}

// Errors of position (seconds of) velocity and spin weigh alike.
double errorOf(const BallState& state, const AirReference::State& truth)
{
  return distance(state.p_WB, truth.p) + 0.1 * distance(state.v_WB, truth.v) + 1e-3 * distance(state.w_WB, truth.w);
}

// Slope of log error over log step, over halvings of the step.
double orderOf(const std::function<double(double)>& error, double step, int halvings)
{
  double fine = step;
  for (int i = 0; i < halvings; ++i) fine *= 0.5;
  const double first = error(step), last = error(fine);
  measured("error at the longest step", first);
  measured("error at the shortest", last);
  return std::log2(first / last) / halvings;
}

// Worked out once: every method is held against the same.
const std::vector<AirReference::State>& truths(double end, bool floor)
{
  static std::map<std::pair<double, bool>, std::vector<AirReference::State>> known;
  std::vector<AirReference::State>& list = known[{end, floor}];
  if (!list.empty()) return list;
  const AirReference reference = referenceOf(fullAir(LiftLaw::Kind::Saturating));
  for (const BallState& shot : shots())
    list.push_back(floor ? reference.rally(stateOf(shot), kTable, end) : reference.flown(stateOf(shot), end));
  return list;
}

double endError(Method method, double dt, double end, bool floor, const std::vector<AirReference::State>& truth)
{
  const std::vector<BallState> starts = shots();
  return rms(
      [&](std::size_t i)
      {
        World world(sceneOf(starts[i], method, dt, floor));
        world.advance(end);
        return errorOf(world.ballState(0), truth[i]);
      });
}

TEST_P(Ladder, HalvingTheStepInTheAirShowsTheOrder)
{
  constexpr double kEnd = 0.512;  // a whole number of all steps
  const std::vector<AirReference::State>& truth = truths(kEnd, false);
  const auto error = [&](double dt) { return endError(GetParam().method, dt, kEnd, false, truth); };
  // Terms of the next order are a few percent at these steps.
  EXPECT_NEAR(orderOf(error, GetParam().step, 3), GetParam().order, 0.1);
}

TEST_P(Ladder, HalvingTheStepThroughBouncesShowsWhatSamplingContactsCosts)
{
  constexpr double kEnd = 1.024;
  const std::vector<AirReference::State>& truth = truths(kEnd, true);
  const bool located = locatesContacts(GetParam().method);
  const auto error = [&](double dt) { return endError(GetParam().method, dt, kEnd, true, truth); };
  // A bounce that is found up to a step late errs by its luck: over 64 shots the slope over 4 halvings wanders by 0.1
  // or so.
  const double order = orderOf(error, located ? GetParam().step : 5e-4, located ? 3 : 4);
  EXPECT_NEAR(order, GetParam().bounced_order, 0.2);
}

TEST_P(Ladder, TheWorldCanBeAskedBetweenStepsWithoutLossOfOrder)
{
  const double queries[] = {0.0131, 0.0712, 0.1234, 0.2021, 0.2477, 0.3103, 0.4001};
  std::vector<std::vector<AirReference::State>> truth;
  for (const double query : queries) truth.push_back(truths(query, false));
  const std::vector<BallState> starts = shots();
  const auto error = [&](double dt)
  {
    return rms(
        [&](std::size_t i)
        {
          World world(sceneOf(starts[i], GetParam().method, dt, false));
          double worst = 0.0;
          for (std::size_t k = 0; k < truth.size(); ++k)
          {
            world.advance(queries[k] - world.time());
            worst = std::max(worst, errorOf(world.ballState(0), truth[k][i]));
          }
          return worst;
        });
  };
  // Methods that step end a step where they are asked: the last one is shorter, and the order a little off.
  EXPECT_NEAR(orderOf(error, GetParam().step, 3), GetParam().order, 0.2);
}

TEST(Ladder, ExactKeepsItsToleranceWhereTheOthersShowTheirOrder)
{
  const std::vector<AirReference::State>& truth = truths(1.024, true);
  const std::vector<BallState> starts = shots();
  const double error = rms(
      [&](std::size_t i)
      {
        World world(sceneOf(starts[i], Method::Exact, 1e-3, true));
        world.advance(1.024);
        return distance(world.ballState(0).p_WB, truth[i].p);
      });
  measured("exact, tolerance 1e-6 m", error);
  EXPECT_LE(error, Scene().tolerance);
}

// Rodrigues' formula, written out: where an axis of the ball points after turning with spin w for t.
Vector3d rotated(const Vector3d& x, const Vector3d& w, double t)
{
  const double angle = w.norm() * t;
  const Vector3d k = w.normalized();
  return x * std::cos(angle) + k.cross(x) * std::sin(angle) + k * k.dot(x) * (1.0 - std::cos(angle));
}

TEST(Ladder, ABallTurnsWithTheSpinBeforeAndAfterABounce)
{
  constexpr double kEnd = 0.3;
  for (const Method method : kMethods)
  {
    BallState start;
    start.p_WB = Vector3d(0, 0, kR + 0.2);
    start.w_WB = Vector3d(30, -80, 150);
    Scene scene = sceneOf(start, method, 1e-3, true);
    scene.forces = onlyGravity();
    World world(scene);
    const std::vector<Contact> bounces = run(world, 0.01, 30);
    ASSERT_EQ(bounces.size(), 1u) << name(method);
    ASSERT_GT((bounces[0].w_after - bounces[0].w_before).norm(), 10.0);
    const BallState end = world.ballState(0);
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3d at_bounce = rotated(Vector3d::Unit(axis), start.w_WB, bounces[0].time);
      const Vector3d truth = rotated(at_bounce, bounces[0].w_after, kEnd - bounces[0].time);
      // 50 rad of turning, added up in 300 steps of a rounding of up to 1e-15 each.
      EXPECT_LE((end.q_WB * Vector3d::Unit(axis) - truth).norm(), 1e-12) << name(method);
    }
  }
}

// --- time reversal ---

void turnBack(World& world)
{
  for (std::size_t i = 0; i < world.ballCount(); ++i)
  {
    BallState state = world.ballState(i);
    state.v_WB = -state.v_WB;
    ASSERT_FALSE(world.setBallState(world.ballId(i), state));
  }
}

// How far balls are from their starts after `duration` there and `duration` back.
double missAfterReturn(const Scene& scene, double duration)
{
  World world(scene);
  world.advance(duration);
  turnBack(world);
  world.advance(duration);
  double worst = 0.0;
  for (std::size_t i = 0; i < world.ballCount(); ++i)
    worst = std::max(worst, (positionOf(world, i) - scene.balls[i].state.p_WB).norm());
  return worst;
}

TEST(Reversal, InFlightEulerMissesByAStepOfFallAndTheOthersComeBack)
{
  constexpr double kDt = 4e-3, kEnd = 0.8;
  for (const Method method : kMethods)
  {
    const double miss = missAfterReturn(SceneBuilder(method, kDt).gravity(kG).ball({0, 0, 1}, {3, 1, 4}).build(), kEnd);
    std::printf("[ measured ] %s, flight there and back: %.3g m\n", name(method), miss);
    const bool euler = method == Method::EulerExplicit || method == Method::EulerSemiImplicit;
    // Each way drifts by g h T/2 in the same direction. The others are exact: 400 roundings of 1e-16 m.
    EXPECT_NEAR(miss, euler ? kG * kDt * kEnd : 0.0, 1e-13) << name(method);
  }
}

// An elastic ball that flies about in a closed box, started from somewhere.
Scene ballInABox(Method method, double dt, int start)
{
  SceneBuilder builder(method, dt);
  builder.gravity(kG);
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1}) builder.box("wall", {2, 2, 2}, at(1.5 * side * Vector3d::Unit(axis)));
  const double part = start / 16.0;
  return builder.ball({0.3 * part, 0.1, 0.2 - 0.4 * part}, {2.0 - part, 1.0 + part, 3.0 * part}).build();
}

double boxMiss(Method method, double dt)
{
  double sum = 0.0;
  for (int start = 0; start < 16; ++start) sum += std::pow(missAfterReturn(ballInABox(method, dt, start), 2.0), 2);
  return std::sqrt(sum / 16.0);
}

TEST(Reversal, InABoxOnlyLocatedContactsBringTheBallBack)
{
  for (const Method method : kMethods)
  {
    const double miss = boxMiss(method, 1e-3);
    std::printf("[ measured ] %s, 2 s in a box there and back, rms of 16: %.3g m\n", name(method), miss);
    if (locatesContacts(method))
      EXPECT_LE(miss, 1e-12) << name(method);  // some twenty bounces of a rounding or two
    else
      EXPECT_GE(miss, 1e-4) << name(method);  // pushing out is not reversible: each bounce loses its place in the step
  }
}
}  // namespace
}  // namespace ping_pong
