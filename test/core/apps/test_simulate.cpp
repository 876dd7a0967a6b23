// The program `simulate`, as batch runs see it: rows, digits, exit status, messages.
#include <sys/wait.h>

#include <cmath>
#include <cstdio>
#include <regex>
#include <sstream>

#include "testing/load_checks.h"

namespace ping_pong
{
namespace
{
struct Output
{
  int status = -1;
  std::string out, err;
};

/// Runs a command line of the shell.
Output runShell(const std::string& command)
{
  const TempFolder folder;
  const std::string error_path = folder.path("err");
  Output output;
  std::FILE* pipe = popen(("(" + command + ") 2>'" + error_path + "'").c_str(), "r");
  if (pipe == nullptr) return output;
  char block[4096];
  while (const std::size_t size = std::fread(block, 1, sizeof block, pipe)) output.out.append(block, size);
  const int status = pclose(pipe);
  output.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  output.err = textOf(error_path);
  return output;
}

Output simulate(const std::string& arguments)
{
  return runShell(std::string("'") + SIMULATE + "' " + arguments);
}

std::string shipped(const std::string& scene)
{
  return std::string("'") + SCENES_DIR + "/" + scene + ".yaml'";
}

std::vector<std::string> lines(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> cells(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

double number(const std::string& line, std::size_t column)
{
  return std::stod(cells(line).at(column));
}

TEST(Simulate, WritesAHeaderAndARowPerBallAndInstant)
{
  const Output output = simulate(shipped("tray") + " --duration 0.05 --rate 100");
  EXPECT_EQ(output.status, 0) << output.err;
  const std::vector<std::string> rows = lines(output.out);
  ASSERT_EQ(rows.size(), 1u + 60u * 6u);
  EXPECT_EQ(rows[0], "t,ball,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz");
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    EXPECT_EQ(cells(rows[i]).size(), 15u);
    EXPECT_EQ(number(rows[i], 0), static_cast<double>((i - 1) / 60) / 100.0);
    EXPECT_EQ(cells(rows[i])[1], std::to_string((i - 1) % 60));
  }
}

TEST(Simulate, WritesNumbersWithAllTheirDigits)
{
  const Output output = simulate(shipped("tray") + " --duration 0.01");
  const Scene scene = loadScene(std::string(SCENES_DIR) + "/tray.yaml");
  const std::vector<std::string> rows = lines(output.out);
  for (std::size_t i = 0; i < scene.balls.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(number(rows.at(i + 1), 2 + axis), scene.balls[i].state.p_WB[axis]);
      EXPECT_EQ(number(rows.at(i + 1), 9 + axis), scene.balls[i].state.v_WB[axis]);
    }
}

TEST(Simulate, FollowsTheParabola)
{
  for (const std::string& row : lines(simulate(shipped("arc") + " --duration 0.9 --rate 30").out))
  {
    if (row[0] == 't') continue;
    const double t = number(row, 0);
    EXPECT_NEAR(number(row, 2), -2.0 + 5.0 * t, 1e-13);  // a few roundings of numbers near 1
    EXPECT_NEAR(number(row, 4), 1.0 + 3.5 * t - 0.5 * 9.81 * t * t, 1e-13);
    EXPECT_NEAR(number(row, 11), 3.5 - 9.81 * t, 1e-13);
  }
}

TEST(Simulate, WritesRowsAtMultiplesOfThePeriodOnly)
{
  // Three tenths are three periods of 10 Hz though 0.3 * 10 rounds; a rest shorter than a period gives no row.
  EXPECT_EQ(lines(simulate(shipped("arc") + " --duration 0.3 --rate 10").out).size(), 1u + 4u);
  EXPECT_EQ(lines(simulate(shipped("arc") + " --duration 0.39 --rate 10").out).size(), 1u + 4u);
  const std::vector<std::string> rows = lines(simulate(shipped("arc") + " --duration 1 --rate 3000").out);
  ASSERT_EQ(rows.size(), 1u + 3001u);
  EXPECT_EQ(number(rows.back(), 0), 1.0);
}

TEST(Simulate, GivesTheSameBitsTwice)
{
  const std::string arguments = shipped("tray") + " --duration 2 --rate 10";
  const Output first = simulate(arguments), second = simulate(arguments);
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(first.out, second.out);
}

TEST(Simulate, TakesAnotherSeed)
{
  const std::string arguments = shipped("tray") + " --duration 0.01";
  EXPECT_EQ(simulate(arguments).out, simulate(arguments + " --seed 1").out);
  EXPECT_NE(simulate(arguments).out, simulate(arguments + " --seed 2").out);
}

TEST(Simulate, TakesAnotherMethodAndStep)
{
  const std::string arguments = shipped("arc") + " --duration 0.2 --rate 5";
  const Output exact = simulate(arguments), euler = simulate(arguments + " --method euler_explicit --dt 0.01");
  EXPECT_EQ(euler.status, 0) << euler.err;
  EXPECT_NE(euler.err.find("method euler_explicit"), std::string::npos) << euler.err;
  // Explicit Euler is g h t / 2 too high in a parabola.
  const double expected = number(lines(exact.out).at(2), 4) + 0.5 * 9.81 * 0.01 * 0.2;
  EXPECT_NEAR(number(lines(euler.out).at(2), 4), expected, 1e-12);
}

TEST(Simulate, SaysWhatAutoTakesAndWhy)
{
  const std::string arguments = shipped("arc") + " --duration 0.2";
  const Output automatic = simulate(arguments + " --method auto");
  const std::vector<std::string> summary = lines(automatic.err);
  ASSERT_EQ(summary.size(), 7u) << automatic.err;
  EXPECT_EQ(summary[0], "scene arc, method exact, 1 balls, 0.2 s simulated");
  const std::string start = "auto takes exact: flight in closed form, since no force but gravity acts; one ball";
  EXPECT_EQ(summary[1].rfind(start, 0), 0u) << summary[1];
  EXPECT_EQ(automatic.out, simulate(arguments).out);
}

TEST(Simulate, TakesAnotherTolerance)
{
  const std::string arguments = shipped("arc_air") + " --duration 0.5 --rate 2";
  const Output own = simulate(arguments), coarse = simulate(arguments + " --tolerance 1e-2");
  EXPECT_EQ(own.out, simulate(arguments + " --tolerance 1e-6").out);  // the scene's
  EXPECT_NE(own.out, coarse.out);
  EXPECT_NEAR(number(lines(own.out).at(2), 4), number(lines(coarse.out).at(2), 4), 1e-2);
}

TEST(Simulate, WritesContacts)
{
  const TempFolder folder;
  const std::string path = folder.path("contacts.csv");
  const Output output = simulate(shipped("drop") + " --duration 0.3 --contacts '" + path + "'");
  EXPECT_EQ(output.status, 0) << output.err;
  const std::vector<std::string> rows = lines(textOf(path));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(cells(rows[0]).size(), 27u);
  EXPECT_EQ(cells(rows[1]).size(), 27u);
  EXPECT_NEAR(number(rows[1], 0), std::sqrt(2.0 * 0.30 / 9.81), 1e-12);
  EXPECT_EQ(cells(rows[1])[2], "table");
  EXPECT_NEAR(number(rows[1], 14), -0.9 * number(rows[1], 11), 1e-12);  // vz after and before
  EXPECT_NE(output.err.find("contacts 1,"), std::string::npos) << output.err;
}

TEST(Simulate, CountsAContactAfterTheLastRow)
{
  const TempFolder folder;
  const std::string path = folder.path("contacts.csv");
  simulate(shipped("drop") + " --duration 0.3 --rate 5 --contacts '" + path + "'");  // the contact is at 0.247 s
  EXPECT_EQ(lines(textOf(path)).size(), 2u);
}

const std::string kCommandHeader = "time,body,mode,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,ax,ay,az,alphax,alphay,alphaz\n";
const std::string kNoValues(19, ',');

std::string shippedSwing()
{
  return std::string("'") + COMMANDS_DIR + "/swing.csv'";
}

/// Rows of the contacts file that tell of this body.
std::vector<std::string> contactsWith(const std::string& body, const std::string& contacts)
{
  std::vector<std::string> rows;
  for (const std::string& row : lines(contacts))
    if (cells(row)[2] == body) rows.push_back(row);
  return rows;
}

// A paddle alone in front of a ball that stands still: what the ball is hit by tells how the paddle has moved.
constexpr char kStandingBall[] = R"(bodies:
  - {name: bat, urdf: bat.urdf, kind: kinematic, limits: {speed: .inf, acceleration: .inf}}
balls: [{position: [0.53, 0, 0]}]
surfaces: [{pair: [any, any], restitution: 0.5}]
)";
constexpr char kPlateUrdf[] = R"(<robot name="bat"><link name="bat">
  <collision><geometry><box size="0.02 0.2 0.2"/></geometry></collision>
</link></robot>
)";

class Commanded : public ::testing::Test
{
protected:
  Commanded()
  {
    folder_.write("bat.urdf", kPlateUrdf);
    folder_.write("scene.yaml", kStandingBall);
  }
  Output run(const std::string& rows, const std::string& arguments)
  {
    folder_.write("commands.csv", kCommandHeader + rows);
    std::filesystem::remove(contacts());
    return simulate("'" + folder_.path("scene.yaml") + "' --commands '" + folder_.path("commands.csv") +
                    "' --contacts '" + contacts() + "' " + arguments);
  }
  std::string contacts() const { return folder_.path("contacts.csv"); }

