// Command files: good ones are read as they say; bad ones name file, line, column, value and what was expected.
#include <sys/stat.h>

#include "apps/command_file.h"
#include "apps/command_queue.h"
#include "testing/load_checks.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
using Mode = PaddleCommand::Mode;

const std::string kHeader = "time,body,mode,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,ax,ay,az,alphax,alphay,alphaz\n";

// The line numbers in the table of errors count from the header.
const std::string kFile = kHeader +
                          "0,bat,hold,,,,,,,,,,,,,,,,,,,\n"
                          "0.25,bat,acceleration,,,,,,,,,,,,,,1,-2,3e-1,4,5,6\n"
                          "0.25,board,velocity,,,,,,,,1,2,3,4,5,6,,,,,,\n"
                          "1.5,bat,pose,0.1,0.2,0.3,0.5,-0.5,0.5,0.5,1,2,3,4,5,6,,,,,,\n";

class CommandFile : public ::testing::Test
{
protected:
  CommandFile()
  {
    scene_ = SceneBuilder().box("table", {1, 1, 0.1}, at({0, 0, 0})).build();
    for (const char* name : {"bat", "board"})
      scene_.bodies.push_back(SceneBuilder().paddle(name, boxShape({0.1, 0.1, 0.1}), at({0, 0, 1})).build().bodies[0]);
  }

  std::vector<TimedCommand> read(const std::string& text) const
  {
    return readCommands(folder_.write("commands.csv", text), scene_.bodies);
  }
  std::string errorOf(const std::string& text) const
  {
    return loadErrorOf([&] { read(text); });
  }
  std::string errorOfFile(const std::string& path) const
  {
    return loadErrorOf([&] { readCommands(path, scene_.bodies); });
  }
  std::string file() const { return folder_.path("commands.csv"); }

  TempFolder folder_;
  Scene scene_;
};

