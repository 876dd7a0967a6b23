#include "marker_publisher.h"

#include "ball_markers.h"
#include "blob_shadows.h"
#include "body_markers.h"

namespace ping_pong_sim
{
namespace
{
constexpr double kSpheresPerSecond = 300000.0;  // of wall time
constexpr double kBodiesRate = 0.5;             // of `body_markers`, per wall second [1/s]

std::vector<ping_pong::BallId> ballIds(const ping_pong::World& world)
{
  std::vector<ping_pong::BallId> ids(world.ballCount());
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = world.ballId(i);
  return ids;
}
}  // namespace

MarkerPublisher::MarkerPublisher(ros::NodeHandle& nh, double rate, const std::string& blobs,
                                 const Simulation& simulation, JobQueue& jobs)
    : nh_(nh),
      simulation_(simulation),
      gate_(rate),
      bodies_gate_(kBodiesRate),
      blobs_(blobs),
      bodies_(nh.advertise<visualization_msgs::MarkerArray>("body_markers", 10, true)),
      markers_(nh, "markers", 10, jobs,
               [this](visualization_msgs::MarkerArray& message, bool newcomer)
               {
                 fill(message, newcomer);
                 return true;
               })
{
  publishBodies();
}

void MarkerPublisher::observeTick()
{
  trails_.observe(simulation_);
  flashes_.observe(simulation_);
}

void MarkerPublisher::update(WallClock::time_point now)
{
  // RViz keeps up with so many spheres; a larger crowd is shown less often.
  const double busy = static_cast<double>(simulation_.world().ballCount()) / kSpheresPerSecond;
  if (gate_.open(now, busy)) publish();
  repeatBodies(now);
}

void MarkerPublisher::publish()
{
  const ros::Time stamp = simulation_.clock().now();
  if (stamp == last_stamp_) return;
  last_stamp_ = stamp;
  markers_.publish();
}

void MarkerPublisher::publishBodies()
{
  const ping_pong::World& world = simulation_.world();
  body_pictures_.markers.clear();
  for (std::size_t i = 0; i < world.bodyCount(); ++i) appendBody(world.body(i), body_pictures_.markers);
  visualization_msgs::MarkerArray message = body_pictures_;
  message.markers.insert(message.markers.begin(), deleteAllMarkers());
  bodies_.publish(message);
  setDescriptions();
}

void MarkerPublisher::repeatBodies(WallClock::time_point now)
{
  if (bodies_gate_.open(now)) bodies_.publish(body_pictures_);
}

void MarkerPublisher::forgetPast()
{
  trails_.clear();
  flashes_.clear();
  shown_.clear();  // colours and sizes may be others now, even if the ids are not
}

void MarkerPublisher::fill(visualization_msgs::MarkerArray& message, bool newcomer)
{
  message.markers.clear();
  const ping_pong::World& world = simulation_.world();
  const std::vector<ping_pong::BallId> ids = ballIds(world);
  if (newcomer || shown_.empty() || ids != shown_)
  {
    message.markers.push_back(deleteAllMarkers());
    if (!simulation_.isDrawnAsList()) appendSingleBalls(world, message.markers);
  }
  if (!newcomer) shown_ = ids;
  if (simulation_.isDrawnAsList()) appendCrowd(world, simulation_.clock().now(), message.markers);
  const auto light = simulation_.props().find(blobs_);
  if (light != simulation_.props().end()) message.markers.push_back(blobShadows(simulation_, light->second.p));
  message.markers.push_back(trails_.marker(simulation_));
  message.markers.push_back(flashes_.marker(simulation_));
}

// For RViz's RobotModel displays.
void MarkerPublisher::setDescriptions()
{
  for (const std::string& name : descriptions_) nh_.deleteParam(name);
  descriptions_.clear();
  const ping_pong::World& world = simulation_.world();
  for (std::size_t i = 0; i < world.bodyCount(); ++i)
  {
    if (world.body(i).urdf_path.empty()) continue;
    descriptions_.push_back(world.body(i).name + "_description");
    nh_.setParam(descriptions_.back(), readText(world.body(i).urdf_path));
  }
}
}  // namespace ping_pong_sim
