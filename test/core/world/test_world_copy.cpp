// A world can be copied at any time between ticks. The copy goes on with the same bits; neither feels what happens to the other.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <type_traits>

#include "ping_pong_sim/state_hash.h"
#include "testing/crowd_scenes.h"

namespace ping_pong
{
namespace
{
template <class... Numbers>
bool sameBits(const Vector3d& a, const Vector3d& b, const Numbers&... more)
{
  if (std::memcmp(a.data(), b.data(), sizeof a) != 0) return false;
  if constexpr (sizeof...(more) > 0)
    return sameBits(more...);
  else
    return true;
}

bool same(const Contact& a, const Contact& b)
{
  return a.time == b.time && a.ball == b.ball && a.with_ball == b.with_ball && a.other_ball == b.other_ball &&
         a.body == b.body && a.shape == b.shape &&
         sameBits(a.p_WC, b.p_WC, a.n_W, b.n_W, a.v_before, b.v_before, a.v_after, b.v_after) &&
         sameBits(a.w_before, b.w_before, a.w_after, b.w_after, a.v_other, b.v_other, a.impulse, b.impulse);
}

bool same(const StepStatus& a, const StepStatus& b)
{
  return a.contacts == b.contacts && a.events == b.events && a.squeezed == b.squeezed &&
         a.blocked_paddles == b.blocked_paddles && a.piled == b.piled && a.event_limit == b.event_limit &&
         a.not_finite == b.not_finite;
}

bool sameBody(const World& a, const World& b, std::size_t i)
{
  const PaddleCommand &one = a.bodyCommand(i), &other = b.bodyCommand(i);
  return one.mode == other.mode && sameBits(one.pose.p, other.pose.p, one.twist.v, other.twist.v, one.a_W, other.a_W) &&
         sameBits(a.bodyPose(i).p, b.bodyPose(i).p, a.bodyTwist(i).v, b.bodyTwist(i).v, a.bodyTwist(i).w,
                  b.bodyTwist(i).w) &&
         a.bodyPose(i).q.coeffs() == b.bodyPose(i).q.coeffs();
}

/// All that can be seen of two worlds, but for the numbers of ticks to come.
void expectSame(const World& a, const World& b)
{
  EXPECT_EQ(stateHash(a), stateHash(b));
  EXPECT_EQ(a.method(), b.method());
  ASSERT_EQ(a.contacts().size(), b.contacts().size());
  for (std::size_t i = 0; i < a.contacts().size(); ++i) ASSERT_TRUE(same(a.contacts()[i], b.contacts()[i])) << i;
  ASSERT_EQ(a.bodyCount(), b.bodyCount());
  for (std::size_t i = 0; i < a.bodyCount(); ++i) EXPECT_TRUE(sameBody(a, b, i)) << a.body(i).name;
  ASSERT_EQ(a.ballCount(), b.ballCount());
  for (std::size_t i = 0; i < a.ballCount(); ++i)
  {
    EXPECT_EQ(a.resting(i), b.resting(i)) << i;
    const double since = a.restingSince(i), since_b = b.restingSince(i);
    EXPECT_TRUE(since == since_b || (std::isnan(since) && std::isnan(since_b))) << i;
  }
}

using Drive = std::function<void(World& world, int tick)>;

struct Moment
{
  std::string title;
  Scene scene;
  double tick = 0.01;
  int before = 0;  ///< ticks before the copy
  int after = 20;
  std::function<bool(const World&, const StepStatus&)> reached = [](const World&, const StepStatus&) { return true; };
  Drive drive = [](World&, int) {};
};

StepStatus goOn(World& world, const Moment& moment, int first, int ticks)
{
  StepStatus status;
  for (int tick = first; tick < first + ticks; ++tick)
  {
    moment.drive(world, tick);
    status = world.advance(moment.tick);
  }
  return status;
}

World worldAt(const Moment& moment)
{
  World world(moment.scene);
  const StepStatus status = goOn(world, moment, 0, moment.before);
  EXPECT_TRUE(moment.reached(world, status)) << "not what the title says";
  return world;
}

void goOnAlike(World& a, World& b, const Moment& moment)
{
  for (int tick = moment.before; tick < moment.before + moment.after; ++tick)
  {
    const StepStatus of_a = goOn(a, moment, tick, 1), of_b = goOn(b, moment, tick, 1);
    EXPECT_TRUE(same(of_a, of_b)) << "tick " << tick;
    ASSERT_NO_FATAL_FAILURE(expectSame(a, b)) << "tick " << tick;
  }
}

// --- Moments worth a copy ---

Drive always(std::size_t body, const PaddleCommand& command)
{
  return [body, command](World& world, int) { world.command(body, command); };
}

Drive once(std::size_t body, const PaddleCommand& command)
{
  return [body, command](World& world, int tick)
  {
    if (tick == 0) world.command(body, command);
  };
}

PaddleCommand poseCommand(const Pose& pose, const Vector3d& v)
{
  PaddleCommand command;
  command.mode = PaddleCommand::Mode::Pose;
  command.pose = pose;
  command.twist.v = v;
  return command;
}

Scene rough(const SceneBuilder& builder, double e = 0.3)
{
  Surface law;
  law.restitution = e;
  law.friction = 0.3;
  law.rolling_resistance = law.spin_friction = 0.01;
  return withLaw(SceneBuilder(builder).build(), law);
}

Scene inThreads(Scene scene, int threads)
{
  scene.threads = static_cast<std::size_t>(threads);
  return scene;
}

std::size_t restingBalls(const World& world)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < world.ballCount(); ++i) count += world.resting(i);
  return count;
}

