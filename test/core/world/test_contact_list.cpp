// The list of contacts of a tick: each one that is counted, in order of time, however long the tick.
#include <gtest/gtest.h>

#include <algorithm>

#include "testing/solver_run.h"

namespace ping_pong
{
namespace
{
void expectWholeList(const World& world, const StepStatus& status)
{
  const std::vector<Contact>& list = world.contacts();
  EXPECT_EQ(list.size(), status.contacts);
  const auto earlier = [](const Contact& a, const Contact& b) { return a.time < b.time; };
  EXPECT_TRUE(std::is_sorted(list.begin(), list.end(), earlier));
}

// An elastic ball: bounces of 0.3 m, of which each takes as long as the one before.
TEST(ContactList, HasEachBounceOfALongTick)
{
  constexpr double kHeight = 0.3, kLong = 400.0;
  const double fall = std::sqrt(2.0 * kHeight / kG);
  for (const Method method : {Method::Exact, Method::Impulse})
  {
    World world = SceneBuilder(method).gravity(kG).floor().ball({0, 0, kR + kHeight}).world();
    const StepStatus status = world.advance(kLong);
    expectWholeList(world, status);
    EXPECT_EQ(status.contacts, static_cast<std::size_t>((kLong / fall + 1.0) / 2.0)) << name(method);
    std::size_t bounce = 0;
    for (const Contact& contact : world.contacts())
      EXPECT_NEAR(contact.time, (2.0 * static_cast<double>(bounce++) + 1.0) * fall, 1e-7) << name(method);
  }
}

// A box full of balls: as many contacts in a tick as there is no room kept for at the start.
TEST(ContactList, HasEachContactOfACrowd)
{
  SceneBuilder builder(Method::Impulse);
  builder.gravity(kG).floor();
  for (const double side : {-0.21, 0.21})
  {
    builder.box(side < 0 ? "left" : "right", {0.02, 0.5, 2}, at({side, 0, 0.5}));
    builder.box(side < 0 ? "front" : "back", {0.5, 0.02, 2}, at({0, side, 0.5}));
  }
  for (int i = 0; i < 50; ++i)
    builder.ball({0.09 * (i % 5) - 0.18, 0.09 * (i / 5 % 5) - 0.18, 0.1 + 0.06 * (i / 25) + 0.001 * i},
                 {std::sin(i), std::cos(2.0 * i), 0.3 * std::sin(3.0 * i)});
  for (const Method method : {Method::Exact, Method::Impulse})
  {
    Scene scene = builder.build();
    scene.method = method;
    World world(scene);
    const StepStatus status = world.advance(2.0);
    EXPECT_GT(status.contacts, 256u + 8u * 50u);
    expectWholeList(world, status);
    world.keepContacts(false);
    EXPECT_GT(world.advance(0.5).contacts, 0u);
    EXPECT_TRUE(world.contacts().empty());
  }
}

// The solver counts its impacts and iterations in 32 bits. After a day or so it counts anew, and nobody notices.
TEST(ContactList, MissesNoneWhenTheCountOfSweepsBeginsAnew)
{
  SceneBuilder builder(Method::Impulse, kStep);
  builder.gravity(kG).restitution(0.9).floor();
  for (int i = 0; i < 40; ++i) builder.ball({0.03 * (i % 5) + 0.001 * i, 0.045 * (i / 5), 0.1 + 0.05 * (i % 3)});
  SolverRun early(builder.build(), 1), late(builder.build(), 1);
  late.world.solver.counter = (1u << 31) - 50u;  // from where it begins anew,
  for (int i = 0; i < 1000; ++i)
  {
    early.step();
    late.step();
    if (i == 300) late.world.solver.counter = ~0u - 100u;  // and from where it would wrap
  }
  EXPECT_LT(late.world.solver.counter, 1u << 31);
  EXPECT_EQ(late.world.contacts.size(), early.world.contacts.size());
  for (std::size_t i = 0; i < early.world.balls.size(); ++i)
  {
    EXPECT_EQ(late.state(i).p_WB, early.state(i).p_WB) << "ball " << i;
    EXPECT_EQ(late.state(i).v_WB, early.state(i).v_WB) << "ball " << i;
  }
}
}  // namespace
}  // namespace ping_pong
