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
add_executable(${PROJECT_NAME}_hashes EXCLUDE_FROM_ALL test/core/hashes.cpp)
target_link_libraries(${PROJECT_NAME}_hashes PRIVATE ${PROJECT_NAME}_core ${PROJECT_NAME}_options)
add_executable(${PROJECT_NAME}_hashes_O1 EXCLUDE_FROM_ALL test/core/hashes.cpp)
target_link_libraries(${PROJECT_NAME}_hashes_O1 PRIVATE ${PROJECT_NAME}_counting ${PROJECT_NAME}_options)

# One executable per file of test/core: test_NAME.cpp -> test NAME.
function(add_core_test name)
  set(target ${PROJECT_NAME}_test_${name})
  if(CORE_ONLY)
    add_executable(${target} test/core/test_${name}.cpp)
    target_link_libraries(${target} GTest::GTest GTest::Main)
    add_test(NAME ${name} COMMAND ${target})
  else()
    catkin_add_gtest(${target} test/core/test_${name}.cpp)
    target_link_libraries(${target} gtest_main)
  endif()
  target_link_libraries(${target} ${PROJECT_NAME}_core ${PROJECT_NAME}_options)
  target_include_directories(${target} PRIVATE test/core src/core)
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

foreach(name
    scene_loader
    shipped_scenes
    urdf_loader
    simulate
    command_line
    progress
    bench_options
    command_file
    paddle_drive
    paddle_blocking
    start_motion
    world_copy
    architecture
    choose_method
    flight
    ladder
    allocations
    pooled
    bouncing
    large_numbers
    tunnelling
    million_hits
    air_contacts
    many_balls
    cradle
    corner
    same_bits
    bounce_run
    crowds
    gas
    state_hash
    threads
    slabs
    batches
    workers
    islands
    impulse
    contact_list
    solver_seams
    solver_squeeze
    handover
    edges
    grazing
    resting
    contact_modes
    carried_ball
    seams
    over_the_edge
    squeeze
    stability
    random_contacts
    air
    friction
    properties
    validation
    shots
    quiet_time
    keys
)
  add_core_test(${name})
endforeach()

# What single tests need besides: a test is built with no more than it uses.
foreach(name cradle random_contacts stability tunnelling)
  target_link_libraries(${PROJECT_NAME}_test_${name} ${PROJECT_NAME}_stability)
endforeach()
target_link_libraries(${PROJECT_NAME}_test_keys ${PROJECT_NAME}_keys)
add_dependencies(${PROJECT_NAME}_test_simulate ${PROJECT_NAME}_simulate)
add_dependencies(${PROJECT_NAME}_test_validation ${PROJECT_NAME}_validate)

foreach(name allocations pooled)
  target_sources(${PROJECT_NAME}_test_${name} PRIVATE test/core/allocations.cpp)
endforeach()

target_sources(${PROJECT_NAME}_test_command_file PRIVATE src/apps/command_file.cpp src/apps/line_reader.cpp)
foreach(name command_line progress bench_options)
  target_link_libraries(${PROJECT_NAME}_test_${name} ${PROJECT_NAME}_command_line)
endforeach()
target_sources(${PROJECT_NAME}_test_bench_options PRIVATE bench/chart_options.cpp bench/crowd/crowd_options.cpp bench/stability/options.cpp)
target_include_directories(${PROJECT_NAME}_test_bench_options PRIVATE bench)
target_sources(${PROJECT_NAME}_test_quiet_time PRIVATE bench/crowd/quiet_time.cpp)
target_include_directories(${PROJECT_NAME}_test_quiet_time PRIVATE bench/crowd)

add_core_test(chart)
add_dependencies(${PROJECT_NAME}_test_chart ${PROJECT_NAME}_chart)
add_dependencies(${PROJECT_NAME}_test_same_bits ${PROJECT_NAME}_hashes ${PROJECT_NAME}_hashes_O1)

set(counting_test ${PROJECT_NAME}_test_pay_for_what_you_name)
if(CORE_ONLY)
  add_executable(${counting_test} test/core/test_pay_for_what_you_name.cpp)
  target_link_libraries(${counting_test} GTest::GTest GTest::Main)
  add_test(NAME pay_for_what_you_name COMMAND ${counting_test})
else()
  catkin_add_gtest(${counting_test} test/core/test_pay_for_what_you_name.cpp)
  target_link_libraries(${counting_test} gtest_main)
endif()
target_link_libraries(${counting_test} ${PROJECT_NAME}_counting ${PROJECT_NAME}_options)

if(NOT CORE_ONLY)
  include(cmake/ros_tests.cmake)
endif()
