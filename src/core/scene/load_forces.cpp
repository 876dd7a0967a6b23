#include "scene/load_forces.h"

#include <cmath>

#include "scene/presets.h"

namespace ping_pong
{
namespace
{
constexpr char kDefault[] = "default";
constexpr double kZeroCelsius = 273.15;    // [K]
constexpr double kRoomTemperature = 20.0;  // [C]

/// A number points down; a vector points where it says.
Vector3d readGravity(const Field& field)
{
  if (field.isList()) return field.vector();
  return {0.0, 0.0, 0.0 - field.notNegative()};  // not -x: that would make a zero negative
}

/// Viscosity of air by Sutherland's law, over its density: kinematic [m^2/s].
double airViscosity(double temperature, double density)
{
  return 1.458e-6 * temperature * std::sqrt(temperature) / (temperature + 110.4) / density;
}

void readAir(const Field& field, Forces& forces)
{
  const Map map(field, {"density", "viscosity", "temperature", "altitude"});
  const Field* celsius = map.find("temperature");
  const Field* altitude = map.find("altitude");
  if (const Field* density = map.find("density"))
  {
    if (celsius != nullptr) celsius->fail("either density or temperature and altitude");
    if (altitude != nullptr) altitude->fail("either density or temperature and altitude");
    forces.air_density = density->positive();
  }
  else if (celsius != nullptr || altitude != nullptr)
  {
    const double degrees = celsius != nullptr ? celsius->within(-100.0, 100.0) : kRoomTemperature;
    const double height = altitude != nullptr ? altitude->within(-500.0, 11000.0) : 0.0;  // the formula's troposphere
    forces.air_density = airDensity(kZeroCelsius + degrees, height);
    forces.air_viscosity = airViscosity(kZeroCelsius + degrees, forces.air_density);
  }
  if (const Field* viscosity = map.find("viscosity")) forces.air_viscosity = viscosity->positive();
}

/// Nodes of a table: at least one, each above the one before.
std::vector<double> readNodes(const Field& field, bool zero_allowed)
{
  std::vector<double> nodes;
  for (const Field& item : field.list())
  {
    nodes.push_back(zero_allowed ? item.notNegative() : item.positive());
    if (nodes.size() > 1 && nodes.back() <= nodes[nodes.size() - 2]) item.fail("a number above the one before it");
  }
  if (nodes.empty()) field.fail("a list of at least one number");
  return nodes;
}

DragLaw readDragTable(const Field& field)
{
  const Map map(field, {"reynolds", "spin_ratio", "values"});
  DragLaw law;
  law.reynolds = readNodes(map.at("reynolds", "a list of Reynolds numbers"), true);
  law.spin_ratio = readNodes(map.at("spin_ratio", "a list of spin ratios"), true);
  const std::string rows = std::to_string(law.reynolds.size()) + " rows, one for each Reynolds number";
  const std::string columns = std::to_string(law.spin_ratio.size()) + " numbers, one for each spin ratio";
  for (const Field& row : map.at("values", rows).list(law.reynolds.size(), rows))
    for (const Field& value : row.list(law.spin_ratio.size(), columns)) law.values.push_back(value.notNegative());
  return law;
}

/// The law of a preset by its name, or of the default one.
const FlightPreset& readPreset(const Field& field, const std::string& also)
{
  const std::string name = field.text();
  if (name == kDefault) return flightPresets().front();
  if (const FlightPreset* preset = findFlightPreset(name)) return *preset;
  field.fail(also + "one of " + kDefault + ", " + flightPresetNames());
}

DragLaw readDragOfSpin(const Map& map)
{
  DragLaw law;
  law.without_spin = map.at("without_spin", "C_D without spin, a number >= 0").notNegative();
  law.with_spin = map.at("with_spin", "C_D at large spin ratios, a number >= 0").notNegative();
  law.half_at = map.at("half_at", "the spin ratio half of the way, a number > 0").positive();
  return law;
}

DragLaw readDrag(const Field& field)
{
  const std::string forms = "{coefficient: ...}, {without_spin: ..., with_spin: ..., half_at: ...}, {table: ...}";
  if (!field.isMap()) return readPreset(field, forms + ", or ").drag;
  const Map map(field, {"coefficient", "without_spin", "with_spin", "half_at", "table"});
  const Field* table = map.find("table");
  const Field* coefficient = map.find("coefficient");
  const Field* of_spin = map.find("without_spin");
  for (const char* key : {"with_spin", "half_at"})
    if (of_spin == nullptr) of_spin = map.find(key);
  if ((table != nullptr) + (coefficient != nullptr) + (of_spin != nullptr) != 1) field.fail("one of " + forms);
  if (table != nullptr) return readDragTable(*table);
  return of_spin != nullptr ? readDragOfSpin(map) : DragLaw::constant(coefficient->notNegative());
}

LiftLaw readLinear(const Field& field)
{
  const Map map(field, {"law", "slope"});
  LiftLaw law;
  law.kind = LiftLaw::Kind::Linear;
  law.slope = map.at("slope", "dC_L/dS, a number").number();
  return law;
}

LiftLaw readSaturating(const Field& field)
{
  const Map map(field, {"law", "slope", "saturation"});
  LiftLaw law;
  law.kind = LiftLaw::Kind::Saturating;
  law.slope = map.at("slope", "dC_L/dS at S = 0, a number").number();
  law.saturation = map.at("saturation", "a number >= 0").notNegative();
  return law;
}

LiftLaw readConstant(const Field& field)
{
  const Map map(field, {"law", "coefficient"});
  LiftLaw law;
  law.kind = LiftLaw::Kind::Constant;
  law.constant = map.at("coefficient", "C_L, a number").number();
  return law;
}

LiftLaw readLiftTable(const Field& field)
{
  const Map map(field, {"law", "spin_ratio", "values"});
  LiftLaw law;
  law.kind = LiftLaw::Kind::Table;
  law.spin_ratio = readNodes(map.at("spin_ratio", "a list of spin ratios > 0"), false);
  const std::string size = std::to_string(law.spin_ratio.size()) + " numbers, one for each spin ratio";
  for (const Field& value : map.at("values", size).list(law.spin_ratio.size(), size))
    law.values.push_back(value.number());
  return law;
}

LiftLaw readMagnus(const Field& field)
{
  if (!field.isMap()) return readPreset(field, "{law: ...}, or ").lift;
  const Map map(field, {"law", "slope", "saturation", "coefficient", "spin_ratio", "values"});
  const std::string laws = "linear, saturating, constant, or table";
  const Field& law = map.at("law", laws);
  const std::string name = law.text();
  if (name == "linear") return readLinear(field);
  if (name == "saturating") return readSaturating(field);
  if (name == "constant") return readConstant(field);
  if (name == "table") return readLiftTable(field);
  law.fail(laws);
}

/// `preset` gives both laws; otherwise each is computed if it is listed.
void readAirLaws(const Map& map, Forces& forces)
{
  const Field* preset = map.find("preset");
  const Field* drag = map.find("drag");
  const Field* magnus = map.find("magnus");
  for (const Field* law : {drag, magnus})
    if (preset != nullptr && law != nullptr) preset->fail("no preset beside drag or magnus, since it gives both");
  if (preset != nullptr) drag = magnus = preset;
  forces.drag = drag != nullptr;
  forces.magnus = magnus != nullptr;
  if (preset != nullptr)
  {
    const FlightPreset& laws = readPreset(*preset, "");
    forces.drag_law = laws.drag;
    forces.lift_law = laws.lift;
    return;
  }
  if (drag != nullptr) forces.drag_law = readDrag(*drag);
  if (magnus != nullptr) forces.lift_law = readMagnus(*magnus);
}
}  // namespace

Forces readForces(const Field& field)
{
  const Map map(field, {"gravity", "air", "preset", "drag", "magnus", "buoyancy", "added_mass", "spin_decay", "wind"});
  Forces forces;
  if (const Field* f = map.find("gravity")) forces.gravity = readGravity(*f);
  if (const Field* f = map.find("air")) readAir(*f, forces);
  readAirLaws(map, forces);
  if (const Field* f = map.find("buoyancy")) forces.buoyancy = f->boolean();
  if (const Field* f = map.find("added_mass")) forces.added_mass = f->boolean();
  if (const Field* f = map.find("spin_decay")) forces.spin_decay = f->notNegative();
  if (const Field* f = map.find("wind")) forces.wind = f->vector();
  return forces;
}
}  // namespace ping_pong
