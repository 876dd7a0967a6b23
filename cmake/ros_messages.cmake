# Messages, services, and what this package offers to others in a catkin workspace.

# catkin remembers only the paths that exist at the first configuration.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/devel/lib/python3/dist-packages)
find_package(catkin REQUIRED COMPONENTS
  diagnostic_msgs
  diagnostic_updater
  geometry_msgs
  message_generation
  roscpp
  rosgraph_msgs
  std_msgs
  std_srvs
  tf2_msgs
  visualization_msgs
)

add_message_files(FILES
  BallState.msg
  BallStates.msg
  Contact.msg
  Crowd.msg
  HandsState.msg
  PaddleCommand.msg
  PaddleState.msg
  PaddleStates.msg
  Score.msg
  SimStatus.msg
  UmpireCall.msg
)
add_service_files(FILES
  DeleteBall.srv
  Launch.srv
  LoadScene.srv
  NewMatch.srv
  SetBallState.srv
  SetBodyPose.srv
  SpawnBall.srv
  Step.srv
  Toss.srv
)
generate_messages(DEPENDENCIES geometry_msgs std_msgs)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES ${PROJECT_NAME}_core
  CATKIN_DEPENDS geometry_msgs message_runtime std_msgs
  DEPENDS EIGEN3
)