bool rolls(const World& world, const StepStatus&)
{
  return world.restingSince(0) < world.time() && velocityOf(world).norm() > 0.05;
}
bool rests(const World& world, const StepStatus&)
{
  return world.resting(0) && velocityOf(world) == Vector3d::Zero();
}
bool ridesAlong(const World& world, const StepStatus&)
{
  return world.restingSince(0) < world.time() && world.bodyTwist(0).v.norm() > 0.01;
}

Moment lying(const char* title, const SceneBuilder& builder, int before)
{
  Moment moment{title, rough(builder)};
  moment.before = before;
  moment.after = 50;
  return moment;
}

Moment rollingBall()
{
  SceneBuilder builder;
  builder.gravity(kG).box("table", {2, 2, 0.1}, at({0, 0, -0.05}, 0.05, {0, 1, 0})).ball({0, 0, 0.05}, {0.5, 0.2, 0});
  Moment moment = lying("rolling on a slope", builder, 60);
  moment.reached = rolls;
  return moment;
}

Moment restingBall()
{
  SceneBuilder builder;
  builder.gravity(kG).floor().ball({0, 0, kR}).ball({0.1, 0, 0.3}).ball({0.1, 0, 0.4}, {0.1, 0, 0});
  Moment moment = lying("resting, with others in the air", builder, 10);
  moment.reached = rests;
  return moment;
}

Moment carriedBall()
{
  SceneBuilder builder;
  builder.gravity(kG).body("tray", BodyKind::Kinematic, {boxShape({0.5, 0.5, 0.02})}, at({0, 0, 0}));
  builder.ball({0.05, 0, 0.01 + kR}).ball({-0.1, 0.05, 0.2});
  Moment moment = lying("on a turning tray", builder, 60);
  moment.reached = ridesAlong;
  moment.drive = always(0, velocityCommand({0.05, 0.02, 0}, {0.05, 0, 0.4}));
  return moment;
}

// Over a lying cylinder that turns and shakes: the spin of its path is no linear one.
Moment ballOnATurningCylinder()
{
  SceneBuilder builder;
  const Pose lying_down = at({0, 0, 0}, 0.5 * kPi, {1, 0, 0});
  builder.gravity(kG)
      .floor(-0.5)
      .paddle("cylinder", cylinderShape(0.1, 2), lying_down)
      .ball({0, 0, 0.1 + kR}, {0.1, 0.2, 0});
  Moment moment = lying("over a cylinder that turns", builder, 10);
  moment.scene.bodies.back().twist.w = {0, 2.0, 0};
  moment.reached = rolls;
  moment.drive = [](World& world, int tick) {
    world.command(1, velocityCommand({0.05 * std::cos(0.3 * tick), 0, 0}, {0, 2.0 + std::sin(0.2 * tick), 0}));
  };
  return moment;
}

