// Crowds: shipped scenes, their number and seed, rooms, and that starting and spawning stay cheap.
#include <chrono>
#include <cmath>

#include "ping_pong_sim/room.h"
#include "testing/load_checks.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
std::string pathOf(const std::string& name)
{
  return std::string(SCENES_DIR) + "/" + name + ".yaml";
}

Scene crowd(const std::string& name, std::size_t balls = 0, std::uint64_t seed = 0)
{
  LoadOptions options;
  options.balls = balls;
  options.seed = seed;
  options.has_seed = seed != 0;
  return loadScene(pathOf(name), options);
}

double secondsOf(const std::function<void()>& work)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

double fillOf(const Scene& scene)
{
  const double r = scene.balls.front().params.radius;
  return static_cast<double>(scene.balls.size()) * 4.0 / 3.0 * kPi * r * r * r / roomSize(scene.bodies.front())->prod();
}

TEST(CrowdScenes, HoldAsManyBallsAsTheySay)
{
  EXPECT_EQ(crowd("crowd").balls.size(), 1000u);
  EXPECT_EQ(crowd("gas").balls.size(), 1000u);
  EXPECT_EQ(crowd("pour").balls.size(), 1000u);
}

TEST(CrowdScenes, TakeAnotherNumberInARoomThatGrowsWithIt)
{
  const double fill = fillOf(crowd("gas"));
  measured("part of the room of `gas` that balls fill", fill);
  for (const std::size_t balls : {30u, 3000u})
  {
    const Scene gas = crowd("gas", balls), floor = crowd("crowd", balls);
    EXPECT_EQ(gas.balls.size(), balls);
    EXPECT_NEAR(fillOf(gas), fill, 1e-12);
    EXPECT_EQ(floor.balls.size(), balls);
    EXPECT_NEAR(fillOf(floor), fillOf(crowd("crowd")), 1e-12);
    EXPECT_EQ(roomSize(floor.bodies.front())->z(), roomSize(crowd("crowd").bodies.front())->z());  // wider, not higher
  }
  EXPECT_EQ(crowd("pour", 8000).balls.size(), 8000u);
}

TEST(CrowdScenes, TakeAnotherSeed)
{
  const auto first = [](std::uint64_t seed) { return crowd("gas", 10, seed).balls.front().state.p_WB; };
  EXPECT_EQ(first(3), first(3));
  EXPECT_NE(first(3), first(4));
}

TEST(CrowdScenes, SayWhenTheBallsDoNotFit)
{
  const std::string message = loadErrorOf([] { crowd("pour", 20000); });
  EXPECT_TRUE(startsWith(message, pathOf("pour") + ":")) << message;
  EXPECT_NE(message.find("balls[0].random.count: 20000: expected fewer balls, or a larger box: they would fill 68.4 %"),
            std::string::npos)
      << message;
  const std::string nearly = loadErrorOf([] { crowd("tray", 1900); });  // 37 %: begins, and ends for want of room
  EXPECT_NE(nearly.find("balls[0].random.count: 1900: expected fewer balls, or a box with room for more than "),
            std::string::npos)
      << nearly;
}

TEST(CrowdScenes, SayWhenThereIsNoOnePatternToTakeTheNumber)
{
  const std::string message = loadErrorOf([] { crowd("arc", 20); });
  EXPECT_NE(message.find(": balls: 0 random patterns: expected exactly one, to take the 20 balls"), std::string::npos)
      << message;
}

TEST(PourScene, StartsWithAllBallsInTheShaftAndAnOpenWayIntoTheTray)
{
  const Scene scene = crowd("pour");
  for (const SceneBall& ball : scene.balls)
  {
    EXPECT_LE(std::abs(ball.state.p_WB.x() - 0.69), 0.5 - kBallRadius);
    EXPECT_LE(std::abs(ball.state.p_WB.y()), 0.5 - kBallRadius);
    EXPECT_GE(ball.state.p_WB.z(), 1.96 + kBallRadius);
  }
  // A ball in the middle of the shaft falls straight through the outlet onto the table.
  Scene lone = scene;
  lone.balls.resize(1);
  lone.balls[0].state = BallState();
  lone.balls[0].state.p_WB = {0.69, 0.0, 2.5};
  World through(lone);
  std::vector<Contact> hits = run(through, 0.01, 70);
  ASSERT_FALSE(hits.empty());
  EXPECT_EQ(through.body(hits[0].body).name, "table");
  // One beside it hits a board, and comes out below all the same.
  lone.balls[0].state.p_WB = {0.69 + 0.4, 0.3, 2.5};
  World along(lone);
  hits = run(along, 0.01, 40);
  ASSERT_FALSE(hits.empty());
  EXPECT_EQ(along.body(hits[0].body).name, "funnel");
  for (int i = 0; i < 5000 && positionOf(along).z() > 1.56; ++i) along.advance(0.001);
  EXPECT_NEAR(positionOf(along).z(), 1.56, 0.01);
  EXPECT_LT(std::abs(positionOf(along).x() - 0.69), 0.12);
  EXPECT_LT(std::abs(positionOf(along).y()), 0.12);
}

