# The work-precision chart: scripts/chart and the tests build it. It needs nothing but the physics; with BENCH_PEERS other
# simulators come along.
add_executable(${PROJECT_NAME}_chart EXCLUDE_FROM_ALL
  bench/chart/scenes/air_scenes.cpp
  bench/chart/scenes/air_truth.cpp
  bench/chart/chart.cpp
  bench/chart/chart_options.cpp
  bench/chart/scenes/chart_scenes.cpp
  bench/chart/energy.cpp
  bench/engines/engines.cpp
  bench/chart/error_run.cpp
  bench/chart/scenes/hit_truth.cpp
  bench/engines/our_engine.cpp
  bench/chart/overlap_check.cpp
  bench/chart/results_file.cpp
  bench/chart/scenes/scene_box.cpp
  bench/chart/scenes/scene_drop.cpp
  bench/chart/scenes/scene_flight.cpp
  bench/chart/scenes/scene_paddle.cpp
  bench/chart/scenes/scene_parts.cpp
  bench/chart/scenes/scene_rally.cpp
  bench/chart/scenes/scenes_air.cpp
  bench/chart/scenes/scenes_simbenchmark.cpp
  bench/chart/time_run.cpp
)
set_target_properties(${PROJECT_NAME}_chart PROPERTIES OUTPUT_NAME chart)
target_include_directories(${PROJECT_NAME}_chart PRIVATE . bench src/core)  # testing/, bench, rooms
target_link_libraries(${PROJECT_NAME}_chart PRIVATE ${PROJECT_NAME}_command_line ${PROJECT_NAME}_options)
if(BENCH_PEERS)
  target_compile_definitions(${PROJECT_NAME}_chart PRIVATE BENCH_PEERS)
  target_link_libraries(${PROJECT_NAME}_chart PRIVATE ${PROJECT_NAME}_peers)
endif()
