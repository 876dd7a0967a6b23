#include "stroke.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/random.h"

namespace ping_pong::play
{
namespace
{
// Spins and times are those of good players; docs/player.md. Places are for the paddle's way: behind the end line it is free.
StrokeWish basic(Stroke stroke)
{
  StrokeWish wish;
  wish.stroke = stroke;
  switch (stroke)
  {
    case Stroke::Drive:
      wish.topspin = 150.0, wish.flight_time = 0.36, wish.target_x = 1.0;
      break;
    case Stroke::Loop:
      wish.topspin = 420.0, wish.flight_time = 0.40, wish.target_x = 1.05, wish.hit_height = 0.15, wish.hit_x = -1.9;
      wish.over_net = 0.06;
      break;
    case Stroke::Push:
      wish.topspin = -150.0, wish.flight_time = 0.50, wish.target_x = 0.85, wish.hit_x = -1.5, wish.hit_height = 0.2;
      break;
    case Stroke::Block:
      wish.brush = false, wish.flight_time = 0.42, wish.target_x = 0.9, wish.hit_x = -1.55;
      break;
    case Stroke::Chop:
      wish.topspin = -300.0, wish.flight_time = 0.60, wish.target_x = 0.95, wish.hit_height = 0.10, wish.hit_x = -2.2;
      break;
    case Stroke::Smash:
      wish.topspin = 40.0, wish.flight_time = 0.20, wish.target_x = 0.95, wish.hit_height = 0.45, wish.hit_x = -1.6;
      break;
    case Stroke::LongServe:
      wish.topspin = 100.0, wish.speed = 5.5, wish.own_bounce = -0.95, wish.target_x = 1.1, wish.over_net = 0.01;
      break;
    case Stroke::ShortServe:
      wish.topspin = -120.0, wish.speed = 3.2, wish.own_bounce = -0.75, wish.target_x = 0.5, wish.over_net = 0.01;
      break;
    case Stroke::SideServe:
      wish.topspin = 40.0, wish.sidespin = 180.0, wish.speed = 4.2, wish.own_bounce = -0.85, wish.target_x = 0.9;
      wish.over_net = 0.01;
      break;
  }
  return wish;
}

Stroke drawn(const Incoming& incoming, Style style, Random& random)
{
  const double chance = random.uniform(0.0, 1.0);
  const bool attack = style == Style::Attack || (style == Style::Mixed && chance < 0.55);
  const double second = random.uniform(0.0, 1.0);
  const bool backspin = incoming.topspin < -40.0;
  if (attack && incoming.highest > 0.38 && incoming.speed < 9.0) return Stroke::Smash;
  if (incoming.is_short) return backspin || !attack ? Stroke::Push : Stroke::Drive;
  if (incoming.speed > 12.0) return second < 0.7 ? Stroke::Block : Stroke::Drive;
  if (attack) return backspin ? Stroke::Loop : second < 0.5 ? Stroke::Loop : Stroke::Drive;
  if (backspin) return second < 0.8 ? Stroke::Push : Stroke::Drive;
  return second < 0.5 ? Stroke::Chop : Stroke::Block;
}

void place(StrokeWish& wish, Style style, double half_length, double half_width, Random& random)
{
  const double inside = half_length - 0.12;
  const double side = random.uniform(-1.0, 1.0), depth = random.uniform(-1.0, 1.0);
  const bool corners = style == Style::Attack && wish.stroke != Stroke::Block;
  const double widest = half_width - 0.12;
  wish.target_y = corners ? (side < 0.0 ? -1.0 : 1.0) * widest * (0.6 + 0.4 * std::abs(side)) : 0.7 * widest * side;
  wish.target_x = std::min(wish.target_x + 0.12 * depth, inside);
}
}  // namespace

const char* name(Stroke stroke)
{
  static const char* const names[] = {"drive", "loop",  "push",        "block",     "chop",
                                      "smash", "serve", "short serve", "side serve"};
  return names[static_cast<int>(stroke)];
}

Style styleFromName(const std::string& text)
{
  if (text == "attack") return Style::Attack;
  if (text == "defend") return Style::Defend;
  if (text == "mixed") return Style::Mixed;
  if (text == "cooperative") return Style::Cooperative;
  throw std::invalid_argument("style: " + text + ": expected attack, defend, mixed or cooperative");
}

std::vector<StrokeWish> chooseStrokes(const Incoming& incoming, Style style, double half_length, double half_width,
                                      Random& random)
{
  std::vector<StrokeWish> wishes;
  if (style == Style::Cooperative)
  {
    StrokeWish gentle = basic(Stroke::Drive);
    gentle.topspin = 80.0, gentle.flight_time = 0.5, gentle.over_net = 0.08, gentle.target_x = 0.9;
    gentle.target_y = random.uniform(-0.2, 0.2);
    wishes.push_back(gentle);
  }
  else
  {
    wishes.push_back(basic(drawn(incoming, style, random)));
    place(wishes.back(), style, half_length, half_width, random);
  }
  const double y = wishes.front().target_y;
  for (const Stroke safer : {Stroke::Drive, Stroke::Push, Stroke::Block})
  {
    if (safer == wishes.front().stroke) continue;
    wishes.push_back(basic(safer));
    wishes.back().target_y = 0.7 * y;
    if (safer == Stroke::Drive) wishes.back().topspin = 60.0, wishes.back().flight_time = 0.45;
  }
  return wishes;
}

std::vector<StrokeWish> chooseServes(Style style, double half_length, double half_width, Random& random)
{
  const Stroke kinds[] = {Stroke::LongServe, Stroke::ShortServe, Stroke::SideServe};
  const double draw = random.uniform(0.0, 3.0), handed = random.uniform(-1.0, 1.0);
  std::vector<StrokeWish> wishes;
  if (style != Style::Cooperative)
  {
    wishes.push_back(basic(kinds[std::min(2, static_cast<int>(draw))]));
    place(wishes.back(), Style::Mixed, half_length, half_width, random);
    if (handed < 0.0) wishes.back().sidespin = -wishes.back().sidespin;
  }
  StrokeWish plain = basic(Stroke::LongServe);
  plain.topspin = 30.0, plain.target_x = 0.9, plain.speed = 4.5, plain.own_bounce = -0.8;
  wishes.push_back(plain);
  return wishes;
}
}  // namespace ping_pong::play
