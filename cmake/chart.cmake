# The work-precision chart: scripts/chart and the tests build it. It needs nothing but the physics; with BENCH_PEERS other
# simulators come along.
add_executable(${PROJECT_NAME}_chart EXCLUDE_FROM_ALL
  bench/air_scenes.cpp
  bench/air_truth.cpp
  bench/chart.cpp
  bench/chart_options.cpp
  bench/chart_scenes.cpp
  bench/energy.cpp
  bench/engines.cpp
  bench/error_run.cpp
  bench/hit_truth.cpp
  bench/our_engine.cpp
  bench/overlap_check.cpp
  bench/results_file.cpp
  bench/scene_box.cpp
  bench/scene_drop.cpp
  bench/scene_flight.cpp
  bench/scene_paddle.cpp
  bench/scene_parts.cpp
  bench/scene_rally.cpp
  bench/scenes_air.cpp
  bench/scenes_simbenchmark.cpp
  bench/time_run.cpp
)
set_target_properties(${PROJECT_NAME}_chart PROPERTIES OUTPUT_NAME chart)
target_include_directories(${PROJECT_NAME}_chart PRIVATE bench test/core src/core)
target_link_libraries(${PROJECT_NAME}_chart PRIVATE ${PROJECT_NAME}_command_line ${PROJECT_NAME}_options)
if(BENCH_PEERS)
  target_compile_definitions(${PROJECT_NAME}_chart PRIVATE BENCH_PEERS)
  target_link_libraries(${PROJECT_NAME}_chart PRIVATE ${PROJECT_NAME}_peers)
endif()
