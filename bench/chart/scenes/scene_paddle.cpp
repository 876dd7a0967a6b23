// A paddle that moves and turns steadily meets a ball.
#include <stdexcept>

#include "draw.h"
#include "hit_truth.h"
#include "sampled.h"
#include "scene_parts.h"

namespace ping_pong::bench
{
namespace
{
const Vector3d kPaddle(0.015, 0.15, 0.15);  // [m]
constexpr double kRestitution = 0.8, kFriction = 0.5;

// Everything at the moment of about the hit, from which the start is found by going back in time.
struct Meeting
{
  double time;  // [s]
  BallState ball;
  Pose paddle;
  Twist twist;
};

Meeting drawMeeting(Random& random)
{
  Meeting meeting;
  meeting.time = random.uniform(0.06, 0.14);
  const double tilt = random.uniform(-0.5, 0.5);
  meeting.paddle.q = Quaterniond(Eigen::AngleAxisd(tilt, random.direction()));
  meeting.twist.v = random.uniform(Vector3d(1, -2, -2), Vector3d(10, 2, 2));
  meeting.twist.w = randomVector(random, 0.0, 20.0);
  const double x = 0.5 * kPaddle.x() + BallParams().radius;
  const Vector3d on_face = random.uniform(Vector3d(x, -0.06, -0.06), Vector3d(x, 0.06, 0.06));
  meeting.ball.p_WB = meeting.paddle.q * on_face;
  meeting.ball.v_WB = random.uniform(Vector3d(-15, -3, -3), Vector3d(-4, 3, 3));
  meeting.ball.w_WB = randomVector(random, 0.0, 200.0);
  return meeting;
}

Pose poseBefore(const Meeting& meeting)
{
  const double angle = -meeting.time * meeting.twist.w.norm();
  const Eigen::AngleAxisd back(angle, meeting.twist.w.normalized());
  return {meeting.paddle.p - meeting.time * meeting.twist.v, (back * meeting.paddle.q).normalized()};
}

BallState ballBefore(const Meeting& meeting)
{
  const double s = meeting.time;
  BallState ball = meeting.ball;
  ball.p_WB += -s * ball.v_WB - 0.5 * s * s * Vector3d(0, 0, kGravity);
  ball.v_WB.z() += s * kGravity;
  return ball;
}

HitTask taskOf(const ChartScene& chart, const Scene& scene, const Twist& twist)
{
  HitTask task;
  task.ball = scene.balls[0].params;
  const BallState& ball = scene.balls[0].state;
  task.start = {ball.p_WB.cast<Real>(), ball.v_WB.cast<Real>(), ball.w_WB.cast<Real>()};
  task.g = kGravity;
  task.restitution = kRestitution;
  task.friction = kFriction;
  const Body& paddle = scene.bodies[0];
  task.half_size = paddle.shapes[0].half_size.cast<Real>();
  task.p = paddle.pose.p.cast<Real>();
  task.q = paddle.pose.q.cast<Real>().normalized();
  task.v = twist.v.cast<Real>();
  task.w = twist.w.cast<Real>();
  task.duration = chart.duration;
  task.sample_period = chart.sample_period;
  return task;
}

Start startPaddleHit(const ChartScene& chart, int n, int)
{
  Random random(6, static_cast<std::uint64_t>(n));
  for (int attempt = 0; attempt < 100; ++attempt)
  {
    const Meeting meeting = drawMeeting(random);
    Start start;
    start.scene = emptyScene(chart.name, contactLaw(kRestitution, kFriction));
    addBox(start.scene, "paddle", BodyKind::Kinematic, kPaddle, poseBefore(meeting));
    addBall(start.scene, BallParams(), ballBefore(meeting));
    start.drives = {{0, meeting.twist}};
    const std::optional<TruePath> path = hitTruth(taskOf(chart, start.scene, meeting.twist));
    if (!path || path->events.front() < 0.03L) continue;
    start.truth = {*path};
    return start;
  }
  throw std::runtime_error("paddle_hit: no start with exactly one hit");
}
}  // namespace

ChartScene paddleHit()
{
  ChartScene chart;
  chart.name = "paddle_hit";
  chart.title = "Hit by a paddle that moves and turns, 0.25 s";
  chart.duration = 0.25;
  chart.sample_period = 0.05;
  chart.steps = oneTwoFive(1e-2, 1e-5);
  chart.tolerances = {1e-6};
  chart.reference = "long double, safe march and Newton's method";
  return withStarts(chart, startPaddleHit);
}
}  // namespace ping_pong::bench
