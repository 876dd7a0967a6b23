// What every ROS test of the simulator needs: wait for a condition with a deadline in wall time, call a service, read
// TF.
#pragma once

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "ping_pong_sim/SimStatus.h"
#include "ping_pong_sim/Step.h"
#include "std_srvs/SetBool.h"
#include "std_srvs/Trigger.h"

namespace sim_test
{
constexpr double kPatience = 10.0;  ///< deadline for what should happen at once [s]

inline double wallNow()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// More wants to run than there are processors: how long something takes says nothing then.
inline bool machineIsBusy()
{
  double load = 0.0;
  return getloadavg(&load, 1) == 1 && load > 2.0 * std::max(1u, std::thread::hardware_concurrency());
}

/// Polls, for what cannot be waited for.
inline bool eventually(const std::function<bool()>& condition, double deadline = kPatience)
{
  const double end = wallNow() + deadline;
  while (wallNow() < end)
  {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return condition();
}

/// Keeps all messages of a topic. Needs a running spinner (see runTests).
template <class Message>
class Inbox
{
public:
  Inbox(ros::NodeHandle nh, const std::string& topic)
  {
    const boost::function<void(const boost::shared_ptr<const Message>&)> keep = [this](const auto& message)
    {
      std::lock_guard<std::mutex> lock(mutex_);
      messages_.push_back(*message);
      arrived_.notify_all();
    };
    subscriber_ = nh.subscribe<Message>(topic, 100000, keep, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  }
  ~Inbox() { subscriber_.shutdown(); }

  /// True as soon as a message, old or new, is as wanted.
  bool waitFor(const std::function<bool(const Message&)>& wanted, double deadline = kPatience)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    std::size_t seen = 0;
    return arrived_.wait_for(lock, std::chrono::duration<double>(deadline),
                             [&]
                             {
                               seen = std::min(seen, messages_.size());
                               for (; seen < messages_.size(); ++seen)
                               {
                                 if (wanted(messages_[seen])) return true;
                               }
                               return false;
                             });
  }
  bool waitForCount(std::size_t count, double deadline = kPatience)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    return arrived_.wait_for(lock, std::chrono::duration<double>(deadline), [&] { return messages_.size() >= count; });
  }
  std::vector<Message> all() const
  {
    std::lock_guard<std::mutex> lock(mutex_);
    return messages_;
  }
  Message last() const
  {
    std::lock_guard<std::mutex> lock(mutex_);
    return messages_.empty() ? Message() : messages_.back();
  }
  void clear()
  {
    std::lock_guard<std::mutex> lock(mutex_);
    messages_.clear();
  }
  bool connected() const { return subscriber_.getNumPublishers() > 0; }

private:
  mutable std::mutex mutex_;
  std::condition_variable arrived_;
  std::vector<Message> messages_;
  ros::Subscriber subscriber_;
};

/// Calls a service by its full name. Persistent: otherwise the server hangs up once it has answered, and a client that
/// learns of that first loses the answer (ros_comm issue 1976).
template <class Service>
bool ask(const std::string& service, Service& exchange)
{
  return ros::NodeHandle().serviceClient<Service>(service, true).call(exchange);
}

/// Calls a private service of the simulator.
template <class Service>
typename Service::Response call(const std::string& name, const typename Service::Request& request)
{
  const std::string service = "/ping_pong_sim/" + name;
  Service exchange;
  exchange.request = request;
  EXPECT_TRUE(eventually([&] { return ros::service::exists(service, false); })) << service;
  EXPECT_TRUE(ask(service, exchange)) << service;
  return exchange.response;
}

inline void pause(bool paused)
{
  std_srvs::SetBool::Request request;
  request.data = paused;
  EXPECT_TRUE(call<std_srvs::SetBool>("pause", request).success);
}

inline void reset()
{
  EXPECT_TRUE(call<std_srvs::Trigger>("reset", {}).success);
}

inline ping_pong_sim::Step::Response step(double duration)
{
  ping_pong_sim::Step::Request request;
  request.duration = duration;
  return call<ping_pong_sim::Step>("step", request);
}

/// TF as any node sees it.
class Frames
{
public:
  Frames() : listener_(buffer_) {}

  /// The newest transform once its stamp is at least `stamp`; empty child_frame_id if that does not come.
  geometry_msgs::TransformStamped at(const std::string& frame, const ros::Time& stamp = ros::Time())
  {
    geometry_msgs::TransformStamped found;
    eventually(
        [&]
        {
          if (!buffer_.canTransform("world", frame, ros::Time(0))) return false;
          const auto newest = buffer_.lookupTransform("world", frame, ros::Time(0));
          if (newest.header.stamp < stamp) return false;
          found = newest;
          return true;
        });
    return found;
  }
  bool knows(const std::string& frame) { return buffer_.canTransform("world", frame, ros::Time(0)); }

private:
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
};

/// main() of all ROS tests.
inline int runTests(int argc, char** argv, const std::string& name)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, name);
  ros::NodeHandle keep_alive;
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
}  // namespace sim_test