TEST(PourScene, NoBallFindsAGapInTheFunnel)
{
  // Points just outside all inner faces of the shaft and the boards are inside a board: a ball at rest there would overlap.
  const Scene scene = crowd("pour");
  const Body& funnel = scene.bodies.at(2);
  for (double z = 0.01; z < 1.4; z += 0.01)
    for (double along = -1.0; along <= 1.0; along += 0.05)
    {
      const double half = z < 0.4 ? 0.12 + (0.5 - 0.12) * z / 0.4 : 0.5;
      for (const Vector3d& p : {Vector3d(half, along * half, z), Vector3d(-half, along * half, z),
                                Vector3d(along * half, half, z), Vector3d(along * half, -half, z)})
      {
        double nearest = 1.0;
        for (const Shape& shape : funnel.shapes) nearest = std::min(nearest, std::abs(proximity(shape, p).distance));
        double deepest = 1.0;
        for (const Shape& shape : funnel.shapes) deepest = std::min(deepest, proximity(shape, p).distance);
        EXPECT_TRUE(nearest < 1e-5 || deepest < 0.0) << p.transpose();
      }
    }
}

// --- rooms ---

const char kRoomScene[] = R"(
bodies:
  - {name: hall, kind: static, position: [1, 2, 3], rpy: [0, 0, 0.3], room: {size: [2, 1, 0.5], material: wall}}
balls:
  - random: {count: 50, in: hall, seed: 2, speed: 1}
surfaces: [{pair: [ball, any], restitution: 1.0}]
)";

std::string roomError(const std::string& from, const std::string& to)
{
  const TempFolder folder;
  return loadErrorOf([&] { loadScene(folder.write("room.yaml", edited(kRoomScene, from, to))); });
}

TEST(Rooms, KeepTheirBallsInside)
{
  const TempFolder folder;
  const Scene scene = loadScene(folder.write("room.yaml", kRoomScene));
  ASSERT_TRUE(roomSize(scene.bodies.at(0)));
  EXPECT_EQ(*roomSize(scene.bodies[0]), Vector3d(2, 1, 0.5));
  World world(scene);
  double closest = 1.0;
  for (int i = 0; i < 200; ++i)
  {
    EXPECT_TRUE(world.advance(0.05).ok());
    for (std::size_t k = 0; k < world.ballCount(); ++k)
    {
      const Pose pose = world.bodyPose(0);
      const Vector3d p = pose.q.conjugate() * (positionOf(world, k) - pose.p);
      closest = std::min({closest, 1.0 - std::abs(p.x()), 0.5 - std::abs(p.y()), p.z(), 0.5 - p.z()});
    }
  }
  measured("least distance of a centre from a wall - radius [m]", closest - kBallRadius);
  EXPECT_NEAR(closest, kBallRadius, 1e-3);  // they do reach the walls
  EXPECT_GE(closest, kBallRadius - 1e-12);
}

TEST(Rooms, SayWhatIsWrong)
{
  const std::pair<std::pair<std::string, std::string>, std::string> cases[] = {
      {{"size: [2, 1, 0.5]", "size: [2, 1, 0]"}, "bodies[0].room.size[2]: 0: expected a finite number > 0"},
      {{"size: [2, 1, 0.5], ", ""}, "bodies[0].room.size: missing: expected the inner size"},
      {{"material: wall", "grow: up"}, "bodies[0].room.grow: up: expected all (length, width and height) or floor"},
      {{"kind: static", "kind: kinematic"}, "bodies[0].room: a map: expected no room unless the kind is static"},
      {{"room: {", "urdf: a.urdf, room: {"}, "bodies[0].urdf: beside room: expected either a urdf or a room"},
      {{"in: hall", "in: hell"}, "balls[0].random.in: hell: expected the name of a body that is a room"},
      {{"in: hall", "in: hall, min: [0, 0, 0]"}, "balls[0].random.min: beside in: expected either in, or min and max"},
      {{"speed: 1", "speed: {maxwell: -1}"}, "balls[0].random.speed.maxwell: -1: expected a finite number >= 0"},
      {{"size: [2, 1, 0.5]", "size: [2, 1, 0.03]"},
       "balls[0].random.count: 50: expected a room with room for one ball"},
  };
  for (const auto& [edit, expected] : cases)
  {
    const std::string message = roomError(edit.first, edit.second);
    EXPECT_NE(message.find(": " + expected), std::string::npos) << message;
  }
}

