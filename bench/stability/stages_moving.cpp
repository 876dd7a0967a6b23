#include "stages.h"
#include "testing/scene_builder.h"

namespace ping_pong::stability
{
namespace
{
DriveLimits limits(Dice& dice)
{
  DriveLimits drive;
  drive.speed = dice.log(0.05, 1.5);
  drive.acceleration = dice.log(0.5, 20.0);
  drive.angular_speed = dice.log(0.05, 8.0);
  drive.angular_acceleration = dice.log(0.5, 50.0);
  return drive;
}

PaddleCommand accelerate(const Vector3d& a, const Vector3d& alpha)
{
  PaddleCommand command;
  command.mode = PaddleCommand::Mode::Acceleration;
  command.a_W = a;
  command.alpha_W = alpha;
  return command;
}

// Along a direction and about an axis, either of which may be zero; sometimes it stops, or turns back.
void drive(Stage& stage, Dice& dice, std::size_t body, const Vector3d& along, const Vector3d& about)
{
  const DriveLimits& most = stage.bodies[body].limits;
  const PaddleCommand there = dice.chance(0.5)
                                  ? accelerate(most.acceleration * along, most.angular_acceleration * about)
                                  : velocityCommand(most.speed * along, most.angular_speed * about);
  stage.commands.push_back({dice.chance(0.7) ? 0.0 : dice.uniform(0.0, 0.5), body, there});
  if (dice.chance(0.3)) stage.commands.push_back({dice.uniform(0.5, 1.5), body, PaddleCommand()});
  if (dice.chance(0.3))
    stage.commands.push_back(
        {dice.uniform(0.5, 1.5), body, velocityCommand(-0.5 * most.speed * along, -0.5 * most.angular_speed * about)});
}

// A floor with up to three walls, all of one body.
void addTray(Stage& stage, Dice& dice, std::size_t body)
{
  const bool disc = dice.chance(0.4);
  stage.feature.push_back(disc ? stage.add(body, cylinderShape(0.4, 0.02), at({0, 0, -0.01}))
                               : stage.addBox(body, {-0.4, -0.4, -0.02}, {0.4, 0.4, 0}));
  const int walls = dice.pick(4);
  if (walls > 0) stage.feature.push_back(stage.addBox(body, {-0.12, -0.2, -0.02}, {-0.1, 0.2, 0.1}));
  if (walls > 1) stage.feature.push_back(stage.addBox(body, {-0.12, -0.2, -0.02}, {0.2, -0.18, 0.1}));
  if (walls > 2) stage.addBox(body, {0.2, -0.2, -0.02}, {0.22, 0.2, 0.1});
  stage.target = {kR - 0.1, walls > 1 ? kR - 0.18 : 0.0, kR};
  stage.low = {-0.07, -0.15, 0};
  stage.high = {0.17, 0.15, 0};
}

// About the upright axis.
Vector3d eitherWay(Dice& dice)
{
  return {0, 0, dice.chance(0.5) ? 1.0 : -1.0};
}

std::size_t addKinematic(Stage& stage, Dice& dice, const Vector3d& origin)
{
  const std::size_t body = stage.addBody("mover", BodyKind::Kinematic, at(origin));
  stage.bodies[body].limits = limits(dice);
  return body;
}
}  // namespace

Stage movingTray(Dice& dice)
{
  Stage stage;
  const std::size_t body = addKinematic(stage, dice, {0, 0, 0});
  addTray(stage, dice, body);
  const Vector3d along = dice.chance(0.5) ? Vector3d(1, 0, 0) : dice.direction();
  drive(stage, dice, body, along, {0, 0, 0});
  return stage;
}

Stage turningTable(Dice& dice)
{
  Stage stage;
  const bool centred = dice.chance(0.5);
  const std::size_t body = addKinematic(stage, dice, centred ? Vector3d(0, 0, 0) : dice.direction() * 0.2);
  addTray(stage, dice, body);
  const bool level = dice.chance(0.7);
  if (!level) stage.bodies[body].limits.angular_speed = dice.log(0.02, 0.5);
  const Vector3d along = dice.chance(0.7) ? Vector3d(0, 0, 0) : dice.direction();
  const Vector3d about = level ? eitherWay(dice) : dice.direction();
  drive(stage, dice, body, along, about);
  stage.tilt = level ? 0.3 : 0.05;
  return stage;
}

// A wall pushes the ball over a floor that stays where it is: upright or leaning back, so that there is always a way
// out.
Stage pushed(Dice& dice)
{
  Stage stage;
  const ShapeName floor = stage.addFloor(0.0);
  const std::size_t body = addKinematic(stage, dice, {0, 0, 0.05});
  const double back = dice.chance(0.5) ? 0.0 : -dice.uniform(0.0, 0.4);
  const ShapeName wall =
      stage.addBox(body, {-0.02, -0.3, 0.005}, {0, 0.3, 0.15}, turnedAbout({0, 0, 0.005}, {0, 1, 0}, back));
  stage.bodies[body].limits.angular_speed = dice.log(0.05, 1.0);
  if (dice.chance(0.3))
    drive(stage, dice, body, {0, 0, 0}, eitherWay(dice));
  else
    drive(stage, dice, body, {1, 0, 0}, {0, 0, 0});
  stage.feature = {floor, wall};
  stage.target = {kR, dice.symmetric(0.1), kR};
  stage.low = {0.03, -0.2, 0};
  stage.high = {0.3, 0.2, 0};
  stage.tilt = 0.1;
  stage.most_friction = 0.8;
  return stage;
}
}  // namespace ping_pong::stability
