// The strokes of table tennis as wishes: spin, flight time, place of the hit, depth of the target.
#pragma once

#include <string>
#include <vector>

namespace ping_pong
{
class Random;
}

namespace ping_pong::play
{
}

namespace ping_pong::play
{
}

namespace ping_pong::play
{
enum class Stroke
{
  Drive,
  Loop,
  Push,
  Block,
  Chop,
  Smash,
  LongServe,
  ShortServe,
  SideServe
};

enum class Style
{
  Attack,
  Defend,
  Mixed,
  Cooperative  ///< keeps a rally going: gentle drives to the middle
};

const char* name(Stroke stroke);
/// Throws std::invalid_argument that lists the known names.
Style styleFromName(const std::string& text);

/// What a stroke asks for. Spin is that of the ball as it leaves; the planner gives as much of it as racket and friction can.
struct StrokeWish
{
  Stroke stroke = Stroke::Drive;
  bool brush = true;                      ///< false: the spin is left to the ball, the face just meets it
  double topspin = 0.0;                   ///< about the axis across the flight; below zero backspin [rad/s]
  double sidespin = 0.0;                  ///< about z [rad/s]
  double flight_time = 0.4;               ///< to the target; a serve: speed along x instead, see `speed` [s]
  double speed = 5.0;                     ///< serves only [m/s]
  double own_bounce = -0.8;               ///< serves only: x of the first landing [m]
  double over_net = 0.03;                 ///< gap between ball and net, at least [m]
  double target_x = 0.9, target_y = 0.0;  ///< on the other half [m]
  double hit_height = 0.25;               ///< where it likes to hit, centre above the table [m]
  double hit_x = -1.7;                    ///< the same along the table [m]
};

/// What the choice depends on.
struct Incoming
{
  double topspin = 0.0;   ///< as the ball comes [rad/s]
  double speed = 0.0;     ///< after its bounce [m/s]
  double highest = 0.0;   ///< of the centre on the way through the reach [m]
  bool is_short = false;  ///< it would bounce again on the table
};

/// Wishes in the order in which they are tried: the stroke of choice, then safer ones.
/// @param half_length, half_width  of the table [m]
std::vector<StrokeWish> chooseStrokes(const Incoming& incoming, Style style, double half_length, double half_width,
                                      Random& random);
/// The same for a serve.
std::vector<StrokeWish> chooseServes(Style style, double half_length, double half_width, Random& random);
}  // namespace ping_pong::play
