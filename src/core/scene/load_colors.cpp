#include "scene/load_colors.h"

namespace ping_pong
{
namespace
{
struct NamedColor
{
  const char* name;
  Color color;
};

const NamedColor kColors[] = {
    {"orange", {1.00f, 0.55f, 0.10f, 1.0f}}, {"white", {0.96f, 0.96f, 0.94f, 1.0f}},
    {"yellow", {0.98f, 0.83f, 0.20f, 1.0f}}, {"red", {0.87f, 0.22f, 0.20f, 1.0f}},
    {"pink", {0.95f, 0.50f, 0.65f, 1.0f}},   {"purple", {0.58f, 0.36f, 0.78f, 1.0f}},
    {"blue", {0.20f, 0.48f, 0.88f, 1.0f}},   {"cyan", {0.25f, 0.75f, 0.80f, 1.0f}},
    {"green", {0.35f, 0.72f, 0.35f, 1.0f}},  {"black", {0.12f, 0.12f, 0.13f, 1.0f}},
};

/// Distinct from each other and from the blue or green of a table.
const char* const kMixed[] = {"orange", "white", "yellow", "red", "pink", "purple", "cyan"};

const Color* findColor(const std::string& name)
{
  for (const NamedColor& known : kColors)
    if (name == known.name) return &known.color;
  return nullptr;
}

std::vector<Color> mixedPalette()
{
  std::vector<Color> palette;
  for (const char* name : kMixed) palette.push_back(*findColor(name));
  return palette;
}

std::string knownColors()
{
  std::vector<std::string> names;
  for (const NamedColor& known : kColors) names.push_back(known.name);
  return joined(names);
}

Color readComponents(const std::vector<Field>& rgb)
{
  return {static_cast<float>(rgb[0].fraction()), static_cast<float>(rgb[1].fraction()),
          static_cast<float>(rgb[2].fraction()), 1.0f};
}
}  // namespace

std::vector<Color> readPalette(const Field& field)
{
  if (field.isList()) return {readComponents(field.list(3, "three numbers [r, g, b] from 0 to 1"))};
  const std::string expected = "mixed, [r, g, b], or one of " + knownColors();
  if (field.isMap()) field.fail(expected);
  const std::string name = field.text();
  if (name == "mixed") return mixedPalette();
  const Color* color = findColor(name);
  if (color == nullptr) field.fail(expected);
  return {*color};
}

Color defaultColor()
{
  return kColors[0].color;
}
}  // namespace ping_pong
