// A paddle follows its commands within its limits: closed forms.
#include <gtest/gtest.h>

#include "paddle/paddle_drive.h"
#include "ping_pong_sim/world.h"

namespace ping_pong
{
namespace
{
const double kInf = std::numeric_limits<double>::infinity();

struct Paddle
{
  World world;

  explicit Paddle(const DriveLimits& limits) : world(scene(limits)) {}
  static Scene scene(const DriveLimits& limits)
  {
    Scene scene;
    scene.materials = {"ball", "rubber"};
    scene.surfaces = SurfaceTable(2);
    Body body;
    body.name = "paddle";
    body.kind = BodyKind::Kinematic;
    body.limits = limits;
    Shape blade;
    blade.half_size = {0.005, 0.08, 0.08};
    body.shapes = {blade};
    scene.bodies = {body};
    return scene;
  }
  void command(const PaddleCommand& command) { ASSERT_FALSE(world.command(0, command)); }
  void run(double duration, double tick = 0.002)
  {
    const int ticks = static_cast<int>(std::lround(duration / tick));
    for (int i = 0; i < ticks; ++i) world.advance(tick);
  }
  Vector3d p() const { return world.bodyPose(0).p; }
  Vector3d v() const { return world.bodyTwist(0).v; }
};

PaddleCommand accelerate(const Vector3d& a, const Vector3d& alpha = Vector3d::Zero())
{
  PaddleCommand command;
  command.mode = PaddleCommand::Mode::Acceleration;
  command.a_W = a;
  command.alpha_W = alpha;
  return command;
}

PaddleCommand moveAt(const Vector3d& v)
{
  PaddleCommand command;
  command.mode = PaddleCommand::Mode::Velocity;
  command.twist.v = v;
  return command;
}

PaddleCommand goTo(const Vector3d& p, const Quaterniond& q = Quaterniond::Identity())
{
  PaddleCommand command;
  command.mode = PaddleCommand::Mode::Pose;
  command.pose = {p, q};
  return command;
}

TEST(PaddleDrive, ASwingIsAParabola)
{
  Paddle paddle({kInf, kInf, kInf, kInf});
  paddle.command(accelerate({20.0, 0.0, -3.0}));
  paddle.run(0.25);
  // p = a t^2/2, v = a t; 125 additions round to 1e-14.
  EXPECT_NEAR(paddle.p().x(), 0.5 * 20.0 * 0.0625, 1e-13);
  EXPECT_NEAR(paddle.p().z(), -0.5 * 3.0 * 0.0625, 1e-13);
  EXPECT_NEAR(paddle.v().x(), 5.0, 1e-13);
}

TEST(PaddleDrive, OneLongTickGivesTheSameSwing)
{
  Paddle paddle({kInf, kInf, kInf, kInf});
  paddle.command(accelerate({20.0, 0.0, 0.0}));
  paddle.world.advance(0.25);
  EXPECT_NEAR(paddle.p().x(), 0.625, 1e-13);
}

// A tick is moved in equal pieces of at most 5 ms; half of the first one's way is lost to coming to speed.
TEST(PaddleDrive, WithoutLimitsAVelocityIsReachedInTheFirstPieceOfATick)
{
  struct Tick
  {
    double length, first_piece;
  };
  for (const Tick tick : {Tick{0.002, 0.002}, Tick{0.005, 0.005}, Tick{0.006, 0.003}, Tick{0.012, 0.004},
                          Tick{0.1, 0.005}, Tick{1.0, 0.005}})
  {
    Paddle paddle({kInf, kInf, kInf, kInf});
    paddle.command(moveAt({3.0, 0.0, 0.0}));
    paddle.world.advance(tick.length);
    EXPECT_EQ(paddle.v().x(), 3.0) << tick.length;
    EXPECT_NEAR(paddle.p().x(), 3.0 * (tick.length - 0.5 * tick.first_piece), 1e-13) << tick.length;  // 200 additions
  }
}

TEST(PaddleDrive, AccelerationAndSpeedStayWithinTheLimits)
{
  Paddle paddle({2.0, 50.0, 10.0, 300.0});
  paddle.command(accelerate({1000.0, 0.0, 0.0}, {0.0, 1e5, 0.0}));
  Twist before;
  for (int i = 0; i < 200; ++i)
  {
    paddle.world.advance(0.002);
    const Twist now = paddle.world.bodyTwist(0);
    EXPECT_LE(now.v.norm(), 2.0 * (1.0 + 1e-12));
    EXPECT_LE(now.w.norm(), 10.0 * (1.0 + 1e-12));
    EXPECT_LE((now.v - before.v).norm(), 50.0 * 0.002 * (1.0 + 1e-9));
    before = now;
  }
  EXPECT_NEAR(paddle.v().x(), 2.0, 1e-12);
}

// Each tick asks for more than the limit: what comes out differs from what the drive does already by a rounding, which would
// be an acceleration if it were taken for one.
TEST(PaddleDrive, AtItsTopSpeedItIsNotAcceleratedByRounding)
{
  const DriveLimits limits{1000.0, kInf, 1000.0, kInf};
  for (const Vector3d& direction : {Vector3d(1, 2, 3), Vector3d(3, -1, 0.7), Vector3d(-0.3, 0.1, 9)})
  {
    const double h = 2e-3;
    BodyMotion motion;
    for (int tick = 0; tick < 50; ++tick)
    {
      motion = followCommand(accelerate(1e6 * direction, 1e6 * direction), limits, motion, h * tick, h);
      if (tick < 3) continue;  // by then it is there
      ASSERT_NEAR(motion.twist.v.norm(), 1000.0, 1e-9);
      ASSERT_EQ(motion.a_WB, Vector3d::Zero()) << tick;
      ASSERT_EQ(motion.alpha_WB, Vector3d::Zero()) << tick;
    }
  }
}

TEST(PaddleDrive, HoldStopsAtFullBrakingAndThenStandsStill)
{
  Paddle paddle({10.0, 100.0, 10.0, 100.0});
  paddle.command(moveAt({2.0, 0.0, 0.0}));
  paddle.run(0.1);
  const double from = paddle.p().x();
  paddle.command(PaddleCommand());
  paddle.run(0.1);
  EXPECT_NEAR(paddle.p().x() - from, 2.0 * 2.0 / (2.0 * 100.0), 1e-12);  // v^2 / 2a
  const Vector3d stopped = paddle.p();
  paddle.run(1.0);
  EXPECT_EQ(paddle.p(), stopped);
  EXPECT_TRUE(paddle.v().isZero(0.0));
}

TEST(PaddleDrive, APoseIsReachedWithoutOvershootAndKept)
{
  Paddle paddle({5.0, 100.0, 20.0, 1000.0});
  const Quaterniond turned(Eigen::AngleAxisd(1.2, Vector3d(1.0, 2.0, 2.0) / 3.0));
  paddle.command(goTo({0.4, -0.3, 0.2}, turned));
  double furthest = 0.0;
  for (int i = 0; i < 500; ++i)
  {
    paddle.world.advance(0.002);
    furthest = std::max(furthest, paddle.p().x());
  }
  EXPECT_LT((paddle.p() - Vector3d(0.4, -0.3, 0.2)).norm(), 1e-10);
  EXPECT_LT(paddle.world.bodyPose(0).q.angularDistance(turned), 1e-7);  // acos near 1 resolves 1e-8
  EXPECT_LT(furthest, 0.4 + 1e-10);
  EXPECT_LT(paddle.v().norm(), 1e-10);
}

TEST(PaddleDrive, APoseTakesNotMuchLongerThanTimeOptimal)
{
  Paddle paddle({kInf, 100.0, kInf, 100.0});
  paddle.command(goTo({1.0, 0.0, 0.0}));
  int ticks = 0;
  while (std::abs(paddle.p().x() - 1.0) > 1e-6 && ticks < 1000)
  {
    paddle.world.advance(0.002);
    ++ticks;
  }
  const double bang_bang = 2.0 * std::sqrt(1.0 / 100.0);
  EXPECT_LT(0.002 * ticks, bang_bang + 0.02);
}

TEST(PaddleDrive, AMovingTargetIsFollowedWithItsVelocity)
{
  Paddle paddle({20.0, 200.0, 20.0, 1000.0});
  PaddleCommand command = goTo({0.1, 0.0, 0.0});
  command.twist.v = {1.0, 0.0, 0.0};
  paddle.command(command);
  paddle.run(0.5);
  EXPECT_NEAR(paddle.p().x(), 0.6, 1e-9);
  EXPECT_NEAR(paddle.v().x(), 1.0, 1e-9);
}

TEST(PaddleDrive, AStaticBodyRefusesCommands)
{
  Scene scene = Paddle::scene({});
  scene.bodies[0].kind = BodyKind::Static;
  World world(scene);
  EXPECT_TRUE(world.command(0, moveAt({1.0, 0.0, 0.0})));
  EXPECT_TRUE(world.command(7, moveAt({1.0, 0.0, 0.0})));
}

TEST(PaddleDrive, CommandsThatAreNotFiniteAreRefusedAndTheOldOneHolds)
{
  Paddle paddle({});
  paddle.command(moveAt({1.0, 0.0, 0.0}));
  const double nan = std::nan("");
  EXPECT_TRUE(paddle.world.command(0, accelerate({nan, 0.0, 0.0})));
  EXPECT_TRUE(paddle.world.command(0, moveAt({0.0, kInf, 0.0})));
  EXPECT_TRUE(paddle.world.command(0, goTo({0.0, 0.0, nan})));
  EXPECT_TRUE(paddle.world.command(0, goTo({0.0, 0.0, 0.0}, Quaterniond(0.0, 0.0, 0.0, 0.0))));
  paddle.run(0.2);
  EXPECT_NEAR(paddle.v().x(), 1.0, 1e-12);
}

// Velocity and acceleration of a motion are the derivatives of its pose, also where the axis of rotation moves.
TEST(BodyMotion, PoseAndVelocityAgree)
{
  for (const double size : {0.01, 1.0, 20.0})
  {
    BodyMotion motion;
    motion.twist = {{1.0, -2.0, 0.5}, size * Vector3d(0.3, 0.8, -0.5)};
    motion.a_WB = {3.0, 1.0, -2.0};
    motion.alpha_WB = size * Vector3d(5.0, -3.0, 2.0);
    const double s = 0.08;
    const double h = 1e-5;
    const BodyFrame frame = frameAt(motion, s);
    const BodyFrame before = frameAt(motion, s - h);
    const BodyFrame after = frameAt(motion, s + h);
    // Central differences err by h^2 f'''/6: 1e-10 of size^3.
    const double tolerance = 1e-9 * (1.0 + size * size * size);
    EXPECT_LT(((after.p_WB - before.p_WB) / (2.0 * h) - frame.v_WB).norm(), 1e-9);
    const Matrix3d spin = (after.R_WB - before.R_WB) / (2.0 * h) * frame.R_WB.transpose();
    EXPECT_LT((Vector3d(spin(2, 1), spin(0, 2), spin(1, 0)) - frame.w_WB).norm(), tolerance) << size;
    EXPECT_LT(((after.w_WB - before.w_WB) / (2.0 * h) - frame.alpha_WB).norm(), tolerance) << size;
  }
}
}  // namespace
}  // namespace ping_pong
