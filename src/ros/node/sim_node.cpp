#include "sim_node.h"

#include <ros/console.h>
#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <cmath>

#include "ping_pong_sim/choose_method.h"
#include "services.h"

namespace ping_pong_sim
{
namespace
{
constexpr double kLongestStep = 3600.0;  ///< [s], of ~step
constexpr double kLongestWait = 10.0;    ///< [s of wall time], of ~step for commands: nobody else is served meanwhile
constexpr double kClockStart = 1.0;      ///< first /clock [s]; not zero, which ROS takes for "no time yet"
constexpr auto kFirstPicture = std::chrono::milliseconds(1500);  ///< from a window's subscription to its first picture
constexpr auto kIdlePeriod = std::chrono::milliseconds(50);      ///< between looks at other duties while nothing moves

// Without /clock the rest of the system runs on wall time, so stamps begin there.
ros::Time firstStamp(bool use_sim_time)
{
  return use_sim_time ? ros::Time(kClockStart) : ros::Time::now();
}

ros::NodeHandle onQueue(ros::NodeHandle nh, ros::CallbackQueue& queue)
{
  nh.setCallbackQueue(&queue);
  return nh;
}

void logScene(const ping_pong::World& world, const std::string& more = "")
{
  const ping_pong::Scene& scene = world.scene();
  ROS_INFO_STREAM("scene " << scene.name << ", method " << ping_pong::name(world.method()) << more);
  if (scene.method == ping_pong::Method::Auto)
    ROS_INFO_STREAM("method auto takes " << ping_pong::chooseMethod(scene).reason);
}
}  // namespace

SimNode::SimNode()
    : command_nh_(onQueue(nh_, command_queue_)),
      params_(readParams(private_nh_)),
      use_sim_time_(ros::Time::isSimTime()),
      paused_(params_.paused),
      simulation_(params_, loadSceneFor(params_, params_.scene, params_.load), command_nh_, rejections_,
                  firstStamp(use_sim_time_)),
      states_(nh_, params_, simulation_, paused_, jobs_),
      markers_(nh_, params_.marker_rate, params_.blob_shadows, simulation_, jobs_),
      status_(nh_, params_, simulation_, rejections_, states_, paused_),
      pacer_(params_.real_time_factor > 0.0 ? params_.tick() / params_.real_time_factor : 0.0),
      state_gate_(params_.publish_rate),
      clock_gate_(params_.clock_rate),
      services_(std::make_unique<Services>(private_nh_, *this))
{
  if (use_sim_time_)
    clock_ = nh_.advertise<rosgraph_msgs::Clock>("/clock", 10, true);
  else if (params_.real_time_factor != 1.0)
    ROS_WARN("real_time_factor is not 1 and /use_sim_time is not set: stamps will leave wall time");
  logScene(simulation_.world(), paused_ ? ", paused" : "");
}

SimNode::~SimNode()
{
  jobs_.close();
  service_spinner_.stop();
  command_spinner_.stop();
}

void SimNode::run()
{
  service_spinner_.start();
  command_spinner_.start();
  showJump(true);
  waitForView();
  pacer_.restart(WallClock::now());
  while (ros::ok())
  {
    if (paused_)
      runPaused();
    else
      runTick();
  }
  jobs_.close();
}

// So that the first second of a scene is seen, and not what is left when the window has drawn.
void SimNode::waitForView()
{
  const WallClock::time_point start = WallClock::now();
  const auto deadline = start + std::chrono::duration<double>(params_.wait_for_view);
  WallClock::time_point seen_at = start;
  while (ros::ok() && !paused_ && WallClock::now() < deadline)
  {
    if (!markers_.watched()) seen_at = WallClock::now();
    if (WallClock::now() - seen_at > kFirstPicture) return;
    runPaused();
  }
}

void SimNode::runPaused()
{
  jobs_.serveUntil(WallClock::now() + kIdlePeriod);
  status_.update(WallClock::now());
  markers_.repeatBodies(WallClock::now());
}

void SimNode::runTick()
{
  simulation_.tick();
  const WallClock::time_point now = WallClock::now();
  // Up to real time every tick is told; beyond, as many per wall second as there would be in real time.
  const bool each = params_.real_time_factor > 0.0 && params_.real_time_factor <= 1.0;
  afterTick(state_gate_.open(now) || each);
  if (clock_gate_.open(now)) publishClock();
  if (simulation_.isOver()) reset();

  if (params_.real_time_factor == 0.0)
  {
    jobs_.serve();
    return;
  }
  waitUntil(pacer_.next(now));
}

void SimNode::waitUntil(WallClock::time_point deadline)
{
  jobs_.serve();  // also when late
  while (ros::ok() && !paused_ && WallClock::now() < deadline)
  {
    jobs_.serveUntil(std::min(deadline, WallClock::now() + kIdlePeriod));
    status_.update(WallClock::now());
  }
}

void SimNode::afterTick(bool publish_state)
{
  const WallClock::time_point now = WallClock::now();
  states_.publishContacts(now);
  if (publish_state) states_.publish(now);
  markers_.observeTick();
  markers_.update(now);
  status_.update(now);
}

void SimNode::publishClock()
{
  if (!use_sim_time_) return;
  rosgraph_msgs::Clock message;
  message.clock = simulation_.clock().now();
  clock_.publish(message);
}

void SimNode::setPaused(bool paused)
{
  if (paused == paused_) return;
  paused_ = paused;
  if (!paused)
  {
    // Without /clock the others' time went on meanwhile.
    if (!use_sim_time_) simulation_.clock().catchUp(ros::Time::now());
    pacer_.restart(WallClock::now());
  }
  states_.publishAll();
  markers_.publish();
  publishClock();
  status_.publish(WallClock::now());
}

void SimNode::reset()
{
  states_.forgetPast();
  simulation_.reset();
  markers_.forgetPast();
  showJump(true);
}

void SimNode::waitForCommands(const Step::Request& request, Step::Response& response)
{
  if (!(request.deadline >= 0.0 && request.deadline <= kLongestWait))
    throw InputError("deadline: " + std::to_string(request.deadline) + ": expected 0 to 10 [s]");
  const auto& paddles = simulation_.paddles();
  const auto find = [&paddles](const std::string& name)
  { return std::find_if(paddles.begin(), paddles.end(), [&name](const auto& p) { return p->name() == name; }); };
  for (const std::string& name : request.wait_for)
    if (find(name) == paddles.end()) throw InputError("wait_for: '" + name + "': expected the name of a paddle");
  const auto deadline = WallClock::now() + std::chrono::duration_cast<WallClock::duration>(
                                               std::chrono::duration<double>(request.deadline));
  for (const std::string& name : request.wait_for)
    if (!(*find(name))->waitForCommand(deadline)) response.late.push_back(name);
}

void SimNode::step(const Step::Request& request, Step::Response& response)
{
  const double duration = request.duration;
  if (!paused_) throw InputError("the simulation is running: expected ~pause first");
  if (!(duration > 0.0 && duration <= kLongestStep))
  {
    throw InputError("duration: " + std::to_string(duration) + ": expected above 0, up to 3600 [s]");
  }
  waitForCommands(request, response);
  const double tick = params_.tick();
  // A remainder below a nanosecond is rounding: stamps cannot show it.
  const auto ticks = static_cast<long>(std::floor(duration / tick + 1e-9));
  const double rest = duration - static_cast<double>(ticks) * tick;
  for (long i = 0; i <= ticks && ros::ok(); ++i)
  {
    if (i < ticks)
      simulation_.tick();
    else if (rest > 1e-9)
      simulation_.partialTick(rest);
    else
      break;
    for (const ping_pong::Contact& contact : simulation_.world().contacts())
    {
      response.contacts.push_back(toContact(simulation_, contact));
    }
    afterTick(true);
  }
  states_.publishAll();
  markers_.publish();
  publishClock();
  response.time = simulation_.world().time();
  fillBalls(simulation_, response.balls);
  fillPaddles(simulation_, response.paddles);
}

void SimNode::load(ping_pong::Scene scene)
{
  simulation_.load(std::move(scene));
  states_.forgetPast();
  markers_.forgetPast();
  markers_.publishBodies();
  showJump(true);
  logScene(simulation_.world());
}

void SimNode::showJump(bool bodies_too)
{
  simulation_.clock().addJump();
  if (bodies_too) states_.publishStaticFrames();
  states_.publishAll();
  markers_.publish();
  publishClock();
  status_.publish(WallClock::now());
}
}  // namespace ping_pong_sim
