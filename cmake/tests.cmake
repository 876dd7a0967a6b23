# gtest without ROS (test/core), and with ROS also rostest (test/ros).
if(CORE_ONLY)
  include(CTest)
  if(NOT BUILD_TESTING)
    return()
  endif()
  find_package(GTest REQUIRED)
elseif(NOT CATKIN_ENABLE_TESTING)
  return()
endif()

# The physics once more, counting the evaluations of each law, and optimised little: the libraries know nothing of it.
add_library(${PROJECT_NAME}_counting STATIC EXCLUDE_FROM_ALL ${${PROJECT_NAME}_physics})
target_compile_definitions(${PROJECT_NAME}_counting PUBLIC PING_PONG_SIM_COUNT)
target_include_directories(${PROJECT_NAME}_counting PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/include src/core)
target_link_libraries(${PROJECT_NAME}_counting PUBLIC Eigen3::Eigen PRIVATE ${PROJECT_NAME}_options Threads::Threads)
target_compile_options(${PROJECT_NAME}_counting PRIVATE -O1)

# Hashes of the results of either build, compared by a test.
add_executable(${PROJECT_NAME}_hashes EXCLUDE_FROM_ALL test/core/world/hashes.cpp)
target_include_directories(${PROJECT_NAME}_hashes PRIVATE .)
target_link_libraries(${PROJECT_NAME}_hashes PRIVATE ${PROJECT_NAME}_core ${PROJECT_NAME}_options)
add_executable(${PROJECT_NAME}_hashes_O1 EXCLUDE_FROM_ALL test/core/world/hashes.cpp)
target_include_directories(${PROJECT_NAME}_hashes_O1 PRIVATE .)
target_link_libraries(${PROJECT_NAME}_hashes_O1 PRIVATE ${PROJECT_NAME}_counting ${PROJECT_NAME}_options)

# gtests of a room: test/core/ROOM/test_NAME.cpp -> test NAME.
function(add_core_tests room)
  foreach(name ${ARGN})
    add_core_test(${name} test/core/${room}/test_${name}.cpp ${PROJECT_NAME}_core)
  endforeach()
endfunction()

function(add_core_test name file core)
  set(target ${PROJECT_NAME}_test_${name})
  if(CORE_ONLY)
    add_executable(${target} ${file})
    target_link_libraries(${target} GTest::GTest GTest::Main)
    add_test(NAME ${name} COMMAND ${target})
  else()
    catkin_add_gtest(${target} ${file})
    target_link_libraries(${target} gtest_main)
  endif()
  target_link_libraries(${target} ${core} ${PROJECT_NAME}_options)
  target_include_directories(${target} PRIVATE . src src/core)  # testing/, apps and teleop, rooms
  target_compile_definitions(${target} PRIVATE
    SCENES_DIR="${CMAKE_CURRENT_SOURCE_DIR}/config/scenes"
    COMMANDS_DIR="${CMAKE_CURRENT_SOURCE_DIR}/config/commands"
    URDF_DIR="${CMAKE_CURRENT_SOURCE_DIR}/urdf"
    SIMULATE="$<TARGET_FILE:${PROJECT_NAME}_simulate>"
    VALIDATE="$<TARGET_FILE:${PROJECT_NAME}_validate>"
    CHART="$<TARGET_FILE:${PROJECT_NAME}_chart>"
    SOURCE_DIR="${CMAKE_CURRENT_SOURCE_DIR}"
    DATA_DIR="${CMAKE_CURRENT_SOURCE_DIR}/test/data"
    HASHES="$<TARGET_FILE:${PROJECT_NAME}_hashes>"
    HASHES_O1="$<TARGET_FILE:${PROJECT_NAME}_hashes_O1>"
    CORE_LIBRARY="$<TARGET_FILE:${PROJECT_NAME}_core>")
endfunction()

