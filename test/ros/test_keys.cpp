// Keys sent to the window of a real RViz, and to `teleop`: what they select, move and start.
#include <cstdlib>

#include "ping_pong_sim/Contact.h"
#include "ping_pong_sim/HandsState.h"
#include "ping_pong_sim/PaddleCommand.h"
#include "ping_pong_sim/PaddleStates.h"
#include "rviz_window.h"

using namespace ping_pong_sim;
using sim_test::Inbox;
using sim_test::RvizWindow;

namespace
{
double speedOf(const PaddleState& paddle)
{
  const auto& v = paddle.twist.linear;
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

bool rests(const PaddleStates& states)
{
  return speedOf(states.paddles.at(0)) == 0.0 && states.paddles.at(0).mode == PaddleCommand::HOLD;
}

class Keys : public sim_test::InRviz
{
protected:
  bool select(const std::string& key, const std::string& name)
  {
    hands_.clear();
    RvizWindow::type(key);
    return hands_.waitFor([&](const HandsState& s) { return s.selected == name; });
  }

  Inbox<PaddleStates> paddles_{nh_, "paddles"};
};
}  // namespace

TEST_F(Keys, NumbersSelectAndUnknownOnesSaySo)
{
  EXPECT_TRUE(select("1", "ball_1"));  // the newest first
  EXPECT_TRUE(select("1", "ball_0"));
  EXPECT_TRUE(select("4", "light"));
  EXPECT_TRUE(select("6", "camera"));
  EXPECT_TRUE(select("5", "paddle"));
  hands_.clear();
  RvizWindow::type("9");
  EXPECT_TRUE(hands_.waitFor([](const HandsState& s) { return !s.note.empty(); }));
  RvizWindow::type("3");  // there are no walls here
  EXPECT_TRUE(hands_.waitFor([](const HandsState& s) { return s.note == "this scene has none of these"; }));
}

TEST_F(Keys, ThePaddleIsAcceleratedHitsTheBallAndComesToRest)
{
  Inbox<Contact> contacts(nh_, "contacts");
  ASSERT_TRUE(select("5", "paddle"));
  ASSERT_TRUE(sim_test::eventually([&] { return contacts.connected(); }));
  RvizWindow::tool("keydown w");
  EXPECT_TRUE(contacts.waitFor([](const Contact& c) { return c.other == "paddle" && c.ball == 0; }));
  RvizWindow::tool("keyup w");
  EXPECT_GT(contacts.last().velocity_after.x, 0.5);
  paddles_.clear();
  EXPECT_TRUE(paddles_.waitFor(rests));
  // It glided: it was still moving some ticks after the release, more slowly with each.
  const std::vector<PaddleStates> way = paddles_.all();
  for (std::size_t i = way.size() / 2; i + 1 < way.size(); ++i)
  {
    EXPECT_LE(speedOf(way[i + 1].paddles[0]), speedOf(way[i].paddles[0]) + 1e-9);
  }
}

TEST_F(Keys, HeldTogetherTheyCombine)
{
  ASSERT_TRUE(select("5", "paddle"));
  paddles_.clear();
  RvizWindow::tool("keydown s keydown q keydown v");
  EXPECT_TRUE(paddles_.waitFor(
      [](const PaddleStates& s)
      {
        const geometry_msgs::Twist& twist = s.paddles.at(0).twist;
        return twist.linear.x < -0.1 && twist.linear.z > 0.1 && twist.angular.z > 0.1;
      }));
  RvizWindow::tool("keyup s keyup q keyup v");
}

TEST_F(Keys, AViewThatLosesTheKeyboardLetsGo)
{
  ASSERT_TRUE(select("5", "paddle"));
  paddles_.clear();
  RvizWindow::tool("keydown s");
  ASSERT_TRUE(paddles_.waitFor([](const PaddleStates& s) { return speedOf(s.paddles.at(0)) > 0.3; }));
  RvizWindow::mouse(606, 42);  // a dialog takes the keyboard while the key is still down
  RvizWindow::tool("click 1");
  paddles_.clear();
  EXPECT_TRUE(paddles_.waitFor(rests, 2.5)) << "before a key held for ever would be given up";
  RvizWindow::tool("keyup s");
  RvizWindow::type("Escape");
}

TEST_F(Keys, OtherThingsMoveSteadily)
{
  for (const auto& [key, name] : {std::pair<std::string, std::string>{"2", "table"}, {"4", "light"}, {"1", "ball_1"}})
  {
    const double y = frames_.at(name).transform.translation.y;
    ASSERT_TRUE(select(key, name));
    RvizWindow::tool("keydown a");
    EXPECT_TRUE(sim_test::eventually([&] { return frames_.at(name).transform.translation.y > y + 0.1; })) << name;
    RvizWindow::tool("keyup a");
  }
}

TEST_F(Keys, PauseStepResetLaunch)
{
  Inbox<SimStatus> status(nh_, "status");
  RvizWindow::type("space");
  ASSERT_TRUE(status.waitFor([](const SimStatus& s) { return s.paused; }));
  const double time = status.last().time;
  RvizWindow::type("n");
  EXPECT_TRUE(status.waitFor([=](const SimStatus& s) { return std::abs(s.time - time - 0.01) < 1e-9; }));
  RvizWindow::type("Return");
  EXPECT_TRUE(status.waitFor([](const SimStatus& s) { return s.balls == 3; }));
  RvizWindow::type("BackSpace");
  EXPECT_TRUE(status.waitFor([](const SimStatus& s) { return s.balls == 2 && s.time == 0.0; }));
  status.clear();
  RvizWindow::type("space");
  EXPECT_TRUE(status.waitFor([](const SimStatus& s) { return !s.paused; }));
}

TEST_F(Keys, TheTextIsOnTheScreenAndHShowsTheKeys)
{
  const auto bright_in_corner = []
  {
    return sim_test::Picture::take().count(26, 72, 600, 500,
                                           [](const sim_test::Pixel& p) { return p.brightness() > 150; });
  };
  EXPECT_TRUE(sim_test::eventually([&] { return bright_in_corner() > 300; }));
  const int without_help = bright_in_corner();
  RvizWindow::type("h");
  EXPECT_TRUE(sim_test::eventually([&] { return bright_in_corner() > without_help + 1000; }));
  RvizWindow::type("h");
  EXPECT_TRUE(sim_test::eventually([&] { return bright_in_corner() < without_help + 500; }));
}

TEST_F(Keys, FromKeyToMotionInTfItTakesLessThanAFrame)
{
  ASSERT_TRUE(select("5", "paddle"));
  std::vector<double> delays;
  for (int i = 0; i < 10; ++i)
  {
    paddles_.clear();
    const double start = sim_test::wallNow();
    RvizWindow::tool("keydown s");
    ASSERT_TRUE(paddles_.waitFor([](const PaddleStates& s) { return speedOf(s.paddles.at(0)) > 0.05; }));
    delays.push_back(sim_test::wallNow() - start);
    RvizWindow::tool("keyup s");
    paddles_.clear();
    ASSERT_TRUE(paddles_.waitFor(rests));
  }
  std::sort(delays.begin(), delays.end());
  std::printf("key to paddle, xdotool's own start included: median %.1f ms, most %.1f ms\n", 1e3 * delays[5],
              1e3 * delays[9]);
  if (sim_test::machineIsBusy()) GTEST_SKIP() << "the machine has other things to do";
  EXPECT_LT(delays[5], 0.1);
}

TEST_F(Keys, ATerminalDoesTheSameAndTwoOperatorsAreTold)
{
  FILE* terminal = popen(TELEOP, "w");
  const auto type = [&](const std::string& keys)
  {
    std::fputs(keys.c_str(), terminal);
    std::fflush(terminal);
  };
  const auto by_terminal = [](const HandsState& s) { return s.operator_name == "/teleop"; };
  ASSERT_TRUE(hands_.waitFor([&](const HandsState& s) { return by_terminal(s) && s.selected == "paddle"; }));
  ASSERT_TRUE(select("5", "paddle"));

  paddles_.clear();
  RvizWindow::tool("keydown s");
  const auto both = [](const HandsState& s) { return s.note.find("also moved by") != std::string::npos; };
  EXPECT_TRUE(sim_test::eventually(
      [&]
      {
        type("s");
        return hands_.waitFor(both, 0.05);
      }));
  RvizWindow::tool("keyup s");
  // Nobody says that a terminal's key was let go: it ends by itself.
  paddles_.clear();
  EXPECT_TRUE(paddles_.waitFor(rests));

  hands_.clear();
  type("2");
  EXPECT_TRUE(hands_.waitFor([&](const HandsState& s) { return by_terminal(s) && s.selected == "table"; }));
  pclose(terminal);  // the end of its input ends it
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_keys");
}
