// A thread that does jobs and serves a callback queue, one after the other.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <atomic>
#include <functional>
#include <thread>
#include <utility>

namespace ping_pong_sim
{
class Worker
{
public:
  Worker() = default;
  ~Worker() { stop(); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Whose callbacks come in the thread.
  ros::NodeHandle nodeHandle()
  {
    ros::NodeHandle nh;
    nh.setCallbackQueue(&queue_);
    return nh;
  }
  /// @param tick  between jobs, at least fifty times a second
  void start(std::function<void()> tick)
  {
    thread_ = std::thread(
        [this, tick = std::move(tick)]
        {
          while (running_ && ros::ok())
          {
            queue_.callAvailable(ros::WallDuration(0.02));
            tick();
          }
        });
  }
  void stop()
  {
    running_ = false;
    if (thread_.joinable()) thread_.join();
  }
  /// From any thread.
  void post(std::function<void()> job) { queue_.addCallback(boost::make_shared<Job>(std::move(job))); }

private:
  class Job : public ros::CallbackInterface
  {
  public:
    explicit Job(std::function<void()> job) : job_(std::move(job)) {}
    CallResult call() override
    {
      job_();
      return Success;
    }

  private:
    std::function<void()> job_;
  };

  ros::CallbackQueue queue_;
  std::atomic<bool> running_{true};
  std::thread thread_;
};
}  // namespace ping_pong_sim
