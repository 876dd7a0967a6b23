// Several threads share a crowd: the same bits, the same contacts in the same order and the same counts as with one.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

#include "ping_pong_sim/state_hash.h"
#include "testing/crowd_scenes.h"

namespace ping_pong
{
namespace
{
struct Course
{
  std::vector<std::uint64_t> states;  // after each tick
  std::vector<std::string> contacts;  // of each tick
  std::vector<std::size_t> counts;    // contacts, events, balls in the solver
  bool operator==(const Course& other) const
  {
    return states == other.states && contacts == other.contacts && counts == other.counts;
  }
};

std::string bitsOf(const std::vector<Contact>& contacts)
{
  std::ostringstream text;
  text << std::hexfloat;
  for (const Contact& c : contacts)
    text << c.time << ' ' << c.ball << ' ' << c.other_ball << ' ' << c.body << ' ' << c.shape << ' '
         << c.p_WC.transpose() << ' ' << c.v_before.transpose() << ' ' << c.v_after.transpose() << ' '
         << c.w_after.transpose() << '\n';
  return text.str();
}

PaddleCommand swing(int tick)
{
  return velocityCommand({tick % 10 < 5 ? 1.0 : -1.0, 0.2, 0}, {0, 1.0, 0});
}

Course courseOf(Scene scene, std::size_t threads, double tick, int ticks)
{
  scene.threads = threads;
  World world(scene);
  const std::size_t paddle = world.findBody("paddle");
  Course course;
  for (int i = 0; i < ticks; ++i)
  {
    if (paddle != kNone) world.command(paddle, swing(i));
    const StepStatus status = world.advance(tick);
    course.states.push_back(stateHash(world));
    course.contacts.push_back(bitsOf(world.contacts()));
    for (const std::size_t number : {status.contacts, status.events, status.piled}) course.counts.push_back(number);
  }
  return course;
}

std::size_t sumOf(const Course& course, std::size_t which)
{
  std::size_t sum = 0;
  for (std::size_t i = which; i < course.counts.size(); i += 3) sum += course.counts[i];
  return sum;
}

// The course with one thread.
Course sameForAnyNumber(const Scene& scene, double tick, int ticks)
{
  const Course alone = courseOf(scene, 1, tick, ticks);
  for (const std::size_t threads : {2, 3, 8})
  {
    const Course shared = courseOf(scene, threads, tick, ticks);
    EXPECT_EQ(shared.states, alone.states) << threads << " threads";
    EXPECT_EQ(shared.counts, alone.counts) << threads << " threads";
    EXPECT_TRUE(shared.contacts == alone.contacts) << threads << " threads";
  }
  return alone;
}

TEST(Threads, AGas)
{
  const Course course = sameForAnyNumber(gasOf(700), 0.01, 20);
  measured("gas of 700: contacts", static_cast<double>(sumOf(course, 0)));
  EXPECT_GT(sumOf(course, 0), 1000u);
}

TEST(Threads, AGasInWindowsThatAreCutShort)  // a tick much longer than windows of this gas
{
  const Course course = sameForAnyNumber(gasOf(700), 0.2, 1);
  EXPECT_GT(sumOf(course, 0), 1000u);
}

TEST(Threads, BallsInAirWithAMovingPaddle)
{
  const Course course = sameForAnyNumber(airOf(600), 0.01, 15);
  EXPECT_GT(sumOf(course, 0), 100u);
}

TEST(Threads, APourThatIsHandedToTheSolver)
{
  const Course course = sameForAnyNumber(pourOf(300), 0.02, 28);
  measured("pour of 300: piled at the end", static_cast<double>(course.counts.back()));
  EXPECT_GT(course.counts.back(), 100u);
  EXPECT_EQ(course.counts[2], 0u);
}

TEST(Threads, TheSolverFromTheStart)
{
  const Course course = sameForAnyNumber(pourOf(800, Method::Impulse), 0.02, 28);
  EXPECT_EQ(course.counts.back(), 800u);
}

TEST(Threads, ComeAndGoWithTheWorld)
{
  const auto threadsNow = []
  {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
      if (line.compare(0, 8, "Threads:") == 0) return std::stoi(line.substr(8));
    return 0;
  };
  // Once they are as many as this, or not in time: the system counts a thread that has been joined for a moment more.
  const auto threadsSoon = [&](int count)
  {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (threadsNow() != count && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    return threadsNow();
  };
  const int before = 1;
  EXPECT_EQ(threadsSoon(before), before);  // those of other tests are gone
  Scene scene = gasOf(10);
  scene.threads = 3;
  {
    World world(scene);
    EXPECT_EQ(threadsNow(), before + 2);
    world.reset();
    EXPECT_EQ(threadsNow(), before + 2);
  }
  scene.balls.resize(1);
  World alone(scene);
  EXPECT_EQ(threadsSoon(before), before);  // there is nothing to share
}
}  // namespace
}  // namespace ping_pong