// On two surfaces at once, in air.
Moment ballInAGroove()
{
  SceneBuilder builder;
  builder.gravity(Vector3d(0, 1, -kG));
  for (const double side : {-1.0, 1.0})
  {
    const double middle = (0.5 + 0.05) * std::sqrt(0.5), height = (0.5 - 0.05) * std::sqrt(0.5);
    builder.box(side < 0 ? "left" : "right", {1, 20, 0.1},
                at({side * middle, 0, height}, -side * 0.25 * kPi, {0, 1, 0}));
  }
  builder.ball({0, 0, kR * std::sqrt(2.0)}, {0, 0.5, 0});
  Moment moment = lying("in a groove in air", builder, 20);
  moment.scene.forces.drag = moment.scene.forces.magnus = true;
  moment.scene.balls[0].state.w_WB = {0, 30, 20};
  moment.reached = rolls;
  return moment;
}

// Some roll, some rest, some are in the air.
Moment ballsOnATable(int threads)
{
  SceneBuilder builder;
  builder.gravity(kG).box("table", {4, 4, 0.1}, at({0, 0, -0.05}));
  for (int i = 0; i < 400; ++i)
    builder.ball({0.1 * (i % 20 - 10), 0.1 * (i / 20 - 10), i % 3 == 2 ? 0.2 : kR},
                 (i % 3 == 0 ? 0.1 : 0.0) * Vector3d(std::sin(i), std::cos(i), 0));
  Moment moment = lying("many that roll", builder, 20);
  moment.scene = inThreads(moment.scene, threads);
  moment.after = 20;
  moment.reached = [](const World& world, const StepStatus&)
  { return restingBalls(world) > 0 && restingBalls(world) < world.ballCount(); };
  return moment;
}

// Between two paddles in mid-air: nothing but them holds it. Another body is put elsewhere meanwhile.
Moment caughtBall()
{
  SceneBuilder builder;
  builder.gravity(kG).restitution(0.5).box("far", {1, 1, 1}, at({5, 5, 5})).ball({0, 0, 0}).ball({0.1, 0, 1.0});
  for (const double side : {-1.0, 1.0})
    builder.paddle(side < 0.0 ? "right" : "left", boxShape({0.2, 0.02, 0.2}), at({0, 0.04 * side, 0}));
  Moment moment{"caught", builder.build(), 5e-3, 5, 60};
  moment.reached = [](const World&, const StepStatus& status) { return status.squeezed == 1; };
  moment.drive = [](World& world, int tick)
  {
    const double speed = tick < 3 ? 1.0 : tick < 30 ? 0.0 : -0.5;
    world.command(1, velocityCommand({0, speed, 0}));
    world.command(2, velocityCommand({0, -speed, 0}));
    if (tick == 10) world.setBodyPose(0, at({5, 5, -5}));
  };
  return moment;
}

Moment squeezedBall()
{
  SceneBuilder builder;
  builder.gravity(kG).restitution(0.9).box("table", {2, 2, 0.1}, at({0, 0, -0.05})).ball({0, 0, kR});
  builder.paddle("paddle", boxShape({0.2, 0.2, 0.01}), at({0, 0, 0.065}));
  Moment moment{"squeezed", builder.build(), 1e-3, 40, 200};
  moment.reached = [](const World&, const StepStatus& status) { return status.squeezed == 1; };
  moment.drive = [](World& world, int tick) { world.command(1, velocityCommand({0, 0, tick < 50 ? -1.0 : 0.5})); };
  return moment;
}

Moment paddleAtWork(const char* title, const PaddleCommand& command)
{
  SceneBuilder builder;
  builder.gravity(kG).floor().restitution(0.9).box("table", {1, 1, 0.1}, at({0, 0, 0.5}));
  builder.body("paddle", BodyKind::Kinematic, {cylinderShape(0.08, 0.01), boxShape({0.02, 0.02, 0.2})},
               at({0.1, 0, 0.9}));
  for (int i = 0; i < 6; ++i) builder.ball({0.07 * i - 0.2, 0.01 * i, 1.1 + 0.03 * i}, {0.2, 0, 0.1 * i});
  Moment moment{title, rough(builder, 0.9)};
  moment.before = 12;
  moment.after = 60;
  moment.drive = once(1, command);
  return moment;
}

