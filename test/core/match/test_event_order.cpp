// Contacts and states of balls that come over two connections are judged in the order of time.
#include <gtest/gtest.h>

#include <string>

#include "ros/match/event_order.h"

namespace
{
using namespace ping_pong_sim;

class EventOrderTest : public testing::Test
{
protected:
  void contactAt(double time, double now)
  {
    ping_pong::Contact contact;
    contact.time = time;
    order_.add(contact, now);
  }
  void tickAt(double time, double now)
  {
    TickEnd tick;
    tick.time = time;
    order_.add(tick, now);
  }
  // "c" for each contact, "t" for each tick that is handed on.
  std::string release(double now)
  {
    std::string said;
    order_.release(
        now, [&](const ping_pong::Contact&) { said += 'c'; }, [&](const TickEnd&) { said += 't'; });
    return said;
  }

  EventOrder order_{0.05};
};

TEST_F(EventOrderTest, AContactThatComesAfterItsTickIsStillBeforeIt)
{
  tickAt(0.01, 0.0);
  tickAt(0.02, 0.0);
  EXPECT_EQ(release(0.0), "");
  contactAt(0.015, 0.001);
  EXPECT_EQ(release(0.001), "tc");  // the tick at 0.02 may have another contact
  EXPECT_EQ(release(0.1), "t");
}

TEST_F(EventOrderTest, AContactAtTheEndOfATickBelongsToIt)
{
  tickAt(0.01, 0.0);
  contactAt(0.01, 0.0);
  EXPECT_EQ(release(0.0), "c");
}

TEST_F(EventOrderTest, NobodyWaitsForEver)
{
  contactAt(0.015, 0.0);
  EXPECT_EQ(release(0.04), "");
  EXPECT_EQ(release(0.05), "c");
}
}  // namespace
