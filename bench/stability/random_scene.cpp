#include "random_scene.h"

#include <algorithm>

#include "launch.h"
#include "testing/scene_builder.h"
#include "touch.h"

namespace ping_pong::stability
{
namespace
{
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kMostRestitution = 0.9;  // bounces end within a hundred hits; or it is 1, and they never do

Surface drawSurface(Dice& dice, double most_friction)
{
  Surface law;
  law.restitution = dice.chance(0.2) ? 0.0 : dice.chance(0.06) ? 1.0 : dice.uniform(0.0, kMostRestitution);
  if (dice.chance(0.2)) law.restitution_slope = dice.uniform(0.0, 0.05);
  if (dice.chance(0.2)) return law;  // smooth
  law.friction = std::min(dice.chance(0.2) ? kInf : dice.log(0.05, 1.5), most_friction);
  if (dice.chance(0.2)) law.tangential_restitution = dice.uniform(-0.5, 0.8);
  if (dice.chance(0.2)) law.rolling_resistance = dice.log(1e-3, 0.3);
  if (dice.chance(0.2)) law.spin_friction = dice.log(1e-3, 0.1);
  return law;
}

// One material for all, or a pool from which each shape has its own.
void drawMaterials(Dice& dice, double most_friction, Scene& scene)
{
  const int pool = dice.chance(0.5) ? 1 : 3;
  scene.materials = {"ball"};
  for (int i = 0; i < pool; ++i) scene.materials.push_back("wall_" + std::to_string(i));
  scene.surfaces = SurfaceTable(scene.materials.size());
  for (int i = 0; i < pool; ++i)
    scene.surfaces.set(0, static_cast<MaterialId>(i + 1), drawSurface(dice, most_friction));
  for (Body& body : scene.bodies)
    for (Shape& shape : body.shapes) shape.material = static_cast<MaterialId>(1 + dice.pick(pool));
}

bool oneMaterial(const Scene& scene)
{
  return scene.materials.size() == 2;
}

Forces drawAir(Dice& dice)
{
  Forces forces;
  if (!dice.chance(0.4)) return forces;
  forces.drag = dice.chance(0.8);
  forces.magnus = dice.chance(0.7);
  forces.buoyancy = dice.chance(0.5);
  forces.added_mass = dice.chance(0.15);
  if (dice.chance(0.3)) forces.spin_decay = dice.log(0.05, 1.0);
  const double wind = dice.chance(0.3) ? dice.log(0.1, 5.0) : 0.0;
  forces.wind = wind * dice.direction();
  return forces;
}

// Which way is up in the frame of the stage.
Vector3d drawUp(Dice& dice, double most_tilt)
{
  if (dice.chance(0.4)) return Vector3d::UnitZ();
  const double tilt = dice.uniform(0.0, most_tilt), way = dice.symmetric(kPi);
  return {std::sin(tilt) * std::cos(way), std::sin(tilt) * std::sin(way), std::cos(tilt)};
}

// Where the stage stands in the world: as it is; so that up is up; or anyhow. A floor stays level.
Pose drawPlace(Dice& dice, const Stage& stage, const Vector3d& up)
{
  const double which = dice.uniform(0.0, 1.0);
  const Vector3d p = dice.uniform(Vector3d(-1, -1, -1), Vector3d(1, 1, 1)), axis = dice.direction();
  const double angle = dice.symmetric(kPi);
  if (which < 0.4) return Pose();
  const bool level = std::any_of(stage.bodies.begin(), stage.bodies.end(),
                                 [](const Body& body) { return body.shapes[0].kind == ShapeKind::HalfSpace; });
  if (level) return at(p, angle, Vector3d::UnitZ());
  return which < 0.7 ? Pose{p, Quaterniond::FromTwoVectors(up, Vector3d::UnitZ())} : at(p, angle, axis);
}

std::vector<Body> moved(std::vector<Body> bodies, const Pose& X)
{
  for (Body& body : bodies) body.pose = {X.p + X.q * body.pose.p, (X.q * body.pose.q).normalized()};
  return bodies;
}

BallState moved(const BallState& ball, const Pose& X)
{
  return {X.p + X.q * ball.p_WB, ball.q_WB, X.q * ball.v_WB, X.q * ball.w_WB};
}

std::vector<TimedCommand> moved(std::vector<TimedCommand> commands, const Pose& X)
{
  for (TimedCommand& each : commands)
  {
    PaddleCommand& command = each.command;
    command.twist = {X.q * command.twist.v, X.q * command.twist.w};
    command.a_W = X.q * command.a_W;
    command.alpha_W = X.q * command.alpha_W;
  }
  std::stable_sort(commands.begin(), commands.end(),
                   [](const TimedCommand& a, const TimedCommand& b) { return a.time < b.time; });
  return commands;
}

BallParams drawBall(Dice& dice)
{
  BallParams ball;
  ball.inertia = dice.chance(0.5) ? kShellInertia : kSolidInertia;
  if (dice.chance(0.2)) ball.radius = dice.uniform(0.012, 0.02);
  if (dice.chance(0.2)) ball.mass = dice.log(1e-3, 0.1);
  return ball;
}

double drawTolerance(Dice& dice)
{
  return dice.chance(0.6) ? 1e-6 : dice.chance(0.5) ? 1e-9 : 1e-11;
}

void drawTicks(Dice& dice, RandomScene& drawn)
{
  const double which = dice.uniform(0.0, 1.0);
  if (which < 0.05)
    drawn.tick = 0.1;
  else if (which < 0.10)
    drawn.tick = 1.0 / 60.0;
  else if (which < 0.15)
  {
    drawn.tick = 1e-3;
    drawn.duration = 0.4;
  }
}

Scene withoutSeams(const Scene& scene, const Stage& stage, const Pose& X_WL)
{
  Scene whole = scene;
  whole.bodies = moved(stage.whole, X_WL);
  for (Body& body : whole.bodies)
    for (Shape& shape : body.shapes) shape.material = 1;
  return whole;
}
}  // namespace

RandomScene randomScene(std::uint64_t seed, std::uint64_t index)
{
  Dice dice(seed, index);
  const StageKind& kind = stageKinds()[index % stageKinds().size()];
  RandomScene drawn;
  drawn.seed = seed;
  drawn.index = index;
  drawn.category = kind.name;
  Stage stage = kind.make(dice);
  const Vector3d up = drawUp(dice, stage.tilt);
  const Pose X_WL = drawPlace(dice, stage, up);
  Scene& scene = drawn.scene;
  scene.name = drawn.category + "_" + std::to_string(index);
  scene.method = Method::Exact;
  scene.bodies = moved(stage.bodies, X_WL);
  drawMaterials(dice, stage.most_friction, scene);
  scene.forces = drawAir(dice);
  scene.forces.gravity = X_WL.q * Vector3d(-kG * up);
  scene.tolerance = drawTolerance(dice);
  SceneBall ball;
  ball.params = drawBall(dice);
  const Launch launch = drawLaunch(dice, stage, ball.params.radius);
  ball.state = moved(launch.state, X_WL);
  scene.balls = {ball};
  drawn.launch = launch.name;
  drawn.commands = moved(stage.commands, X_WL);
  drawTicks(dice, drawn);
  if (!stage.whole.empty() && oneMaterial(scene)) drawn.whole = withoutSeams(scene, stage, X_WL);
  return drawn;
}
}  // namespace ping_pong::stability
