// An elastic ball between four walls, on the floor.
#include "closed_forms.h"
#include "draw.h"
#include "sampled.h"
#include "scene_parts.h"

namespace ping_pong::bench
{
namespace
{
const Vector3d kRoom(1.0, 0.8, 3.0);  // inside, x and y from the middle, z from the floor [m]
constexpr double kWall = 1.0;         // thickness [m]

void addWalls(Scene& scene)
{
  for (const double side : {-1.0, 1.0})
  {
    const Pose along_x{{side * 0.5 * (kRoom.x() + kWall), 0.0, 0.5 * kRoom.z()}, Quaterniond::Identity()};
    const Pose along_y{{0.0, side * 0.5 * (kRoom.y() + kWall), 0.5 * kRoom.z()}, Quaterniond::Identity()};
    const std::string which = side < 0.0 ? "low" : "high";
    addBox(scene, "wall_x_" + which, BodyKind::Static, {kWall, kRoom.y() + 2.0 * kWall, kRoom.z()}, along_x);
    addBox(scene, "wall_y_" + which, BodyKind::Static, {kRoom.x() + 2.0 * kWall, kWall, kRoom.z()}, along_y);
  }
}

TruePath pathInBox(const ChartScene& chart, const BallState& state, Real radius)
{
  const Vector3r p = state.p_WB.cast<Real>(), v = state.v_WB.cast<Real>();
  const Real half_x = 0.5L * kRoom.x() - radius, half_y = 0.5L * kRoom.y() - radius;
  const BackAndForth x(-half_x, half_x, p.x(), v.x()), y(-half_y, half_y, p.y(), v.y());
  const ElasticBouncing z({p.z() - radius, v.z()}, kGravity);
  TruePath path;
  path.samples = sampled(chart,
                         [&](Real t)
                         {
                           const Vertical up = z.at(t);
                           return TrueState{{x.position(t), y.position(t), up.z + radius},
                                            {x.velocity(t), y.velocity(t), up.v},
                                            Vector3r::Zero()};
                         });
  path.events = x.bounces(chart.duration);
  for (const Real t : y.bounces(chart.duration)) path.events.push_back(t);
  path.bounces = 0;
  for (Real t = z.firstBounce(); t < chart.duration; t += z.period(), ++path.bounces) path.events.push_back(t);
  return path;
}

Start startBallInBox(const ChartScene& chart, int n, int)
{
  Random random(3, static_cast<std::uint64_t>(n));
  BallState state;
  state.p_WB = random.uniform(Vector3d(-0.4, -0.3, 0.1), Vector3d(0.4, 0.3, 0.5));
  state.v_WB = random.uniform(Vector3d(-3, -3, -3), Vector3d(3, 3, 3));
  Start start;
  start.scene = emptyScene(chart.name, contactLaw(1.0, 0.0));
  addFloor(start.scene);
  addWalls(start.scene);
  addBall(start.scene, BallParams(), state);
  start.truth = {pathInBox(chart, state, BallParams().radius)};
  return start;
}
}  // namespace

ChartScene ballInBox()
{
  ChartScene chart;
  chart.name = "ball_in_box";
  chart.title = "Elastic ball in a box, 10 s";
  chart.duration = 10.0;
  chart.sample_period = 0.1;
  chart.steps = oneTwoFive(1e-1, 1e-5);
  chart.tolerances = {1e-6};
  chart.reference = "closed form";
  chart.lost = [](const BallState& ball)
  { return 2.0 * std::abs(ball.p_WB.x()) > kRoom.x() || 2.0 * std::abs(ball.p_WB.y()) > kRoom.y(); };
  return withStarts(chart, startBallInBox);
}
}  // namespace ping_pong::bench
