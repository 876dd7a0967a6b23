// Measured rebounds from rubber against contact laws.
#include <algorithm>
#include <cmath>

#include "csv_file.h"
#include "ping_pong_sim/resolve.h"
#include "validate_parts.h"

namespace ping_pong
{
double medianOf(std::vector<double> values)
{
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

std::vector<RubberScore> scoreRubber(const std::vector<Rebound>& measured)
{
  std::vector<RubberScore> scores;
  for (const RubberChoice& choice : rubberChoices())
  {
    RubberScore score;
    score.choice = choice;
    double speed = 0.0, spin = 0.0;
    for (const Rebound& rebound : measured)
    {
      BallState state = rebound.before;
      bounce(choice.rubber, BallParams(), state, Vector3d::Zero(), Vector3d::UnitZ());
      const Vector3d dv = state.v_WB - rebound.after.v_WB;
      speed += dv.x() * dv.x() + dv.z() * dv.z();
      spin += std::pow(state.w_WB.y() - rebound.after.w_WB.y(), 2);
      score.predicted.push_back(state);
    }
    const double count = static_cast<double>(measured.size());
    score.speed = std::sqrt(speed / (2.0 * count));
    score.spin = std::sqrt(spin / count);
    scores.push_back(score);
  }
  return scores;
}

void writeRubber(const std::vector<Rebound>& measured, const std::vector<RubberScore>& scores, const std::string& out)
{
  CsvFile table(out + "/rubber.csv");
  for (const char* head : {"law", "what", "speed_rms", "spin_rms"}) table.text(head);
  table.endRow();
  CsvFile rows(out + "/rubber_rows.csv");
  for (const char* head : {"law", "row", "vx", "vz", "wy", "vx_measured", "vz_measured", "wy_measured"})
    rows.text(head);
  rows.endRow();
  for (const RubberScore& score : scores)
  {
    table.text(('"' + score.choice.name + '"').c_str());
    table.text(('"' + score.choice.what + '"').c_str());
    table.number(score.speed);
    table.number(score.spin);
    table.endRow();
    for (std::size_t i = 0; i < measured.size(); ++i)
    {
      rows.text(('"' + score.choice.name + '"').c_str());
      rows.integer(i);
      for (const BallState& state : {score.predicted[i], measured[i].after})
      {
        rows.number(state.v_WB.x());
        rows.number(state.v_WB.z());
        rows.number(state.w_WB.y());
      }
      rows.endRow();
    }
  }
  table.close();
  rows.close();
}
}  // namespace ping_pong
