#include "selection.h"

#include <algorithm>

namespace ping_pong_sim
{
namespace
{
using ping_pong::Group;

bool startsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

bool isTable(const std::string& name)
{
  return startsWith(name, "table");
}
}  // namespace

std::vector<std::string> members(const SimStatus& status, Group group)
{
  std::vector<std::string> names;
  const auto collect = [&](const std::vector<std::string>& from, auto wanted)
  { std::copy_if(from.begin(), from.end(), std::back_inserter(names), wanted); };
  switch (group)
  {
    case Group::None:
      break;
    case Group::Balls:
      // The newest first: it is the one that everybody looks at.
      for (auto id = status.ball_ids.rbegin(); id != status.ball_ids.rend(); ++id)
        names.push_back("ball_" + std::to_string(*id));
      break;
    case Group::Paddles:
      names = status.paddles;
      break;
    case Group::Table:
      collect(status.furniture, isTable);
      break;
    case Group::Walls:
      collect(status.furniture, [](const std::string& name) { return !isTable(name); });
      break;
    case Group::Light:
      collect(status.props, [](const std::string& name) { return startsWith(name, "light"); });
      break;
    case Group::Camera:
      collect(status.props, [](const std::string& name) { return startsWith(name, "camera"); });
      break;
  }
  return names;
}

const std::string& nextOf(const std::vector<std::string>& names, const std::string& current)
{
  const auto found = std::find(names.begin(), names.end(), current);
  const bool next = found != names.end() && std::next(found) != names.end();
  return next ? *std::next(found) : names.front();
}

void putFirst(const std::string& name, std::vector<std::string>& names)
{
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) std::rotate(names.begin(), found, std::next(found));
}

std::string paddleAtMinusX(const PaddleStates& states)
{
  const auto further = [](const PaddleState& a, const PaddleState& b) { return a.pose.position.x < b.pose.position.x; };
  const auto found = std::min_element(states.paddles.begin(), states.paddles.end(), further);
  return found != states.paddles.end() ? found->name : "";
}

bool isPaddle(const SimStatus& status, const std::string& name)
{
  return std::count(status.paddles.begin(), status.paddles.end(), name) > 0;
}
}  // namespace ping_pong_sim
