#include "drills.h"

#include <algorithm>
#include <cmath>

namespace ping_pong
{
namespace
{
constexpr double kLongest = 4.0;     // from one touch to the next [s]
constexpr double kLeastRise = 0.16;  // of a toss, ITTF 2.6.2 [m]

enum class Place
{
  OwnHalf,
  OtherHalf,
  Paddle,
  Elsewhere
};

Place placeOf(const Trial& trial, const Court& court, const Contact& contact)
{
  if (trial.playerOf(contact.body) != kNone) return Place::Paddle;
  if (contact.body != court.table() || contact.shape != court.surface()) return Place::Elsewhere;
  const Pose at = court.toOwn(Pose{contact.p_WC, Quaterniond::Identity()});
  if (at.p.z() < -1e-3) return Place::Elsewhere;
  return at.p.x() < 0.0 ? Place::OwnHalf : Place::OtherHalf;
}

double missOf(const Court& court, const Contact& contact, const StrokeWish& wish)
{
  const Vector3d at = court.toOwn(Pose{contact.p_WC, Quaterniond::Identity()}).p;
  return std::hypot(at.x() - wish.target_x, at.y() - wish.target_y);
}
}  // namespace

const char* name(Outcome outcome)
{
  static const char* const names[] = {"returned", "not its half", "untouched", "touched twice", "into net", "out"};
  return names[static_cast<int>(outcome)];
}

ReturnResult returnOf(Trial& trial, const BallState& launch, std::uint64_t seed)
{
  const Court court = trial.player(0).court();
  trial.restart(court.toWorld(launch), seed);
  ReturnResult result;
  StrokeWish wish;
  bool bounced = false, struck = false;
  for (double until = kLongest; trial.world().time() < until;)
  {
    if (!struck && trial.player(0).plan() != nullptr) wish = trial.player(0).plan()->wish;
    trial.tick();
    for (const Contact& contact : trial.world().contacts())
    {
      const Place place = placeOf(trial, court, contact);
      if (struck)
      {
        result.landing_error = missOf(court, contact, wish);
        result.outcome = place == Place::OtherHalf       ? Outcome::Returned
                         : place == Place::Paddle        ? Outcome::TouchedTwice
                         : contact.body == court.table() ? Outcome::IntoNet
                                                         : Outcome::Out;
        return result;
      }
      if (place == Place::Paddle)
      {
        result.stroke = wish.stroke;
        result.spin = contact.w_before.norm();
        result.speed = contact.v_before.norm();
        if (!bounced)
        {
          result.outcome = Outcome::NotItsHalf;
          return result;
        }
        struck = true;
        until = trial.world().time() + kLongest;
      }
      else if (place == Place::OwnHalf && !bounced)
        bounced = true;
      else if (place != Place::OtherHalf || bounced)
      {
        result.outcome = bounced ? Outcome::Untouched : Outcome::NotItsHalf;
        if (bounced || place == Place::Elsewhere) return result;
      }
    }
  }
  return result;
}

ServeResult serveOf(Trial& trial, std::uint64_t seed)
{
  const Court court = trial.player(0).court();
  const BallState toss = trial.player(0).toss();
  trial.restart(toss, seed);
  trial.serves(0);
  ServeResult result;
  StrokeWish wish;
  double highest = toss.p_WB.z();
  int touches = 0;
  const auto fault = [&](const std::string& what)
  {
    result.fault = what;
    return result;
  };
  while (trial.world().time() < kLongest)
  {
    if (touches == 0 && trial.player(0).plan() != nullptr) wish = trial.player(0).plan()->wish;
    trial.tick();
    highest = std::max(highest, trial.world().ballState(0).p_WB.z());
    for (const Contact& contact : trial.world().contacts())
    {
      const Place place = placeOf(trial, court, contact);
      const Vector3d p = court.toOwn(trial.world().ballState(0)).p_WB;
      if (touches == 0)
      {
        result.rise = highest - toss.p_WB.z();
        result.stroke = wish.stroke;
        if (place != Place::Paddle) return fault("not struck");
        if (result.rise < kLeastRise) return fault("toss too low");
        if (contact.v_before.z() >= 0.0) return fault("struck as it rises");
        if (contact.p_WC.z() < court.toWorld(Pose()).p.z()) return fault("struck below the surface");
        if (p.x() > -court.halfLength()) return fault("struck over the table");
        trial.serves(kNone);
      }
      else if (touches == 1 && place != Place::OwnHalf)
        return fault(place == Place::Paddle ? "struck twice" : "not on the own half first");
      else if (touches == 2)
      {
        if (place != Place::OtherHalf) return fault("not on the other half");
        result.landing_error = missOf(court, contact, wish);
        result.legal = true;
        return result;
      }
      ++touches;
    }
  }
  return fault("nothing happened");
}

std::size_t rallyOf(Trial& trial, std::uint64_t seed, std::size_t most)
{
  trial.restart(trial.player(0).toss(), seed);
  trial.serves(0);
  std::size_t strokes = 0, last = kNone;
  bool good = true;  // the ball may be struck
  for (double touched = 0.0; strokes < most && trial.world().time() < touched + kLongest;)
  {
    trial.tick();
    for (const Contact& contact : trial.world().contacts())
    {
      const std::size_t striker = trial.playerOf(contact.body);
      if (striker != kNone)
      {
        if (!good || striker == last) return strokes;
        trial.serves(kNone);
        last = striker;
        good = false;
        ++strokes;
      }
      else
      {
        if (last == kNone) return strokes;
        const Place place = placeOf(trial, trial.player(last).court(), contact);
        const bool own_bounce_of_serve = strokes == 1 && place == Place::OwnHalf;
        if (place == Place::OtherHalf && !good)
          good = true;
        else if (!own_bounce_of_serve)
          return strokes;
      }
      touched = trial.world().time();
    }
  }
  return strokes;
}
}  // namespace ping_pong
