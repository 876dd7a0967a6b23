#include "measured_data.h"

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

namespace ping_pong
{
namespace
{
using Row = std::vector<std::string>;

// Rows below the headline; lines that begin with # are skipped.
std::vector<Row> readRows(const std::string& path, std::size_t columns)
{
  std::ifstream file(path);
  if (!file) throw DataError(path + ": cannot be read");
  std::vector<Row> rows;
  std::string line;
  bool headline = true;
  while (std::getline(file, line))
  {
    if (line.empty() || line[0] == '#') continue;
    Row row(1);
    for (const char letter : line)
    {
      if (letter == ',')
        row.emplace_back();
      else if (letter != '\r')
        row.back() += letter;
    }
    if (row.size() != columns)
      throw DataError(path + ": " + line + ": expected " + std::to_string(columns) + " columns");
    if (!headline) rows.push_back(row);
    headline = false;
  }
  return rows;
}

double number(const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') throw DataError(text + ": expected a number");
  return value;
}

Vector3d vectorAt(const Row& row, std::size_t column)
{
  return {number(row[column]), number(row[column + 1]), number(row[column + 2])};
}
}  // namespace

std::vector<Flight> readFlights(const std::string& data)
{
  std::vector<Flight> flights;
  std::map<std::string, std::size_t> index;
  for (const Row& row : readRows(data + "/flights/index.csv", 7))
  {
    Flight flight;
    flight.name = row[0];
    flight.no_spin = row[0].find("no_spin") != std::string::npos;
    if (!row[4].empty()) flight.bounce = number(row[4]);
    flight.noise = 1e-3 * number(row[5]);  // given in millimetres
    index[flight.name] = flights.size();
    flights.push_back(flight);
  }
  for (const Row& row : readRows(data + "/flights/flights.csv", 5))
  {
    Flight& flight = flights.at(index.at(row[0]));
    flight.times.push_back(number(row[1]));
    flight.positions.push_back(vectorAt(row, 2));
  }
  return flights;
}

std::vector<Rebound> readRebounds(const std::string& data)
{
  std::vector<Rebound> rebounds;
  for (const Row& row : readRows(data + "/rubber/racket01_sample.csv", 6))
  {
    Rebound rebound;
    rebound.before.w_WB.y() = number(row[0]);
    rebound.after.w_WB.y() = number(row[1]);
    rebound.before.v_WB = Vector3d(number(row[2]), 0.0, number(row[3]));
    rebound.after.v_WB = Vector3d(number(row[4]), 0.0, number(row[5]));
    rebounds.push_back(rebound);
  }
  return rebounds;
}

std::vector<Launch> readLaunches(const std::string& data)
{
  std::vector<Launch> launches;
  for (const Row& row : readRows(data + "/launches/launch_states.csv", 11))
  {
    Launch launch;
    launch.kind = row[0];
    launch.state.p_WB = vectorAt(row, 2);
    launch.state.v_WB = vectorAt(row, 5);
    launch.state.w_WB = vectorAt(row, 8);
    launches.push_back(launch);
  }
  return launches;
}
}  // namespace ping_pong
