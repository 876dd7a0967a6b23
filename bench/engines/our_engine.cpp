#include "our_engine.h"

#include <algorithm>

#include "ping_pong_sim/world.h"

namespace ping_pong::bench
{
namespace
{
constexpr char kOurName[] = "ping_pong_sim";
constexpr double kRampTime = 5e-3;  // in which a driven body comes to speed [s]

// Where a body has to start so that, after coming to speed evenly, it is where constant speed would have brought it.
Pose aheadOf(const Pose& pose, const Twist& twist, double time)
{
  const double angle = twist.w.norm() * time;
  if (angle == 0.0) return {pose.p + time * twist.v, pose.q};
  return {pose.p + time * twist.v, Quaterniond(Eigen::AngleAxisd(angle, twist.w.normalized())) * pose.q};
}

class OurEngine : public Engine
{
public:
  explicit OurEngine(const Scene& scene) : world_(scene)
  {
    world_.keepContacts(false);  // nobody reads them here, and no other engine is asked to list its contacts
  }

  void drive(std::size_t body, const Twist& twist) override { driven_.push_back({body, twist}); }

  void advance(double duration) override
  {
    if (!started_) duration -= start(duration);
    world_.advance(duration);
  }

  BallState ballState(std::size_t ball) const override { return world_.ballState(ball); }

private:
  struct Drive
  {
    std::size_t body;
    Twist twist;
  };

  // Planned contacts are part of the cost: setting a state makes the world plan anew, now that the clock runs.
  // Drives reach their speed within one call of World::advance. Returns the time that has passed.
  double start(double duration)
  {
    started_ = true;
    const double ramp = driven_.empty() ? 0.0 : std::min(duration, kRampTime);
    for (const Drive& drive : driven_) command(drive, ramp);
    if (world_.ballCount() > 0) world_.setBallState(world_.ballId(0), world_.ballState(0));
    world_.advance(ramp);
    return ramp;
  }

  void command(const Drive& drive, double ramp)
  {
    world_.setBodyPose(drive.body, aheadOf(world_.bodyPose(drive.body), drive.twist, 0.5 * ramp));
    PaddleCommand command;
    command.mode = PaddleCommand::Mode::Velocity;
    command.twist = drive.twist;
    world_.command(drive.body, command);
  }

  World world_;
  std::vector<Drive> driven_;
  bool started_ = false;
};

// Those that run: `auto` is one of them.
std::vector<std::string> methodNames()
{
  std::vector<std::string> names;
  for (const Method method : kMethods) names.emplace_back(name(method));
  return names;
}

std::unique_ptr<Engine> make(Scene scene, const std::string& variant, double step)
{
  scene.method = methodFromName(variant);
  (takesTolerance(kOurName, variant) ? scene.tolerance : scene.dt) = step;
  return std::make_unique<OurEngine>(scene);
}
}  // namespace

EngineKind ourEngine()
{
  return {kOurName, methodNames(), [](const Scene&, const std::string&) { return std::string(); }, make};
}

bool takesTolerance(const std::string& engine, const std::string& variant)
{
  return engine == kOurName && variant == "exact";
}
}  // namespace ping_pong::bench
