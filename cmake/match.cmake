# A match: rules, players, headless play; with ROS the nodes `umpire` and `player`.
add_subdirectory(src/game)
add_subdirectory(src/play)
add_subdirectory(src/match)

add_executable(${PROJECT_NAME}_tournament EXCLUDE_FROM_ALL src/apps/tournament.cpp)
set_target_properties(${PROJECT_NAME}_tournament PROPERTIES OUTPUT_NAME tournament)
target_link_libraries(${PROJECT_NAME}_tournament PRIVATE ${PROJECT_NAME}_match ${PROJECT_NAME}_command_line ${PROJECT_NAME}_options)
target_compile_definitions(${PROJECT_NAME}_tournament PRIVATE SCENES_DIR="${CMAKE_CURRENT_SOURCE_DIR}/config/scenes")
add_executable(${PROJECT_NAME}_player_check EXCLUDE_FROM_ALL src/apps/player_check.cpp src/apps/measured_data.cpp)
set_target_properties(${PROJECT_NAME}_player_check PROPERTIES OUTPUT_NAME player_check)
target_link_libraries(${PROJECT_NAME}_player_check PRIVATE
  ${PROJECT_NAME}_play ${PROJECT_NAME}_command_line ${PROJECT_NAME}_options)
if(CORE_ONLY)
  return()
endif()

add_library(${PROJECT_NAME}_match_ros STATIC
  src/ros/match/event_order.cpp
  src/ros/match/plan_markers.cpp
  src/ros/match/player_node.cpp
  src/ros/match/result_file.cpp
  src/ros/match/umpire_messages.cpp
  src/ros/match/umpire_node.cpp
)
target_link_libraries(${PROJECT_NAME}_match_ros PUBLIC
  ${PROJECT_NAME}_match ${PROJECT_NAME}_ros ${PROJECT_NAME}_operator PRIVATE ${PROJECT_NAME}_options)
foreach(name umpire player)
  add_executable(${PROJECT_NAME}_${name} src/ros/match/${name}_main.cpp)
  set_target_properties(${PROJECT_NAME}_${name} PROPERTIES OUTPUT_NAME ${name})
  target_link_libraries(${PROJECT_NAME}_${name} PRIVATE ${PROJECT_NAME}_match_ros ${PROJECT_NAME}_options)
endforeach()
install(TARGETS ${PROJECT_NAME}_umpire ${PROJECT_NAME}_player RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
