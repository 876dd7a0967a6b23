// The one table of keys, for RViz and for terminals.
#pragma once

#include <string>
#include <vector>

namespace ping_pong
{
/// A key: its character, letters in lower case, or one of the codes below.
using Key = int;
constexpr Key kEnter = '\n';
constexpr Key kBackspace = '\b';
constexpr Key kFunction = 0x100;  ///< F1 is kFunction + 1

enum class Action
{
  Select,  ///< what `group` says; again: the next of the group
  Move,    ///< along `axis` in direction `sign`
  Turn,    ///< about `axis` in direction `sign`
  Pause,
  Step,
  Reset,
  Serve,  ///< the umpire throws the ball up; without a match: launches one
  NewMatch,
  Level,  ///< of the opponent: one up or down, as `sign` says
  Help,
  Tool,  ///< what the mouse does: number `axis`, from 0: play, look around, drag
  View   ///< saved view number `axis`, from 0
};

enum class Group
{
  None,
  Balls,
  Table,
  Walls,
  Light,
  Paddles,
  Camera
};

struct KeyEntry
{
  Key key;
  Action action;
  const char* label;  ///< as a person writes the key
  const char* text;   ///< what it does
  Group group = Group::None;
  int axis = 0;  ///< 0: away from the viewer, 1: to the left, 2: up
  int sign = 0;
};

const std::vector<KeyEntry>& keyTable();
/// Null for a key that does nothing.
const KeyEntry* findKey(Key key);
/// The table for people, a line per row.
std::string keyHelp();
}  // namespace ping_pong
