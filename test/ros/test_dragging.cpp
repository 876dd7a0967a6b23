// Handles dragged with the mouse in a real RViz.
#include <visualization_msgs/InteractiveMarkerUpdate.h>

#include "ping_pong_sim/BallStates.h"
#include "ping_pong_sim/Contact.h"
#include "ping_pong_sim/PaddleStates.h"
#include "ping_pong_sim/SetBallState.h"
#include "ping_pong_sim/SetBodyPose.h"
#include "rviz_window.h"

using namespace ping_pong_sim;
using sim_test::Inbox;
using sim_test::RvizWindow;

namespace
{
// What the player's view (F1) looks at is in the middle of the 3D view; it looks along +x, so right is -y.
constexpr int kMiddleX = 640, kMiddleY = 416;
constexpr double kFocusX = -0.2, kFocusZ = 0.7;

class Dragging : public sim_test::InRviz
{
protected:
  // Handles show while RViz's own tool is active, and only then.
  void SetUp() override
  {
    InRviz::SetUp();
    RvizWindow::type("i");
  }
  void TearDown() override
  {
    RvizWindow::type("k");
    InRviz::TearDown();
  }
  // Waits until its handle is there too.
  void putBody(const std::string& name, double x, double y)
  {
    SetBodyPose::Request request;
    request.body = name;
    request.pose.position.x = x;
    request.pose.position.y = y;
    request.pose.position.z = kFocusZ;
    request.pose.orientation.w = 1.0;
    handles_.clear();
    EXPECT_TRUE(sim_test::call<SetBodyPose>("set_body_pose", request).success);
    waitForHandle(name, x);
  }
  // Out of the picture's middle.
  void clearMiddle()
  {
    static double y = 2.0;
    y += 0.1;  // another place each time: a handle that is there already is not told again
    putBody("paddle", -1.0, y);
    EXPECT_TRUE(putBall(0, 0.0, -2.0, 1.0).success);
  }
  static SetBallState::Response putBall(unsigned id, double x, double y, double z)
  {
    SetBallState::Request request;
    request.id = id;
    request.pose.position.x = x;
    request.pose.position.y = y;
    request.pose.position.z = z;
    request.pose.orientation.w = 1.0;
    return sim_test::call<SetBallState>("set_ball_state", request);
  }
  void waitForHandle(const std::string& name, double x)
  {
    EXPECT_TRUE(handles_.waitFor(
        [&](const visualization_msgs::InteractiveMarkerUpdate& update)
        {
          for (const auto& handle : update.markers)
          {
            if (handle.name == name && std::abs(handle.pose.position.x - x) < 2e-3) return true;
          }
          for (const auto& pose : update.poses)
          {
            if (pose.name == name && std::abs(pose.pose.position.x - x) < 2e-3) return true;
          }
          return false;
        }))
        << name;
  }

  Inbox<visualization_msgs::InteractiveMarkerUpdate> handles_{nh_, "handles/update"};
};
}  // namespace

TEST_F(Dragging, ADraggedPaddleMovesWithAVelocityAndHits)
{
  Inbox<PaddleStates> paddles(nh_, "paddles");
  Inbox<Contact> contacts(nh_, "contacts");
  ASSERT_TRUE(sim_test::eventually([&] { return contacts.connected() && paddles.connected(); }));
  putBody("paddle", kFocusX, 0.0);
  ASSERT_TRUE(putBall(0, kFocusX, -0.22, kFocusZ).success);  // in the way of its edge
  paddles.clear();
  RvizWindow::drag(kMiddleX, kMiddleY, kMiddleX + 120, kMiddleY);
  EXPECT_TRUE(contacts.waitFor([](const Contact& c) { return c.ball == 0 && c.other == "paddle"; }));
  EXPECT_TRUE(paddles.waitFor([](const PaddleStates& s) { return s.paddles[0].pose.position.y < -0.15; }));
  const std::vector<PaddleStates> way = paddles.all();
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
  {
    const auto& from = way[i].paddles[0].pose.position;
    const auto& to = way[i + 1].paddles[0].pose.position;
    EXPECT_LT(std::abs(to.y - from.y), 0.06) << "no jump: at most 6 m/s";
  }
}

TEST_F(Dragging, ADraggedTableIsFollowedByTf)
{
  clearMiddle();
  putBody("table", kFocusX, 0.0);
  RvizWindow::drag(kMiddleX, kMiddleY, kMiddleX, kMiddleY - 60);
  EXPECT_TRUE(sim_test::eventually([&] { return frames_.at("table").transform.translation.z > kFocusZ + 0.05; }));
}

TEST_F(Dragging, ABallStartsFromWhereItIsLetGo)
{
  clearMiddle();
  handles_.clear();
  ASSERT_TRUE(putBall(1, kFocusX, 0.0, kFocusZ).success);
  waitForHandle("ball_1", kFocusX);
  RvizWindow::drag(kMiddleX, kMiddleY, kMiddleX - 90, kMiddleY);
  EXPECT_TRUE(sim_test::eventually([&] { return frames_.at("ball_1").transform.translation.y > 0.1; }));
  Inbox<BallStates> balls(nh_, "balls");
  ASSERT_TRUE(balls.waitForCount(20));
  EXPECT_EQ(balls.last().balls.at(1).twist.linear.y, 0.0);
}

TEST_F(Dragging, ABeadThrowsTheBallOfAPausedWorld)
{
  clearMiddle();
  sim_test::pause(true);
  handles_.clear();
  ASSERT_TRUE(putBall(1, kFocusX, 0.0, kFocusZ - 0.08).success);  // so its bead is in the middle
  waitForHandle("throw_1", kFocusX);
  RvizWindow::drag(kMiddleX, kMiddleY, kMiddleX - 60, kMiddleY);
  Inbox<BallStates> balls(nh_, "balls");
  EXPECT_TRUE(balls.waitFor([](const BallStates& b) { return b.balls.at(1).twist.linear.y > 0.3; }));
}

TEST_F(Dragging, TheMenuPauses)
{
  Inbox<SimStatus> status(nh_, "status");
  clearMiddle();
  putBody("table", kFocusX, 0.0);
  RvizWindow::mouse(kMiddleX - 3, kMiddleY);
  RvizWindow::mouse(kMiddleX, kMiddleY);
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  RvizWindow::tool("click 3");
  status.clear();
  EXPECT_TRUE(sim_test::eventually(
      [&]
      {
        RvizWindow::tool("key Down key Return");  // its first line
        return status.waitFor([](const SimStatus& s) { return s.paused; }, 0.7);
      }));
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_dragging");
}