Moment blockedPaddle()
{
  Moment moment = paddleAtWork("a paddle that the table stops", velocityCommand({-0.2, 0.1, -3.0}, {0.5, 1.0, 0}));
  moment.drive = once(2, velocityCommand({-0.2, 0.1, -3.0}, {0.5, 1.0, 0}));
  moment.reached = [](const World&, const StepStatus& status) { return status.blocked_paddles > 0; };
  moment.before = 25;
  return moment;
}

Moment swungPaddle()
{
  Moment moment = paddleAtWork("a paddle on its way to a pose", {});
  moment.drive = once(2, poseCommand(at({0.4, 0.2, 1.1}, 1.0, {1, 1, 0}), {0.1, 0, 0}));
  moment.reached = [](const World& world, const StepStatus&) { return world.bodyTwist(2).v.norm() > 0.5; };
  moment.before = 5;
  return moment;
}

Moment heap(const char* title, int threads, int before)
{
  const int balls = threads == 1 ? 150 : 600;  // which are worth sharing
  return {title, inThreads(pourOf(balls, Method::Impulse), threads), 0.02, before, 5};
}

// A heap that `exact` has passed on, and balls above it that it has not.
Moment handedOver(int threads)
{
  Moment moment{"some handed over", inThreads(pourOf(150), threads), 0.02, 22, 10};
  moment.drive = [](World& world, int tick)
  {
    BallState above;
    above.p_WB = {0.03, 0.02, 1.0 + 0.05 * tick};
    if (tick >= 10 && tick < 20) world.spawnBall(BallParams(), above);
  };
  moment.reached = [](const World& world, const StepStatus& status)
  { return status.piled > 0 && status.piled < world.ballCount(); };
  return moment;
}

std::vector<Moment> makeMoments()
{
  std::vector<Moment> all;
  for (const int before : {0, 1, 30})
  {
    Moment air{"air and a paddle that moves", airOf(60), 0.01, before, 40};
    air.drive = once(5, velocityCommand({0.5, 0.1, 0}, {0, 0, 2}));
    all.push_back(air);
  }
  for (const Moment& moment : {rollingBall(), restingBall(), carriedBall(), ballOnATurningCylinder(), ballInAGroove(),
                               squeezedBall(), caughtBall(), blockedPaddle(), swungPaddle()})
    all.push_back(moment);
  for (const int threads : {1, 2})
  {
    for (const int before : {0, 7})  // short ticks: between them it is known who meets whom next
      all.push_back({"gas", inThreads(gasOf(600), threads), 2e-3, before, 10});
    Moment falling = heap("falling together", threads, 5);
    falling.reached = [](const World& world, const StepStatus& status) { return status.piled == world.ballCount(); };
    Moment asleep = heap("half asleep", threads, 50);
    asleep.reached = [](const World& world, const StepStatus&)
    { return restingBalls(world) > 0 && restingBalls(world) < world.ballCount(); };
    for (const Moment& moment : {falling, asleep, handedOver(threads), ballsOnATable(threads)}) all.push_back(moment);
  }
  for (const Method method : kMethods)
  {
    Moment moment{std::string("bouncing, ") + name(method), airOf(20), 0.01, 20, 40};
    moment.scene.method = method;
    all.push_back(moment);
    for (Moment lying : {rollingBall(), ballOnATurningCylinder(), ballInAGroove(), squeezedBall()})
    {
      lying.title += std::string(", ") + name(method);
      lying.scene.method = method;
      lying.reached = [](const World&, const StepStatus&) { return true; };  // of rest only some methods tell
      all.push_back(lying);
    }
  }
  return all;
}

const std::vector<Moment>& moments()
{
  static const std::vector<Moment> all = makeMoments();
  return all;
}

