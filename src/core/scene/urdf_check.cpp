#include "scene/urdf_check.h"

#include <tinyxml2.h>

#include <algorithm>

#include "scene/materials.h"
#include "scene/text_input.h"

namespace ping_pong
{
namespace
{
using tinyxml2::XMLAttribute;
using tinyxml2::XMLDocument;
using tinyxml2::XMLElement;
using tinyxml2::XMLNode;
using Names = std::vector<std::string>;

bool contains(const Names& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// robot/link/collision/geometry
std::string keyOf(const XMLNode& node)
{
  const XMLNode* parent = node.Parent();
  if (parent == nullptr || parent->ToElement() == nullptr) return node.Value();
  return keyOf(*parent) + "/" + node.Value();
}

/// The tests of one file; each throws if its part of the file is wrong.
class Checker
{
public:
  explicit Checker(const std::string& path) : path_(path) {}

  CheckedUrdf check(const XMLDocument& document)
  {
    const XMLElement& robot = soleRoot(document);
    requireText(robot, "name");
    const XMLElement& link = soleLink(robot);
    const std::string link_name = requireText(link, "name");
    allowChildren(link, {"visual", "collision", "inertial"});
    checked_.link_line = link.GetLineNum();
    for (const XMLElement* e = link.FirstChildElement("collision"); e; e = e->NextSiblingElement("collision"))
      checkCollision(*e, link_name);
    if (checked_.collisions.empty()) fail(link, "no collision", "at least one collision");
    return checked_;
  }

private:
  [[noreturn]] void fail(const XMLNode& node, const std::string& value, const std::string& expected) const
  {
    failLoad({path_, std::max(node.GetLineNum(), 1)}, keyOf(node), value, expected);
  }

  [[noreturn]] void fail(const XMLElement& element, const XMLAttribute& attribute, const std::string& expected) const
  {
    failLoad({path_, std::max(attribute.GetLineNum(), 1)}, keyOf(element) + "." + attribute.Name(), attribute.Value(),
             expected);
  }

  const XMLElement& soleRoot(const XMLDocument& document) const
  {
    const XMLElement* root = document.RootElement();
    if (root == nullptr) failLoad({path_, 1}, "robot", "missing", "a robot element");
    if (std::string(root->Name()) != "robot") fail(*root, "unknown element", "robot as the outermost element");
    if (const XMLElement* second = root->NextSiblingElement()) fail(*second, "second element", "one outermost element");
    return *root;
  }

  const XMLElement& soleLink(const XMLElement& robot) const
  {
    for (const XMLElement* e = robot.FirstChildElement("joint"); e; e = e->NextSiblingElement("joint"))
      fail(*e, "joint", "no joints: one file is one rigid body of one link");
    allowChildren(robot, {"link", "material"});
    const XMLElement* link = robot.FirstChildElement("link");
    if (link == nullptr) fail(robot, "no link", "one link");
    if (const XMLElement* second = link->NextSiblingElement("link")) fail(*second, "second link", "one link");
    return *link;
  }

  void allowChildren(const XMLElement& element, const Names& names) const
  {
    for (const XMLNode* node = element.FirstChild(); node; node = node->NextSibling())
    {
      if (node->ToText() != nullptr) fail(element, "text", "no text in this element");
      if (node->ToElement() != nullptr && !contains(names, node->Value()))
        fail(*node, "unknown element", names.empty() ? "nothing here" : "one of " + joined(names));
    }
  }

  void allowAttributes(const XMLElement& element, const Names& names) const
  {
    for (const XMLAttribute* a = element.FirstAttribute(); a; a = a->Next())
      if (!contains(names, a->Name()))
        fail(element, *a, names.empty() ? "no attributes" : "no attribute other than " + joined(names));
  }

  const XMLAttribute& require(const XMLElement& element, const char* name, const std::string& expected) const
  {
    const XMLAttribute* attribute = element.FindAttribute(name);
    if (attribute == nullptr)
      failLoad({path_, std::max(element.GetLineNum(), 1)}, keyOf(element) + "." + name, "missing", expected);
    return *attribute;
  }

  std::string requireText(const XMLElement& element, const char* name) const
  {
    const XMLAttribute& attribute = require(element, name, "a name");
    if (std::string(attribute.Value()).empty()) fail(element, attribute, "a name");
    return attribute.Value();
  }

  void requireSizes(const XMLElement& element, const char* name, std::size_t count) const
  {
    const std::string expected = count == 1 ? "a finite number > 0" : std::to_string(count) + " finite numbers > 0";
    const XMLAttribute& attribute = require(element, name, expected);
    std::vector<double> sizes;
    const bool valid = parseNumbers(attribute.Value(), count, sizes);
    if (!valid || *std::min_element(sizes.begin(), sizes.end()) <= 0.0) fail(element, attribute, expected);
  }

  const XMLElement* atMostOne(const XMLElement& parent, const char* name) const
  {
    const XMLElement* first = parent.FirstChildElement(name);
    const XMLElement* second = first != nullptr ? first->NextSiblingElement(name) : nullptr;
    if (second != nullptr) fail(*second, std::string("second ") + name, "one");
    return first;
  }

  void checkCollision(const XMLElement& collision, const std::string& link_name)
  {
    allowAttributes(collision, {"name"});
    allowChildren(collision, {"origin", "geometry"});
    if (const XMLElement* origin = atMostOne(collision, "origin")) checkOrigin(*origin);
    const XMLElement* geometry = atMostOne(collision, "geometry");
    if (geometry == nullptr) fail(collision, "no geometry", "one geometry");
    checkGeometry(*geometry);
    const bool named = collision.FindAttribute("name") != nullptr;
    const std::string material = named ? requireText(collision, "name") : link_name;
    if (material == kAnyMaterial) fail(collision, material, "another name: any stands for all materials in a scene");
    checked_.collisions.push_back({collision.GetLineNum(), material});
  }

  void checkOrigin(const XMLElement& origin) const
  {
    allowAttributes(origin, {"xyz", "rpy"});
    allowChildren(origin, {});
    std::vector<double> numbers;
    for (const XMLAttribute* a = origin.FirstAttribute(); a; a = a->Next())
      if (!parseNumbers(a->Value(), 3, numbers)) fail(origin, *a, "three finite numbers");
  }

  void checkGeometry(const XMLElement& geometry) const
  {
    allowAttributes(geometry, {});
    if (const XMLElement* mesh = geometry.FirstChildElement("mesh"))
      fail(*mesh, "mesh", "box, cylinder or sphere as collision");
    allowChildren(geometry, {"box", "cylinder", "sphere"});
    const XMLElement* shape = geometry.FirstChildElement();
    if (shape == nullptr) fail(geometry, "no shape", "box, cylinder or sphere as collision");
    if (const XMLElement* second = shape->NextSiblingElement())
      fail(*second, "second shape", "one shape per collision");
    allowChildren(*shape, {});
    checkSizes(*shape);
  }

  void checkSizes(const XMLElement& shape) const
  {
    const std::string kind = shape.Name();
    const Names names = kind == "box" ? Names{"size"} : kind == "sphere" ? Names{"radius"} : Names{"radius", "length"};
    allowAttributes(shape, names);
    for (const std::string& name : names) requireSizes(shape, name.c_str(), name == "size" ? 3 : 1);
  }

  std::string path_;
  CheckedUrdf checked_;
};
}  // namespace

CheckedUrdf checkUrdf(const std::string& text, const std::string& path)
{
  XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
    failLoad({path, std::max(document.ErrorLineNum(), 1)}, "robot", document.ErrorName(), "well-formed XML");
  return Checker(path).check(document);
}
}  // namespace ping_pong
