#include "key_table.h"

namespace ping_pong
{
const std::vector<KeyEntry>& keyTable()
{
  static const std::vector<KeyEntry> table = {
      {'1', Action::Select, "1", "newest ball; again: the next", Group::Balls},
      {'2', Action::Select, "2", "table", Group::Table},
      {'3', Action::Select, "3", "walls; again: the next", Group::Walls},
      {'4', Action::Select, "4", "light; again: the next", Group::Light},
      {'5', Action::Select, "5", "paddle; again: the next", Group::Paddles},
      {'6', Action::Select, "6", "camera", Group::Camera},
      {'w', Action::Move, "W", "away from you", Group::None, 0, +1},
      {'s', Action::Move, "S", "towards you", Group::None, 0, -1},
      {'a', Action::Move, "A", "left", Group::None, 1, +1},
      {'d', Action::Move, "D", "right", Group::None, 1, -1},
      {'q', Action::Move, "Q", "up", Group::None, 2, +1},
      {'e', Action::Move, "E", "down", Group::None, 2, -1},
      {'r', Action::Turn, "R", "roll right", Group::None, 0, +1},
      {'t', Action::Turn, "T", "roll left", Group::None, 0, -1},
      {'f', Action::Turn, "F", "tilt away from you", Group::None, 1, +1},
      {'g', Action::Turn, "G", "tilt towards you", Group::None, 1, -1},
      {'v', Action::Turn, "V", "turn left", Group::None, 2, +1},
      {'b', Action::Turn, "B", "turn right", Group::None, 2, -1},
      {' ', Action::Pause, "space", "pause, go on"},
      {'n', Action::Step, "N", "one step"},
      {kBackspace, Action::Reset, "backspace", "back to the start"},
      {kEnter, Action::Serve, "enter", "serve a ball"},
      {'m', Action::NewMatch, "M", "new match"},
      {'+', Action::Level, "+", "stronger opponent", Group::None, 0, +1},
      {'-', Action::Level, "-", "weaker opponent", Group::None, 0, -1},
      {'h', Action::Help, "H", "show the keys, hide them"},
      {'p', Action::Tool, "P", "the mouse plays", Group::None, 0},
      {'k', Action::Tool, "K", "the mouse looks around", Group::None, 1},
      {'i', Action::Tool, "I", "the mouse drags things", Group::None, 2},
      {kFunction + 1, Action::View, "F1", "player's view", Group::None, 0},
      {kFunction + 2, Action::View, "F2", "umpire's view", Group::None, 1},
      {kFunction + 3, Action::View, "F3", "from above", Group::None, 2},
      {kFunction + 4, Action::View, "F4", "behind the ball", Group::None, 3},
      {kFunction + 5, Action::View, "F5", "with the paddle", Group::None, 4},
  };
  return table;
}

const KeyEntry* findKey(Key key)
{
  for (const KeyEntry& entry : keyTable())
  {
    if (entry.key == key) return &entry;
  }
  return nullptr;
}

std::string keyHelp()
{
  std::string help;
  for (const KeyEntry& entry : keyTable())
  {
    const std::string label = entry.label;
    help += label + std::string(label.size() < 10 ? 10 - label.size() : 1, ' ') + entry.text + "\n";
  }
  return help;
}
}  // namespace ping_pong