std::string describe(const Moment& moment)
{
  return moment.title + ", after " + std::to_string(moment.before) +
         " ticks, threads: " + std::to_string(moment.scene.threads);
}

TEST(WorldCopy, GoesOnWithTheSameBits)
{
  for (const Moment& moment : moments())
  {
    SCOPED_TRACE(describe(moment));
    World model = worldAt(moment);
    World copy = model;
    ASSERT_NO_FATAL_FAILURE(expectSame(copy, model));
    ASSERT_NO_FATAL_FAILURE(goOnAlike(copy, model, moment));
    World undisturbed(moment.scene);  // that nobody copied
    goOn(undisturbed, moment, 0, moment.before + moment.after);
    expectSame(model, undisturbed);
  }
}

TEST(WorldCopy, OutlivesItsModel)
{
  for (const Moment& moment : moments())
  {
    SCOPED_TRACE(describe(moment));
    std::optional<World> model(worldAt(moment));
    World copy = *model;
    World expected = *model;
    goOn(expected, moment, moment.before, moment.after);
    model.reset();
    goOn(copy, moment, moment.before, moment.after);
    ASSERT_NO_FATAL_FAILURE(expectSame(copy, expected));
  }
}

TEST(WorldCopy, OfACopyGoesOnLikeTheFirst)
{
  const Moment moment = handedOver(1);
  World first = worldAt(moment);
  World third = World(World(first));
  goOnAlike(first, third, moment);
  World fourth = third;
  expectSame(first, fourth);
}

TEST(WorldCopy, SharesTheSceneAndHasItsOwnRest)
{
  World model = worldAt(rollingBall());
  World copy = model;
  EXPECT_EQ(&copy.scene(), &model.scene());
  EXPECT_NE(&copy.contacts(), &model.contacts());
  EXPECT_NE(&copy.body(0), &model.body(0));
  EXPECT_NE(&copy.ballParams(0), &model.ballParams(0));
}

TEST(WorldCopy, HasTheContactsOfTheLastTick)
{
  World world = SceneBuilder().gravity(kG).floor().ball({0, 0, 0.1}, {0.3, 0, -2}).world();
  ASSERT_EQ(world.advance(0.1).contacts, 1u);
  World copy = world;
  ASSERT_EQ(copy.contacts().size(), 1u);
  EXPECT_TRUE(same(copy.contacts()[0], world.contacts()[0]));
  world.advance(1e-3);
  EXPECT_TRUE(world.contacts().empty());
  EXPECT_EQ(copy.contacts().size(), 1u);
}

TEST(WorldCopy, KeepsContactsIfItsModelDoes)
{
  World world = SceneBuilder().gravity(kG).floor().ball({0, 0, 0.1}).world();
  world.keepContacts(false);
  World copy = world;
  copy.advance(0.3);
  EXPECT_TRUE(copy.contacts().empty());
  copy.keepContacts(true);
  world.advance(0.3);
  EXPECT_TRUE(world.contacts().empty());
}

TEST(WorldCopy, CountsTimeInTheSameTicks)  // what rounding took from the time so far is copied, too
{
  World world = SceneBuilder().ball({0, 0, 0}).world();
  for (int i = 0; i < 12345; ++i) world.advance(1e-4);
  World copy = world;
  for (int i = 12345; i < 100000; ++i) copy.advance(1e-4);
  EXPECT_EQ(copy.time(), 100000 * 1e-4);
}

// --- Changes to one of the two ---

struct Change
{
  const char* title;
  std::function<void(World&)> make;
};

BallState far(double x)
{
  BallState state;
  state.p_WB = {x, 0.9, 1.5};
  state.v_WB = {0.1, 0, 0};
  return state;
}

