#include "random_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "contact_law.h"
#include "moment.h"
#include "ping_pong_sim/state_hash.h"
#include "play.h"

namespace ping_pong::stability
{
namespace
{
constexpr double kGone = 3.0;           // further from where it was a ball meets nothing any more [m]
constexpr double kProbe = 1e-4;         // so long forces are measured [s]
constexpr int kProbeEvery = 5;          // ticks
constexpr int kSameBitsEvery = 10;      // scenes
constexpr double kSmallMoment = 1e-12;  // [s]

// Part of forces that no law explains. In 0.1 ms directions turn by 1e-2 at most and their means stand for them to
// 1e-4; a piece of path with an error of 1e-6 m over a second has forces true to some 1e-3.
constexpr double kAgainstTheLaw = 5e-3;
constexpr double kPlaced = 2e-10;  // a ball put down in touch may sink in by as much, and is lifted [m]
// Bounces that no longer count are slower than 1e-5 m/s, and each leaves a part e_t of the slip that the one before it
// left; roundings are smaller. Besides, what the tolerance permits: 1e-6 m in a second is 1e-6 m/s.
constexpr double kNoSlip = 1e-8;  // [m/s]
constexpr double kStill = 1e-9;   // [m/s]
constexpr double kSurely = 0.99;  // of what can hold a ball

class RandomRun
{
public:
  RandomRun(const RandomScene& drawn, Method method, double dt)
      : drawn_(drawn), scene_(drawn.scene), pull_(pullOf(scene_)), play_(drawn, method, dt)
  {
    if (drawn.hasWhole()) whole_ = std::make_unique<World>(withMethod(drawn.whole, method, dt));
    now_ = momentOf(world(), pull_);
    lowest_ = now_.energy;
    for (std::size_t i = 1; i < scene_.materials.size(); ++i)
      bouncy_ |= scene_.surfaces.at(0, static_cast<MaterialId>(i)).restitution > 0.95;
  }

  /// Until something is lost, or the end.
  Verdict run();

private:
  bool tick(int number);
  bool step(double duration);
  const World& world() const { return play_.world(); }
  const Surface& lawOf(const ShapeName& of) const
  {
    return scene_.surfaces.at(0, scene_.bodies[of.body].shapes[of.shape].material);
  }

  void checkStatus(const StepStatus& status);
  void countEvents(const StepStatus& status, double duration);
  void checkQuietTime();
  void checkState();
  void checkRecord(const StepStatus& status);
  void checkContact(const Contact& contact);
  void checkDepth();
  void checkThrough(const std::vector<Pose>& earlier);
  void checkGain();
  void checkLoss(bool contacts);
  void checkSlip(bool contacts);
  void checkRest(bool contacts);
  void checkSeam(double duration);

  bool conserves() const;
  bool holdsIts(const Touch& touch) const;
  bool allLoaded() const;
  bool resistanceHolds(const Touch& touch) const;
  double energySlack() const;
  double slipSlack() const { return kNoSlip + scene_.tolerance; }
  bool still() const { return !drawn_.moves(); }
  void note(Check check, double value, double bound) { verdict_.note(check, value, bound, now_.time); }

