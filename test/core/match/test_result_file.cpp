// The file that a match leaves behind.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "ping_pong_sim/scene_loader.h"
#include "ros/match/result_file.h"

namespace
{
using namespace ping_pong;

game::Umpire umpireOfMatch()
{
  return game::Umpire(game::findCourt(loadScene(SCENES_DIR "/match.yaml")), game::rulesPreset("relaxed"));
}

std::string read(const std::string& file)
{
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(ResultFile, TellsWinnerAndGames)
{
  game::Umpire umpire = umpireOfMatch();
  EXPECT_TRUE(umpire.forfeit(1.0, game::Player::A, "is gone").reason.empty());
  const std::string file = testing::TempDir() + "/result.yaml";
  ping_pong_sim::writeResult(file, umpire, {"one \"x\"", "two"}, 12.5);
  const std::string text = read(file);
  EXPECT_NE(text.find("winner: \"two\"\n"), std::string::npos) << text;
  EXPECT_NE(text.find("players: [\"one \\\"x\\\"\", \"two\"]\n"), std::string::npos) << text;
  EXPECT_NE(text.find("time: 12.5"), std::string::npos) << text;
  std::filesystem::remove(file);
}

TEST(ResultFile, SaysWhereItCannotWrite)
{
  const game::Umpire umpire = umpireOfMatch();
  try
  {
    ping_pong_sim::writeResult("/nowhere/result.yaml", umpire, {"A", "B"}, 0.0);
    FAIL() << "expected an error";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("/nowhere/result.yaml"), std::string::npos) << error.what();
  }
}
}  // namespace