add_core_tests(base pooled workers)
add_core_tests(evolve air flight ladder large_numbers)
add_core_tests(resolve friction)
add_core_tests(detect air_contacts edges grazing million_hits tunnelling)
add_core_tests(paddle paddle_blocking paddle_drive start_motion)
add_core_tests(scene scene_loader shipped_scenes shots urdf_loader)
add_core_tests(resting carried_ball contact_modes over_the_edge resting seams)
add_core_tests(solver batches impulse slabs solver_seams solver_squeeze)
add_core_tests(events bounce_run bouncing corner cradle many_balls squeeze)
add_core_tests(windows crowds gas handover islands threads)
add_core_tests(methods choose_method random_contacts stability)
add_core_tests(world allocations contact_list properties same_bits state_hash world_copy)
add_core_tests(apps command_file command_line progress simulate validation)
add_core_tests(bench bench_options chart quiet_time)
add_core_tests(teleop keys mouse)
add_core_tests(game score umpire umpire_flown umpire_match umpire_service umpire_trouble umpire_world)
add_core_tests(play player racket_path shot_to_target stroke_inversion)
add_core_tests(match event_order headless_match result_file)
add_core_test(architecture test/core/test_architecture.cpp ${PROJECT_NAME}_core)
add_core_test(pay_for_what_you_name test/core/world/test_pay_for_what_you_name.cpp ${PROJECT_NAME}_counting)

# Every public header compiles alone, with std and Eigen.
file(GLOB public_headers CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/include include/${PROJECT_NAME}/*.h)
foreach(header ${public_headers})
  string(MAKE_C_IDENTIFIER ${header} unit)
  set(file ${CMAKE_BINARY_DIR}/public_headers/${unit}.cpp)
  file(GENERATE OUTPUT ${file} CONTENT "#include \"${header}\"\n")
  list(APPEND header_units ${file})
endforeach()
add_library(${PROJECT_NAME}_public_headers OBJECT EXCLUDE_FROM_ALL ${header_units})
target_include_directories(${PROJECT_NAME}_public_headers PRIVATE include)
target_link_libraries(${PROJECT_NAME}_public_headers PRIVATE Eigen3::Eigen ${PROJECT_NAME}_options)
add_dependencies(${PROJECT_NAME}_test_architecture ${PROJECT_NAME}_public_headers)

# What single tests need besides: a test is built with no more than it uses.
foreach(name cradle random_contacts stability tunnelling)
  target_link_libraries(${PROJECT_NAME}_test_${name} ${PROJECT_NAME}_stability)
endforeach()
foreach(name keys mouse)
  target_link_libraries(${PROJECT_NAME}_test_${name} ${PROJECT_NAME}_keys)
endforeach()
foreach(name score umpire umpire_flown umpire_match umpire_service umpire_trouble umpire_world)
  target_link_libraries(${PROJECT_NAME}_test_${name} ${PROJECT_NAME}_game)
endforeach()
foreach(name player racket_path shot_to_target stroke_inversion)
  target_link_libraries(${PROJECT_NAME}_test_${name} ${PROJECT_NAME}_play)
endforeach()
target_link_libraries(${PROJECT_NAME}_test_headless_match ${PROJECT_NAME}_match)
target_sources(${PROJECT_NAME}_test_event_order PRIVATE src/ros/match/event_order.cpp)
target_sources(${PROJECT_NAME}_test_result_file PRIVATE src/ros/match/result_file.cpp)
target_link_libraries(${PROJECT_NAME}_test_result_file ${PROJECT_NAME}_game)
add_dependencies(${PROJECT_NAME}_test_simulate ${PROJECT_NAME}_simulate)
add_dependencies(${PROJECT_NAME}_test_validation ${PROJECT_NAME}_validate)

foreach(name allocations pooled)
  target_sources(${PROJECT_NAME}_test_${name} PRIVATE testing/allocations.cpp)
endforeach()

target_sources(${PROJECT_NAME}_test_command_file PRIVATE src/apps/command_file.cpp src/apps/line_reader.cpp)
foreach(name command_line progress bench_options)
  target_link_libraries(${PROJECT_NAME}_test_${name} ${PROJECT_NAME}_command_line)
endforeach()
target_sources(${PROJECT_NAME}_test_bench_options PRIVATE bench/chart/chart_options.cpp bench/crowd/crowd_options.cpp bench/stability/options.cpp)
target_include_directories(${PROJECT_NAME}_test_bench_options PRIVATE bench)
target_sources(${PROJECT_NAME}_test_quiet_time PRIVATE bench/crowd/quiet_time.cpp)
target_include_directories(${PROJECT_NAME}_test_quiet_time PRIVATE bench)

add_dependencies(${PROJECT_NAME}_test_chart ${PROJECT_NAME}_chart)
add_dependencies(${PROJECT_NAME}_test_same_bits ${PROJECT_NAME}_hashes ${PROJECT_NAME}_hashes_O1)

if(NOT CORE_ONLY)
  include(cmake/ros_tests.cmake)
endif()