// In a world of airOf(), whose last body is its paddle.
std::vector<Change> changes()
{
  const auto other_ball = []
  {
    BallParams params;
    params.radius = 0.03;
    params.mass = 0.01;
    return params;
  };
  return {{"spawn a ball of a new type", [=](World& world) { EXPECT_FALSE(world.spawnBall(other_ball(), far(0.5))); }},
          {"spawn many",
           [](World& world)
           {
             for (int i = 0; i < 30; ++i) EXPECT_FALSE(world.spawnBall(BallParams(), far(0.05 * i - 0.75)));
           }},
          {"delete a ball", [](World& world) { EXPECT_FALSE(world.deleteBall(world.ballId(3))); }},
          {"delete all balls",
           [](World& world)
           {
             while (world.ballCount() > 0) world.deleteBall(world.ballId(0));
           }},
          {"put a ball elsewhere", [](World& world) { EXPECT_FALSE(world.setBallState(world.ballId(0), far(0))); }},
          {"command a paddle",
           [](World& world) {
             EXPECT_FALSE(world.command(5, velocityCommand({2, 0, 0}, {0, 3, 0})));
           }},
          {"put a paddle elsewhere",
           [](World& world) {
             EXPECT_FALSE(world.setBodyPose(5, at({0.4, 0.2, 0.3})));
           }},
          {"reset", [](World& world) { world.reset(); }},
          {"advance alone", [](World& world) { run(world, 0.013, 40); }},
          {"keep no contacts", [](World& world) { world.keepContacts(false); }},
          {"nothing, but end", [](World&) {}}};
}

Moment inTheAir()
{
  Moment moment{"air", airOf(40), 0.01, 25, 25};
  moment.drive = once(5, velocityCommand({0.5, 0.1, 0}, {0, 0, 2}));
  return moment;
}

TEST(WorldCopy, IsNotFeltByItsModelWhateverIsDoneToIt)
{
  const Moment moment = inTheAir();
  for (const Change& change : changes())
  {
    SCOPED_TRACE(change.title);
    World model = worldAt(moment), expected = worldAt(moment);
    {
      World copy = model;
      change.make(copy);
      run(copy, 0.01, 25);
      ASSERT_NO_FATAL_FAILURE(expectSame(model, expected));
    }
    ASSERT_NO_FATAL_FAILURE(goOnAlike(model, expected, moment));
  }
}

TEST(WorldCopy, DoesNotFeelWhatIsDoneToItsModel)
{
  const Moment moment = inTheAir();
  for (const Change& change : changes())
  {
    SCOPED_TRACE(change.title);
    World model = worldAt(moment), expected = worldAt(moment);
    World copy = model;
    change.make(model);
    run(model, 0.01, 25);
    ASSERT_NO_FATAL_FAILURE(expectSame(copy, expected));
    ASSERT_NO_FATAL_FAILURE(goOnAlike(copy, expected, moment));
  }
}

TEST(WorldCopy, TakesAnyChangeAsItsModelDoes)
{
  const Moment moment = inTheAir();
  for (const Change& change : changes())
  {
    SCOPED_TRACE(change.title);
    World model = worldAt(moment);
    World copy = model;
    change.make(model);
    change.make(copy);
    ASSERT_NO_FATAL_FAILURE(goOnAlike(copy, model, moment));
    BallId of_model = 0, of_copy = 0;
    ASSERT_FALSE(model.spawnBall(BallParams(), far(-0.7), &of_model));
    ASSERT_FALSE(copy.spawnBall(BallParams(), far(-0.7), &of_copy));
    EXPECT_EQ(of_copy, of_model);
    ASSERT_NO_FATAL_FAILURE(goOnAlike(copy, model, moment));
  }
}

TEST(WorldCopy, OfOneBallTakesOthersInOfAnyMethodAndNumberOfThreads)
{
  for (const Method method : kMethods)
    for (const int threads : {1, 2})
      for (const int at_first : {0, 1, 2})
      {
        SCOPED_TRACE(std::string(name(method)) + ", balls at first: " + std::to_string(at_first));
        SceneBuilder builder = SceneBuilder(method).gravity(kG).floor();
        stackBalls(builder, at_first, 1, 0.1, 0.1);
        const Moment moment{"few balls", inThreads(rough(builder), threads)};
        World model(moment.scene);
        if (at_first == 2) model.deleteBall(0);  // there is room for two
        World copy = model;
        World assigned = model;  // of the same scene
        for (int i = 0; i < 5; ++i) assigned.spawnBall(BallParams(), far(0.2 * i));
        assigned = copy;
        for (int i = 0; i < 9; ++i)
          for (World* world : {&model, &copy, &assigned}) ASSERT_FALSE(world->spawnBall(BallParams(), far(0.05 * i)));
        ASSERT_NO_FATAL_FAILURE(goOnAlike(copy, model, moment));
        goOn(assigned, moment, moment.before, moment.after);
        expectSame(assigned, model);
      }
}

