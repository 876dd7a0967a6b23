// What a player makes of its looks: one estimate of the ball, its prediction, and who touched the ball last.
#pragma once

#include "perception.h"

namespace ping_pong::play
{
class BallEstimate
{
public:
  BallEstimate(const Scene& scene, const Court& court, const BallParams& ball, const LevelTraits& level,
               std::uint64_t seed);

  enum class News
  {
    None,     ///< the ball does what was expected
    Changed,  ///< the prediction is another, by a little or by a bounce that was not expected so
    Struck    ///< a new ball, or the opponent has struck it
  };
  News update(double time, const BallState& state);
  void forget();
  void feel(bool feel) { perception_.feel(feel); }
  /// The player has struck the ball: until somebody else does it is not to be played.
  void struckByMe() { mine_ = true; }

  const Prediction& prediction() const { return prediction_; }
  bool mine() const { return mine_; }
  /// From when and until when the ball may be played: after its one bounce on the own half, before the next touch. False: never.
  bool window(double& from, double& to) const;

private:
  News adopt(const PathSample& seen);
  bool nearBounce(double time) const;
  void noteBounces(double until);

  LevelTraits level_;
  Perception perception_;
  Prediction prediction_;
  std::size_t looks_ = 0;  // that the estimate is the mean of
  bool mine_ = false;
  int bounces_ = 0;             // on the own half since the last stroke, up to the start of the prediction
  double bounce_until_ = -1e9;  // they are counted up to here [s]
  double bounce_from_ = 0.0;    // the last of them [s]
};
}  // namespace ping_pong::play
