// What a ball will do: our own World, run ahead of the match without paddles.
#pragma once

#include <vector>

#include "court.h"
#include "ping_pong_sim/world.h"

namespace ping_pong::play
{
struct PathSample
{
  double time = 0.0;  ///< [s]
  BallState state;    ///< frame O
};

enum class Touched
{
  OwnHalf,
  OtherHalf,
  Net,   ///< net, posts
  Other  ///< floor, sides and frame of the table
};

struct PredictedBounce
{
  double time = 0.0;
  Vector3d p = Vector3d::Zero();  ///< centre of the ball [m]
  Touched touched = Touched::Other;
};

class Prediction
{
public:
  /// @param scene  of the match; its paddles are left out
  Prediction(const Scene& scene, const Court& court, const BallParams& ball);

  /// From this state on until something other than table and net is hit, the ball is far away, or the horizon is reached.
  void predict(double time, const BallState& state);
  void forget() { samples_.clear(), bounces_.clear(); }
  bool empty() const { return samples_.empty(); }
  double start() const { return samples_.front().time; }
  double end() const { return samples_.back().time; }  ///< it says nothing about what follows [s]
  /// State at a time from start() to end(): Hermite's cubic between samples, off by less than 1e-8 m and 1e-5 m/s.
  BallState at(double time) const;
  const std::vector<PathSample>& samples() const { return samples_; }  ///< two at each bounce: before and after
  const std::vector<PredictedBounce>& bounces() const { return bounces_; }

private:
  Touched touchedBy(const Contact& contact) const;
  void add(double time, const BallState& state) { samples_.push_back({time, state}); }

  std::size_t table_ = kNone, surface_ = kNone;  // as the world counts them
  double radius_;
  World world_;
  std::vector<PathSample> samples_;
  std::vector<PredictedBounce> bounces_;
};
}  // namespace ping_pong::play
