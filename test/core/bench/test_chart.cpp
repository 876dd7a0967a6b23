// The work-precision chart can be measured, and `exact` stands where it should. Nothing here depends on time.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace
{
using Row = std::map<std::string, std::string>;

std::vector<std::string> cells(const std::string& line)
{
  std::vector<std::string> all;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) all.push_back(cell);
  return all;
}

std::vector<Row> readCsv(const std::filesystem::path& path)
{
  std::ifstream file(path);
  std::vector<std::string> head;
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);)
  {
    if (line.empty() || line[0] == '#') continue;
    const std::vector<std::string> row = cells(line);
    if (head.empty())
    {
      head = row;
      continue;
    }
    EXPECT_EQ(row.size(), head.size()) << line;
    rows.emplace_back();
    for (std::size_t i = 0; i < std::min(head.size(), row.size()); ++i) rows.back()[head[i]] = row[i];
  }
  return rows;
}

// Everything is measured once, for all tests.
class Chart : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    directory() = std::filesystem::temp_directory_path() / ("chart_test_" + std::to_string(getpid()));
    std::filesystem::create_directories(directory());
    const std::string command =
        std::string(CHART) + " --quick --engine ping_pong_sim --out " + directory().string() + " > /dev/null";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << command;
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(directory()); }

  static std::filesystem::path& directory()
  {
    static std::filesystem::path path;
    return path;
  }
  static std::vector<Row> rows(const std::string& scene) { return readCsv(directory() / (scene + ".csv")); }

  static std::vector<Row> ours(const std::string& scene, const std::string& variant)
  {
    std::vector<Row> found;
    for (const Row& row : rows(scene))
      if (row.at("engine") == "ping_pong_sim" && row.at("variant") == variant) found.push_back(row);
    return found;
  }
  /// Of the finest tolerance.
  static double exact(const std::string& scene, const std::string& column)
  {
    const std::vector<Row> found = ours(scene, "exact");
    return found.empty() ? std::nan("") : std::stod(found.back().at(column));
  }
};

// [m], a thousandth of a ball of 200 mm: `exact` hands a heap to `impulse`, at 1 ms.
constexpr double kHeapOverlap = 2e-4;

const std::vector<std::string> kVacuum = {"flight_vacuum",      "bouncing",    "drop_to_rest",
                                          "spin_bounce_vacuum", "ball_in_box", "paddle_hit"};
const std::vector<std::string> kAir = {"flight_air", "spin_bounce", "rally"};

std::vector<std::string> all()
{
  std::vector<std::string> scenes = kVacuum;
  scenes.insert(scenes.end(), kAir.begin(), kAir.end());
  scenes.emplace_back("elastic_666");
  scenes.emplace_back("inelastic_666");
  return scenes;
}
}  // namespace

TEST_F(Chart, EverySceneIsMeasuredWithEveryMethod)
{
  for (const std::string& scene : all())
    for (const char* method : {"euler_explicit", "euler_semi_implicit", "exact"})
      EXPECT_FALSE(ours(scene, method).empty()) << scene << ' ' << method;
}

TEST_F(Chart, EveryMeasuredPointHasACost)
{
  for (const std::string& scene : all())
    for (const Row& row : rows(scene))
      EXPECT_TRUE(row.at("refusal") != "\"\"" || std::stod(row.at("cost_s")) > 0.0)
          << scene << ' ' << row.at("variant");
}

TEST_F(Chart, ExactNeverFails)
{
  for (const std::string& scene : all())
    for (const Row& row : ours(scene, "exact"))
    {
      EXPECT_EQ(row.at("failures"), "") << scene << ' ' << row.at("step");
      EXPECT_EQ(row.at("wrong_bounces"), "0") << scene << ' ' << row.at("step");
      const double most = scene == "inelastic_666" ? kHeapOverlap : 1e-12;
      EXPECT_LE(std::stod(row.at("penetration_m")), most) << scene << ' ' << row.at("step");
    }
}

TEST_F(Chart, HeapsStayApart)  // what follows impacts in the order of a list lets balls sink twenty times deeper
{
  std::map<std::string, double> simple;
  for (const Row& row : ours("inelastic_666", "euler_semi_implicit"))
    if (row.at("refusal") == "\"\"") simple[row.at("step")] = std::stod(row.at("overlap_rms_m"));
  ASSERT_FALSE(simple.empty());
  for (const auto& [step, overlap] : simple)
    for (const Row& row : ours("inelastic_666", "impulse"))
    {
      if (row.at("step") != step) continue;
      EXPECT_EQ(row.at("failures"), "") << step;
      EXPECT_LE(std::stod(row.at("overlap_rms_m")), 0.05 * overlap) << step;
    }
}

TEST_F(Chart, ExactIsExactInVacuum)  // 16 units in the last place of 100 m, where the longest flight goes
{
  for (const std::string& scene : kVacuum)
  {
    EXPECT_LE(exact(scene, "position_max_m"), 1e-12) << scene;
    EXPECT_LE(exact(scene, "energy_rms"), 1e-13) << scene;
  }
}

TEST_F(Chart, ExactKeepsItsToleranceInAir)  // bounces may multiply an error by ten; below 1e-12 it is rounding
{
  for (const std::string& scene : kAir)
    for (const Row& row : ours(scene, "exact"))
      EXPECT_LE(std::stod(row.at("position_max_m")), 10.0 * std::stod(row.at("step")) + 5e-12) << scene;
}

TEST_F(Chart, ExactKeepsEnergyAndMomentumAmong216Balls)
{
  EXPECT_LE(exact("elastic_666", "energy_rms"), 1e-13);
  EXPECT_LE(exact("elastic_666", "momentum"), 1e-13);
}

TEST_F(Chart, ReferencesAgreeWithThemselvesAtHalfTheStep)  // a hundred times below what is held against them
{
  for (const std::string& scene : all())
  {
    std::ifstream file(directory() / (scene + ".csv"));
    std::string line;
    const std::string key = "# reference_error_m: ";
    while (std::getline(file, line) && line.rfind(key, 0) != 0)
    {
    }
    ASSERT_GT(line.size(), key.size()) << scene;
    EXPECT_LE(std::stod(line.substr(key.size())), 5e-15) << scene;
  }
}
