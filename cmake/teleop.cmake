# Hands on the simulation. The keys and how they move things are plain C++; everything else needs ROS, and the plugins RViz.
add_library(${PROJECT_NAME}_keys STATIC
  src/teleop/assistance.cpp src/teleop/follow.cpp src/teleop/glide.cpp src/teleop/held_keys.cpp src/teleop/key_table.cpp
  src/teleop/play_hand.cpp src/teleop/reach.cpp src/teleop/swing.cpp)
set_target_properties(${PROJECT_NAME}_keys PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_include_directories(${PROJECT_NAME}_keys PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/src)
target_link_libraries(${PROJECT_NAME}_keys PUBLIC Eigen3::Eigen PRIVATE ${PROJECT_NAME}_options)
if(CORE_ONLY)
  return()
endif()

find_package(tf2_ros REQUIRED)
add_library(${PROJECT_NAME}_operator STATIC
  src/teleop/call_deadline.cpp src/teleop/match_desk.cpp src/teleop/operator.cpp src/teleop/operator_keys.cpp src/teleop/paddle_glide.cpp
  src/teleop/paddle_play.cpp src/teleop/selection.cpp src/teleop/sim_link.cpp src/teleop/steady_move.cpp)
set_target_properties(${PROJECT_NAME}_operator PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_include_directories(${PROJECT_NAME}_operator SYSTEM PUBLIC
  ${CATKIN_DEVEL_PREFIX}/include ${catkin_INCLUDE_DIRS} ${tf2_ros_INCLUDE_DIRS})
target_link_libraries(${PROJECT_NAME}_operator
  PUBLIC ${PROJECT_NAME}_keys ${catkin_LIBRARIES} ${tf2_ros_LIBRARIES} PRIVATE ${PROJECT_NAME}_options)
add_dependencies(${PROJECT_NAME}_operator ${PROJECT_NAME}_generate_messages_cpp)

add_executable(${PROJECT_NAME}_teleop src/teleop/teleop_main.cpp src/teleop/terminal.cpp)
set_target_properties(${PROJECT_NAME}_teleop PROPERTIES OUTPUT_NAME teleop)
target_link_libraries(${PROJECT_NAME}_teleop PRIVATE
  ${PROJECT_NAME}_operator ${PROJECT_NAME}_ros ${PROJECT_NAME}_options)
install(TARGETS ${PROJECT_NAME}_teleop RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(PROGRAMS scripts/view scripts/joystick DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})

# For RViz. Without its headers the simulator is built without them.
find_package(rviz QUIET)
find_package(interactive_markers QUIET)
if(NOT rviz_FOUND OR NOT interactive_markers_FOUND)
  message(STATUS "RViz's headers (librviz-dev) not found: handles, and keys, text and light in RViz are not built")
  return()
endif()
add_executable(${PROJECT_NAME}_handles
  src/teleop/ball_throws.cpp src/teleop/handle_markers.cpp src/teleop/handle_menus.cpp src/teleop/handles.cpp
  src/teleop/handles_main.cpp src/teleop/paddle_drag.cpp)
set_target_properties(${PROJECT_NAME}_handles PROPERTIES OUTPUT_NAME handles)
target_include_directories(${PROJECT_NAME}_handles SYSTEM PRIVATE ${interactive_markers_INCLUDE_DIRS})
target_link_libraries(${PROJECT_NAME}_handles PRIVATE
  ${PROJECT_NAME}_operator ${PROJECT_NAME}_core ${PROJECT_NAME}_options ${interactive_markers_LIBRARIES})
install(TARGETS ${PROJECT_NAME}_handles RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})

find_package(pluginlib REQUIRED)
find_package(Qt5 REQUIRED COMPONENTS Widgets)

add_library(${PROJECT_NAME}_rviz SHARED
  src/rviz/hint.cpp
  src/rviz/image_panel.cpp
  src/rviz/key_tool.cpp
  src/rviz/light_display.cpp
  src/rviz/overlay_display.cpp
  src/rviz/overlay_text.cpp
  src/rviz/overlay_topics.cpp
  src/rviz/play_tool.cpp
  src/rviz/score_image.cpp
  src/rviz/score_text.cpp
  src/rviz/shadow_rig.cpp
  src/rviz/text_image.cpp
)
set_target_properties(${PROJECT_NAME}_rviz PROPERTIES AUTOMOC ON)
target_compile_definitions(${PROJECT_NAME}_rviz PRIVATE QT_NO_KEYWORDS)  # ROS uses `signals` and `slots` as names
target_include_directories(${PROJECT_NAME}_rviz SYSTEM PRIVATE ${rviz_INCLUDE_DIRS} ${OGRE_INCLUDE_DIRS})
# A missing symbol shall fail here, not when RViz loads the library.
target_link_options(${PROJECT_NAME}_rviz PRIVATE -Wl,--no-undefined)
target_link_libraries(${PROJECT_NAME}_rviz PRIVATE
  ${PROJECT_NAME}_operator ${PROJECT_NAME}_options
  ${rviz_DEFAULT_PLUGIN_LIBRARIES} ${rviz_LIBRARIES} pluginlib::pluginlib Qt5::Widgets)
install(TARGETS ${PROJECT_NAME}_rviz LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
install(FILES rviz_plugins.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
