# The node, and where everything goes on `install`.
add_library(${PROJECT_NAME}_ros
  src/ros/commands/ball_feed.cpp
  src/ros/markers/ball_markers.cpp
  src/ros/markers/blob_shadows.cpp
  src/ros/markers/soft_shadow.cpp
  src/ros/markers/body_markers.cpp
  src/ros/commands/command_mailbox.cpp
  src/ros/markers/contact_flashes.cpp
  src/ros/base/conversions.cpp
  src/ros/state/crowd_message.cpp
  src/ros/base/job_queue.cpp
  src/ros/commands/launching.cpp
  src/ros/markers/marker_publisher.cpp
  src/ros/simulation/node_params.cpp
  src/ros/commands/paddle_control.cpp
  src/ros/base/pacer.cpp
  src/ros/base/param_reader.cpp
  src/ros/simulation/props.cpp
  src/ros/simulation/rally.cpp
  src/ros/simulation/repeat.cpp
  src/ros/base/rejections.cpp
  src/ros/base/scene_path.cpp
  src/ros/node/services.cpp
  src/ros/node/sim_node.cpp
  src/ros/simulation/simulation.cpp
  src/ros/state/state_messages.cpp
  src/ros/state/state_publisher.cpp
  src/ros/state/status_publisher.cpp
  src/ros/markers/trails.cpp
)
target_include_directories(${PROJECT_NAME}_ros PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/src>)
target_include_directories(${PROJECT_NAME}_ros PRIVATE src/core)  # text_input
# SYSTEM: warnings are for this package's own code, not for generated or foreign headers.
target_include_directories(${PROJECT_NAME}_ros SYSTEM PUBLIC
  ${CATKIN_DEVEL_PREFIX}/include ${catkin_INCLUDE_DIRS})
target_link_libraries(${PROJECT_NAME}_ros
  PUBLIC ${PROJECT_NAME}_core ${catkin_LIBRARIES}
  PRIVATE ${PROJECT_NAME}_options PkgConfig::URDFDOM)
add_dependencies(${PROJECT_NAME}_ros ${PROJECT_NAME}_generate_messages_cpp ${catkin_EXPORTED_TARGETS})

add_executable(${PROJECT_NAME}_node src/ros/node/main.cpp)
set_target_properties(${PROJECT_NAME}_node PROPERTIES OUTPUT_NAME ping_pong_sim)
target_link_libraries(${PROJECT_NAME}_node PRIVATE ${PROJECT_NAME}_ros ${PROJECT_NAME}_options)

# The example controllers are built and tested like everything else, so that they stay true.
add_executable(${PROJECT_NAME}_bouncer examples/bouncer.cpp)
set_target_properties(${PROJECT_NAME}_bouncer PROPERTIES OUTPUT_NAME bouncer)
target_link_libraries(${PROJECT_NAME}_bouncer PRIVATE ${PROJECT_NAME}_ros ${PROJECT_NAME}_options)
catkin_install_python(PROGRAMS examples/bouncer.py examples/returner.py DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
# `rosrun` looks through all of the source tree: what catkin left there on the way, executable, would be a second bouncer.py. For
# the same reason the source itself is no executable.
file(REMOVE_RECURSE ${CMAKE_CURRENT_BINARY_DIR}/atomic_configure)

install(TARGETS ${PROJECT_NAME}_core ${PROJECT_NAME}_ros
  ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  RUNTIME DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION})
install(TARGETS ${PROJECT_NAME}_node ${PROJECT_NAME}_simulate ${PROJECT_NAME}_bouncer
  RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(DIRECTORY include/${PROJECT_NAME}/ DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
install(FILES examples/bouncer.yaml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}/examples)
install(DIRECTORY launch urdf meshes config DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