  const RandomScene& drawn_;
  const Scene& scene_;
  const Vector3d pull_;
  Play play_;
  std::unique_ptr<World> whole_;
  Moment last_, now_;
  bool bouncy_ = false;   // a surface sends a ball back as fast as it comes, or nearly
  bool at_rest_ = false;  // at the start and the end of the last tick
  double lowest_ = 0.0;   // energy so far [J/kg]
  double quiet_events_ = 0.0, quiet_time_ = 0.0, events_ = 0.0;
  Verdict verdict_;
};

// --- energy ---

// What the tolerance permits: 1e-6 m in a second is 1e-6 m/s of a velocity, a part of that of its square, and more
// where gravity makes it faster within the second. And roundings, the last bounces of 1e-12 m among them.
double RandomRun::energySlack() const
{
  const double speed = std::max(now_.scale(), last_.scale()) + pull_.norm() * 1.0;
  return speed * scene_.tolerance + 1e-12 * speed * speed + kPlaced * pull_.norm();
}

void RandomRun::checkGain()
{
  const bool wind = scene_.forces.dependOnVelocity() && !scene_.forces.wind.isZero(0.0);
  if (!still() || scene_.forces.added_mass || wind) return;
  const double gain = now_.energy - lowest_;
  note(Check::Gain, gain, energySlack());
  verdict_.gain = std::max(verdict_.gain, gain / (now_.scale() * now_.scale()));
  lowest_ = std::min(lowest_, now_.energy);
}

// Smooth, or without slip, and nothing that resists.
bool RandomRun::holdsIts(const Touch& touch) const
{
  const Surface& law = lawOf(touch.of);
  if (law.friction == 0.0) return true;
  return std::isinf(law.friction) && law.rolling_resistance == 0.0 && law.spin_friction == 0.0;
}

bool RandomRun::conserves() const
{
  const Forces& forces = scene_.forces;
  if (forces.drag || forces.added_mass || forces.spin_decay > 0.0) return false;
  if (forces.magnus && !forces.wind.isZero(0.0)) return false;
  if (!sameTouches(last_, now_)) return false;
  for (const Moment* moment : {&last_, &now_})
  {
    const double reach = (now_.time - last_.time) * (moment->scale() + pull_.norm() * (now_.time - last_.time));
    for (const Touch& touch : moment->around)
      if (touch.gap >= kTouchGap && touch.gap < reach) return false;
    for (const Touch& touch : moment->touching)
    {
      if (!holdsIts(touch)) return false;
      if (lawOf(touch.of).friction > 0.0 && slipOf(touch, moment->ball, moment->radius).norm() > slipSlack())
        return false;
    }
  }
  return true;
}

void RandomRun::checkLoss(bool contacts)
{
  if (still() && !contacts && conserves()) note(Check::Loss, last_.energy - now_.energy, energySlack());
}

// --- what holds ---

// Whether gravity surely presses the ball on all that it touches: loads of smooth surfaces, all of them a part of its
// own.
bool RandomRun::allLoaded() const
{
  const auto count = static_cast<Eigen::Index>(now_.touching.size());
  if (count > 3) return false;
  Eigen::Matrix<double, 3, Eigen::Dynamic> n(3, count);
  for (Eigen::Index i = 0; i < count; ++i) n.col(i) = now_.touching[static_cast<std::size_t>(i)].n_W;
  const Eigen::MatrixXd gram = n.transpose() * n;
  if (std::abs(gram.determinant()) < 1e-3) return false;
  const Eigen::VectorXd load = gram.inverse() * (n.transpose() * -pull_);
  return load.minCoeff() > 0.05 * pull_.norm();
}

void RandomRun::checkSlip(bool contacts)
{
  if (contacts || !now_.held || !last_.held || !sameTouches(last_, now_) || now_.touching.empty()) return;
  double least = Stage::kNoLimit, most = 0.0;
  for (const Touch& touch : now_.touching)
  {
    if (!std::isinf(lawOf(touch.of).friction))
    {
      least = 0.0;  // maybe this one alone carries the ball
      continue;
    }
    const double slip = slipOf(touch, now_.ball, now_.radius).norm();
    least = std::min(least, slip);
    most = std::max(most, slip);
  }
  const bool all = now_.touching.size() == 1 || (still() && allLoaded());
  note(Check::Slip, all ? most : least, slipSlack());
}

bool stands(const Moment& moment)
{
  return moment.ball.v_WB.norm() <= kStill && moment.radius * moment.ball.w_WB.norm() <= kStill;
}

// Nothing changes with time where nothing moves: what has stood still for a tick stands still for ever. And rolling
// resistance holds what pulls less than it does. Rolling resistance surely holds what pulls less than it does, where
// friction can hold it.
bool RandomRun::resistanceHolds(const Touch& touch) const
{
  const Surface& law = lawOf(touch.of);
  const BallParams& ball = scene_.balls[0].params;
  const Vector3d a = FlightModel(scene_.forces, ball).acceleration(Vector3d::Zero(), Vector3d::Zero());
  const double load = -touch.n_W.dot(a), drive = (a + load * touch.n_W).norm();
  return load > 0.0 && drive / (1.0 + ball.inertia) < kSurely * law.rolling_resistance * load &&
         drive < kSurely * law.friction * load;
}

// Nothing changes with time where nothing moves: what has stood still for a tick stands still for ever.
void RandomRun::checkRest(bool contacts)
{
  const bool stood = stands(last_);
  if (still() && stood && sameTouches(last_, now_) && !contacts)
    if (at_rest_ || (last_.touching.size() == 1 && resistanceHolds(last_.touching[0])))
      note(Check::Rest, now_.ball.v_WB.norm() + now_.radius * now_.ball.w_WB.norm(), 2.0 * kStill);
  at_rest_ = stood && stands(now_) && (now_.ball.p_WB - last_.ball.p_WB).norm() < 1e-13;
}

// --- events ---

void RandomRun::checkQuietTime()
{
  if (!bouncy_) note(Check::Events, quiet_events_, kLastBounces + kEventsPerSecond * quiet_time_);
}

void RandomRun::countEvents(const StepStatus& status, double duration)
{
  double closing = 0.0;
  for (const Contact& contact : world().contacts()) closing = std::max(closing, closingOf(contact));
  const auto events = static_cast<double>(status.events);
  events_ += events;
  if (closing > kRealBounce)
    quiet_events_ = quiet_time_ = 0.0;
  else
  {
    quiet_events_ += events;
    quiet_time_ += duration;
    checkQuietTime();
  }
  if (status.event_limit) verdict_.note(Check::Storm, std::max(events_, 1e6), kStorm, now_.time);
  if (!bouncy_) note(Check::Storm, events_ / std::max(now_.time, 1.0), kStorm);
}

// --- state and record ---

void RandomRun::checkState()
{
  const BallState& ball = now_.ball;
  const bool finite = ball.p_WB.allFinite() && ball.v_WB.allFinite() && ball.w_WB.allFinite();
  if (!finite || !(std::abs(ball.q_WB.norm() - 1.0) < 1e-9)) verdict_.fault(Check::State, now_.time);
  if (still() && world().resting(0) && ball.v_WB.norm() > 0.0) verdict_.fault(Check::State, now_.time);
}

double energyOver(const BallParams& ball, const Vector3d& v, const Vector3d& w)
{
  return v.squaredNorm() + ball.inertia * ball.radius * ball.radius * w.squaredNorm();
}

void RandomRun::checkContact(const Contact& contact)
{
  const BallParams& ball = scene_.balls[0].params;
  const Vector3d u = contact.v_other;
  const double before = energyOver(ball, contact.v_before - u, contact.w_before);
  const double after = energyOver(ball, contact.v_after - u, contact.w_after);
  if (!(std::abs(contact.n_W.norm() - 1.0) < 1e-9) || !(after <= before * (1.0 + 1e-9) + 1e-18))
    verdict_.fault(Check::Record, contact.time);
}

void RandomRun::checkRecord(const StepStatus& status)
{
  double earlier = last_.time - kSmallMoment;
  if (world().contacts().size() != status.contacts) verdict_.fault(Check::Record, now_.time);
  for (const Contact& contact : world().contacts())
  {
    if (!(contact.time >= earlier && contact.time <= now_.time + kSmallMoment))
      verdict_.fault(Check::Record, now_.time);
    earlier = contact.time;
    if (scene_.bodies.size() == 1 || still()) checkContact(contact);
  }
}

// --- places ---

// Depth of the centre in a shape, deepest on the straight way from a to b, both in the body's frame: the distance from
// a convex shape is a convex function.
double deepestOnTheWay(const Shape& shape, Vector3d a, Vector3d b)
{
  for (int i = 0; i < 40; ++i)
  {
    const Vector3d p = a + (b - a) / 3.0, q = b - (b - a) / 3.0;
    if (proximity(shape, p).distance < proximity(shape, q).distance)
      b = q;
    else
      a = p;
  }
  return -proximity(shape, a).distance;
}

void RandomRun::checkDepth()
{
  const double depth = now_.depth();
  note(Check::Depth, depth, kMostDepth);
  verdict_.deepest = std::max(verdict_.deepest, depth);
}

// On the straight way between the ends of the tick the centre comes no nearer than the ball, but for what the path
// bends.
void RandomRun::checkThrough(const std::vector<Pose>& earlier)
{
  const auto seen = [](const Pose& X, const Vector3d& p) { return Vector3d(X.q.conjugate() * (p - X.p)); };
  const double way = (now_.ball.p_WB - last_.ball.p_WB).norm();
  for (std::size_t i = 0; i < now_.around.size(); ++i)
  {
    const ShapeName of = now_.around[i].of;
    const double room = now_.around[i].gap + last_.around[i].gap + 2.0 * now_.radius;
    if (room > way && still()) continue;
    const double depth =
        deepestOnTheWay(scene_.bodies[of.body].shapes[of.shape], seen(earlier[of.body], last_.ball.p_WB),
                        seen(world().bodyPose(of.body), now_.ball.p_WB));
    note(Check::Through, depth, 0.25 * now_.radius);
  }
}

// --- the run ---

void RandomRun::checkSeam(double duration)
{
  if (!whole_) return;
  whole_->advance(duration);
  const double slack = (1e-9 + scene_.tolerance) * std::max(1.0, now_.time);
  note(Check::Seam, (whole_->ballState(0).p_WB - now_.ball.p_WB).norm(), slack);
}

// False if there is no going on.
bool RandomRun::step(double duration)
{
  std::vector<Pose> poses;
  for (std::size_t b = 0; b < world().bodyCount(); ++b) poses.push_back(world().bodyPose(b));
  const StepStatus status = play_.advance(duration);
  last_ = std::move(now_);
  now_ = momentOf(world(), pull_);
  checkState();
  countEvents(status, duration);
  checkRecord(status);
  if (status.not_finite) verdict_.fault(Check::State, now_.time);
  if (status.squeezed > 0 && (still() || scene_.bodies.size() == 1)) verdict_.fault(Check::Squeezed, now_.time);
  if (status.event_limit || status.not_finite || status.squeezed > 0 || verdict_.of(Check::State).broken) return false;
  checkDepth();
  checkThrough(poses);
  const bool contacts = status.contacts > 0;
  checkGain();
  checkLoss(contacts);
  checkSlip(contacts);
  checkRest(contacts);
  checkSeam(duration);
  return true;
}

bool RandomRun::tick(int number)
{
  if (number % kProbeEvery != 0) return step(drawn_.tick);
  if (!step(drawn_.tick - kProbe)) return false;
  const bool quiet = now_.held;
  if (!step(kProbe)) return false;
  if (!quiet || !now_.held || !world().contacts().empty()) return true;
  if (const std::optional<double> part = againstTheLaw(scene_, last_, now_)) note(Check::Law, *part, kAgainstTheLaw);
  return true;
}

Verdict RandomRun::run()
{
  const Vector3d start = now_.ball.p_WB;
  const int ticks = static_cast<int>(std::lround(drawn_.duration / drawn_.tick));
  for (int i = 0; i < ticks; ++i)
    if (!tick(i) || (now_.ball.p_WB - start).norm() > kGone) break;
  verdict_.quiet_events = quiet_time_ > 0.1 ? quiet_events_ / quiet_time_ : -1.0;
  return verdict_;
}

// --- the same again ---

std::uint64_t hashAfter(const RandomScene& drawn, Method method, double dt)
{
  Play play(drawn, method, dt);
  const int ticks = static_cast<int>(std::lround(drawn.duration / drawn.tick));
  for (int i = 0; i < ticks; ++i)
    if (!play.advance(drawn.tick).ok()) break;
  return stateHash(play.world());
}
}  // namespace

Verdict judge(const RandomScene& drawn, Method method, double dt)
{
  Verdict verdict = RandomRun(drawn, method, dt).run();
  const std::uint64_t round = drawn.index / stageKinds().size();
  if (round % kSameBitsEvery != 0 || verdict.of(Check::Storm).broken) return verdict;
  const RandomScene again = randomScene(drawn.seed, drawn.index);
  if (hashAfter(drawn, method, dt) != hashAfter(again, method, dt)) verdict.fault(Check::SameBits, drawn.duration);
  return verdict;
}
}  // namespace ping_pong::stability
