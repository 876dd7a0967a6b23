// Does every peer do what its adapter promises? Small scenes with a known answer, two step sizes, one table.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <optional>
#include <string>

#include "apps/command_line.h"
#include "peers.h"
#include "ping_pong_sim/world.h"
#include "scene/text_input.h"

namespace ping_pong::bench
{
namespace
{
constexpr double kGravity = 9.81;          // [m/s^2]
constexpr double kStart = 1e-10;           // in which our drive brings a body to its velocity [s]
constexpr double kSteps[] = {1e-3, 1e-4};  // [s]; tolerances of engines that have no steps

struct Case
{
  std::string name;
  Scene scene;
  double duration = 0.5;       // [s]
  std::size_t driven = kNone;  // this body moves with this twist
  Twist twist = {};
  double bound = 0.0;        // error that "best" may have at the shorter step [m], [m/s]; r w counts as a speed
  double soft_bound = 0.05;  // the same for an engine without restitution: its bounces take time, and turn meanwhile
};

SceneBall ballAt(const Vector3d& p, const Vector3d& v, const Vector3d& w = Vector3d::Zero())
{
  SceneBall ball;
  ball.state.p_WB = p;
  ball.state.v_WB = v;
  ball.state.w_WB = w;
  return ball;
}

Scene emptyScene(double gravity)
{
  Scene scene;
  scene.materials = {"ball", "wall"};
  scene.surfaces = SurfaceTable(2);
  scene.forces.gravity = Vector3d(0, 0, -gravity);
  return scene;
}

Scene sceneOn(ShapeKind kind, double restitution, double friction, double gravity = kGravity)
{
  Scene scene = emptyScene(gravity);
  Surface law;
  law.restitution = restitution;
  law.friction = friction;
  scene.surfaces.set(0, 1, law);
  Shape shape;
  shape.kind = kind;
  shape.half_size = Vector3d(1.0, 1.0, 0.01);
  shape.material = 1;
  Body body;
  body.name = "body";
  if (kind == ShapeKind::Box) body.pose.p.z() = -shape.half_size.z();
  body.shapes = {shape};
  scene.bodies = {body};
  return scene;
}

Case freeFlight()
{
  Case c{"free flight", emptyScene(kGravity), 1.0};
  c.scene.balls = {ballAt({0, 0, 1}, {3, 0, 4}, {10, 200, -30})};
  c.bound = 1e-3;
  return c;
}

Case flightInAir()
{
  Case c{"air, spin", emptyScene(kGravity), 0.5};
  c.scene.forces.drag = c.scene.forces.magnus = true;
  c.scene.forces.wind = Vector3d(0, 2, 0);
  c.scene.forces.spin_decay = 0.5;
  c.scene.balls = {ballAt({0, 0, 1}, {8, 0, 3}, {10, 200, -30})};
  c.bound = 5e-3;
  return c;
}

Case bounce(const std::string& name, ShapeKind kind, double restitution, double duration)
{
  Case c{name, sceneOn(kind, restitution, 0.0), duration};
  c.scene.balls = {ballAt({0.01, 0.02, 0.3217}, {0, 0, 0})};
  c.bound = 2e-2;
  c.soft_bound = 0.1;
  return c;
}

// After one bounce, at the top: there the error is that of the energy, not of the time.
Case apex()
{
  const double fall = std::sqrt(2 * 0.3017 / kGravity);
  return bounce("apex, e .9", ShapeKind::HalfSpace, 0.9, std::round(1.9 * fall / 1e-3) * 1e-3);
}

Case spin(const std::string& name, double friction, double speed)
{
  Case c{name, sceneOn(ShapeKind::HalfSpace, 0.9, friction), 0.3};
  c.scene.balls = {ballAt({0, 0, 0.0823}, {speed, 0.4, -2}, {20, -100, 50})};
  c.bound = 2e-2;
  c.soft_bound = 0.3;
  return c;
}

Case slideAndRoll()
{
  Case c{"slide, roll", sceneOn(ShapeKind::HalfSpace, 0.0, 0.2), 1.0};
  c.scene.balls = {ballAt({0, 0, kBallRadius}, {2, 0, 0})};
  c.bound = 1e-2;
  return c;
}

Case tilted()
{
  Case c{"tilted box", sceneOn(ShapeKind::Box, 0.8, 0.1), 0.25};
  c.scene.bodies[0].pose.q = Quaterniond(Eigen::AngleAxisd(0.4, Vector3d(1, 2, 3).normalized()));
  c.scene.balls = {ballAt({0.0, 0.0, 0.1234}, {0.3, 0.1, -3}, {0, 30, 0})};
  c.bound = 2e-2;
  return c;
}

Case paddle()
{
  Case c{"paddle hit", sceneOn(ShapeKind::Box, 0.8, 0.0, 0.0), 0.1};
  c.scene.bodies[0].kind = BodyKind::Kinematic;
  c.scene.bodies[0].shapes[0].half_size = Vector3d(0.08, 0.08, 0.0075);
  c.scene.bodies[0].pose.p = Vector3d::Zero();
  c.driven = 0;
  c.twist.v = Vector3d(0.1, 0, 3.0);
  c.scene.balls = {ballAt({0, 0, 0.2001}, {0, 0, -2})};
  c.bound = 1e-2;
  return c;
}

Case swing()
{
  Case c = paddle();
  c.name = "swing, mu .3";
  c.scene = sceneOn(ShapeKind::Box, 0.8, 0.3, 0.0);
  c.scene.bodies[0].kind = BodyKind::Kinematic;
  c.scene.bodies[0].shapes[0].half_size = Vector3d(0.08, 0.08, 0.0075);
  c.scene.bodies[0].shapes[0].p_BS = Vector3d(0.1, 0, 0);
  c.scene.bodies[0].pose.p = Vector3d(-0.1, 0, 0);
  c.twist.w = Vector3d(0, -5, 0);
  c.scene.balls = {ballAt({0, 0, 0.2001}, {0, 0.5, -2}, {30, 50, 0})};
  c.bound = 3e-2;
  c.soft_bound = 0.3;
  return c;
}

Case twoBalls()
{
  Case c{"two balls", emptyScene(0.0), 0.2};
  c.scene.balls = {ballAt({0, 0, 0}, {2, 0, 0}), ballAt({0.2003, 0.01, 0}, {-1, 0, 0})};
  c.bound = 1e-2;
  return c;
}

// Two laws in one scene: they meet in the air with e .5, then on the floor with .8.
Case twoLaws()
{
  Case c{"two laws", sceneOn(ShapeKind::HalfSpace, 0.8, 0.0), 0.45};
  Surface law;
  law.restitution = 0.5;
  c.scene.surfaces.set(0, 0, law);
  c.scene.balls = {ballAt({0, 0, 0.3003}, {0, 0, 0}), ballAt({0.025, 0, 0.1002}, {0, 0, 2.5})};
  c.bound = 3e-2;
  c.soft_bound = 0.1;
  return c;
}

std::vector<Case> allCases()
{
  return {freeFlight(),
          flightInAir(),
          apex(),
          bounce("bounce, e .9", ShapeKind::HalfSpace, 0.9, 1.5),
          bounce("bounce, e 1", ShapeKind::HalfSpace, 1.0, 1.5),
          bounce("on box, e .9", ShapeKind::Box, 0.9, 1.5),
          spin("spin, slides", 0.1, 3.0),
          spin("spin, grips", 0.5, 1.0),
          slideAndRoll(),
          tilted(),
          paddle(),
          swing(),
          twoBalls(),
          twoLaws()};
}

std::vector<BallState> reference(const Case& c)
{
  Scene scene = c.scene;
  scene.method = Method::Exact;
  scene.tolerance = 1e-9;
  const double infinite = std::numeric_limits<double>::infinity();
  for (Body& body : scene.bodies) body.limits = {infinite, infinite, infinite, infinite};
  World world(scene);
  if (c.driven != kNone)
  {
    PaddleCommand command;
    command.mode = PaddleCommand::Mode::Velocity;
    command.twist = c.twist;
    world.command(c.driven, command);
  }
  world.advance(kStart);
  world.advance(c.duration - kStart);
  std::vector<BallState> states;
  for (std::size_t i = 0; i < world.ballCount(); ++i) states.push_back(world.ballState(i));
  return states;
}
struct Error
{
  double position = 0.0;  // [m]
  double velocity = 0.0;  // of the centre or, by spin, of the surface [m/s]
};

Error errorOf(const Case& c, const EngineKind& kind, const std::string& variant, double step,
              const std::vector<BallState>& truth)
{
  const std::unique_ptr<Engine> engine = kind.make(c.scene, variant, step);
  if (c.driven != kNone) engine->drive(c.driven, c.twist);
  engine->advance(c.duration);
  Error error;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    const BallState state = engine->ballState(i);
    const double spin = c.scene.balls[i].params.radius * (state.w_WB - truth[i].w_WB).norm();
    error.position = std::max(error.position, (state.p_WB - truth[i].p_WB).norm());
    error.velocity = std::max({error.velocity, (state.v_WB - truth[i].v_WB).norm(), spin});
  }
  return error;
}

// One line of the table. False: the best variant misses the bound.
bool check(const Case& c, const EngineKind& kind, const std::string& variant, const std::vector<BallState>& truth)
{
  std::printf("%-14s %-8s %-8s", c.name.c_str(), kind.name.c_str(), variant.c_str());
  const std::string refusal = kind.refuse(c.scene, variant);
  if (!refusal.empty())
  {
    std::printf("  refused: %s\n", refusal.c_str());
    return true;
  }
  Error error;
  for (const double step : kSteps)
  {
    error = errorOf(c, kind, variant, step, truth);
    std::printf("  %9.2e %9.2e", error.position, error.velocity);
  }
  const double bound = kind.name == "mujoco" ? std::max(c.bound, c.soft_bound) : c.bound;
  const bool good = variant != "best" || std::max(error.position, error.velocity) < bound;
  std::printf("%s\n", good ? "" : "  FAR OFF");
  return good;
}

int checkAll(const std::string& only)
{
  std::printf("%-14s %-8s %-8s  %9s %9s  %9s %9s\n", "case", "engine", "variant", "1 ms: m", "m/s", "0.1 ms: m", "m/s");
  int failures = 0;
  for (const Case& c : allCases())
  {
    const std::vector<BallState> truth = reference(c);
    for (const EngineKind& kind : peerKinds())
      for (const std::string& variant : kind.variants)
        if (only.empty() || only == kind.name) failures += check(c, kind, variant, truth) ? 0 : 1;
  }
  return failures == 0 ? 0 : 1;
}

// One ball that bounces on a plane without end: processor time per step.
int timeAll(const std::string& only)
{
  constexpr double kStep = 1e-3, kDuration = 20.0;  // [s]
  const Case c = bounce("", ShapeKind::HalfSpace, 1.0, kDuration);
  for (const EngineKind& kind : peerKinds())
    for (const std::string& variant : kind.variants)
    {
      if ((!only.empty() && only != kind.name) || !kind.refuse(c.scene, variant).empty()) continue;
      double best = std::numeric_limits<double>::infinity();
      for (int repeat = 0; repeat < 5; ++repeat)
      {
        const std::unique_ptr<Engine> engine = kind.make(c.scene, variant, kStep);
        engine->advance(1.0);
        const std::clock_t start = std::clock();  // of this process: others may be busy
        engine->advance(kDuration);
        const double taken = 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;  // [ns]
        best = std::min(best, taken / (kDuration / kStep));
      }
      std::printf("%-8s %-8s %8.0f ns per ball-step\n", kind.name.c_str(), variant.c_str(), best);
    }
  return 0;
}

std::string engineName(const std::string& text)
{
  std::vector<std::string> names;
  for (const EngineKind& kind : peerKinds()) names.push_back(kind.name);
  if (std::find(names.begin(), names.end(), text) != names.end()) return text;
  throw Unexpected{"one of: " + joined(names)};
}

int run(int argc, char** argv)
{
  std::string only;
  bool time = false;
  const OptionGroup what = {
      "What is done",
      {{"ENGINE", "", "this engine alone", into(only, engineName)},
       {"--time", "", "processor time per step of one ball that bounces; checks nothing", flag(time)}}};
  const CommandLine line = {"peers_check",
                            "Holds every other simulator to small scenes with a known answer.",
                            {what},
                            "Exit status: 0 all is well; 1 an engine is far off; 2 bad command line."};
  if (const std::optional<std::string> help = parse(line, argc, argv)) return writeHelp(*help) ? 0 : 2;
  return time ? timeAll(only) : checkAll(only);
}
}  // namespace
}  // namespace ping_pong::bench

int main(int argc, char** argv)
{
  try
  {
    return ping_pong::bench::run(argc, argv);
  }
  catch (const ping_pong::UsageError& error)
  {
    std::fprintf(stderr, "peers_check: %s\n", error.what());
    return 2;
  }
}
