# The node, and where everything goes on `install`.
add_library(${PROJECT_NAME}_ros
  src/ros/ball_feed.cpp
  src/ros/ball_markers.cpp
  src/ros/blob_shadows.cpp
  src/ros/soft_shadow.cpp
  src/ros/body_markers.cpp
  src/ros/command_mailbox.cpp
  src/ros/contact_flashes.cpp
  src/ros/conversions.cpp
  src/ros/crowd_message.cpp
  src/ros/job_queue.cpp
  src/ros/launching.cpp
  src/ros/marker_publisher.cpp
  src/ros/node_params.cpp
  src/ros/paddle_control.cpp
  src/ros/pacer.cpp
  src/ros/param_reader.cpp
  src/ros/props.cpp
  src/ros/rally.cpp
  src/ros/rejections.cpp
  src/ros/services.cpp
  src/ros/sim_node.cpp
  src/ros/simulation.cpp
  src/ros/state_messages.cpp
  src/ros/state_publisher.cpp
  src/ros/status_publisher.cpp
  src/ros/trails.cpp
)
# SYSTEM: warnings are for this package's own code, not for generated or foreign headers.
target_include_directories(${PROJECT_NAME}_ros SYSTEM PUBLIC
  ${CATKIN_DEVEL_PREFIX}/include ${catkin_INCLUDE_DIRS})
target_link_libraries(${PROJECT_NAME}_ros
  PUBLIC ${PROJECT_NAME}_core ${catkin_LIBRARIES}
  PRIVATE ${PROJECT_NAME}_options PkgConfig::URDFDOM)
add_dependencies(${PROJECT_NAME}_ros ${PROJECT_NAME}_generate_messages_cpp ${catkin_EXPORTED_TARGETS})

add_executable(${PROJECT_NAME}_node src/ros/main.cpp)
set_target_properties(${PROJECT_NAME}_node PROPERTIES OUTPUT_NAME ping_pong_sim)
target_link_libraries(${PROJECT_NAME}_node PRIVATE ${PROJECT_NAME}_ros ${PROJECT_NAME}_options)

# The example controllers are built and tested like everything else, so that they stay true.
add_executable(${PROJECT_NAME}_bouncer examples/bouncer.cpp)
set_target_properties(${PROJECT_NAME}_bouncer PROPERTIES OUTPUT_NAME bouncer)
target_link_libraries(${PROJECT_NAME}_bouncer PRIVATE ${PROJECT_NAME}_ros ${PROJECT_NAME}_options)
catkin_install_python(PROGRAMS examples/bouncer.py DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})

install(TARGETS ${PROJECT_NAME}_core ${PROJECT_NAME}_ros
  ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  RUNTIME DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION})
install(TARGETS ${PROJECT_NAME}_node ${PROJECT_NAME}_simulate ${PROJECT_NAME}_bouncer
  RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(DIRECTORY include/${PROJECT_NAME}/ DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
install(FILES examples/bouncer.yaml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}/examples)
install(DIRECTORY launch urdf meshes config DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
