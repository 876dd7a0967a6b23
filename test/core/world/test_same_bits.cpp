// The same scene gives the same bits on every run; the order of lists does not matter.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "ping_pong_sim/scene_loader.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
Scene tray()
{
  return loadScene(std::string(SCENES_DIR) + "/tray.yaml");
}

// FNV-1a over the bytes of all positions and velocities.
std::uint64_t hashOf(const World& world)
{
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&](const Vector3d& x)
  {
    unsigned char bytes[3 * sizeof(double)];
    std::memcpy(bytes, x.data(), sizeof bytes);
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 1099511628211ULL;
  };
  for (std::size_t i = 0; i < world.ballCount(); ++i)
  {
    add(positionOf(world, i));
    add(velocityOf(world, i));
  }
  return hash;
}

std::uint64_t hashAfter(World& world, double tick, int ticks)
{
  run(world, tick, ticks);
  return hashOf(world);
}

TEST(SameBits, OnEveryRunOfEveryMethod)
{
  for (const Method method : kMethods)
  {
    Scene scene = tray();
    scene.method = method;
    World first(scene);
    World second(scene);
    const std::uint64_t hash = hashAfter(first, 2e-3, 1000);
    EXPECT_EQ(hashAfter(second, 2e-3, 1000), hash) << name(method);
    first.reset();
    EXPECT_EQ(hashAfter(first, 2e-3, 1000), hash) << "after reset, " << name(method);
  }
}

TEST(SameBits, WhateverTheTicksOfAWorldWithoutPaddles)
{
  World fine(tray());
  World coarse(tray());
  EXPECT_EQ(hashAfter(fine, 1e-3, 2000), hashAfter(coarse, 0.5, 4));
}

std::string outputOf(const char* program)
{
  std::string text;
  std::FILE* out = popen(program, "r");
  if (out == nullptr) return text;
  for (int c = std::fgetc(out); c != EOF; c = std::fgetc(out)) text += static_cast<char>(c);
  EXPECT_EQ(pclose(out), 0) << program;
  return text;
}

TEST(SameBits, AtEitherLevelOfOptimisation)
{
  const std::string usual = outputOf(HASHES), little = outputOf(HASHES_O1);
  EXPECT_EQ(std::count(usual.begin(), usual.end(), '\n'), 2 + static_cast<long>(kMethods.size()));
  EXPECT_EQ(little, usual);
}

TEST(SameBits, WhetherContactsAreListedOrCountedOnly)
{
  for (const Method method : kMethods)
  {
    Scene scene = tray();
    scene.method = method;
    World listed(scene), counted(scene);
    counted.keepContacts(false);
    std::size_t contacts = 0, same = 0;
    for (int tick = 0; tick < 50; ++tick)
    {
      const StepStatus status = listed.advance(0.01);
      contacts += status.contacts;
      EXPECT_EQ(status.contacts, listed.contacts().size()) << name(method);
      same += counted.advance(0.01).contacts;
      EXPECT_TRUE(counted.contacts().empty());
    }
    EXPECT_GT(contacts, 50u) << name(method);
    EXPECT_EQ(same, contacts) << name(method);
    EXPECT_EQ(hashOf(counted), hashOf(listed)) << name(method);
  }
}

TEST(SameBits, ABitMoreIsNotTheSame)  // or the hash would notice nothing
{
  Scene scene = tray();
  World first(scene);
  scene.balls[7].state.p_WB.x() = std::nextafter(scene.balls[7].state.p_WB.x(), 1.0);
  World second(scene);
  EXPECT_NE(hashAfter(first, 2e-3, 1000), hashAfter(second, 2e-3, 1000));
}

TEST(SameBits, TheOrderOfTheListsDoesNotMatter)
{
  Scene scene = tray();
  World forward(scene);
  std::reverse(scene.balls.begin(), scene.balls.end());
  std::reverse(scene.bodies.begin(), scene.bodies.end());
  World backward(scene);
  const std::size_t hits = run(forward, 0.01, 30).size();
  EXPECT_EQ(run(backward, 0.01, 30).size(), hits);
  double worst = 0.0;
  const std::size_t count = forward.ballCount();
  for (std::size_t i = 0; i < count; ++i)
    worst = std::max(worst, (positionOf(forward, i) - positionOf(backward, count - 1 - i)).norm());
  measured("hits in 0.3 s", static_cast<double>(hits));
  measured("reversed lists, largest difference [m]", worst);
  EXPECT_GT(hits, 50u);
  EXPECT_LE(worst, 1e-12);  // a rounding of 1e-16 grows some tenfold with every hit of a ball with a ball
}
}  // namespace
}  // namespace ping_pong
