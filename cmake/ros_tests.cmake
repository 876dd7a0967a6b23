# rostest: one behaviour per file. test/ros/NAME.test runs the gtest of test/ros/test_NAME.cpp beside a simulator.
find_package(rostest REQUIRED)
find_package(tf2_ros REQUIRED)

# NAME is unique over all .test files: results are written under it.
function(add_ros_test name)
  set(target ${PROJECT_NAME}_test_ros_${name})
  add_rostest_gtest(${target} test/ros/${name}.test test/ros/test_${name}.cpp)
  target_include_directories(${target} SYSTEM PRIVATE ${tf2_ros_INCLUDE_DIRS})
  target_link_libraries(${target} ${PROJECT_NAME}_ros ${PROJECT_NAME}_options ${tf2_ros_LIBRARIES})
  target_compile_definitions(${target} PRIVATE
    SCENES="${CMAKE_CURRENT_SOURCE_DIR}/config/scenes"
    TEST_SCENES="${CMAKE_CURRENT_SOURCE_DIR}/test/ros/data"
    NODE="$<TARGET_FILE:${PROJECT_NAME}_node>"
    TELEOP="$<TARGET_FILE:${PROJECT_NAME}_teleop>"
    VIEW="${CMAKE_CURRENT_SOURCE_DIR}/config/view.rviz")
  add_dependencies(${target} ${PROJECT_NAME}_node ${PROJECT_NAME}_teleop ${PROJECT_NAME}_umpire ${PROJECT_NAME}_player)
endfunction()

foreach(name
    clock
    command
    contacts
    crowd
    examples
    flat_out
    latency
    match
    launch
    feed
    parameters
    real_time
    refusals
    repeat
    scene_switching
    services
    stale_command
    start_motion
)
  add_ros_test(${name})
endforeach()

# In a real RViz on a screen in memory.
if(TARGET ${PROJECT_NAME}_rviz)
  foreach(name keys dragging light play_tool)
    add_ros_test(${name})
    add_dependencies(${PROJECT_NAME}_test_ros_${name} ${PROJECT_NAME}_rviz ${PROJECT_NAME}_handles)
  endforeach()
endif()