  TempFolder folder_;
};

TEST_F(Commanded, AccelerationsActFromTheirVeryInstantsOn)
{
  // The bat's face has 0.5 m to the ball, first with 4 m/s^2 and then with 1 m/s^2.
  const double t0 = 0.1234567, t1 = 0.3, v1 = 4.0 * (t1 - t0), x1 = 2.0 * (t1 - t0) * (t1 - t0);
  const double v = std::sqrt(v1 * v1 + 2.0 * (0.5 - x1));
  for (const std::string rate : {"1", "10", "333"})
  {
    const Output output =
        run("0.1234567,bat,acceleration,,,,,,,,,,,,,,4,0,0,0,0,0\n"
            "0.3,bat,acceleration,,,,,,,,,,,,,,1,0,0,0,0,0\n",
            "--duration 1 --rate " + rate);
    EXPECT_EQ(output.status, 0) << output.err;
    const std::vector<std::string> hits = contactsWith("bat", textOf(contacts()));
    ASSERT_EQ(hits.size(), 1u) << rate;
    EXPECT_NEAR(number(hits[0], 0), t1 + v - v1, 1e-12) << rate;
    EXPECT_NEAR(number(hits[0], 21), v, 1e-12) << rate;  // vx_other
    EXPECT_EQ(lines(output.out).size(), 2u + static_cast<std::size_t>(std::stoi(rate))) << "rows stay where they are";
  }
}

TEST_F(Commanded, CommandsAtZeroPrecedeTheFirstTickAndEachHoldsUntilTheNext)
{
  // Without limits a velocity is there after the first piece of 2 ms, and of 1 ms at the second command.
  const Output output =
      run("0,bat,velocity,,,,,,,,1,0,0,0,0,0,,,,,,\n"
          "0.201,bat,velocity,,,,,,,,3,0,0,0,0,0,,,,,,\n"
          "0.5,bat,hold" +
              kNoValues + "\n",
          "--duration 0.5 --rate 500");
  EXPECT_EQ(output.status, 0) << output.err;
  const std::vector<std::string> hits = contactsWith("bat", textOf(contacts()));
  ASSERT_EQ(hits.size(), 1u);
  const double left = 0.5 - 1.0 * (0.201 - 0.001) + 3.0 * 0.5e-3 - 0.5e-3;  // at 3 m/s, and the ramp of 1 ms from 1 m/s
  EXPECT_NEAR(number(hits[0], 0), 0.201 + left / 3.0, 1e-12);
  EXPECT_NEAR(number(hits[0], 21), 3.0, 1e-12);
  EXPECT_NE(output.err.find("commands 2 given, 1 left at the end\n"), std::string::npos) << output.err;
}

TEST_F(Commanded, APoseIsReachedAndTheBallPushedOnTheWay)
{
  run("0.1,bat,pose,1,0,0,1,0,0,0,0,0,0,0,0,0,,,,,,\n", "--duration 0.2 --rate 100");
  EXPECT_GE(contactsWith("bat", textOf(contacts())).size(), 1u);
  run("0.1,bat,pose,-1,0,0,1,0,0,0,0,0,0,0,0,0,,,,,,\n", "--duration 0.2 --rate 100");
  EXPECT_EQ(contactsWith("bat", textOf(contacts())).size(), 0u);
}

TEST_F(Commanded, BadCommandsLeaveNoOutput)
{
  const Output output = run("0,bat,hold" + kNoValues + "\n0.5,bat,dance" + kNoValues + "\n", "--duration 1");
  EXPECT_EQ(output.status, 2);
  EXPECT_EQ(output.out, "");
  EXPECT_EQ(output.err, "simulate: " + folder_.path("commands.csv") +
                            ":3: mode: dance: expected one of hold, acceleration, velocity, pose\n");
  EXPECT_FALSE(std::filesystem::exists(contacts()));
}

TEST(Simulate, ReturnsTheServeByTheShippedSwing)
{
  const TempFolder folder;
  const std::string contacts = folder.path("contacts.csv");
  const Output output =
      simulate(shipped("rally") + " --duration 1.4 --commands " + shippedSwing() + " --contacts '" + contacts + "'");
  EXPECT_EQ(output.status, 0) << output.err;
  EXPECT_NE(output.err.find("commands 3 given, 0 left at the end\n"), std::string::npos) << output.err;
  const std::vector<std::string> hits = contactsWith("paddle", textOf(contacts)),
                                 bounces = contactsWith("table", textOf(contacts));
  ASSERT_EQ(hits.size(), 1u);
  ASSERT_EQ(bounces.size(), 3u);
  EXPECT_EQ(lines(textOf(contacts)).size(), 1u + 4u);
  const double swing = number(hits[0], 0) - 0.64;
  EXPECT_NEAR(number(hits[0], 0), 0.729, 5e-4);  // as the file says, to its last digit
  EXPECT_NEAR(number(hits[0], 21), 20.0 * swing, 1e-12);
  EXPECT_NEAR(number(hits[0], 23), 5.0 * swing, 1e-12);
  EXPECT_NEAR(number(bounces[2], 0), 1.298, 5e-4);
  EXPECT_NEAR(number(bounces[2], 3), 1.17, 5e-3);
}

TEST(Simulate, WithoutCommandsNothingChangesAndNothingIsSaidOfThem)
{
  EXPECT_EQ(simulate(shipped("rally") + " --duration 0.1").err.find("commands"), std::string::npos);
}

TEST(Simulate, DoesNotWriteContactsOverWhatItReads)
{
  const TempFolder folder;
  const std::string scene = folder.write("scene.yaml", kStandingBall), urdf = folder.write("bat.urdf", kPlateUrdf);
  const std::string commands = folder.write("commands.csv", kCommandHeader + "0,bat,hold" + kNoValues + "\n");
  std::filesystem::create_symlink("scene.yaml", folder.path("link"));
  std::filesystem::create_hard_link(commands, folder.path("twin"));
  const std::pair<std::string, std::string> cases[] = {{"scene.yaml", "the scene"},   {"link", "the scene"},
                                                       {"./scene.yaml", "the scene"}, {"commands.csv", "the commands"},
                                                       {"twin", "the commands"},      {"bat.urdf", "the URDF of bat"}};
  for (const auto& [name, what] : cases)
  {
    const std::string path = folder.path(name);
    const Output output =
        simulate("'" + scene + "' --duration 1 --commands '" + commands + "' --contacts '" + path + "'");
    EXPECT_EQ(output.status, 2) << path;
    EXPECT_EQ(output.out, "") << path;
    EXPECT_EQ(output.err, "simulate: --contacts: " + path + ": expected another file than " + what + "\n");
  }
  EXPECT_EQ(textOf(scene), kStandingBall);
  EXPECT_EQ(textOf(urdf), kPlateUrdf);
  EXPECT_EQ(lines(textOf(commands)).size(), 2u);
}

TEST(Simulate, SummarisesOnStandardError)
{
  const Output output = simulate(shipped("arc") + " --duration 0.5");
  const std::vector<std::string> summary = lines(output.err);
  ASSERT_EQ(summary.size(), 6u) << output.err;
  EXPECT_EQ(summary[0], "scene arc, method exact, 1 balls, 0.5 s simulated");
  EXPECT_TRUE(std::regex_match(summary[1], std::regex("cost .* s wall, .* us per ball and simulated second, .*")));
  EXPECT_TRUE(std::regex_match(summary[2], std::regex("contacts \\d+, events \\d+")));
  EXPECT_TRUE(std::regex_match(summary[3], std::regex("energy .* J at start, .* J at end")));
  EXPECT_TRUE(std::regex_match(summary[4], std::regex("state hash [0-9a-f]{16}")));
  EXPECT_EQ(summary[5], "status ok");
}

TEST(Simulate, TellsAHashOfTheEnd)
{
  const auto hashOf = [](const std::string& arguments)
  { return lines(simulate(shipped("tray") + arguments).err).at(4); };
  EXPECT_TRUE(startsWith(hashOf(" --duration 1"), "state hash "));
  EXPECT_EQ(hashOf(" --duration 1"), hashOf(" --duration 1 --rate 7"));  // rows change nothing
  EXPECT_NE(hashOf(" --duration 1"), hashOf(" --duration 1 --seed 2"));
}

TEST(Simulate, TakesAnotherNumberOfBalls)
{
  const Output output = simulate(shipped("gas") + " --duration 0.1 --rate 10 --balls 30");
  EXPECT_EQ(output.status, 0) << output.err;
  EXPECT_EQ(lines(output.out).size(), 1u + 2u * 30u);
  EXPECT_EQ(simulate(shipped("gas") + " --duration 0.1 --rate 10 --balls 30 --seed 3").status, 0);
}

TEST(Simulate, AnyNumberOfThreadsWritesTheSame)
{
  const std::string arguments = shipped("gas") + " --duration 0.1 --rate 10 --balls 600";
  const Output alone = simulate(arguments), shared = simulate(arguments + " --threads 3");
  EXPECT_EQ(shared.status, 0) << shared.err;
  EXPECT_EQ(shared.out, alone.out);
}

TEST(Simulate, ExplainsItself)
{
  const Output output = simulate("--help");
  EXPECT_EQ(output.status, 0);
  for (const char* option : {"--duration", "--rate", "--method", "--dt", "--tolerance", "--seed", "--balls",
                             "--threads", "--contacts", "--commands"})
    EXPECT_NE(output.out.find(option), std::string::npos) << option;
  for (const Method method : kMethods) EXPECT_NE(output.out.find(name(method)), std::string::npos) << name(method);
  for (const char* part :
       {"auto", "\nRun:\n", "--duration T REQUIRED", "\nOutput:\n", "--rate R=100 ", "\nInstead of the scene's own:\n"})
    EXPECT_NE(output.out.find(part), std::string::npos) << part;
  EXPECT_EQ(runShell(std::string("'") + SIMULATE + "' --help > /dev/full").status, 1);
}

TEST(Simulate, TakesOptionsCutShortOrJoinedAndTheLastOneOfAName)
{
  const Output whole = simulate(shipped("tray") + " --duration 0.05 --rate 20 --seed 2");
  EXPECT_EQ(simulate("--dur 9 --rat=20 --see 2 --duration=0.05 -- " + shipped("tray")).out, whole.out);
}

TEST(Simulate, RefusesBadInputWithOneLineAndStatusTwo)
{
  const std::string arc = shipped("arc");
  const std::pair<std::string, std::string> cases[] = {
      {"", "SCENE.yaml: missing: expected"},
      {arc, "--duration: missing: expected"},
      {arc + " --duration", "--duration: nothing: expected a value"},
      {arc + " --duration 0", "--duration: 0: expected a finite number > 0"},
      {arc + " --duration -1", "--duration: -1: expected"},
      {arc + " --duration=inf", "--duration: inf: expected"},
      {arc + " --duration 1s", "--duration: 1s: expected"},
      {arc + " --duration 1 --rate 0", "--rate: 0: expected"},
      {arc + " --duration 1e300 --rate 1e300", "--rate: too many rows: expected"},
      {arc + " --duration 1 --dt nan", "--dt: nan: expected"},
      {arc + " --duration 1 --method magic", "--method: magic: expected one of: euler_explicit"},
      {arc + " --duration 1 --seed -1", "--seed: -1: expected an integer"},
      {arc + " --duration 1 --balls 0", "--balls: 0: expected an integer from 1 to 100000"},
      {arc + " --duration 1 --threads 65", "--threads: 65: expected an integer from 1 to 64"},
      {arc + " --duration 1 --balls 1e3", "--balls: 1e3: expected an integer from 1 to 100000"},
      {arc + " --duration 1 --contacts ''", "--contacts: nothing: expected"},
      {arc + " --duration 1 --commands ''", "--commands: nothing: expected a file name"},
      {arc + " --duration 1 --commands /no/file",
       "/no/file:1: commands: No such file or directory: expected a regular file"},
      {arc + " --duration 1 --fast", "--fast: unknown option: expected"},
      {arc + " --duration 1 -q", "-q: unknown option: expected"},
      {arc + " --duration 1 --tolerance 1", "--tolerance: 1: expected a number from 1e-12 to 0.1"},
      {arc + " --duration 1 --tolerance 0", "--tolerance: 0: expected a number from"},
      {arc + " --duration 1 --tolerance fine", "--tolerance: fine: expected a number from"},
      {arc + " other.yaml --duration 1", "other.yaml: second scene: expected"},
      {"/no/scene.yaml --duration 1", "/no/scene.yaml:1: scene: No such file or directory: expected"},
  };
  for (const auto& [arguments, message] : cases)
  {
    const Output output = simulate(arguments);
    EXPECT_EQ(output.status, 2) << arguments;
    EXPECT_EQ(output.out, "") << arguments;
    EXPECT_EQ(lines(output.err).size(), 1u) << output.err;
    EXPECT_TRUE(startsWith(output.err, "simulate: " + message)) << arguments << "\n" << output.err;
  }
}

TEST(Simulate, FailsWhenOutputIsLost)
{
  const std::string run = std::string("'") + SIMULATE + "' " + shipped("arc") + " --duration 100 ";
  const Output full = runShell(run + "> /dev/full");
  EXPECT_EQ(full.status, 1);
  EXPECT_EQ(full.err, "simulate: cannot write standard output: No space left on device\n");
  const Output no_room = runShell(run + "--contacts /dev/full");
  EXPECT_EQ(no_room.status, 1);
  EXPECT_EQ(no_room.err, "simulate: cannot write /dev/full: No space left on device\n");
  const Output no_folder = runShell(run + "--contacts /no/folder/file");
  EXPECT_EQ(no_folder.status, 1);
  EXPECT_EQ(no_folder.err, "simulate: cannot write /no/folder/file: No such file or directory\n");
  const Output pipe = runShell("{ " + run + "; echo status $? >&2; } | head -n 1");
  EXPECT_NE(pipe.err.find("simulate: cannot write standard output: Broken pipe\nstatus 1"), std::string::npos)
      << pipe.err;
}

TEST(Simulate, ReportsAWorldThatIsNotOk)
{
  // Explicit Euler overflows when a step is far too long; the row still holds the last finite state.
  const TempFolder folder;
  const std::string scene = folder.write("far.yaml", "balls: [{position: [0, 0, 1], velocity: [1e308, 0, 0]}]\n");
  const Output output = simulate("'" + scene + "' --duration 100 --rate 1 --method euler_explicit --dt 10");
  EXPECT_EQ(output.status, 3) << output.err;
  EXPECT_NE(output.err.find("status not ok: not_finite"), std::string::npos) << output.err;
  EXPECT_EQ(output.out.find("nan"), std::string::npos);
  EXPECT_EQ(output.out.find("inf"), std::string::npos);
}

TEST(CoreLibrary, HasNoRos)
{
  const Output output = runShell(std::string("nm -C '") + CORE_LIBRARY + "'");
  EXPECT_EQ(output.status, 0) << output.err;
  EXPECT_NE(output.out.find("ping_pong::loadScene"), std::string::npos);
  EXPECT_FALSE(std::regex_search(output.out.begin(), output.out.end(), std::regex("\\bros::"))) << "nm shows ros::";
}
}  // namespace
}  // namespace ping_pong
