// A scene of the chart: many starts of one situation, what the truth is at sample times, and which steps are tried.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "ping_pong_sim/scene.h"

namespace ping_pong::bench
{
using Real = long double;
using Vector3r = Eigen::Matrix<Real, 3, 1>;

/// Where a ball truly is.
struct TrueState
{
  Vector3r p = Vector3r::Zero();  ///< [m]
  Vector3r v = Vector3r::Zero();  ///< [m/s]
  Vector3r w = Vector3r::Zero();  ///< [rad/s]
};

/// The true path of one ball: a state for every sample time.
struct TruePath
{
  std::vector<TrueState> samples;  ///< the first one a sample period after the start
  std::vector<Real> events;        ///< times of bounces [s]; a sample close to one is not compared
  int bounces = -1;                ///< on level ground until the end; below 0: not counted
};

struct Drive
{
  std::size_t body;
  Twist twist;
};

/// One start: what to simulate and the truth about it.
struct Start
{
  Scene scene;
  std::vector<Drive> drives;
  std::vector<TruePath> truth;  ///< by ball; empty for a chaotic scene
};

enum class Measure
{
  Position,  ///< [m]
  Energy,    ///< relative: a chaotic scene has no position to compare
  Overlap    ///< of all that touch [m]: neither has a chaotic scene that loses energy an energy to compare
};

struct ChartScene
{
  std::string name;   ///< of files
  std::string title;  ///< for people
  Measure measure = Measure::Position;
  double duration = 0.0;           ///< [s], a whole number of sample periods
  double sample_period = 0.0;      ///< [s], a whole number of every step
  std::vector<double> steps;       ///< of methods that step, falling [s]
  std::vector<double> tolerances;  ///< of methods that take one, falling [m]
  int starts = 64;
  std::string reference;  ///< what the truth comes from, for people
  /// A ball ended where it cannot have come without going through something; may be empty.
  std::function<bool(const BallState& end)> lost;
  /// Every ball has to end where this holds; may be empty.
  std::function<bool(const BallState& end)> settled;
  /// The n-th start; the same n, the same bits.
  /// @param refinement  1, or 2 for a reference of half the step, to see how good it is
  std::function<Start(int n, int refinement)> start;
};

/// All scenes, in the order of the chart.
std::vector<ChartScene> chartScenes();

ChartScene vacuumFlight();
ChartScene airFlight();
ChartScene bouncing();
ChartScene elastic666();
ChartScene inelastic666();
ChartScene dropToRest();
ChartScene spinBounce();
ChartScene spinBounceVacuum();
ChartScene ballInBox();
ChartScene paddleHit();
ChartScene rally();

/// a, a/2, a/5, a/10 ... down to the last one that is not below b; a is 1, 2 or 5 times a power of ten.
std::vector<double> oneTwoFive(double from, double to);
/// from, from/10 ... to.
std::vector<double> decades(double from, double to);
}  // namespace ping_pong::bench