TEST(RandomSpeeds, FollowMaxwell)
{
  const TempFolder folder;
  const std::string text = edited(edited(kRoomScene, "speed: 1", "speed: {maxwell: 2}"), "count: 50", "count: 1000");
  const Scene scene = loadScene(folder.write("room.yaml", edited(text, "size: [2, 1, 0.5]", "size: [2, 2, 2]")));
  double sum = 0.0, squares = 0.0, fourth = 0.0;
  for (const SceneBall& ball : scene.balls)
    for (int axis = 0; axis < 3; ++axis)
    {
      const double v = ball.state.v_WB[axis];
      sum += v;
      squares += v * v;
      fourth += v * v * v * v;
    }
  const double n = 3000.0;
  EXPECT_NEAR(sum / n, 0.0, 4.0 * 2.0 / std::sqrt(n));                    // 4 standard errors
  EXPECT_NEAR(squares / n, 4.0, 4.0 * 4.0 * std::sqrt(2.0 / n));          // of the variance
  EXPECT_NEAR(fourth / n, 3.0 * 16.0, 4.0 * 16.0 * std::sqrt(96.0 / n));  // of the fourth moment
}

// --- cost of starting ---

TEST(StartingACrowd, OfAHundredThousandBallsTakesSeconds)
{
  Scene scene;
  const double load = secondsOf([&] { scene = crowd("gas", kMaxBalls); });
  std::size_t balls = 0;
  const double start = secondsOf([&] { balls = World(scene).ballCount(); });
  EXPECT_EQ(balls, kMaxBalls);
  measured("loading 100 000 balls [s]", load);
  measured("starting them [s]", start);
  // A search of every ball against every other one takes 50 s; a busy machine may need ten times the usual 0.5 s.
  EXPECT_LT(load + start, 6.0);
}

TEST(StartingACrowd, SpawningBallByBallTakesNoMemoryEachTime)
{
  World world = SceneBuilder().gravity(kG).floor().world();
  const auto spawn = [&](int from, int to)
  {
    for (int i = from; i < to; ++i)
    {
      BallState state;
      state.p_WB = {0.05 * (i % 50), 0.05 * (i / 50), 1.0};
      EXPECT_FALSE(world.spawnBall({}, state));
    }
  };
  spawn(0, 1000);
  const double early = secondsOf([&] { spawn(1000, 1500); });
  spawn(1500, 3000);
  const double late = secondsOf([&] { spawn(3000, 3500); });
  measured("spawning one of 1000 balls [us]", 1e6 * early / 500);
  measured("spawning one of 3000 balls [us]", 1e6 * late / 500);
  EXPECT_LT(late / 500, 1e-3);  // some 20 us for a look at all others
  EXPECT_TRUE(world.advance(0.01).ok());
  EXPECT_EQ(world.ballCount(), 3500u);
}

// --- room at the start ---

TEST(OverlappingStarts, ArePushedApartInACrowdToo)
{
  // Eighty balls, every second one 10 mm in its neighbour, and one in the floor.
  SceneBuilder builder;
  builder.floor();
  for (int i = 0; i < 40; ++i) builder.ball({0.2 * i, 0, 0.02}).ball({0.2 * i + 0.03, 0, 0.02});
  builder.ball({0.5, 0.5, 0.01});
  World world = builder.world();
  double overlap = 0.0;
  for (std::size_t i = 0; i < world.ballCount(); ++i)
  {
    overlap = std::max(overlap, kR - positionOf(world, i).z());
    for (std::size_t k = 0; k < i; ++k)
      overlap = std::max(overlap, 2.0 * kR - (positionOf(world, i) - positionOf(world, k)).norm());
  }
  EXPECT_LE(overlap, 1e-9);
  EXPECT_NEAR(positionOf(world, 0).x(), -0.01, 1e-9);  // the first of a pair makes room
  EXPECT_NEAR(positionOf(world, 1).x(), 0.03, 1e-9);
  EXPECT_TRUE(world.advance(0.01).ok());
}
}  // namespace
}  // namespace ping_pong
