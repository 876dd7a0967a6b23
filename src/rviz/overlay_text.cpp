#include "overlay_text.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <sstream>

#include "teleop/key_table.h"

namespace ping_pong_sim
{
namespace
{
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...)
{
  char text[400];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(text, sizeof text, pattern, arguments);
  va_end(arguments);
  return text;
}

double norm(const geometry_msgs::Vector3& v)
{
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

double turnsPerSecond(const geometry_msgs::Vector3& w)
{
  return norm(w) / (2.0 * M_PI);
}

// As people say it: degrees, roll, pitch and yaw as in URDF.
std::string poseText(const Eigen::Isometry3d& pose)
{
  const Eigen::Matrix3d R = pose.linear();
  const double degree = 180.0 / M_PI;
  const double roll = std::atan2(R(2, 1), R(2, 2)) * degree;
  const double pitch = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0))) * degree;
  const double yaw = std::atan2(R(1, 0), R(0, 0)) * degree;
  const Eigen::Vector3d p = pose.translation();
  return format("x %+.3f  y %+.3f  z %+.3f m   roll %+.0f  pitch %+.0f  yaw %+.0f deg", p.x(), p.y(), p.z(), roll + 0.0,
                pitch + 0.0, yaw + 0.0);
}

std::string timeText(const SimStatus& status)
{
  std::string text = format("time %.2f s", status.time);
  if (!status.paused) text += format("   real-time factor %.2f", status.real_time_factor);
  return text + format("   balls %u", status.balls);
}

void appendStatus(const SimStatus& status, bool in_match, std::vector<TextLine>& lines)
{
  lines.push_back({Tone::Title, status.scene + (status.paused ? "   paused" : "   running")});
  if (in_match)  // short: the score stands beside it
    lines.push_back({Tone::Normal, format("time %.1f s   x %.2f", status.time, status.real_time_factor)});
  else
    lines.push_back({Tone::Normal, timeText(status)});
  if (status.has_contact && !in_match)
  {
    const Contact& c = status.last_contact;
    lines.push_back({Tone::Normal, format("ball_%u met %s: %.2f -> %.2f m/s, spin %.1f -> %.1f rev/s", c.ball,
                                          c.other.c_str(), norm(c.velocity_before), norm(c.velocity_after),
                                          turnsPerSecond(c.spin_before), turnsPerSecond(c.spin_after))});
  }
  if (!status.paddles.empty() && !in_match)
    lines.push_back({Tone::Normal, format("rally %u   best %u", status.rally, status.best_rally)});
  if (status.rejected > 0) lines.push_back({Tone::Faint, "last refusal: " + status.rejected_reason});
}

void appendOperator(const OperatorLine& line, bool named, bool in_match, std::vector<TextLine>& lines)
{
  const HandsState& state = line.state;
  std::string text = named ? state.operator_name + ": " : "";
  text += state.selected.empty() ? "nothing selected" : state.selected;
  if (line.pose && !in_match) text += "   " + poseText(*line.pose);
  lines.push_back({state.moving ? Tone::Title : Tone::Normal, text});
  if (!state.note.empty()) lines.push_back({Tone::Warning, state.note});
}

// In two columns, so that it leaves the scene to be seen.
void appendHelp(std::vector<TextLine>& lines)
{
  std::vector<std::string> rows;
  std::istringstream help(ping_pong::keyHelp());
  for (std::string row; std::getline(help, row);) rows.push_back(row);
  const std::size_t half = (rows.size() + 1) / 2;
  for (std::size_t i = 0; i < half; ++i)
  {
    std::string text = rows[i];
    if (half + i < rows.size()) text += std::string(text.size() < 46 ? 46 - text.size() : 1, ' ') + rows[half + i];
    lines.push_back({Tone::Faint, text});
  }
}
}  // namespace

std::vector<TextLine> overlayText(const SimStatus* status, const std::vector<OperatorLine>& operators, bool in_match)
{
  std::vector<TextLine> lines;
  if (status != nullptr)
    appendStatus(*status, in_match, lines);
  else
    lines.push_back({Tone::Warning, "no simulator: waiting for its status"});
  bool help = false;
  for (const OperatorLine& line : operators)
  {
    appendOperator(line, operators.size() > 1, in_match, lines);
    help = help || line.state.help;
  }
  if (help)
    appendHelp(lines);
  else if (!operators.empty())
    lines.push_back({Tone::Faint, "H: keys"});
  return lines;
}
}  // namespace ping_pong_sim
