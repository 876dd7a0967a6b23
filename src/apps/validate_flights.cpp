// Measured flights against models of air and table.
#include <cmath>

#include "csv_file.h"
#include "validate_parts.h"

namespace ping_pong
{
namespace
{
constexpr double kRowsOfConstants = 19.0;  // those without spin take no time beside them
constexpr double kMargin = 0.004;          // samples so close to the bounce may be on either side [s]

std::size_t samplesBeforeBounce(const Flight& flight)
{
  if (flight.bounce < 0.0) return flight.times.size();
  std::size_t count = 0;
  while (count < flight.times.size() && flight.times[count] < flight.bounce - kMargin) ++count;
  return count;
}

FlightScore score(const Flight& flight, const FlightChoice& model, bool checked)
{
  FlightScore result;
  result.flight = flight.name;
  result.no_spin = flight.no_spin;
  result.checked = checked;
  result.noise = flight.noise;
  result.before = fitFlight(flight, samplesBeforeBounce(flight), model, true).misfit;
  if (flight.bounce < 0.0) return result;
  const FlightFit whole = fitFlight(flight, flight.times.size(), model, true);
  result.through = whole.misfit;
  for (std::size_t i = 0; i < flight.times.size(); ++i)
  {
    result.times.push_back(flight.times[i] - flight.bounce);
    result.distances.push_back(whole.residuals[i].norm());
  }
  return result;
}

bool isChecked(std::size_t index)
{
  return index % 2 == 1;
}

template <class Value>
double medianRatio(const std::vector<FlightScore>& scores, bool only_checked, Value value)
{
  std::vector<double> ratios;
  for (const FlightScore& score : scores)
    if (value(score) >= 0.0 && (score.checked || !only_checked)) ratios.push_back(value(score) / score.noise);
  return medianOf(ratios);
}

std::vector<FlightScore> ofKind(const std::vector<FlightScore>& scores, bool no_spin)
{
  std::vector<FlightScore> some;
  for (const FlightScore& score : scores)
    if (score.no_spin == no_spin) some.push_back(score);
  return some;
}

// Median misfit of all flights at times from the bounce, in bins.
void writeResiduals(CsvFile& file, const std::string& model, const std::vector<FlightScore>& scores)
{
  constexpr double kBin = 0.02;  // [s]
  for (int bin = -27; bin < 19; ++bin)
  {
    std::vector<double> distances;
    for (const FlightScore& score : scores)
      for (std::size_t i = 0; i < score.times.size(); ++i)
        if (std::floor(score.times[i] / kBin) == bin) distances.push_back(score.distances[i]);
    if (distances.size() < 20) continue;
    file.text(model.c_str());
    file.number((bin + 0.5) * kBin);
    file.number(medianOf(distances));
    file.endRow();
  }
}
}  // namespace

std::vector<FlightScore> scoreFlights(const std::vector<Flight>& flights, const FlightChoice& model, bool only_checked)
{
  std::vector<FlightScore> scores;
  for (std::size_t i = 0; i < flights.size(); ++i)
    if (isChecked(i) || !only_checked) scores.push_back(score(flights[i], model, isChecked(i)));
  return scores;
}

double medianBefore(const std::vector<FlightScore>& scores, bool only_checked)
{
  return medianRatio(scores, only_checked, [](const FlightScore& score) { return score.before; });
}

double medianThrough(const std::vector<FlightScore>& scores, bool only_checked)
{
  return medianRatio(scores, only_checked, [](const FlightScore& score) { return score.through; });
}

void writeFlights(const std::vector<Flight>& flights, const std::string& out, const PartDone& done)
{
  CsvFile table(out + "/flights.csv"), each(out + "/flights_each.csv"), residuals(out + "/residuals.csv");
  for (const char* head :
       {"model", "what", "before", "before_no_spin", "before_spin", "through", "before_checked", "through_checked"})
    table.text(head);
  table.endRow();
  for (const char* head : {"model", "flight", "checked", "before_m", "through_m", "noise_m"}) each.text(head);
  each.endRow();
  for (const char* head : {"model", "time_from_bounce", "median_misfit_m"}) residuals.text(head);
  residuals.endRow();
  const std::vector<FlightChoice> models = flightChoices();
  double models_done = 0.0;
  for (const FlightChoice& model : models)
  {
    const std::vector<FlightScore> scores = scoreFlights(flights, model, false);
    table.text(('"' + model.name + '"').c_str());
    table.text(('"' + model.what + '"').c_str());
    table.number(medianBefore(scores, false));
    table.number(medianBefore(ofKind(scores, true), false));
    table.number(medianBefore(ofKind(scores, false), false));
    table.number(medianThrough(scores, false));
    table.number(medianBefore(scores, true));
    table.number(medianThrough(scores, true));
    table.endRow();
    for (const FlightScore& score : scores)
    {
      each.text(('"' + model.name + '"').c_str());
      each.text(score.flight.c_str());
      each.integer(score.checked);
      each.number(score.before);
      each.number(score.through);
      each.number(score.noise);
      each.endRow();
    }
    writeResiduals(residuals, '"' + model.name + '"', scores);
    done(++models_done / static_cast<double>(models.size()));
  }
  table.close();
  each.close();
  residuals.close();
}

void writeChoiceOfConstants(const std::vector<Flight>& flights, const std::string& out, const PartDone& done)
{
  std::vector<Flight> half;
  for (std::size_t i = 0; i < flights.size(); ++i)
    if (!isChecked(i)) half.push_back(flights[i]);
  CsvFile table(out + "/constants.csv");
  for (const char* head : {"C_D_without_spin", "half_at", "e", "e_t", "before", "through"}) table.text(head);
  table.endRow();
  double rows_done = 0.0;
  const auto row = [&](double C_D, double half_at, double e, double e_t)
  {
    FlightChoice model;
    model.forces = defaultForces();
    model.forces.drag_law.without_spin = C_D;
    model.forces.drag_law.half_at = half_at;
    model.table = defaultTable();
    model.table.restitution = e;
    model.table.tangential_restitution = e_t;
    const std::vector<FlightScore> scores = scoreFlights(half, model, false);
    for (const double value : {C_D, half_at, e, e_t, medianBefore(scores, false), medianThrough(scores, false)})
      table.number(value);
    table.endRow();
    done(++rows_done / kRowsOfConstants);
  };
  const double half_at = defaultForces().drag_law.half_at;
  for (const double C_D : {0.24, 0.30, 0.33, 0.36, 0.40, 0.44, 0.53}) row(C_D, half_at, 0.99, 0.15);
  for (const double part : {0.05, 0.1, 0.2}) row(0.33, part, 0.99, 0.15);
  for (const double e : {0.98, 0.99, 1.0})
    for (const double e_t : {0.0, 0.15, 0.3}) row(0.33, half_at, e, e_t);
  table.close();

  // The same for balls that shall have no spin at all: then nothing can stand in for drag.
  CsvFile still(out + "/drag_without_spin.csv");
  for (const char* head : {"C_D", "before"}) still.text(head);
  still.endRow();
  for (const double C_D : {0.24, 0.27, 0.30, 0.33, 0.36, 0.40, 0.44, 0.53})
  {
    FlightChoice model;
    model.forces = defaultForces();
    model.forces.drag_law = DragLaw::constant(C_D);
    std::vector<double> ratios;
    for (const Flight& flight : half)
      if (flight.no_spin)
        ratios.push_back(fitFlight(flight, samplesBeforeBounce(flight), model, false).misfit / flight.noise);
    still.number(C_D);
    still.number(medianOf(ratios));
    still.endRow();
  }
  still.close();
}
}  // namespace ping_pong
