// A bad parameter or scene: one clear line that names it, its value and what was expected, and an exit code that is not
// 0.
#include <sys/wait.h>

#include <array>
#include <cstdio>

#include "sim_client.h"

namespace
{
struct Ending
{
  int code;
  std::string text;
};

/// Runs the node until it ends by itself, or for three seconds, and then asks it to (SIGTERM).
Ending run(const std::string& arguments)
{
  const std::string command =
      "timeout --preserve-status -s TERM 3 " + std::string(NODE) + " __name:=refused " + arguments + " 2>&1";
  Ending ending{-1, ""};
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return ending;
  std::array<char, 512> buffer;
  while (fgets(buffer.data(), buffer.size(), pipe) != nullptr) ending.text += buffer.data();
  ending.code = WEXITSTATUS(pclose(pipe));
  ros::param::del("/refused");
  return ending;
}

void expectRefused(const std::string& arguments, const std::vector<std::string>& words)
{
  const Ending ending = run(arguments);
  EXPECT_EQ(ending.code, 1) << ending.text;
  for (const std::string& word : words) EXPECT_NE(ending.text.find(word), std::string::npos) << ending.text;
}

const std::string kScene = "_scene:=" + std::string(TEST_SCENES) + "/bench.yaml";
}  // namespace

TEST(Parameters, NegativeRate)
{
  expectRefused(kScene + " _publish_rate:=-5", {"/refused/publish_rate", "-5", "above 0"});
}

TEST(Parameters, FactorThatIsAText)
{
  expectRefused(kScene + " _real_time_factor:=fast", {"/refused/real_time_factor", "fast", "a number"});
}

TEST(Parameters, UnknownMethod)
{
  expectRefused(kScene + " _method:=magic", {"/refused/method", "magic", "exact", "auto", "scene"});
}

TEST(Parameters, AutoIsAMethodAndSaysOnceWhatItTakes)
{
  const std::string text = run(kScene + " _method:=auto").text;
  const std::size_t said = text.find("method auto takes exact: flight in closed form");
  ASSERT_NE(said, std::string::npos) << text;
  EXPECT_EQ(text.find("auto takes", said + 20), std::string::npos) << text;
}

TEST(Parameters, ToleranceOutOfRange)
{
  expectRefused(kScene + " _threads:=1.5", {"/refused/threads", "64"});
  expectRefused(kScene + " _tolerance:=-1.0e-6", {"/refused/tolerance", "[m]"});
}

TEST(Parameters, UnknownShot)
{
  expectRefused(kScene + " _feed_shot:=moonball", {"/refused/feed_shot", "moonball", "serve", "random"});
}

TEST(Parameters, FeedFasterThanTicks)
{
  expectRefused(kScene + " _feed_period:=0.005", {"/refused/feed_period", "0.005", "one tick"});
}

TEST(Parameters, NegativeFeedPeriod)
{
  expectRefused(kScene + " _feed_period:=-1", {"/refused/feed_period", "-1", "0 (no feed)"});
}

TEST(Parameters, HalfABallToKeep)
{
  expectRefused(kScene + " _feed_keep:=2.5", {"/refused/feed_keep", "2.5", "a whole number"});
}

TEST(Parameters, BallsOfASceneWithoutAPattern)
{
  expectRefused(kScene + " _balls:=20", {"bench.yaml", "0 random patterns", "the 20 balls"});
  expectRefused(kScene + " _balls:=-3", {"/refused/balls", "-3", "a whole number from 1 to 100000"});
  expectRefused(kScene + " _seed:=0.5", {"/refused/seed", "0.5", "a whole number >= 0"});
}

TEST(Parameters, NoScene)
{
  expectRefused("", {"/refused/scene", "expected"});
}

TEST(Parameters, MissingSceneFile)
{
  expectRefused("_scene:=/no/such.yaml", {"/no/such.yaml"});
}

TEST(Parameters, BrokenScene)
{
  expectRefused("_scene:=broken _scene_directory:=" + std::string(TEST_SCENES), {"broken.yaml", "mass", "-1"});
}

TEST(Parameters, UnknownOneIsWarnedAboutAndSigtermIsACleanEnd)
{
  const Ending ending = run(kScene + " _publish_rat:=50");
  EXPECT_EQ(ending.code, 0) << ending.text;
  EXPECT_NE(ending.text.find("/refused/publish_rat is not known"), std::string::npos) << ending.text;
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_parameters");
}
