#include "drills.h"

#include <algorithm>
#include <cmath>

namespace ping_pong::play
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

namespace
{
// Until the racket meets it: what the ball has touched.
struct Approach
{
  int own = 0, other = 0, net = 0;
  bool over = false;
  std::string why;  // it did not come to the own half

  void add(Place place, bool net_touched)
  {
    if (place == Place::OwnHalf)
      over = ++own > 1;
    else if (place == Place::OtherHalf)
      over = ++other > 1 || own > 0;
    else if (net_touched)
      ++net;
    else
      over = true;
    if (own == 0 && over)
      why = net > 0 ? "ends in the net" : other > 1 ? "bounces twice before it" : "misses the table";
  }
};

bool touchesNet(const Trial& trial, const Court& court, const Contact& contact)
{
  if (contact.body != court.table()) return false;
  const MaterialId material = trial.world().body(contact.body).shapes[contact.shape].material;
  return trial.world().scene().materials[material] == "net";
}

Outcome outcomeOf(Place place, const Court& court, const Contact& contact)
{
  if (place == Place::OtherHalf) return Outcome::Returned;
  if (place == Place::Paddle) return Outcome::TouchedTwice;
  return contact.body == court.table() ? Outcome::IntoNet : Outcome::Out;
}
}  // namespace

ReturnResult returnOf(Trial& trial, const BallState& launch, std::uint64_t seed)
{
  const Court court = trial.player(0).court();
  trial.restart(court.toWorld(launch), seed);
  ReturnResult result;
  StrokeWish wish;
  Approach approach;
  bool struck = false;
  for (double until = kLongest; trial.world().time() < until && !approach.over;)
  {
    if (!struck && trial.player(0).plan() != nullptr) wish = trial.player(0).plan()->wish;
    trial.tick();
    for (const Contact& contact : trial.world().contacts())
    {
      const Place place = placeOf(trial, court, contact);
      if (struck)
      {
        result.landing_error = missOf(court, contact, wish);
        result.outcome = outcomeOf(place, court, contact);
        return result;
      }
      if (place != Place::Paddle)
      {
        approach.add(place, touchesNet(trial, court, contact));
        continue;
      }
      result.stroke = wish.stroke;
      result.spin = contact.w_before.norm();
      result.speed = contact.v_before.norm();
      result.outcome = Outcome::Volley;
      if (approach.own == 0) return result;
      struck = true;
      until = trial.world().time() + kLongest;
    }
  }
  result.outcome = approach.own > 0 || struck ? Outcome::Untouched : Outcome::NotItsHalf;
  result.why = result.outcome == Outcome::NotItsHalf && approach.why.empty() ? "stays in the net" : approach.why;
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

RallyResult rallyOf(Trial& trial, std::uint64_t seed, std::size_t most)
{
  trial.restart(trial.player(0).toss(), seed);
  trial.serves(0);
  RallyResult rally;
  std::size_t last = kNone;
  bool good = true;  // the ball may be struck
  const auto lost = [&] { return RallyResult{rally.strokes, last == kNone ? 0 : good ? 1 - last : last}; };
  for (double touched = 0.0; rally.strokes < most;)
  {
    if (trial.world().time() > touched + kLongest) return lost();
    trial.tick();
    for (const Contact& contact : trial.world().contacts())
    {
      touched = trial.world().time();
      const std::size_t striker = trial.playerOf(contact.body);
      if (striker != kNone)
      {
        if (striker == last || !good) return {rally.strokes, striker};  // twice, or before its bounce
        trial.serves(kNone);
        last = striker;
        good = false;
        ++rally.strokes;
        continue;
      }
      if (last == kNone) return lost();
      const Place place = placeOf(trial, trial.player(last).court(), contact);
      const bool own_bounce_of_serve = rally.strokes == 1 && place == Place::OwnHalf;
      if (place == Place::OtherHalf && !good)
        good = true;
      else if (!own_bounce_of_serve && !touchesNet(trial, trial.player(last).court(), contact))
        return lost();
    }
  }
  return rally;
}
}  // namespace ping_pong::play
