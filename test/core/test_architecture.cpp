// The house keeps its order: rooms, who includes whom, and what a header owes its reader. See docs/architecture.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace
{
namespace fs = std::filesystem;

const fs::path kSource = SOURCE_DIR;
const fs::path kCore = kSource / "src" / "core";
const fs::path kGame = kSource / "src" / "game";
const fs::path kPlay = kSource / "src" / "play";

// Bottom to top: a room includes only itself, those before it, and the public headers.
const std::vector<std::string> kRooms = {"base",  "geometry", "evolve", "resolve", "detect",  "paddle",  "scene",
                                         "state", "resting",  "solver", "events",  "windows", "methods", "world"};

// The same for the node.
const fs::path kNode = kSource / "src" / "ros";
const std::vector<std::string> kNodeRooms = {"base", "commands", "simulation", "state", "markers", "node", "match"};

std::vector<fs::path> sourcesIn(const fs::path& folder)
{
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> linesOf(const fs::path& file)
{
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> includesOf(const fs::path& file)
{
  static const std::regex kInclude("^\\s*#\\s*include\\s+[<\"]([^>\"]+)[>\"].*");
  std::vector<std::string> includes;
  for (const std::string& line : linesOf(file))
  {
    std::smatch match;
    if (std::regex_match(line, match, kInclude)) includes.push_back(match[1]);
  }
  return includes;
}

bool startsWith(const std::string& text, const std::string& beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

std::size_t levelIn(const std::vector<std::string>& rooms, const std::string& room)
{
  return static_cast<std::size_t>(std::find(rooms.begin(), rooms.end(), room) - rooms.begin());
}

std::size_t levelOf(const std::string& room)
{
  return levelIn(kRooms, room);
}

std::string roomOf(const fs::path& file)
{
  return fs::relative(file, kCore).begin()->string();
}

TEST(Architecture, EverySourceOfTheCoreIsInARoom)
{
  for (const fs::path& file : sourcesIn(kCore)) EXPECT_LT(levelOf(roomOf(file)), kRooms.size()) << file;
}

TEST(Architecture, IncludesGoDownward)
{
  std::size_t between_rooms = 0;
  for (const fs::path& file : sourcesIn(kCore))
    for (const std::string& include : includesOf(file))
    {
      const std::string room = include.substr(0, include.find('/'));
      if (!fs::exists(kCore / include)) continue;
      between_rooms += room != roomOf(file);
      EXPECT_LE(levelOf(room), levelOf(roomOf(file))) << file << " includes " << include;
    }
  EXPECT_GT(between_rooms, 100u);  // the test has looked at something
}

TEST(Architecture, IncludesOfTheNodeGoDownward)
{
  std::size_t between_rooms = 0;
  for (const fs::path& file : sourcesIn(kNode))
  {
    const std::size_t level = levelIn(kNodeRooms, fs::relative(file, kNode).begin()->string());
    EXPECT_LT(level, kNodeRooms.size()) << file;
    for (const std::string& include : includesOf(file))
    {
      if (!fs::exists(kSource / "src" / include) || !startsWith(include, "ros/")) continue;
      const std::string room = include.substr(4, include.find('/', 4) - 4);
      EXPECT_LE(levelIn(kNodeRooms, room), level) << file << " includes " << include;
      ++between_rooms;
    }
  }
  EXPECT_GT(between_rooms, 20u);  // the test has looked at something
}

// Tests of a room stand in a folder of its name.
TEST(Architecture, TestsMirrorTheRooms)
{
  for (const fs::path& file : sourcesIn(kSource / "test" / "core"))
  {
    const std::string folder = fs::relative(file.parent_path(), kSource / "test" / "core").string();
    const bool somewhere = folder == "." || fs::is_directory(kCore / folder) ||
                           fs::is_directory(kSource / "src" / folder) || fs::is_directory(kSource / folder);
    EXPECT_TRUE(somewhere) << file;
  }
}

TEST(Architecture, OnlyTheSceneReadsFiles)
{
  const std::vector<std::string> kLoaders = {"yaml-cpp/", "urdf_parser/", "urdf_model/", "tinyxml2"};
  for (const fs::path& file : sourcesIn(kCore))
    for (const std::string& include : includesOf(file))
      for (const std::string& loader : kLoaders)
        EXPECT_TRUE(!startsWith(include, loader) || roomOf(file) == "scene") << file << " includes " << include;
}

TEST(Architecture, PhysicsKnowsNoRos)
{
  const std::vector<std::string> kRos = {
      "ros/", "tf2", "rviz/", "geometry_msgs/", "visualization_msgs/", "ping_pong_sim/Ball", "std_msgs/"};
  for (const fs::path& folder : {kCore, kSource / "include", kGame, kPlay, kSource / "src" / "apps", kSource / "bench"})
    for (const fs::path& file : sourcesIn(folder))
      for (const std::string& include : includesOf(file))
        for (const std::string& ros : kRos) EXPECT_FALSE(startsWith(include, ros)) << file << " includes " << include;
}

// A player flies and strikes with the core's own laws; how the world goes about it is none of its business.
TEST(Architecture, ThePlayerKnowsOnlyTheLaws)
{
  const std::set<std::string> kLaws = {"base", "evolve", "resolve", "paddle"};
  for (const fs::path& file : sourcesIn(kPlay))
    for (const std::string& include : includesOf(file))
      if (fs::exists(kCore / include))
      {
        EXPECT_EQ(kLaws.count(include.substr(0, include.find('/'))), 1u) << file << " includes " << include;
      }
}

TEST(Architecture, PublicHeadersNeedNoneOfTheCore)
{
  for (const fs::path& file : sourcesIn(kSource / "include"))
    for (const std::string& include : includesOf(file))
      EXPECT_FALSE(fs::exists(kCore / include)) << file << " includes " << include;
}

// The game sees of the physics what any other project would.
TEST(Architecture, TheGameIncludesPublicHeadersOnly)
{
  for (const fs::path& file : sourcesIn(kGame))
    for (const std::string& include : includesOf(file))
    {
      if (include.find('/') == std::string::npos) continue;  // of the standard library
      EXPECT_TRUE(startsWith(include, "game/") || startsWith(include, "ping_pong_sim/") ||
                  startsWith(include, "Eigen/"))
          << file << " includes " << include;
    }
}

TEST(Architecture, EveryHeaderBeginsWithItsPurposeAndIsShort)
{
  for (const fs::path& folder :
       {kCore, kGame, kPlay, kSource / "include", kSource / "src" / "ros", kSource / "src" / "apps"})
    for (const fs::path& file : sourcesIn(folder))
    {
      if (file.extension() != ".h") continue;
      const std::vector<std::string> lines = linesOf(file);
      ASSERT_FALSE(lines.empty()) << file;
      EXPECT_TRUE(startsWith(lines.front(), "// ") && lines.front().size() > 12) << file << ": " << lines.front();
      EXPECT_LE(lines.size(), 250u) << file;
    }
}

// Words by camelCase, snake_case and kConstant.
std::vector<std::string> wordsOf(const std::string& identifier)
{
  std::vector<std::string> words;
  bool lower = false;  // the letter before
  for (const char c : identifier)
  {
    const bool letter = std::isalpha(static_cast<unsigned char>(c)) != 0;
    const bool upper = std::isupper(static_cast<unsigned char>(c)) != 0;
    if (words.empty() || !letter || (upper && lower)) words.emplace_back();
    if (letter) words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    lower = letter && !upper;
  }
  return words;
}

std::string codeOf(const fs::path& file)
{
  static const std::regex kNoCode("//.*|\"(?:[^\"\\\\]|\\\\.)*\"|^\\s*#.*");
  std::string code;
  for (const std::string& line : linesOf(file)) code += std::regex_replace(line, kNoCode, " ") + '\n';
  return code;
}

// A stranger knows the words of the field: these were ours.
TEST(Architecture, IdentifiersAreTheWordsOfTheField)
{
  const std::set<std::string> kOurs = {
      "pile",   "piles",  "glance",    "glances",  "outlook", "foresee", "foreseen", "foresaw", "soonest",
      "hop",    "hops",   "nudge",     "crush",    "streak",  "flown",   "march",    "desk",    "encounter",
      "chain",  "chains", "sweep",     "sweeps",   "calm",    "tired",   "crowding", "crowded", "announce",
      "thrown", "settle", "announced", "troubles", "further", "passing", "meetings", "gather"};
  static const std::regex kIdentifier("[A-Za-z_]\\w*");
  std::size_t looked_at = 0;
  for (const fs::path& file : sourcesIn(kCore))
  {
    const std::string code = codeOf(file);
    for (std::sregex_iterator it(code.begin(), code.end(), kIdentifier); it != std::sregex_iterator(); ++it)
      for (const std::string& word : wordsOf(it->str()))
      {
        ++looked_at;
        EXPECT_EQ(kOurs.count(word), 0u) << file << ": " << it->str();
      }
  }
  EXPECT_GT(looked_at, 50000u);
}

// The page names every room, and no file that is not there.
TEST(Architecture, ItsPageIsTrue)
{
  const fs::path page = kSource / "docs" / "architecture.md";
  static const std::regex kLink("\\]\\(([^)#]+)\\)");
  std::string text;
  for (const std::string& line : linesOf(page)) text += line + '\n';
  std::size_t links = 0;
  for (std::sregex_iterator link(text.begin(), text.end(), kLink); link != std::sregex_iterator(); ++link)
  {
    const std::string target = (*link)[1];
    if (startsWith(target, "http")) continue;
    EXPECT_TRUE(fs::exists(page.parent_path() / target)) << target;
    ++links;
  }
  EXPECT_GT(links, 30u);
  for (const std::string& room : kRooms) EXPECT_NE(text.find("`" + room + "/`"), std::string::npos) << room;
}
}  // namespace
