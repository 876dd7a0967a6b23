// Light and shadows in a real RViz: what is seen, and that nothing of it ends RViz.
#include <rviz/SendFilePath.h>

#include <sstream>

#include "ping_pong_sim/SetBallState.h"
#include "rviz_window.h"

using namespace ping_pong_sim;
using sim_test::Inbox;
using sim_test::Picture;
using sim_test::Pixel;
using sim_test::RvizWindow;

namespace
{
constexpr int kLeft = 660, kTop = 110, kWidth = 580, kHeight = 640;  ///< of the view, without the text

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

class Light : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    std::ostringstream text;
    text << std::ifstream(VIEW).rdbuf();
    shipped_ = text.str();
    simulator_ = startSimulator();
    window_ = std::make_unique<RvizWindow>(VIEW);
  }
  static void TearDownTestSuite()
  {
    window_.reset();
    simulator_.reset();
  }
  static std::unique_ptr<sim_test::Child> startSimulator()
  {
    return std::make_unique<sim_test::Child>(std::vector<std::string>{NODE, "__name:=ping_pong_sim"});
  }
  void SetUp() override { ASSERT_TRUE(window_->answers(hands_)); }
  void TearDown() override { EXPECT_TRUE(window_->alive()); }

  // As "Open Config" does.
  static bool load(const std::string& config)
  {
    const std::string path = "/tmp/ping_pong_view." + std::to_string(getpid()) + ".rviz";
    std::ofstream(path) << config;
    rviz::SendFilePath exchange;
    exchange.request.path.data = path;
    const bool loaded = sim_test::ask("/rviz/load_config_discarding_changes", exchange) && exchange.response.success;
    std::remove(path.c_str());
    return loaded;
  }
  static std::string unlit()
  {
    return replaced(shipped_, "    Enabled: true\n    Frame: light", "    Enabled: false\n    Frame: light");
  }
  static void putBall(double x, double y, double z)
  {
    SetBallState::Request request;
    request.pose.position.x = x;
    request.pose.position.y = y;
    request.pose.position.z = z;
    request.pose.orientation.w = 1.0;
    EXPECT_TRUE(sim_test::call<SetBallState>("set_ball_state", request).success);
  }
  // Mean difference of brightness, 0 to 255.
  static double difference(const Picture& a, const Picture& b)
  {
    double sum = 0.0;
    for (int y = kTop; y < kTop + kHeight; ++y)
    {
      for (int x = kLeft; x < kLeft + kWidth; ++x) sum += std::abs(a.at(x, y).brightness() - b.at(x, y).brightness());
    }
    return sum / (kWidth * kHeight);
  }
  // Once two pictures in a row are alike.
  static Picture settled()
  {
    Picture last = Picture::take();
    EXPECT_TRUE(sim_test::eventually(
        [&]
        {
          std::this_thread::sleep_for(std::chrono::milliseconds(300));
          const Picture now = Picture::take();
          const bool same = difference(now, last) < 0.02;
          last = now;
          return same;
        }));
    return last;
  }

  static bool isTable(const Pixel& pixel) { return pixel.b > 100 && pixel.b > 2 * pixel.r; }
  static int tablePixels(const Picture& picture)
  {
    int count = 0;
    for (int y = kTop; y < kTop + kHeight; ++y)
    {
      for (int x = kLeft; x < kLeft + kWidth; ++x) count += isTable(picture.at(x, y)) ? 1 : 0;
    }
    return count;
  }

  // Pixels of the table, seen from above, that a ball over it darkens.
  static int shadowOfABall()
  {
    RvizWindow::type("F3");      // from above
    RvizWindow::mouse(640, 20);  // away from the view: no handles
    putBall(0.5, -3.5, 1.0);
    const Picture without = settled();
    putBall(0.6, -0.2, 1.05);
    const Picture with = settled();
    int shadow = 0;
    for (int y = kTop; y < kTop + kHeight; ++y)
    {
      for (int x = kLeft; x < kLeft + kWidth; ++x)
      {
        const Pixel before = without.at(x, y);
        const Pixel after = with.at(x, y);
        shadow += isTable(before) && after.b > after.r && after.brightness() < 0.8 * before.brightness() ? 1 : 0;
      }
    }
    return shadow;
  }

  static std::string shipped_;
  static std::unique_ptr<sim_test::Child> simulator_;
  static std::unique_ptr<RvizWindow> window_;
  ros::NodeHandle nh_;
  Inbox<HandsState> hands_{nh_, "hands"};
};