// --- Assignment ---

TEST(WorldCopy, MayBeAssignedOverARunningWorld)
{
  std::vector<World> worlds;
  for (const Moment& moment : moments()) worlds.push_back(worldAt(moment));
  World becomes = worlds.back();
  for (std::size_t i = 0; i < worlds.size(); ++i)  // each one over the one before, that has gone on
  {
    const Moment& moment = moments()[i];
    SCOPED_TRACE(describe(moment));
    World expected = worlds[i];
    goOn(expected, moment, moment.before, moment.after);
    becomes = worlds[i];
    ASSERT_NO_FATAL_FAILURE(expectSame(becomes, worlds[i]));
    goOn(becomes, moment, moment.before, moment.after);
    ASSERT_NO_FATAL_FAILURE(expectSame(becomes, expected));
  }
}

// As a planner goes back to the same instant for each try.
TEST(WorldCopy, BringsAWorldBackToTheSameInstantAgainAndAgain)
{
  for (const Moment& moment : moments())
  {
    SCOPED_TRACE(describe(moment));
    const World model = worldAt(moment);
    World expected = model;
    goOn(expected, moment, moment.before, moment.after);
    World tried = model;
    for (int trial = 0; trial < 3; ++trial)
    {
      tried = model;
      goOn(tried, moment, moment.before, 2);
      if (trial > 0) tried.deleteBall(tried.ballId(0));
      if (trial > 1) tried.reset();
      goOn(tried, moment, moment.before, 2);
    }
    tried = model;
    ASSERT_NO_FATAL_FAILURE(expectSame(tried, model));
    goOn(tried, moment, moment.before, moment.after);
    ASSERT_NO_FATAL_FAILURE(expectSame(tried, expected));
  }
}

TEST(WorldCopy, AssignedToItselfStaysAsItIs)
{
  const Moment moment = inTheAir();
  World world = worldAt(moment), expected = worldAt(moment);
  World& same_world = world;
  world = same_world;
  goOnAlike(world, expected, moment);
}

TEST(WorldCopy, MayBeAssignedToAWorldThatWasMovedFrom)
{
  const Moment moment = inTheAir();
  World world = worldAt(moment);
  World taken = std::move(world);
  world = taken;
  goOnAlike(world, taken, moment);
  World again = std::move(world);
  world = std::move(again);
  expectSame(world, taken);
}

TEST(WorldCopy, StandsInContainers)
{
  static_assert(std::is_nothrow_move_constructible_v<World> && std::is_nothrow_move_assignable_v<World>,
                "a list that grows moves");
  const Moment moment = rollingBall();
  const World model = worldAt(moment);
  std::vector<World> fan(3, model);
  for (std::size_t i = 0; i < 4; ++i) fan.push_back(fan[i]);
  World expected = model;
  goOn(expected, moment, moment.before, moment.after);
  for (World& world : fan)
  {
    goOn(world, moment, moment.before, moment.after);
    expectSame(world, expected);
  }
}

TEST(WorldCopy, IsTakenBySeveralThreadsAtATime)
{
  const Moment moment = handedOver(1);
  const World model = worldAt(moment);
  std::vector<std::uint64_t> hashes(4);
  std::vector<std::thread> threads;
  for (std::uint64_t& hash : hashes)
    threads.emplace_back(
        [&]
        {
          World copy = model;
          goOn(copy, moment, moment.before, moment.after);
          hash = stateHash(copy);
        });
  for (std::thread& thread : threads) thread.join();
  World alone = model;
  goOn(alone, moment, moment.before, moment.after);
  EXPECT_EQ(hashes, std::vector<std::uint64_t>(4, stateHash(alone)));
}
}  // namespace
}  // namespace ping_pong
