#include "scene/load_surfaces.h"

#include "scene/materials.h"
#include "scene/presets.h"

namespace ping_pong
{
namespace
{
constexpr std::size_t kMaxMaterials = 1000;  ///< the table has an entry for each pair

/// One entry of the list: a law for two materials, either of which may be kAnyMaterial.
struct Rule
{
  Field pair;
  std::string first, second;
  Surface surface;
};

std::string readPairMember(const Field& field, const std::vector<std::string>& materials)
{
  const std::string name = field.text();
  if (name != kAnyMaterial && findMaterial(materials, name) == kNone)
    field.fail("a material of this scene: any, " + joined(materials));
  return name;
}

Surface readPreset(const Field& field)
{
  if (const SurfacePreset* preset = findSurfacePreset(field.text())) return preset->surface;
  field.fail("one of " + surfacePresetNames());
}

/// What only rubs where friction can hold the ball.
const Field* findRough(const Map& map, const char* key, const Surface& surface)
{
  const Field* field = map.find(key);
  if (field != nullptr && surface.friction == 0.0) field->fail("it only beside a friction > 0");
  return field;
}

Surface readLaw(const Map& map)
{
  Surface surface;
  surface.restitution = map.at("restitution", "a number from 0 to 1, or a preset").fraction();
  if (const Field* f = map.find("restitution_slope")) surface.restitution_slope = f->notNegative();
  if (const Field* f = map.find("friction")) surface.friction = f->notNegativeOrInfinite();
  if (const Field* f = findRough(map, "tangential_restitution", surface))
    surface.tangential_restitution = f->within(-1.0, 1.0);
  if (const Field* f = findRough(map, "rolling_resistance", surface)) surface.rolling_resistance = f->notNegative();
  if (const Field* f = findRough(map, "spin_friction", surface)) surface.spin_friction = f->notNegative();
  return surface;
}

/// A preset stands alone: an entry that changed a part of it would no longer be what its name says.
Surface readSurface(const Map& map)
{
  const Field* preset = map.find("preset");
  if (preset == nullptr) return readLaw(map);
  Map(map.field(), {"pair", "preset"});
  return readPreset(*preset);
}

Rule readRule(const Field& field, const std::vector<std::string>& materials)
{
  const Map map(field, {"pair", "preset", "restitution", "restitution_slope", "friction", "tangential_restitution",
                        "rolling_resistance", "spin_friction"});
  const Field& pair = map.at("pair", "two materials [a, b]");
  const std::vector<Field> members = pair.list(2, "two materials [a, b]");
  return {pair, readPairMember(members[0], materials), readPairMember(members[1], materials), readSurface(map)};
}

bool samePair(const Rule& a, const Rule& b)
{
  return (a.first == b.first && a.second == b.second) || (a.first == b.second && a.second == b.first);
}

std::vector<Rule> readRules(const Field& surfaces, const std::vector<std::string>& materials)
{
  std::vector<Rule> rules;
  for (const Field& field : surfaces.list())
  {
    const Rule rule = readRule(field, materials);
    for (const Rule& earlier : rules)
      if (samePair(rule, earlier)) rule.pair.fail("each pair once");
    rules.push_back(rule);
  }
  return rules;
}

/// How many of the two materials a rule names; -1: it does not speak of them.
int specificity(const Rule& rule, const std::string& a, const std::string& b)
{
  const auto matches = [](const std::string& pattern, const std::string& name)
  { return pattern == kAnyMaterial || pattern == name; };
  const bool fits =
      (matches(rule.first, a) && matches(rule.second, b)) || (matches(rule.first, b) && matches(rule.second, a));
  if (!fits) return -1;
  return (rule.first != kAnyMaterial ? 1 : 0) + (rule.second != kAnyMaterial ? 1 : 0);
}

/// The most specific rule for two materials, or null; `rival` is another one just as specific, or null.
const Rule* bestRule(const std::vector<Rule>& rules, const std::string& a, const std::string& b, const Rule*& rival)
{
  const Rule* best = nullptr;
  int best_specificity = -1;
  rival = nullptr;
  for (const Rule& rule : rules)
  {
    const int found = specificity(rule, a, b);
    if (found < 0 || found < best_specificity) continue;
    rival = found == best_specificity ? &rule : nullptr;
    if (found == best_specificity) continue;
    best = &rule;
    best_specificity = found;
  }
  return best;
}

/// Symmetric yes/no per pair of materials: can they meet in this scene?
class MeetingPairs
{
public:
  explicit MeetingPairs(const Scene& scene) : size_(scene.materials.size()), meet_(size_ * size_, false)
  {
    std::vector<int> balls(size_, 0);
    for (const SceneBall& ball : scene.balls) ++balls[ball.params.material];
    for (std::size_t a = 0; a < size_; ++a)
      for (std::size_t b = 0; b < size_; ++b) meet_[a * size_ + b] = balls[a] > 0 && balls[b] > (a == b ? 1 : 0);
    for (const Body& body : scene.bodies)
      for (const Shape& shape : body.shapes)
        for (std::size_t a = 0; a < size_; ++a)
          if (balls[a] > 0) meet_[a * size_ + shape.material] = meet_[shape.material * size_ + a] = true;
  }
  bool at(std::size_t a, std::size_t b) const { return meet_[a * size_ + b]; }

private:
  std::size_t size_;
  std::vector<bool> meet_;
};

void checkRule(const Rule* best, const Rule* rival, const std::string& pair, const Map& scene_map)
{
  const std::string expected = "a restitution for " + pair + ", since these materials can meet";
  if (best == nullptr) scene_map.at("surfaces", expected).fail(expected);
  if (rival != nullptr) rival->pair.fail("a law for " + pair + " itself, since two fallbacks fit that pair");
}
}  // namespace

void readSurfaces(const Map& scene_map, Scene& scene)
{
  if (scene.materials.size() > kMaxMaterials)
    scene_map.field().failWith(std::to_string(scene.materials.size()) + " materials", "at most 1000 of them");
  const Field* surfaces = scene_map.find("surfaces");
  const std::vector<Rule> rules = surfaces != nullptr ? readRules(*surfaces, scene.materials) : std::vector<Rule>();
  const MeetingPairs meetingLaw(scene);
  const std::vector<std::string>& names = scene.materials;
  scene.surfaces = SurfaceTable(names.size());
  for (std::size_t a = 0; a < names.size(); ++a)
    for (std::size_t b = a; b < names.size(); ++b)
    {
      const Rule* rival = nullptr;
      const Rule* best = bestRule(rules, names[a], names[b], rival);
      const std::string pair = "[" + names[a] + ", " + names[b] + "]";
      if (meetingLaw.at(a, b)) checkRule(best, rival, pair, scene_map);
      if (best != nullptr) scene.surfaces.set(static_cast<MaterialId>(a), static_cast<MaterialId>(b), best->surface);
    }
}
}  // namespace ping_pong