TEST_F(CommandFile, ReadsEveryMode)
{
  const std::vector<TimedCommand> commands = read(kFile);
  ASSERT_EQ(commands.size(), 4u);
  const TimedCommand &hold = commands[0], &swing = commands[1], &move = commands[2], &pose = commands[3];
  EXPECT_EQ(hold.time, 0.0);
  EXPECT_EQ(hold.body, 1u);
  EXPECT_EQ(hold.command.mode, Mode::Hold);
  EXPECT_EQ(swing.time, 0.25);
  EXPECT_EQ(swing.command.mode, Mode::Acceleration);
  EXPECT_EQ(swing.command.a_W, Vector3d(1, -2, 0.3));
  EXPECT_EQ(swing.command.alpha_W, Vector3d(4, 5, 6));
  EXPECT_EQ(move.time, 0.25);
  EXPECT_EQ(move.body, 2u);
  EXPECT_EQ(move.command.mode, Mode::Velocity);
  EXPECT_EQ(move.command.twist.v, Vector3d(1, 2, 3));
  EXPECT_EQ(move.command.twist.w, Vector3d(4, 5, 6));
  EXPECT_EQ(pose.time, 1.5);
  EXPECT_EQ(pose.body, 1u);
  EXPECT_EQ(pose.command.mode, Mode::Pose);
  EXPECT_EQ(pose.command.pose.p, Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(pose.command.pose.q.coeffs(), Quaterniond(0.5, -0.5, 0.5, 0.5).coeffs());
  EXPECT_EQ(pose.command.twist.v, Vector3d(1, 2, 3));
  EXPECT_EQ(pose.command.twist.w, Vector3d(4, 5, 6));
}

TEST_F(CommandFile, TheWorldRefusesNothingOfIt)
{
  World world(scene_);
  for (const TimedCommand& command : read(kFile)) EXPECT_FALSE(world.command(command.body, command.command));
}

TEST_F(CommandFile, MayHaveCommentsAndTheLineEndsOfAnySystem)
{
  EXPECT_EQ(read("# a swing\n" + kHeader + "# and\n0,bat,hold" + std::string(19, ',')).size(), 1u);
  std::string dos;
  for (const char c : kFile) dos += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(read(dos).size(), 4u);
}

TEST_F(CommandFile, HasADecimalPointWhateverTheLocale)
{
  const DecimalComma comma;
  EXPECT_EQ(read(kFile)[1].command.a_W.z(), 0.3);
}

struct BadFile
{
  const char* what;
  std::string from, to;  ///< edit of kFile
  int line;
  std::string message;  ///< begins with the column
};

const BadFile kBadFiles[] = {
    {"empty", kFile, "", 1, "header: nothing: expected time,body,mode,x"},
    {"comments only", kFile, "# a\n# b\n", 2, "header: nothing: expected time,body,mode,x"},
    {"no header", kHeader, "", 1, "header: 0,bat,hold,,,,,,,,,,,,,,,,,,,: expected time,body,mode"},
    {"another header", "time,body", "t,body", 1, "header: t,body,mode"},
    {"header of more columns", "alphaz\n", "alphaz,\n", 1, "header: time,body"},
    {"header alone", kFile, kHeader, 1, "commands: nothing: expected at least one command"},
    {"empty line", "0,bat", "\n0,bat", 2, "body: missing: expected 22 fields, not 1"},
    {"few fields", ",,,,,,\n0.25,bat", "\n0.25,bat", 2, "ax: missing: expected 22 fields, not 16"},
    {"many fields", ",1,-2", ",1,,-2", 3, "column 23: 6: expected 22 fields, not 23"},
    {"cut off", "1,2,3,4,5,6,,,,,,\n1.5", "1,2\n1.5", 4, "vz: missing: expected 22 fields, not 12"},
    // time
    {"no time", "0,bat", ",bat", 2, "time: \"\": expected a finite number >= 0"},
    {"negative time", "0,bat", "-0.1,bat", 2, "time: -0.1: expected a finite number >= 0"},
    {"NaN time", "0,bat", "nan,bat", 2, "time: nan: expected a finite number >= 0"},
    {"infinite time", "1.5,bat", "inf,bat", 5, "time: inf: expected a finite number >= 0"},
    {"time that overflows", "1.5,bat", "1e999,bat", 5, "time: 1e999: expected a finite number >= 0"},
    {"time in words", "1.5,bat", "1.5s,bat", 5, "time: 1.5s: expected a finite number >= 0"},
    {"time with a blank", "1.5,bat", " 1.5,bat", 5, "time:  1.5: expected a finite number >= 0"},
    {"time that goes back", "1.5,bat", "0.2499,bat", 5,
     "time: 0.2499: expected a time that is not before that of the row above, 0.25"},
    // body
    {"unknown body", "1.5,bat", "1.5,racket", 5, "body: racket: expected a kinematic body of the scene: bat, board"},
    {"no body", "1.5,bat", "1.5,", 5, "body: \"\": expected a kinematic body of the scene: bat, board"},
    {"static body", "1.5,bat", "1.5,table", 5, "body: table: expected a kinematic body; this one is static"},
    {"quoted body", "1.5,bat", "1.5,\"bat\"", 5, "body: \"bat\": expected a kinematic body"},
    // mode
    {"unknown mode", "bat,pose", "bat,swing", 5, "mode: swing: expected one of hold, acceleration, velocity, pose"},
    {"capital mode", "bat,hold", "bat,Hold", 2, "mode: Hold: expected one of hold"},
    {"no mode", "bat,hold", "bat,", 2, "mode: \"\": expected one of hold"},
    // values
    {"NaN", "3e-1", "nan", 3, "az: nan: expected a finite number"},
    {"infinity", "board,velocity,,,,,,,,1,2,3,4", "board,velocity,,,,,,,,1,2,3,inf", 4,
     "wx: inf: expected a finite number"},
    {"overflow", "3e-1", "3e999", 3, "az: 3e999: expected a finite number"},
    {"no number", "0.1,0.2", "0.1,left", 5, "y: left: expected a finite number"},
    {"hexadecimal", "0.1,0.2", "0x1,0.2", 5, "x: 0x1: expected a finite number"},
    {"NaN in the quaternion", "-0.5,0.5", "nan,0.5", 5, "qx: nan: expected a finite number"},
    {"no quaternion", "0.5,-0.5,0.5,0.5", "0,0,0,0", 5,
     "qw: [0, 0, 0, 0]: expected a quaternion qw, qx, qy, qz of length 1"},
    {"long quaternion", "0.5,-0.5,0.5,0.5", "0.5,-0.5,0.5,0.501", 5,
     "qw: [0.5, -0.5, 0.5, 0.501]: expected a quaternion"},
    // values of the wrong mode
    {"velocity of a swing", "acceleration,,,,,,,,,,,,,,1", "acceleration,,,,,,,,,,,,,0,1", 3,
     "wz: 0: expected nothing, since mode acceleration does not use it"},
    {"acceleration of a pose", "5,6,,,,,,", "5,6,,,,,,7", 4,
     "alphaz: 7: expected nothing, since mode velocity does not use it"},
    {"place of a hold", "bat,hold,", "bat,hold,1", 2, "x: 1: expected nothing, since mode hold does not use it"},
    {"swing without a turn", "3e-1,4,5,6", "3e-1,,,", 3,
     "alphax: nothing: expected a finite number, since mode acceleration uses it"},
    {"pose without a velocity", "0.5,1,2,3,4,5,6,", "0.5,,,,,,,", 5,
     "vx: nothing: expected a finite number, since mode pose uses it"},
    {"acceleration called velocity", "acceleration", "velocity", 3,
     "ax: 1: expected nothing, since mode velocity does not use it"},
    // size
    {"long line", "bat,hold", "bat,hold" + std::string(5000, ','), 2,
     "commands: a longer line: expected at most 4095 bytes"},
};

TEST_F(CommandFile, NamesFileLineColumnValueAndExpectation)
{
  for (const BadFile& bad : kBadFiles)
  {
    SCOPED_TRACE(bad.what);
    expectMessage(errorOf(edited(kFile, bad.from, bad.to)),
                  file() + ":" + std::to_string(bad.line) + ": " + bad.message);
  }
}

TEST_F(CommandFile, HasAMillionLinesAtMost)
{
  std::string text = kFile;
  for (int line = 6; line <= 1000000; ++line) text += "#\n";
  EXPECT_EQ(read(text).size(), 4u);
  expectMessage(errorOf(text + "#\n"), file() + ":1000001: commands: more lines: expected at most 1000000 lines");
}

TEST_F(CommandFile, IsARegularFile)
{
  const std::string pipe = folder_.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string expected = ": expected a regular file that can be read";
  EXPECT_EQ(errorOfFile(pipe), pipe + ":1: commands: a pipe or a device" + expected);
  EXPECT_EQ(errorOfFile("/dev/zero"), "/dev/zero:1: commands: a pipe or a device" + expected);
  EXPECT_EQ(errorOfFile(folder_.path("")), folder_.path("") + ":1: commands: a directory" + expected);
  EXPECT_EQ(errorOfFile("/no/file"), "/no/file:1: commands: No such file or directory" + expected);
}

TEST_F(CommandFile, OfASceneWithoutPaddlesIsRefused)
{
  scene_.bodies.resize(1);
  expectMessage(errorOf(kFile), file() + ":2: body: bat: expected a scene with a kinematic body");
}

TEST_F(CommandFile, WaitsInAQueueForItsTimes)
{
  World world(scene_);
  CommandQueue queue(read(kFile));
  EXPECT_EQ(queue.nextTime(), 0.0);
  queue.give(world);
  EXPECT_EQ(queue.given(), 1u);
  EXPECT_EQ(queue.nextTime(), 0.25);
  queue.give(world);  // both of that time
  EXPECT_EQ(world.bodyCommand(1).mode, Mode::Acceleration);
  EXPECT_EQ(world.bodyCommand(2).mode, Mode::Velocity);
  EXPECT_EQ(queue.nextTime(), 1.5);
  queue.give(world);
  EXPECT_TRUE(std::isinf(queue.nextTime()));
  EXPECT_EQ(queue.given(), queue.size());
  queue.give(world);
  EXPECT_EQ(queue.given(), 4u);
}
}  // namespace
}  // namespace ping_pong
