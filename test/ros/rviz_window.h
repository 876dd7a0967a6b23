// A real RViz on a screen in memory, with keys, mouse and pictures.
#pragma once

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "ping_pong_sim/HandsState.h"
#include "sim_client.h"

namespace sim_test
{
/// A program that never outlives the test.
class Child
{
public:
  explicit Child(const std::vector<std::string>& command)
  {
    pid_ = fork();
    if (pid_ != 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  ~Child()
  {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  bool alive() const { return waitpid(pid_, nullptr, WNOHANG) == 0; }
  void send(int signal) const { kill(pid_, signal); }

private:
  pid_t pid_;
};

inline std::string outputOf(const std::string& command)
{
  std::string output;
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 65536> part{};
  for (std::size_t n; (n = fread(part.data(), 1, part.size(), pipe)) > 0;) output.append(part.data(), n);
  pclose(pipe);
  return output;
}

struct Pixel
{
  int r = 0, g = 0, b = 0;
  double brightness() const { return 0.30 * r + 0.59 * g + 0.11 * b; }
};

class Picture
{
public:
  /// Of the whole screen.
  static Picture take()
  {
    Picture picture;
    const std::string ppm = outputOf("import -silent -window root -depth 8 ppm:- 2>/dev/null");
    int start = 0;
    if (std::sscanf(ppm.c_str(), "P6 %d %d 255%n", &picture.width_, &picture.height_, &start) < 2) return {};
    picture.bytes_ = ppm.substr(static_cast<std::size_t>(start) + 1);
    return picture;
  }
  Pixel at(int x, int y) const
  {
    const auto i = static_cast<std::size_t>(3 * (y * width_ + x));
    if (x < 0 || y < 0 || x >= width_ || y >= height_ || i + 2 >= bytes_.size()) return {};
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(bytes_[i + k]); };
    return {byte(0), byte(1), byte(2)};
  }
  int count(int left, int top, int width, int height, const std::function<bool(const Pixel&)>& wanted) const
  {
    int found = 0;
    for (int y = top; y < top + height; ++y)
    {
      for (int x = left; x < left + width; ++x) found += wanted(at(x, y)) ? 1 : 0;
    }
    return found;
  }

private:
  int width_ = 0, height_ = 0;
  std::string bytes_;
};

/// Screen and window of 1280 x 800. DISPLAY is set for this process, so for xdotool and import too.
class RvizWindow
{
public:
  explicit RvizWindow(const std::string& config)
  {
    const std::string name = "/tmp/ping_pong_screen." + std::to_string(getpid());
    screen_ = std::make_unique<Child>(std::vector<std::string>{
        "sh", "-c", "exec Xvfb -displayfd 1 -screen 0 1280x800x24 -noreset -nolisten tcp > " + name + " 2>/dev/null"});
    EXPECT_TRUE(eventually([&] { return !(std::ifstream(name) >> number_).fail(); })) << "no Xvfb";
    std::remove(name.c_str());
    setenv("DISPLAY", (":" + std::to_string(number_)).c_str(), 1);
    EXPECT_TRUE(eventually([] { return std::system("xwininfo -root > /dev/null 2>&1") == 0; })) << "no screen";
    rviz_ = std::make_unique<Child>(
        std::vector<std::string>{"/usr/lib/rviz/rviz", "-d", config, "--disable-anti-aliasing", "__name:=rviz"});
  }
  bool alive() const { return rviz_->alive(); }

  /// True once keys are answered: the window is there, and the mouse is over its view.
  bool answers(Inbox<ping_pong_sim::HandsState>& hands, double deadline = 40.0)
  {
    const auto answer = [&]
    {
      if (!alive()) return true;
      mouse(640, 500);
      mouse(641, 500);
      type("2");
      return hands.waitFor([](const ping_pong_sim::HandsState& s) { return s.selected == "table"; }, 0.5);
    };
    return eventually(answer, deadline) && alive();
  }

  static void tool(const std::string& command)
  {
    EXPECT_EQ(std::system(("xdotool " + command + " > /dev/null 2>&1").c_str()), 0) << command;
  }
  /// Left button down at the first point, up at the second.
  static void drag(int x0, int y0, int x1, int y1)
  {
    mouse(x0 - 3, y0);
    mouse(x0, y0);
    std::this_thread::sleep_for(std::chrono::milliseconds(600));  // RViz looks what is under the mouse, now and then
    tool("mousedown 1");
    for (int i = 1; i <= 10; ++i)
    {
      mouse(x0 + (x1 - x0) * i / 10, y0 + (y1 - y0) * i / 10);
      std::this_thread::sleep_for(std::chrono::milliseconds(40));  // a hand
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    tool("mouseup 1");
  }
  static void mouse(int x, int y) { tool("mousemove " + std::to_string(x) + " " + std::to_string(y)); }
  static void type(const std::string& key) { tool("key " + key); }

private:
  int number_ = 0;
  std::unique_ptr<Child> screen_;
  std::unique_ptr<Child> rviz_;
};

inline std::string viewCopy()
{
  return "/tmp/ping_pong_view." + std::to_string(getpid()) + ".rviz";
}

/// The saved view without a tool, so that the next one is active at the start.
inline std::string viewWithout(const std::string& tool)
{
  std::ifstream view(VIEW);
  std::ofstream copy(viewCopy());
  for (std::string line; std::getline(view, line);)
  {
    if (line != "  - Class: " + tool) copy << line << "\n";
  }
  return viewCopy();
}

/// Tests in one window beside the simulator of the .test file: each begins with a running world at its start, seen by
/// the player (F1), away being +x. The tool Keys is active: the mouse moves no paddle.
class InRviz : public testing::Test
{
protected:
  static void SetUpTestSuite() { window_ = std::make_unique<RvizWindow>(viewWithout("ping_pong_sim/Play")); }
  static void TearDownTestSuite()
  {
    window_.reset();
    std::remove(viewCopy().c_str());
  }
  void SetUp() override
  {
    ASSERT_TRUE(window_->answers(hands_));
    pause(false);
    reset();
    RvizWindow::type("F1");
  }
  void TearDown() override { EXPECT_TRUE(window_->alive()); }

  static inline std::unique_ptr<RvizWindow> window_;
  ros::NodeHandle nh_;
  Inbox<ping_pong_sim::HandsState> hands_{nh_, "hands"};
  Frames frames_;
};
}  // namespace sim_test
