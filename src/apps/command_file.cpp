#include "command_file.h"

#include <array>
#include <cmath>
#include <utility>

#include "line_reader.h"

namespace ping_pong
{
namespace
{
constexpr char kHeader[] = "time,body,mode,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,ax,ay,az,alphax,alphay,alphaz";

enum Column : std::size_t
{
  kTime = 0,
  kBody = 1,
  kMode = 2,
  kPosition = 3,
  kOrientation = 6,
  kVelocity = 10,
  kAngularVelocity = 13,
  kAcceleration = 16,
  kAngularAcceleration = 19,
  kColumns = 22
};

struct ModeName
{
  const char* text;
  PaddleCommand::Mode mode;
};

constexpr std::array<ModeName, 4> kModeNames = {{{"hold", PaddleCommand::Mode::Hold},
                                                 {"acceleration", PaddleCommand::Mode::Acceleration},
                                                 {"velocity", PaddleCommand::Mode::Velocity},
                                                 {"pose", PaddleCommand::Mode::Pose}}};

std::vector<std::string> split(const std::string& line)
{
  std::vector<std::string> fields(1);
  for (const char letter : line)
    if (letter == ',')
      fields.emplace_back();
    else
      fields.back() += letter;
  return fields;
}

std::string columnName(std::size_t column)
{
  static const std::vector<std::string> names = split(kHeader);
  return column < kColumns ? names[column] : "column " + std::to_string(column + 1);
}

/// Whether a command of this mode has a value in this column.
bool uses(PaddleCommand::Mode mode, std::size_t column)
{
  if (column >= kAcceleration) return mode == PaddleCommand::Mode::Acceleration;
  if (column >= kVelocity) return mode == PaddleCommand::Mode::Velocity || mode == PaddleCommand::Mode::Pose;
  return column < kPosition || mode == PaddleCommand::Mode::Pose;
}

/// One line of the file, a field per column.
class Row
{
public:
  Row(const std::string& line, const FileLine& at) : at_(at), fields_(split(line))
  {
    const std::string expected = std::to_string(kColumns) + " fields, not " + std::to_string(fields_.size());
    if (fields_.size() < kColumns) failWith(fields_.size(), "missing", expected);
    if (fields_.size() > kColumns) failWith(kColumns, fields_[kColumns], expected);
  }

  const std::string& text(std::size_t column) const { return fields_[column]; }
  double number(std::size_t column) const
  {
    double number = 0.0;
    if (text(column).empty()) failWith(column, "nothing", "a finite number, since mode " + text(kMode) + " uses it");
    if (!parseNumber(text(column), number)) fail(column, "a finite number");
    return number;
  }
  Vector3d vector(std::size_t first) const { return {number(first), number(first + 1), number(first + 2)}; }
  Quaterniond quaternion(std::size_t first) const
  {
    const Quaterniond q(number(first), number(first + 1), number(first + 2), number(first + 3));
    if (!(std::abs(q.norm() - 1.0) < 1e-6))
      failWith(first, "[" + joined({fields_.begin() + first, fields_.begin() + first + 4}) + "]",
               "a quaternion qw, qx, qy, qz of length 1");
    return q.normalized();
  }

  [[noreturn]] void fail(std::size_t column, const std::string& expected) const
  {
    failWith(column, text(column), expected);
  }
  [[noreturn]] void failWith(std::size_t column, const std::string& value, const std::string& expected) const
  {
    failLoad(at_, columnName(column), value, expected);
  }

private:
  const FileLine& at_;
  std::vector<std::string> fields_;
};

double readTime(const Row& row, const std::string& earlier)
{
  double time = 0.0, before = 0.0;
  parseNumber(earlier, before);
  if (!parseNumber(row.text(kTime), time) || !(time >= 0.0)) row.fail(kTime, "a finite number >= 0");
  if (time < before) row.fail(kTime, "a time that is not before that of the row above, " + earlier);
  return time;
}

std::size_t readBody(const Row& row, const std::vector<Body>& bodies)
{
  std::vector<std::string> paddles;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    if (bodies[i].kind == BodyKind::Kinematic) paddles.push_back(bodies[i].name);
    if (bodies[i].name != row.text(kBody)) continue;
    if (bodies[i].kind == BodyKind::Kinematic) return i;
    row.fail(kBody, "a kinematic body; this one is static");
  }
  row.fail(kBody,
           paddles.empty() ? "a scene with a kinematic body" : "a kinematic body of the scene: " + joined(paddles));
}

PaddleCommand::Mode readMode(const Row& row)
{
  std::vector<std::string> names;
  for (const ModeName& known : kModeNames)
  {
    if (row.text(kMode) == known.text) return known.mode;
    names.push_back(known.text);
  }
  row.fail(kMode, "one of " + joined(names));
}

PaddleCommand readCommand(const Row& row)
{
  PaddleCommand command;
  command.mode = readMode(row);
  for (std::size_t column = kPosition; column < kColumns; ++column)
    if (!uses(command.mode, column) && !row.text(column).empty())
      row.fail(column, "nothing, since mode " + row.text(kMode) + " does not use it");
  if (uses(command.mode, kPosition)) command.pose = {row.vector(kPosition), row.quaternion(kOrientation)};
  if (uses(command.mode, kVelocity)) command.twist = {row.vector(kVelocity), row.vector(kAngularVelocity)};
  if (uses(command.mode, kAcceleration)) command.a_W = row.vector(kAcceleration);
  if (uses(command.mode, kAcceleration)) command.alpha_W = row.vector(kAngularAcceleration);
  return command;
}

/// Comments begin with #.
bool nextRow(LineReader& lines, std::string& line)
{
  while (lines.next(line))
    if (line.empty() || line[0] != '#') return true;
  return false;
}
}  // namespace

std::vector<TimedCommand> readCommands(const std::string& path, const std::vector<Body>& bodies)
{
  LineReader lines(path, "commands");
  std::string line, time = "0";
  if (!nextRow(lines, line)) failLoad(lines.at(), "header", "nothing", kHeader);
  if (line != kHeader) failLoad(lines.at(), "header", line, kHeader);
  std::vector<TimedCommand> commands;
  while (nextRow(lines, line))
  {
    const Row row(line, lines.at());
    commands.push_back({readTime(row, time), readBody(row, bodies), readCommand(row)});
    time = row.text(kTime);
  }
  if (commands.empty()) failLoad(lines.at(), "commands", "nothing", "at least one command below the header");
  return commands;
}
}  // namespace ping_pong
