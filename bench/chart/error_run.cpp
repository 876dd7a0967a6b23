#include "error_run.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "energy.h"
#include "engines/our_engine.h"
#include "overlap_check.h"

namespace ping_pong::bench
{
namespace
{
constexpr double kWatchPeriod = 1e-3;    // about, between looks at overlap and bounces [s]
constexpr double kCountPeriod = 0.02;    // between looks, at most, if bounces are to be counted [s]
constexpr Real kAwayFromBounce = 1e-3L;  // [s]

struct Mean
{
  double sum = 0.0;
  long count = 0;
  void add(double value)
  {
    sum += value;
    ++count;
  }
  double root() const { return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0; }
};

// Of the processor's time: a budget that a busy machine does not use up.
class Stopwatch
{
public:
  double seconds() const { return static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC; }

private:
  const std::clock_t begin_ = std::clock();
};

struct Sums
{
  Mean position, spin, energy, overlap, wrong_bounces;
};

bool finite(const std::vector<BallState>& balls)
{
  return std::all_of(balls.begin(), balls.end(),
                     [](const BallState& ball)
                     { return ball.p_WB.allFinite() && ball.v_WB.allFinite() && ball.w_WB.allFinite(); });
}

bool awayFromBounces(const TruePath& path, Real t)
{
  const auto next = std::lower_bound(path.events.begin(), path.events.end(), t - kAwayFromBounce);
  return next == path.events.end() || *next > t + kAwayFromBounce;
}

// One start, from its beginning to its end.
class Run
{
public:
  Run(const ChartScene& chart, const Start& start, const Point& point, Errors& errors, Sums& sums)
      : chart_(chart),
        start_(start),
        errors_(errors),
        sums_(sums),
        engine_(point.engine->make(start.scene, point.variant, point.step)),
        watches_(watchesOf(chart, point))
  {
    for (const Drive& drive : start.drives) engine_->drive(drive.body, drive.twist);
    for (const SceneBall& ball : start.scene.balls) balls_.push_back(ball.state);
    rising_.resize(balls_.size());
    bounces_.assign(balls_.size(), 0);
    findEnergyScale();
  }

  /// Gives up, and says false, when the stopwatch shows more than `most` [s].
  bool run(const Stopwatch& stopwatch, double most)
  {
    const long samples = std::lround(chart_.duration / chart_.sample_period);
    for (long i = 0; i < samples; ++i)
    {
      if (stopwatch.seconds() > most) return false;
      if (!watch(i))
      {
        ++errors_.not_finite;
        return true;
      }
      compareEnergy(static_cast<std::size_t>(i));
      for (std::size_t ball = 0; ball < start_.truth.size(); ++ball) compare(ball, static_cast<std::size_t>(i));
    }
    finish();
    return true;
  }

private:
  static long watchesOf(const ChartScene& chart, const Point& point)
  {
    const double least = takesTolerance(point.engine->name, point.variant) ? 0.0 : point.step;
    const long steps = std::lround(chart.sample_period / std::max(least, 1e-12));
    long watches = std::max(1L, std::lround(chart.sample_period / std::max(least, kWatchPeriod)));
    while (steps % watches != 0) --watches;
    return watches;
  }

  void findEnergyScale()
  {
    start_energy_ = energy_scale_ = energyOf(start_.scene, balls_);
    for (std::size_t i = 0; !start_.truth.empty() && i < start_.truth[0].samples.size(); ++i)
      energy_scale_ = std::max(energy_scale_, trueEnergy(start_, i));
  }

  // Up to the next sample in small pieces. False if a number is no longer finite.
  bool watch(long sample)
  {
    const double period = chart_.sample_period / static_cast<double>(watches_);
    for (long k = 1; k <= watches_; ++k)
    {
      engine_->advance(period);
      balls_ = statesOf(*engine_, balls_.size());
      if (!finite(balls_)) return false;
      const double time = static_cast<double>(sample) * chart_.sample_period + static_cast<double>(k) * period;
      noteOverlap(overlapOf(start_, balls_, time));
      for (std::size_t i = 0; i < balls_.size(); ++i) countBounce(i);
    }
    return true;
  }

  void noteOverlap(const Overlap& overlap)
  {
    errors_.penetration = std::max(errors_.penetration, overlap.deepest);
    sums_.overlap.add(overlap.sum_of_squares);
  }

