// From a prediction and a wish to a stroke: where to hit, what the ball shall do, what the racket does, how it gets there.
#pragma once

#include <optional>

#include "shot_to_target.h"
#include "stroke.h"
#include "stroke_path.h"

namespace ping_pong::play
{
struct StrokePlan
{
  StrokeWish wish;
  Face face = Face::Forehand;
  BallState in;         ///< as the ball comes, at the hit
  AimedShot shot;       ///< as it shall leave
  RacketImpact impact;  ///< of the racket, without the error
  RacketPath path;
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
  Vector3d spinWish(const StrokeWish& wish, const BallState& in, double share) const;

  const Court& court_;
  const Blade& blade_;
  BallParams ball_;
  Forces forces_;  // frame O
  FlightModel model_;
  Flyer flyer_;
  Surface table_;
  DriveLimits limits_;
  StrokePaths paths_;
};
}  // namespace ping_pong::play
