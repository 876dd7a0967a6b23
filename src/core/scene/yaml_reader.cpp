#include "scene/yaml_reader.h"

#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "ping_pong_sim/scene_loader.h"

namespace ping_pong
{
namespace
{
constexpr int kMaxNesting = 100;

int lineOf(const YAML::Mark& mark)
{
  return std::max(mark.line, 0) + 1;
}

/// Reads a document and keeps nothing of it.
class IgnoreEvents : public YAML::EventHandler
{
public:
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

/// Not LoadAll: on a stray comma it makes documents until memory ends (yaml-cpp 0.7).
int documentsUpToTwo(const std::string& text)
{
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  IgnoreEvents ignore;
  int count = 0;
  while (count < 2 && parser.HandleNextDocument(ignore)) ++count;
  return count;
}

/// yaml-cpp before 0.7 follows nested brackets until the stack is full. Brackets in quotes and comments count too: the
/// bound is far above what a scene needs.
void checkNesting(const std::string& text, const std::string& path)
{
  int depth = 0, line = 1;
  for (const char c : text)
  {
    if (c == '\n') ++line;
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (depth > kMaxNesting) failLoad({path, line}, "scene", std::string(1, c), "at most 100 nested brackets");
  }
}
}  // namespace

Field::Field(YAML::Node node, FileLine at, std::string key)
    : node_(std::move(node)), at_(std::move(at)), key_(std::move(key))
{
}

bool Field::plain() const
{
  return node_.IsScalar() && node_.Tag() != "!";
}

bool Field::infinite() const
{
  return plain() && (node_.Scalar() == ".inf" || node_.Scalar() == "+.inf");
}

std::string Field::value() const
{
  if (node_.IsScalar()) return node_.Scalar();
  if (node_.IsMap()) return "a map";
  if (!node_.IsSequence()) return "nothing";
  std::vector<std::string> items;
  for (const YAML::Node& item : node_)
  {
    if (!item.IsScalar()) return "a list";
    items.push_back(item.Scalar());
  }
  return "[" + joined(items) + "]";
}

void Field::failWith(const std::string& value, const std::string& expected) const
{
  failLoad(at_, key_.empty() ? "scene" : key_, value, expected);
}

std::string Field::text() const
{
  if (!node_.IsScalar() || node_.Scalar().empty()) fail("a text");
  return node_.Scalar();
}

double Field::number() const
{
  double number = 0.0;
  if (!plain() || !parseNumber(node_.Scalar(), number)) fail("a finite number");
  return number;
}

double Field::positive() const
{
  double number = 0.0;
  if (!plain() || !parseNumber(node_.Scalar(), number) || !(number > 0.0)) fail("a finite number > 0");
  return number;
}

double Field::positiveOrInfinite() const
{
  if (infinite()) return std::numeric_limits<double>::infinity();
  double number = 0.0;
  if (!plain() || !parseNumber(node_.Scalar(), number) || !(number > 0.0)) fail("a number > 0 or .inf");
  return number;
}

double Field::notNegative() const
{
  double number = 0.0;
  if (!plain() || !parseNumber(node_.Scalar(), number) || !(number >= 0.0)) fail("a finite number >= 0");
  return number;
}

double Field::notNegativeOrInfinite() const
{
  if (infinite()) return std::numeric_limits<double>::infinity();
  double number = 0.0;
  if (!plain() || !parseNumber(node_.Scalar(), number) || !(number >= 0.0)) fail("a number >= 0 or .inf");
  return number;
}

double Field::fraction() const
{
  return within(0.0, 1.0);
}

double Field::within(double low, double high) const
{
  double number = 0.0;
  if (!plain() || !parseNumber(node_.Scalar(), number) || !(number >= low && number <= high))
    fail(rangeText(low, high));
  return number;
}

bool Field::boolean() const
{
  const std::string text = plain() ? node_.Scalar() : "";
  if (text != "true" && text != "false") fail("true or false");
  return text == "true";
}

std::uint64_t Field::integer() const
{
  std::uint64_t number = 0;
  if (!plain() || !parseInteger(node_.Scalar(), number)) fail("an integer >= 0");
  return number;
}

std::size_t Field::count(std::size_t most) const
{
  std::uint64_t number = 0;
  if (!plain() || !parseInteger(node_.Scalar(), number) || number < 1 || number > most)
    fail("an integer from 1 to " + std::to_string(most));
  return static_cast<std::size_t>(number);
}

Vector3d Field::vector() const
{
  const std::vector<Field> items = list(3, "three numbers [x, y, z]");
  return {items[0].number(), items[1].number(), items[2].number()};
}

Field Field::item(const YAML::Node& node, std::size_t index) const
{
  return {node, {at_.file, lineOf(node.Mark())}, key_ + "[" + std::to_string(index) + "]"};
}

std::vector<Field> Field::list() const
{
  if (!node_.IsSequence()) fail("a list");
  std::vector<Field> items;
  for (const YAML::Node& node : node_) items.push_back(item(node, items.size()));
  return items;
}

std::vector<Field> Field::list(std::size_t size, const std::string& expected) const
{
  if (!node_.IsSequence() || node_.size() != size) fail(expected);
  return list();
}

Map::Map(const Field& field, const std::vector<std::string>& known_keys) : field_(field)
{
  if (!field.isMap()) field.fail("a map with the keys " + joined(known_keys));
  for (const auto& entry : field.node_) add(entry.first, entry.second, known_keys);
}

void Map::add(const YAML::Node& key, const YAML::Node& value, const std::vector<std::string>& known_keys)
{
  const int key_line = lineOf(key.Mark());
  const std::string prefix = field_.key_.empty() ? "" : field_.key_ + ".";
  const std::string name = key.IsScalar() ? key.Scalar() : "?";
  // A missing value has the mark of whatever comes next.
  const Field entry(value, {field_.at_.file, value.IsNull() ? key_line : lineOf(value.Mark())}, prefix + name);
  const Field key_entry(key, {field_.at_.file, key_line}, prefix + name);
  if (std::find(known_keys.begin(), known_keys.end(), name) == known_keys.end())
    key_entry.failWith("unknown key", "one of " + joined(known_keys));
  if (find(name) != nullptr) key_entry.failWith("repeated key", "each key once");
  entries_.emplace_back(name, entry);
}

const Field* Map::find(const std::string& key) const
{
  for (const auto& [name, field] : entries_)
    if (name == key) return &field;
  return nullptr;
}

const Field& Map::at(const std::string& key, const std::string& expected) const
{
  if (const Field* field = find(key)) return *field;
  const std::string prefix = field_.key_.empty() ? "" : field_.key_ + ".";
  failLoad(field_.at_, prefix + key, "missing", expected);
}

Field readYaml(const std::string& path)
{
  std::string text;
  try
  {
    text = readFile(path);
  }
  catch (const std::runtime_error& error)
  {
    failLoad({path, 1}, "scene", error.what(), "a readable file");
  }
  checkNesting(text, path);
  try
  {
    const int documents = documentsUpToTwo(text);
    if (documents != 1) failLoad({path, 1}, "scene", std::to_string(documents) + " documents", "one YAML document");
    const YAML::Node document = YAML::Load(text);
    return {document, {path, lineOf(document.Mark())}, ""};
  }
  catch (const YAML::Exception& error)
  {
    failLoad({path, lineOf(error.mark)}, "scene", error.msg, "well-formed YAML");
  }
}
}  // namespace ping_pong
