# The stability map: its situations as a library that tests share, and the program that measures all of them.
add_library(${PROJECT_NAME}_stability STATIC EXCLUDE_FROM_ALL
  bench/stability/plates.cpp
  bench/stability/moving_bodies.cpp
  bench/stability/rest.cpp
  bench/stability/lines.cpp
  bench/stability/features.cpp
  bench/stability/overlap.cpp
  bench/stability/air.cpp
  bench/stability/cases.cpp
  bench/stability/stage.cpp
  bench/stability/stages_corners.cpp
  bench/stability/stages_seams.cpp
  bench/stability/stages_round.cpp
  bench/stability/stages_moving.cpp
  bench/stability/touch.cpp
  bench/stability/launch.cpp
  bench/stability/random_scene.cpp
  bench/stability/play.cpp
  bench/stability/moment.cpp
  bench/stability/contact_law.cpp
  bench/stability/verdict.cpp
  bench/stability/random_checks.cpp
  bench/stability/impulse_agreement.cpp
  bench/stability/random_report.cpp
  bench/stability/watched.cpp
)
target_include_directories(${PROJECT_NAME}_stability PUBLIC . bench src/core)  # testing/, bench, rooms
target_link_libraries(${PROJECT_NAME}_stability PUBLIC ${PROJECT_NAME}_core PRIVATE ${PROJECT_NAME}_options)

add_executable(${PROJECT_NAME}_stability_map EXCLUDE_FROM_ALL
  bench/stability/main.cpp bench/stability/options.cpp bench/stability/random_main.cpp bench/stability/scene_files.cpp)
target_link_libraries(${PROJECT_NAME}_stability_map PRIVATE ${PROJECT_NAME}_stability ${PROJECT_NAME}_command_line ${PROJECT_NAME}_options)
set_target_properties(${PROJECT_NAME}_stability_map PROPERTIES OUTPUT_NAME stability)
if(BENCH)
  set_target_properties(${PROJECT_NAME}_stability ${PROJECT_NAME}_stability_map PROPERTIES EXCLUDE_FROM_ALL FALSE)
endif()
