// From a command to its effect in TF, at 500 Hz with the simulator in real time.
#include <tf2_msgs/TFMessage.h>

#include <algorithm>

#include "ping_pong_sim/PaddleCommand.h"
#include "sim_client.h"

using namespace ping_pong_sim;

TEST(Latency, FromCommandToTfIsBelowFiveMilliseconds)
{
  ros::NodeHandle nh;
  ros::Publisher commands = nh.advertise<PaddleCommand>("paddle/command", 1);
  std::mutex mutex;
  std::condition_variable moved;
  double y = 0.0;       // of the paddle [m]
  double stride = 0.0;  // from tick to tick [m]
  const boost::function<void(const tf2_msgs::TFMessage::ConstPtr&)> onTf = [&](const auto& message)
  {
    for (const auto& transform : message->transforms)
    {
      if (transform.child_frame_id != "paddle") continue;
      std::lock_guard<std::mutex> lock(mutex);
      stride = transform.transform.translation.y - y;
      y = transform.transform.translation.y;
      moved.notify_all();
    }
  };
  const ros::Subscriber tf =
      nh.subscribe<tf2_msgs::TFMessage>("/tf", 100, onTf, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  ASSERT_TRUE(sim_test::eventually([&] { return commands.getNumSubscribers() > 0 && tf.getNumPublishers() > 0; }));

  std::vector<double> latencies;
  for (int i = 0; i < 200; ++i)
  {
    // Back and forth; the first transform whose stride (1 mm per tick) differs has felt the command.
    const double direction = i % 2 == 0 ? 1.0 : -1.0;
    PaddleCommand command;
    command.mode = PaddleCommand::VELOCITY;
    command.twist.linear.y = 0.5 * direction;
    std::unique_lock<std::mutex> lock(mutex);
    const double steady = stride;
    const double start = sim_test::wallNow();
    commands.publish(command);
    ASSERT_TRUE(moved.wait_for(lock, std::chrono::seconds(2), [&] { return std::abs(stride - steady) > 1e-4; }));
    latencies.push_back(sim_test::wallNow() - start);
    lock.unlock();
    std::this_thread::sleep_for(std::chrono::microseconds(15000 + 137 * (i % 16)));  // at any phase of a tick
  }
  std::sort(latencies.begin(), latencies.end());
  std::printf("command to TF: median %.2f ms, 95 %% %.2f ms\n", 1e3 * latencies[100], 1e3 * latencies[190]);
  EXPECT_LT(latencies[100], 5e-3);
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_latency");
}
