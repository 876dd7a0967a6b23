#include "node_params.h"

#include <ros/console.h>
#include <ros/names.h>

#include <cmath>

#include "ping_pong_sim/scene_loader.h"
#include "ping_pong_sim/shots.h"
#include "ros/base/param_reader.h"
#include "ros/base/scene_path.h"

namespace ping_pong_sim
{
namespace
{
bool isRate(double rate)
{
  return rate > 0.0 && rate <= 10000.0;
}
bool isFactor(double factor)
{
  return factor >= 0.0 && std::isfinite(factor);
}
bool isTimeout(double seconds)
{
  return seconds > 0.0;
}
bool isStep(double seconds)
{
  return seconds >= 0.0 && seconds <= 1.0;
}

bool isTolerance(double metres)
{
  return metres == 0.0 || (metres >= ping_pong::kMinTolerance && metres <= ping_pong::kMaxTolerance);
}
bool isPeriod(double seconds)
{
  return seconds >= 0.0 && std::isfinite(seconds);
}
bool isCount(double number)
{
  return number >= 1.0 && number <= 1e6 && number == std::floor(number);
}

bool isBallCount(double number)
{
  return number >= 0.0 && number <= static_cast<double>(ping_pong::kMaxBalls) && number == std::floor(number);
}
bool isThreads(double number)
{
  return number >= 0.0 && number <= static_cast<double>(ping_pong::kMaxThreads) && number == std::floor(number);
}
bool isContactRate(double rate)
{
  return rate >= 1.0 && rate <= 1e6;
}
bool isSeed(double number)
{
  return number >= -1.0 && number <= 0x1p53 && number == std::floor(number);
}

ping_pong::LoadOptions readLoad(ParamReader& reader)
{
  ping_pong::LoadOptions load;
  load.balls = static_cast<std::size_t>(
      reader.number("balls", 0.0, isBallCount, "a whole number from 1 to 100000, or 0 (the scene's own)"));
  const double seed = reader.number("seed", -1.0, isSeed, "a whole number >= 0, or -1 (the scene's own)");
  load.has_seed = seed >= 0.0;
  if (load.has_seed) load.seed = static_cast<std::uint64_t>(seed);
  return load;
}

FeedParams readFeed(const ros::NodeHandle& nh, ParamReader& reader, double tick)
{
  FeedParams feed;
  feed.period = reader.number("feed_period", feed.period, isPeriod, "a time above 0 [s], or 0 (no feed)");
  feed.shot = reader.text("feed_shot", feed.shot);
  feed.keep = static_cast<std::size_t>(
      reader.number("feed_keep", static_cast<double>(feed.keep), isCount, "a whole number from 1 to 1000000"));
  if (feed.period > 0.0 && feed.period < tick)
  {
    throw ParamError("parameter " + nh.resolveName("feed_period") + ": " + std::to_string(feed.period) +
                     ": expected at least one tick, 1 / publish_rate = " + std::to_string(tick) +
                     " [s], or 0 (no feed)");
  }
  if (feed.shot != kRandomShot && ping_pong::findShot(feed.shot) == nullptr)
  {
    throw ParamError("parameter " + nh.resolveName("feed_shot") + ": " + feed.shot + ": expected one of " +
                     ping_pong::shotNames() + ", or " + kRandomShot);
  }
  return feed;
}

void checkMethod(const ros::NodeHandle& nh, const std::string& method)
{
  if (method == kMethodOfScene) return;
  try
  {
    ping_pong::methodFromName(method);
  }
  catch (const std::invalid_argument& error)
  {
    throw ParamError("parameter " + nh.resolveName("method") + ": " + method + ": " + error.what() + ", or " +
                     kMethodOfScene);
  }
}

Props readProps(ParamReader& reader)
{
  const ParamReader::Rows rows =
      reader.rows("props", {}, 6, "NAME: [x, y, z, roll, pitch, yaw], pose of a frame in the world [m], [rad]");
  if (rows.empty()) return defaultProps();
  Props props;
  for (const auto& row : rows)
  {
    const std::vector<double>& n = row.second;
    props[row.first] = propPose({n[0], n[1], n[2]}, {n[3], n[4], n[5]});
  }
  return props;
}

// Body names become frames and, for paddles, topics.
void checkNames(const ping_pong::Scene& scene)
{
  for (const ping_pong::Body& body : scene.bodies)
  {
    std::string why;
    if (ros::names::validate(body.name, why)) continue;
    throw std::runtime_error(scene.path + ": body name: " + body.name + ": expected a ROS name: " + why);
  }
}
}  // namespace

NodeParams readParams(const ros::NodeHandle& private_nh)
{
  ParamReader reader(private_nh);
  const std::string rate = "a rate above 0, up to 10000 [1/s]";
  NodeParams p;
  p.scene = reader.text("scene", p.scene);
  p.scene_directory = reader.text("scene_directory", p.scene_directory);
  p.real_time_factor = reader.number("real_time_factor", p.real_time_factor, isFactor, "a number >= 0 (0: flat out)");
  p.publish_rate = reader.number("publish_rate", p.publish_rate, isRate, rate);
  p.clock_rate = reader.number("clock_rate", p.clock_rate, isRate, rate);
  p.marker_rate = reader.number("marker_rate", p.marker_rate, isRate, rate);
  p.command_timeout =
      reader.number("command_timeout", p.command_timeout, isTimeout, "a time above 0 [s] (.inf: never)");
  p.paused = reader.flag("paused", p.paused);
  p.wait_for_view = reader.number("wait_for_view", p.wait_for_view, isPeriod, "a time >= 0 [s] (0: do not wait)");
  p.repeat = reader.number("repeat", p.repeat, isPeriod, "a time >= 0 [s] (0: never)");
  p.rewind_clock = reader.flag("rewind_clock", p.rewind_clock);
  p.compact_above = static_cast<std::size_t>(reader.number("compact_above", static_cast<double>(p.compact_above),
                                                           isBallCount, "a whole number from 0 to 100000"));
  p.contact_rate = reader.number("contact_rate", p.contact_rate, isContactRate, "a rate from 1 to 1000000 [1/s]");
  p.load = readLoad(reader);
  p.method = reader.text("method", p.method);
  p.dt = reader.number("dt", p.dt, isStep, "a step from 0 (the scene's own) to 1 [s]");
  p.tolerance =
      reader.number("tolerance", p.tolerance, isTolerance, "0 (the scene's own), or an error from 1e-12 to 0.1 [m]");
  p.threads = static_cast<std::size_t>(
      reader.number("threads", 0.0, isThreads, "a whole number from 1 to 64, or 0 (the scene's own)"));
  p.feed = readFeed(private_nh, reader, p.tick());
  p.props = readProps(reader);
  p.blob_shadows = reader.text("blob_shadows", p.blob_shadows);
  if (!p.blob_shadows.empty() && p.props.count(p.blob_shadows) == 0)
  {
    throw ParamError("parameter " + private_nh.resolveName("blob_shadows") + ": " + p.blob_shadows +
                     ": expected the name of a light of ~props, or nothing");
  }
  checkMethod(private_nh, p.method);
  if (p.scene.empty())
  {
    throw ParamError("parameter " + private_nh.resolveName("scene") + ": empty: expected a scene file or name");
  }
  for (const std::string& name : reader.unread()) ROS_WARN_STREAM("parameter " << name << " is not known; ignored");
  return p;
}

ping_pong::Scene loadSceneFor(const NodeParams& params, const std::string& scene_name,
                              const ping_pong::LoadOptions& options)
{
  ping_pong::Scene scene = ping_pong::loadScene(scenePath(params.scene_directory, scene_name), options);
  if (params.method != kMethodOfScene) scene.method = ping_pong::methodFromName(params.method);
  if (params.dt > 0.0) scene.dt = params.dt;
  if (params.tolerance > 0.0) scene.tolerance = params.tolerance;
  if (params.threads > 0) scene.threads = params.threads;
  checkNames(scene);
  return scene;
}
}  // namespace ping_pong_sim