  // On level ground a ball that sank and now rises has bounced.
  void countBounce(std::size_t i)
  {
    const double v = balls_[i].v_WB.z();
    if (v > 0.0 && rising_[i] == -1) ++bounces_[i];
    if (v != 0.0) rising_[i] = v > 0.0 ? 1 : -1;
  }

  void compareEnergy(std::size_t sample)
  {
    const double energy = energyOf(start_.scene, balls_);
    const double wanted = start_.truth.empty() ? start_energy_ : trueEnergy(start_, sample);
    const double relative = (energy - wanted) / energy_scale_;
    sums_.energy.add(relative * relative);
    errors_.energy_growth = std::max(errors_.energy_growth, energy / energy_scale_ - 1.0);
    if (!start_.truth.empty()) return;
    errors_.momentum = std::max(errors_.momentum, sidewaysMomentum(start_.scene, balls_, energy_scale_));
  }

  void compare(std::size_t i, std::size_t sample)
  {
    const TruePath& path = start_.truth[i];
    if (!awayFromBounces(path, static_cast<Real>(sample + 1) * chart_.sample_period)) return;
    const TrueState& wanted = path.samples[sample];
    const Real distance = (balls_[i].p_WB.cast<Real>() - wanted.p).norm();
    const Real spin = (balls_[i].w_WB.cast<Real>() - wanted.w).norm();
    sums_.position.add(static_cast<double>(distance * distance));
    sums_.spin.add(static_cast<double>(spin * spin));
    errors_.position_max = std::max(errors_.position_max, static_cast<double>(distance));
  }

  void finish()
  {
    const bool counted = chart_.sample_period / static_cast<double>(watches_) <= 1.0001 * kCountPeriod;
    for (std::size_t i = 0; i < start_.truth.size(); ++i)
      if (counted && start_.truth[i].bounces >= 0) sums_.wrong_bounces.add(bounces_[i] != start_.truth[i].bounces);
    const bool inside = worstDepthInBody(start_, balls_, chart_.duration) > 1.0;
    errors_.tunnelled += inside || (chart_.lost && chart_.lost(balls_[0]));
    errors_.unsettled += chart_.settled && !std::all_of(balls_.begin(), balls_.end(), chart_.settled);
    if (!start_.drives.empty()) errors_.missed += missed();
  }

  // Nearer to the flight without the hit than to the one with it.
  bool missed() const
  {
    const BallState& begin = start_.scene.balls[0].state;
    const Vector3d unhit = begin.v_WB + chart_.duration * start_.scene.forces.gravity;
    const Vector3d hit = start_.truth[0].samples.back().v.cast<double>();
    return (balls_[0].v_WB - unhit).norm() < (balls_[0].v_WB - hit).norm();
  }

  const ChartScene& chart_;
  const Start& start_;
  Errors& errors_;
  Sums& sums_;
  std::unique_ptr<Engine> engine_;
  long watches_;  // per sample
  std::vector<BallState> balls_;
  std::vector<int> rising_, bounces_;
  double start_energy_ = 0.0, energy_scale_ = 0.0;
};
}  // namespace

std::optional<Errors> measureErrors(const ChartScene& chart, const std::vector<Start>& starts, const Point& point,
                                    double most)
{
  Errors errors;
  Sums sums;
  const Stopwatch stopwatch;
  for (const Start& start : starts)
    if (!Run(chart, start, point, errors, sums).run(stopwatch, most)) return std::nullopt;
  errors.seconds = stopwatch.seconds();
  errors.starts = static_cast<int>(starts.size());
  errors.position_rms = sums.position.root();
  errors.spin_rms = sums.spin.root();
  errors.energy_rms = sums.energy.root();
  errors.overlap_rms = sums.overlap.root();
  const Mean& wrong = sums.wrong_bounces;
  errors.wrong_bounces = wrong.count > 0 ? wrong.sum / static_cast<double>(wrong.count) : 0.0;
  return errors;
}

double referenceError(const ChartScene& chart, const std::vector<Start>& starts)
{
  constexpr std::size_t kStarts = 8;
  Real worst = 0.0L;
  for (std::size_t n = 0; n < std::min(kStarts, starts.size()); ++n)
  {
    const Start finer = chart.start(static_cast<int>(n), 2);
    for (std::size_t i = 0; i < finer.truth.size(); ++i)
      for (std::size_t k = 0; k < finer.truth[i].samples.size(); ++k)
        worst = std::max(worst, (finer.truth[i].samples[k].p - starts[n].truth[i].samples[k].p).norm());
  }
  return static_cast<double>(worst);
}
}  // namespace ping_pong::bench
