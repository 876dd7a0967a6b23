// The parts of `validate`: each computes its numbers and can write them as CSV.
#pragma once

#include <string>
#include <vector>

#include "flight_fit.h"
#include "progress.h"

namespace ping_pong
{
double medianOf(std::vector<double> values);

// --- measured rebounds from rubber ---

struct RubberScore
{
  RubberChoice choice;
  double speed = 0.0;                ///< rms error of a velocity component [m/s]
  double spin = 0.0;                 ///< rms error [rad/s]
  std::vector<BallState> predicted;  ///< in the order of the measurements
};

std::vector<RubberScore> scoreRubber(const std::vector<Rebound>& measured);
void writeRubber(const std::vector<Rebound>& measured, const std::vector<RubberScore>& scores, const std::string& out);

// --- measured flights ---

struct FlightScore
{
  std::string flight;
  bool no_spin = false, checked = false;  ///< checked: in the half on which no constant was chosen
  double before = 0.0;                    ///< rms misfit up to the bounce [m]
  double through = -1.0;                  ///< and of the whole arc; negative: no bounce [m]
  double noise = 0.0;                     ///< [m]
  std::vector<double> times;              ///< of samples from the bounce [s]
  std::vector<double> distances;          ///< misfit of samples, of the whole arc [m]
};

/// Every second flight is `checked`; constants may be chosen on the others alone.
std::vector<FlightScore> scoreFlights(const std::vector<Flight>& flights, const FlightChoice& model, bool only_checked);
/// Median of misfit / noise; of the checked half alone, if asked.
double medianBefore(const std::vector<FlightScore>& scores, bool only_checked);
double medianThrough(const std::vector<FlightScore>& scores, bool only_checked);
void writeFlights(const std::vector<Flight>& flights, const std::string& out, const PartDone& done);
/// The choice of C_D without spin, e and e_t of the table on the half that is not checked.
void writeChoiceOfConstants(const std::vector<Flight>& flights, const std::string& out, const PartDone& done);

// --- what to leave out ---

void writeOmissions(const std::vector<Launch>& launches, const std::string& out);
/// What the air costs in a whole scene: the shots of the ball launcher in this one, with its forces and with gravity alone.
void writeRallyCosts(const std::string& scene_file, const std::string& out);
}  // namespace ping_pong
