# What a crowd costs against the number of its balls: scripts/crowd builds it; with BENCH_PEERS other simulators come along.
add_executable(${PROJECT_NAME}_crowd EXCLUDE_FROM_ALL
  bench/crowd/crowd_options.cpp
  bench/crowd/crowd_run.cpp
  bench/crowd/crowd_scene.cpp
  bench/crowd/main.cpp
  bench/crowd/quiet_time.cpp
  bench/crowd/companion.cpp
  bench/crowd/core_distance.cpp
  bench/crowd/processors.cpp
  bench/crowd/tray_scene.cpp
  bench/engines/engines.cpp
  bench/engines/our_engine.cpp
  bench/chart/results_file.cpp
)
set_target_properties(${PROJECT_NAME}_crowd PROPERTIES OUTPUT_NAME crowd)
target_include_directories(${PROJECT_NAME}_crowd PRIVATE . bench src/core)  # testing/, bench, rooms
target_link_libraries(${PROJECT_NAME}_crowd PRIVATE ${PROJECT_NAME}_command_line ${PROJECT_NAME}_options)
target_compile_definitions(${PROJECT_NAME}_crowd PRIVATE SCENES_DIR="${CMAKE_CURRENT_SOURCE_DIR}/config/scenes")
if(BENCH_PEERS)
  target_compile_definitions(${PROJECT_NAME}_crowd PRIVATE BENCH_PEERS)
  target_link_libraries(${PROJECT_NAME}_crowd PRIVATE ${PROJECT_NAME}_peers)
endif()