std::string Light::shipped_;
std::unique_ptr<sim_test::Child> Light::simulator_;
std::unique_ptr<RvizWindow> Light::window_;
}  // namespace

TEST_F(Light, AShadowIsDarkerThanTheLitTable)
{
  const int shadow = shadowOfABall();
  EXPECT_GT(shadow, 20);
  EXPECT_LT(shadow, 2000);
}

TEST_F(Light, APointLightCastsShadowsToo)
{
  ASSERT_TRUE(load(replaced(shipped_, "Type: Spot", "Type: Point")));
  EXPECT_TRUE(window_->answers(hands_));
  const int shadow = shadowOfABall();
  EXPECT_GT(shadow, 20);
  EXPECT_LT(shadow, 2000);
  ASSERT_TRUE(load(shipped_));
}

TEST_F(Light, SwitchedOffItLeavesRvizAsItWas)
{
  RvizWindow::mouse(640, 20);
  ASSERT_TRUE(load(unlit()));
  const Picture before = settled();
  ASSERT_TRUE(load(shipped_));
  EXPECT_TRUE(sim_test::eventually([&] { return difference(Picture::take(), before) > 3.0; }));
  ASSERT_TRUE(load(unlit()));
  EXPECT_TRUE(sim_test::eventually([&] { return difference(Picture::take(), before) < 0.1; }));
  ASSERT_TRUE(load(shipped_));
}

TEST_F(Light, AMissingFrameTurnsOffTheLightOnly)
{
  ASSERT_TRUE(load(replaced(shipped_, "    Frame: light", "    Frame: nowhere")));
  EXPECT_TRUE(window_->answers(hands_));
  ASSERT_TRUE(load(replaced(shipped_, "Type: Spot", "Type: Directional")));
  EXPECT_TRUE(window_->answers(hands_));
  ASSERT_TRUE(load(replaced(shipped_, "Type: Spot", "Type: Point")));
  EXPECT_TRUE(window_->answers(hands_));
  ASSERT_TRUE(load(shipped_));
}

// The mouse goes over the view meanwhile, for RViz then renders what is under it in a way of its own.
TEST_F(Light, FiftyReloadsDoNoHarm)
{
  for (int i = 0; i < 50 && window_->alive(); ++i)
  {
    ASSERT_TRUE(load(i % 2 == 0 ? unlit() : shipped_)) << i;
    RvizWindow::mouse(500 + 9 * (i % 7), 300 + 11 * (i % 13));
  }
  hands_.clear();
  EXPECT_TRUE(window_->answers(hands_));
}

TEST_F(Light, ASimulatorThatGoesAndComesBackIsTold)
{
  simulator_.reset();
  EXPECT_TRUE(hands_.waitFor([](const HandsState& s) { return s.note == "no simulator"; }));
  simulator_ = startSimulator();
  hands_.clear();
  EXPECT_TRUE(hands_.waitFor([](const HandsState& s) { return s.note.empty(); }));
  hands_.clear();
  EXPECT_TRUE(window_->answers(hands_));
  // Time has jumped back, at which RViz forgets what it was shown.
  RvizWindow::type("F3");
  EXPECT_TRUE(sim_test::eventually([] { return tablePixels(Picture::take()) > 10000; }));
}

// It is there, its connections are, and it answers nobody.
TEST_F(Light, NobodyWaitsForASimulatorThatIsStopped)
{
  simulator_->send(SIGSTOP);
  hands_.clear();
  RvizWindow::type("space");
  EXPECT_TRUE(hands_.waitFor([](const HandsState& s) { return s.note == "the simulator does not answer"; }, 4.0));
  hands_.clear();
  RvizWindow::type("h");
  EXPECT_TRUE(hands_.waitFor([](const HandsState& s) { return s.help; }, 4.0)) << "the keys still work";
  RvizWindow::type("h");
  simulator_->send(SIGCONT);
  hands_.clear();
  EXPECT_TRUE(hands_.waitFor([](const HandsState& s) { return s.note.empty(); }));
  hands_.clear();
  EXPECT_TRUE(window_->answers(hands_));
}

TEST(View, WithoutAScreenItSaysSo)
{
  const std::string view = std::string(VIEW) + "/../../scripts/view";
  const std::string words = sim_test::outputOf("env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM " +
                                               replaced(view, "/view.rviz/../..", "/..") + " 2>&1");
  EXPECT_NE(words.find("DISPLAY is not set"), std::string::npos) << words;
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_light");
}
