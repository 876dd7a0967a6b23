// From a prediction and a wish to a stroke: where to hit, what the ball shall do, what the racket does, how it gets there.
#pragma once

#include <optional>

#include "blade.h"
#include "prediction.h"
#include "racket_path.h"
#include "shot_to_target.h"
#include "stroke.h"
#include "stroke_inversion.h"

namespace ping_pong
{
/// What a hand does wrong in one stroke; all zero: nothing.
struct StrokeError
{
  Vector3d place = Vector3d::Zero();  ///< of the racket [m]
  double pitch = 0.0, yaw = 0.0;      ///< of the face [rad]
  double speed = 0.0;                 ///< part of the racket's speed
};

struct StrokePlan
{
  StrokeWish wish;
  Face face = Face::Forehand;
  BallState in;         ///< as the ball comes, at the hit
  AimedShot shot;       ///< as it shall leave
  RacketImpact impact;  ///< of the racket, without the error
  RacketPath path;
};

/// Where and when a racket is.
struct RacketNow
{
  double time = 0.0;
  Pose pose;    ///< frame O
  Twist twist;  ///< frame O
};

class StrokePlanner
{
public:
  StrokePlanner(const Scene& scene, const Court& court, const Blade& blade, const BallParams& ball,
                const DriveLimits& limits);
  StrokePlanner(const StrokePlanner&) = delete;  // the flyer points into it
  StrokePlanner& operator=(const StrokePlanner&) = delete;

  /// The first wish that can be had at some time between from and to. Bounded work: below 2 ms.
  /// @param serve  the ball comes from the own toss, and has to touch the own half first
  std::optional<StrokePlan> plan(const Prediction& prediction, double from, double to, const RacketNow& now,
                                 const std::vector<StrokeWish>& wishes, const StrokeError& error, bool serve) const;
  /// The same stroke at the same time for a ball that is now expected to come a little differently.
  std::optional<StrokePlan> refined(const StrokePlan& plan, const Prediction& prediction, const RacketNow& now,
                                    const StrokeError& error, bool serve) const;
  Incoming incoming(const Prediction& prediction, double from, double to) const;

private:
  struct Candidate
  {
    double time = 0.0, cost = 0.0;
  };
  std::vector<Candidate> candidates(const Prediction& prediction, double from, double to, const RacketNow& now,
                                    const StrokeWish& wish, bool serve) const;
  bool aim(StrokePlan& plan, bool serve, Flyer flyer, const Vector3d& guess) const;
  bool lay(StrokePlan& plan, double time, const Prediction& prediction, const RacketNow& now,
           const StrokeError& error, int& work) const;
  bool layFor(StrokePlan& plan, double swing, double follow, const Prediction& prediction, const RacketNow& now) const;
  bool clear(const RacketPath& path, const Prediction& prediction, const RacketNow& now) const;
  Vector3d spinWish(const StrokeWish& wish, const BallState& in, double share) const;

  const Court& court_;
  const Blade& blade_;
  BallParams ball_;
  Forces forces_;  // frame O
  FlightModel model_;
  Flyer flyer_;
  Surface table_;
  DriveLimits limits_;
};
}  // namespace ping_pong
