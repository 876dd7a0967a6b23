#include "services.h"

#include "ping_pong_sim/constants.h"
#include "ros/commands/launching.h"

namespace ping_pong_sim
{
namespace
{
void throwIf(const ping_pong::Refusal& refusal)
{
  if (refusal) throw InputError(refusal.reason);
}

ping_pong::MaterialId materialNamed(const ping_pong::Scene& scene, const std::string& wanted)
{
  if (wanted.empty()) return ballMaterial(scene);
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
  {
    if (scene.materials[i] == wanted) return static_cast<ping_pong::MaterialId>(i);
  }
  throw InputError("material: " + wanted + ": expected one that the scene knows");
}

double orDefault(double value, double fallback, const std::string& field)
{
  return checkedNumber(value, field) == 0.0 ? fallback : value;
}

ping_pong::BallParams paramsOf(const ping_pong::Scene& scene, const SpawnBall::Request& request)
{
  ping_pong::BallParams params;
  params.radius = orDefault(request.radius, ping_pong::kBallRadius, "radius");
  params.mass = orDefault(request.mass, ping_pong::kBallMass, "mass");
  if (params.radius <= 0.0) throw InputError("radius: " + std::to_string(request.radius) + ": expected above 0 [m]");
  if (params.mass <= 0.0) throw InputError("mass: " + std::to_string(request.mass) + ": expected above 0 [kg]");
  params.color = fromColor(request.color);
  params.material = materialNamed(scene, request.material);
  return params;
}

ping_pong::BallState stateOf(const ping_pong::Pose& X_WF, const ping_pong::Pose& pose, const ping_pong::Twist& twist)
{
  const ping_pong::Pose X_WB = poseInWorld(X_WF, pose);
  const ping_pong::Twist twist_W = twistInWorld(X_WF, twist);
  return {X_WB.p, X_WB.q, twist_W.v, twist_W.w};
}

// What the request says, in its own frame and without scatter: a shot by name or by its vectors.
ping_pong::Shot shotOf(const Launch::Request& request)
{
  ping_pong::Shot shot;
  shot.p_TB = fromPoint(request.position, "position");
  shot.v_TB = fromVector(request.velocity, "velocity");
  shot.w_TB = fromVector(request.spin, "spin");
  if (request.shot.empty()) return shot;
  const ping_pong::Shot& named = shotNamed(request.shot);
  if (shot.p_TB.isZero(0.0) && shot.v_TB.isZero(0.0) && shot.w_TB.isZero(0.0)) return named;
  throw InputError("shot: " + request.shot + ": expected a name, or position, velocity and spin, not both");
}
}  // namespace

Services::Services(ros::NodeHandle& nh, SimNode& node) : node_(node)
{
  offer<std_srvs::SetBool>(nh, "pause", [this](auto& request, auto&) { node_.setPaused(request.data); });
  offer<std_srvs::Trigger>(nh, "reset", [this](auto&, auto&) { node_.reset(); });
  offer<Step>(nh, "step", [this](auto& request, auto& response) { node_.step(request, response); });
  offer<SpawnBall>(nh, "spawn_ball", [this](auto& request, auto& response) { spawnBall(request, response); });
  offer<Launch>(nh, "launch", [this](auto& request, auto& response) { launch(request, response); });
  offer<DeleteBall>(nh, "delete_ball", [this](auto& request, auto&) { deleteBall(request); });
  offer<SetBallState>(nh, "set_ball_state", [this](auto& request, auto&) { setBallState(request); });
  offer<SetBodyPose>(nh, "set_body_pose", [this](auto& request, auto&) { setBodyPose(request); });
  offerLoadScene(nh);
}

template <class Service>
void Services::offer(ros::NodeHandle& nh, const std::string& name,
                     std::function<void(typename Service::Request&, typename Service::Response&)> action)
{
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  const boost::function<bool(Request&, Response&)> callback = [=](Request& request, Response& response)
  {
    response.message = "shutting down";
    node_.jobs().run(
        [&]
        {
          try
          {
            response.message.clear();
            action(request, response);
            response.success = true;
          }
          catch (const std::exception& error)
          {
            response.success = false;
            response.message = error.what();
            node_.rejections().add("~" + name, error.what());
          }
        });
    return true;
  };
  servers_.push_back(nh.advertiseService(name, callback));
}

void Services::spawnBall(const SpawnBall::Request& request, SpawnBall::Response& response)
{
  ping_pong::World& world = node_.simulation().world();
  ping_pong::Pose pose;
  pose.p = fromPoint(request.position, "position");
  const ping_pong::Twist twist{fromVector(request.velocity, "velocity"), fromVector(request.spin, "spin")};
  const ping_pong::BallState state = stateOf(framePose(world, request.frame_id), pose, twist);
  ping_pong::BallId id = 0;
  throwIf(world.spawnBall(paramsOf(world.scene(), request), state, &id));
  response.id = id;
  node_.showJump();
}

void Services::launch(const Launch::Request& request, Launch::Response& response)
{
  ping_pong::World& world = node_.simulation().world();
  const ping_pong::Shot shot = shotOf(request);
  const double scatter = checkedNumber(request.scatter, "scatter");
  if (scatter < 0.0 || scatter > 1.0)
  {
    throw InputError("scatter: " + std::to_string(scatter) + ": expected a part from 0 to 1");
  }
  const bool at_table = !request.shot.empty() && request.frame_id.empty();
  const ping_pong::Pose X_WF = at_table ? tableFrame(world) : framePose(world, request.frame_id);
  response.id = launchBall(world, X_WF, ping_pong::scattered(shot, scatter, request.seed));
  node_.showJump();
}

void Services::deleteBall(const DeleteBall::Request& request)
{
  throwIf(node_.simulation().world().deleteBall(request.id));
  node_.showJump();
}

void Services::setBallState(const SetBallState::Request& request)
{
  ping_pong::World& world = node_.simulation().world();
  const ping_pong::Pose X_WF = framePose(world, request.frame_id);
  const ping_pong::BallState state = stateOf(X_WF, fromPose(request.pose, "pose"), fromTwist(request.twist, "twist"));
  throwIf(world.setBallState(request.id, state));
  node_.forgetTrail(request.id);
  node_.showJump();
}

void Services::setBodyPose(const SetBodyPose::Request& request)
{
  ping_pong::World& world = node_.simulation().world();
  const ping_pong::Pose X_WB = poseInWorld(framePose(world, request.frame_id), fromPose(request.pose, "pose"));
  const std::size_t body = world.findBody(request.body);
  const auto prop = node_.simulation().props().find(request.body);
  if (body != ping_pong::kNone)
  {
    throwIf(world.setBodyPose(body, X_WB));
    node_.simulation().releasePaddle(body);
  }
  else if (prop != node_.simulation().props().end())
  {
    prop->second = X_WB;
  }
  else
  {
    throw InputError("body: " + request.body + ": expected the name of a body, a light or a camera");
  }
  node_.showJump(true);
}

// Reads and checks the file in the service's own thread: a running simulation does not wait for the disk.
void Services::offerLoadScene(ros::NodeHandle& nh)
{
  using Request = LoadScene::Request;
  using Response = LoadScene::Response;
  const boost::function<bool(Request&, Response&)> callback = [this](Request& request, Response& response)
  {
    try
    {
      ping_pong::Scene scene = loadSceneFor(node_.params(), request.scene);
      std::string failure = "shutting down";
      node_.jobs().run(
          [&]
          {
            try
            {
              node_.load(std::move(scene));
              failure.clear();
            }
            catch (const std::exception& error)
            {
              failure = error.what();
            }
          });
      if (!failure.empty()) throw InputError(failure);
      response.success = true;
    }
    catch (const std::exception& error)
    {
      response.success = false;
      response.message = error.what();
      node_.rejections().add("~load_scene", error.what());
    }
    return true;
  };
  servers_.push_back(nh.advertiseService("load_scene", callback));
}
}  // namespace ping_pong_sim
