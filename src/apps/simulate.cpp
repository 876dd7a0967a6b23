// Runs a scene without ROS: ball states to standard output, a summary to standard error.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>

#include "command_queue.h"
#include "csv_file.h"
#include "ping_pong_sim/choose_method.h"
#include "ping_pong_sim/scene_loader.h"
#include "ping_pong_sim/state_hash.h"
#include "ping_pong_sim/world.h"
#include "progress.h"
#include "simulate_options.h"

namespace ping_pong
{
namespace
{
enum ExitStatus
{
  kWhole = 0,
  kOutputFailed = 1,
  kBadInput = 2,
  kWorldNotOk = 3
};

/// What the summary tells.
struct Report
{
  double wall = 0.0;          ///< spent in World::advance() [s]
  double energy_start = 0.0;  ///< [J]
  std::size_t contacts = 0;
  std::size_t events = 0;
  std::size_t squeezed = 0;
  bool event_limit = false;
  bool not_finite = false;
  double trouble_since = -1.0;  ///< simulated time of the first flag; negative: none [s]
};

/// What a run moves on, and where it writes.
struct Run
{
  World& world;
  CommandQueue& commands;
  CsvFile& balls;
  CsvFile* contacts;  ///< null: they are not written
  Report report;
};

Scene prepareScene(const SimulateOptions& options)
{
  LoadOptions load_options;
  load_options.has_seed = options.seed.has_value();
  load_options.seed = options.seed.value_or(0);
  load_options.balls = options.balls.value_or(0);
  Scene scene = loadScene(options.scene_path, load_options);
  if (options.method) scene.method = *options.method;
  if (options.dt) scene.dt = *options.dt;
  if (options.tolerance) scene.tolerance = *options.tolerance;
  if (options.threads) scene.threads = *options.threads;
  return scene;
}

std::vector<TimedCommand> prepareCommands(const SimulateOptions& options, const Scene& scene)
{
  return options.commands_path.empty() ? std::vector<TimedCommand>()
                                       : readCommands(options.commands_path, scene.bodies);
}

/// What has just been read shall not be written over, by whatever name.
void checkIsNoInput(const std::string& path, const SimulateOptions& options, const Scene& scene)
{
  const auto check = [&path](const std::string& input, const std::string& what)
  {
    std::error_code none;  // a file that is not there is no input
    if (!input.empty() && std::filesystem::equivalent(path, input, none))
      throw UsageError("--contacts: " + path + ": expected another file than " + what);
  };
  check(scene.path, "the scene");
  check(options.commands_path, "the commands");
  for (const Body& body : scene.bodies) check(body.urdf_path, "the URDF of " + body.name);
}

void writeHeader(CsvFile& file, const char* header)
{
  file.text(header);
  file.endRow();
}

void writeBalls(const World& world, double time, CsvFile& file)
{
  for (std::size_t i = 0; i < world.ballCount(); ++i)
  {
    const BallState state = world.ballState(i);
    file.number(time);
    file.integer(world.ballId(i));
    file.vector(state.p_WB);
    for (const double component : {state.q_WB.w(), state.q_WB.x(), state.q_WB.y(), state.q_WB.z()})
      file.number(component);
    file.vector(state.v_WB);
    file.vector(state.w_WB);
    file.endRow();
  }
}

std::string otherName(const World& world, const Contact& contact)
{
  return contact.with_ball ? "ball_" + std::to_string(contact.other_ball) : world.body(contact.body).name;
}

void writeContacts(const World& world, CsvFile& file)
{
  for (const Contact& contact : world.contacts())
  {
    file.number(contact.time);
    file.integer(contact.ball);
    file.text(otherName(world, contact).c_str());
    for (const Vector3d& v : {contact.p_WC, contact.n_W, contact.v_before, contact.v_after, contact.w_before,
                              contact.w_after, contact.v_other, contact.impulse})
      file.vector(v);
    file.endRow();
  }
}

/// One tick.
void tickTo(double time, Run& run)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  const StepStatus status = run.world.advance(std::max(time - run.world.time(), 0.0));  // rounding does not pile up
  Report& report = run.report;
  report.wall += std::chrono::duration<double>(Clock::now() - begin).count();
  report.contacts += status.contacts;
  report.events += status.events;
  report.squeezed = std::max(report.squeezed, status.squeezed);
  report.event_limit |= status.event_limit;
  report.not_finite |= status.not_finite;
  if (!status.ok() && report.trouble_since < 0.0) report.trouble_since = time;
  if (run.contacts != nullptr) writeContacts(run.world, *run.contacts);
}

/// A command acts at its own time: a tick ends there, and another one begins.
void advanceTo(double time, Run& run)
{
  while (run.commands.nextTime() < time)
  {
    tickTo(run.commands.nextTime(), run);
    run.commands.give(run.world);
  }
  tickTo(time, run);
}

/// Rows that run over the same terminal are progress enough.
int terminalForProgress()
{
  return isatty(STDOUT_FILENO) != 0 ? -1 : STDERR_FILENO;
}

void runWhole(const SimulateOptions& options, Run& run)
{
  Progress progress("simulate", terminalForProgress());
  run.report.energy_start = run.world.totals().energy();
  // A duration such as 0.3 s at 10 Hz has three rows after the first, though 0.3 * 10 may round below 3.
  const auto rows = static_cast<std::uint64_t>(options.duration * options.rate * (1.0 + 1e-12));
  for (std::uint64_t k = 0; k <= rows; ++k)
  {
    const double time = static_cast<double>(k) / options.rate;
    if (k > 0) advanceTo(time, run);
    writeBalls(run.world, time, run.balls);
    progress.show(time / options.duration);
  }
  if (run.world.time() < options.duration) advanceTo(options.duration, run);  // the rest, shorter than a row
}

std::string statusText(const Report& report)
{
  if (report.trouble_since < 0.0) return "ok";
  std::string text;
  if (report.squeezed > 0) text += " squeezed (" + std::to_string(report.squeezed) + " balls without room)";
  if (report.event_limit) text += " event_limit (too many events, contacts were skipped)";
  if (report.not_finite) text += " not_finite (a step gave inf or NaN; try a smaller --dt)";
  return "not ok:" + text + ", first at t <= " + std::to_string(report.trouble_since) + " s";
}

void printSummary(const SimulateOptions& options, const Run& run)
{
  const World& world = run.world;
  const Report& report = run.report;
  const double ball_seconds = static_cast<double>(world.ballCount()) * options.duration;
  std::fprintf(stderr, "scene %s, method %s, %zu balls, %g s simulated\n", world.scene().name.c_str(),
               name(world.method()), world.ballCount(), options.duration);
  if (world.scene().method == Method::Auto)
    std::fprintf(stderr, "auto takes %s\n", chooseMethod(world.scene()).reason.c_str());
  std::fprintf(stderr, "cost %.6g s wall, %.4g us per ball and simulated second, %.4g x real time\n", report.wall,
               ball_seconds > 0.0 ? 1e6 * report.wall / ball_seconds : 0.0, options.duration / report.wall);
  std::fprintf(stderr, "contacts %zu, events %zu\n", report.contacts, report.events);
  if (run.commands.size() > 0)
    std::fprintf(stderr, "commands %zu given, %zu left at the end\n", run.commands.given(),
                 run.commands.size() - run.commands.given());
  std::fprintf(stderr, "energy %.9g J at start, %.9g J at end\n", report.energy_start, world.totals().energy());
  std::fprintf(stderr, "state hash %016" PRIx64 "\n", stateHash(world));
  std::fprintf(stderr, "status %s\n", statusText(report).c_str());
}

ExitStatus simulate(const SimulateOptions& options)
{
  World world(prepareScene(options));
  CommandQueue commands(
      prepareCommands(options, world.scene()));  // checked to the last line before anything is written
  if (!options.contacts_path.empty()) checkIsNoInput(options.contacts_path, options, world.scene());
  CsvFile balls;
  std::unique_ptr<CsvFile> contacts;
  if (!options.contacts_path.empty()) contacts = std::make_unique<CsvFile>(options.contacts_path);
  writeHeader(balls, "t,ball,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz");
  if (contacts)
    writeHeader(*contacts,
                "t,ball,other,px,py,pz,nx,ny,nz,vx_before,vy_before,vz_before,vx_after,vy_after,vz_after,"
                "wx_before,wy_before,wz_before,wx_after,wy_after,wz_after,vx_other,vy_other,vz_other,Jx,Jy,Jz");
  world.keepContacts(contacts != nullptr);
  Run run{world, commands, balls, contacts.get(), {}};
  runWhole(options, run);
  balls.close();
  if (contacts) contacts->close();
  printSummary(options, run);
  return run.report.trouble_since < 0.0 ? kWhole : kWorldNotOk;
}

ExitStatus simulateOrHelp(int argc, char** argv)
{
  const SimulateOptions options = parseSimulateOptions(argc, argv);
  if (!options.help) return simulate(options);
  return writeHelp(*options.help) ? kWhole : kOutputFailed;
}
}  // namespace
}  // namespace ping_pong

int main(int argc, char** argv)
{
  using namespace ping_pong;
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error to report, not a silent death
  try
  {
    return simulateOrHelp(argc, argv);
  }
  catch (const OutputError& error)
  {
    std::fprintf(stderr, "simulate: cannot write %s\n", error.what());
    return kOutputFailed;
  }
  catch (const std::exception& error)  // LoadError, UsageError
  {
    std::fprintf(stderr, "simulate: %s\n", error.what());
    return kBadInput;
  }
}
