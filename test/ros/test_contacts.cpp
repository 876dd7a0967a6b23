// Every impact is one message on `contacts`, and says what happened. A ball bounces on a table without loss, running.
#include "ping_pong_sim/Contact.h"
#include "sim_client.h"

using namespace ping_pong_sim;

TEST(Contacts, AreToldOnceEachAndInOrder)
{
  ros::NodeHandle nh;
  sim_test::Inbox<Contact> contacts(nh, "contacts");
  sim_test::Inbox<SimStatus> status(nh, "status");
  ASSERT_TRUE(sim_test::eventually([&] { return contacts.connected() && status.connected(); }));
  sim_test::pause(false);
  ASSERT_TRUE(contacts.waitForCount(5));
  sim_test::pause(true);
  ASSERT_TRUE(status.waitFor([](const SimStatus& s) { return s.paused && s.contacts >= 5; }));
  const std::size_t counted = status.last().contacts;
  ASSERT_TRUE(contacts.waitForCount(counted));

  const double g = 9.81;
  const double fall = std::sqrt(2.0 * 0.5 / g);  // 0.5 m
  const std::vector<Contact> all = contacts.all();
  ASSERT_EQ(all.size(), counted);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    EXPECT_NEAR(all[i].time, fall * (1.0 + 2.0 * static_cast<double>(i)), 1e-9);
    EXPECT_EQ(all[i].ball, 0u);
    EXPECT_EQ(all[i].other, "table");
    EXPECT_FALSE(all[i].with_ball);
    EXPECT_EQ(all[i].shape, 0);
    EXPECT_NEAR(all[i].normal.z, 1.0, 1e-12);
    EXPECT_NEAR(all[i].point.z, 0.76, 1e-9);
    EXPECT_NEAR(all[i].velocity_before.z, -g * fall, 1e-9);
    EXPECT_NEAR(all[i].velocity_after.z, g * fall, 1e-9);
    EXPECT_NEAR(all[i].impulse.z, 0.0027 * 2.0 * g * fall, 1e-9);
    if (i == 0) continue;
    // Stamps are the instants of impact, not the ends of ticks.
    EXPECT_NEAR((all[i].header.stamp - all[i - 1].header.stamp).toSec(), all[i].time - all[i - 1].time, 3e-9);
  }
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_contacts");
}
