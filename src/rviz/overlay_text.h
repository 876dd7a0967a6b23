// What the overlay says, from what the topics say.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "ping_pong_sim/HandsState.h"
#include "ping_pong_sim/SimStatus.h"

namespace ping_pong_sim
{
enum class Tone
{
  Title,
  Normal,
  Faint,
  Warning
};

struct TextLine
{
  Tone tone;
  std::string text;
  bool operator==(const TextLine& other) const { return tone == other.tone && text == other.text; }
};

/// Somebody at the keys, and where what they selected is.
struct OperatorLine
{
  HandsState state;
  std::optional<Eigen::Isometry3d> pose;  ///< in the fixed frame
};

/// @param status    null: the simulator is silent
/// @param in_match  the score board says what the rally is
std::vector<TextLine> overlayText(const SimStatus* status, const std::vector<OperatorLine>& operators, bool in_match);
}  // namespace ping_pong_sim
