// What a simulated second costs, scene by scene and method by method: time per ball and simulated second.
#include <benchmark/benchmark.h>

#include "ping_pong_sim/scene_loader.h"
#include "ping_pong_sim/world.h"

namespace ping_pong
{
namespace
{
constexpr double kDuration = 1.0;  // [s], simulated
constexpr double kTick = 0.01;     // [s]

void simulateOneSecond(benchmark::State& state, const std::string& file, Method method)
{
  Scene scene = loadScene(std::string(SCENES_DIR) + "/" + file);
  scene.method = method;
  World world(scene);
  for (auto _ : state)
  {
    state.PauseTiming();
    world.reset();
    state.ResumeTiming();
    for (int i = 0; i < static_cast<int>(kDuration / kTick + 0.5); ++i) world.advance(kTick);
    benchmark::DoNotOptimize(world.ballState(0));
  }
  state.counters["per ball"] =
      benchmark::Counter(kDuration * static_cast<double>(scene.balls.size()),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void registerAll()
{
  for (const char* file : {"arc.yaml", "arc_air.yaml", "drop.yaml", "tray.yaml", "rally.yaml"})
    for (const Method method : {Method::Exact, Method::EulerSemiImplicit})
      benchmark::RegisterBenchmark((std::string(file) + "/" + name(method)).c_str(),
                                   [=](benchmark::State& state) { simulateOneSecond(state, file, method); });
}
}  // namespace
}  // namespace ping_pong

int main(int argc, char** argv)
{
  ping_pong::registerAll();
  benchmark::Initialize(&argc, argv);  // the options are the library's; --help lists them
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
