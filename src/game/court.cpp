#include "game/court.h"

#include <algorithm>
#include <cmath>

namespace ping_pong::game
{
namespace
{
// Contacts are located to 1e-9 m; far more than that below the edge is the side.
constexpr double kEdge = 1e-6;  // [m]

// Only the top and its edges have a normal that points upwards at all. Methods that look at the ends of steps report points inside
// the table, so that the depth alone would not do.
bool onTop(const Vector3d& p_TC, const Vector3d& n_T)
{
  return p_TC.z() >= -kEdge || n_T.z() > kEdge;
}

// Part of the line p + s v, s >= 0, where |p + s v| <= half, cut from [from, to].
bool clip(double p, double v, double half, double& from, double& to)
{
  if (v == 0.0) return std::abs(p) <= half;
  const double a = (-half - p) / v;
  const double b = (half - p) / v;
  from = std::max(from, std::min(a, b));
  to = std::min(to, std::max(a, b));
  return from <= to;
}
}  // namespace

Touch Court::touchOf(const Contact& contact, BallId ball, double radius) const
{
  Touch touch;
  touch.time = contact.time;
  const bool first = contact.ball == ball;
  touch.p_TB = positionInT(contact.p_WC + (first ? radius : -radius) * contact.n_W);
  touch.v_TB = vectorInT(first ? contact.v_before : contact.v_other);
  touch.body = contact.body;
  touch.shape = contact.shape;
  if (contact.with_ball)
  {
    touch.part = Part::Ball;
    return touch;
  }
  if (contact.body < roles.size() && contact.shape < roles[contact.body].size())
    touch.part = roles[contact.body][contact.shape].part;
  const Vector3d p_TC = positionInT(contact.p_WC);
  if (touch.part == Part::Court)
  {
    touch.end = p_TC.x() < 0.0 ? End::Minus : End::Plus;
    if (!onTop(p_TC, vectorInT(contact.n_W))) touch.part = Part::Side;
  }
  if (touch.part == Part::Racket) touch.end = contact.body == racket[index(End::Minus)] ? End::Minus : End::Plus;
  return touch;
}

std::string Court::nameOf(const Touch& touch) const
{
  switch (touch.part)
  {
    case Part::Court:
      return std::string("the court at ") + name(touch.end);
    case Part::Side:
      return "the side of the table";
    case Part::Net:
      return "the net assembly";
    case Part::Racket:
      return std::string("the racket at ") + name(touch.end);
    case Part::Ball:
      return "another ball";
    case Part::Other:
      break;
  }
  if (touch.body < roles.size() && touch.shape < roles[touch.body].size())
    return "the " + roles[touch.body][touch.shape].name;
  return "something else";
}

bool Court::behindEndLine(End end, const Vector3d& p_TB, double radius) const
{
  return sign(end) * p_TB.x() - radius >= half_length - kEdge;
}

bool Court::overSurface(const Vector3d& p_TB, double radius) const
{
  return p_TB.z() > 0.0 && std::abs(p_TB.x()) < half_length + radius && std::abs(p_TB.y()) < half_width + radius;
}

bool Court::mayStillLand(const Vector3d& p_TB, const Vector3d& v_TB, double radius) const
{
  if (p_TB.z() <= 0.0) return false;
  if (overSurface(p_TB, radius)) return true;
  double from = 0.0;
  double to = HUGE_VAL;
  return clip(p_TB.x(), v_TB.x(), half_length + radius, from, to) &&
         clip(p_TB.y(), v_TB.y(), half_width + radius, from, to);
}

void Court::moveTable(const Pose& X_WB_new)
{
  X_WB = X_WB_new;
  X_WT.p = X_WB.p + X_WB.q * X_BT.p;
  X_WT.q = X_WB.q * X_BT.q;
}
}  // namespace ping_pong::game
