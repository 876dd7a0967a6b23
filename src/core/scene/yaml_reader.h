// Strict reading of YAML: each value knows its file, line and key path, and each complaint names them.
#pragma once

#include <yaml-cpp/yaml.h>

#include <array>
#include <string>
#include <vector>

#include "ping_pong_sim/types.h"
#include "scene/text_input.h"

namespace ping_pong
{
/// One value of a YAML file. The readers throw LoadError if the value is not what they are named after.
class Field
{
public:
  Field(YAML::Node node, FileLine at, std::string key);

  std::string text() const;                      ///< not empty
  double number() const;                         ///< finite
  double positive() const;                       ///< finite, > 0
  double positiveOrInfinite() const;             ///< > 0, .inf allowed
  double notNegative() const;                    ///< finite, >= 0
  double notNegativeOrInfinite() const;          ///< >= 0, .inf allowed
  double fraction() const;                       ///< 0 to 1
  double within(double low, double high) const;  ///< ends included
  bool boolean() const;                          ///< true or false
  std::uint64_t integer() const;                 ///< >= 0
  std::size_t count(std::size_t most) const;     ///< 1 to `most`
  Vector3d vector() const;                       ///< [x, y, z], finite
  std::vector<Field> list() const;
  std::vector<Field> list(std::size_t size, const std::string& expected) const;

  bool isMap() const { return node_.IsMap(); }
  bool isList() const { return node_.IsSequence(); }

  /// "FILE:LINE: KEY.PATH: VALUE: expected EXPECTED"; the value is the one that the file holds, unless given.
  [[noreturn]] void fail(const std::string& expected) const { failWith(value(), expected); }
  [[noreturn]] void failWith(const std::string& value, const std::string& expected) const;

private:
  friend class Map;
  std::string value() const;
  Field item(const YAML::Node& node, std::size_t index) const;
  bool plain() const;  ///< an unquoted scalar: may be a number
  bool infinite() const;

  YAML::Node node_;
  FileLine at_;
  std::string key_;  ///< path such as balls[0].position
};

/// A YAML map with a closed list of keys. Unknown and repeated keys are errors.
class Map
{
public:
  Map(const Field& field, const std::vector<std::string>& known_keys);
  /// Null if the file does not have the key.
  const Field* find(const std::string& key) const;
  /// Throws LoadError if the file does not have the key.
  const Field& at(const std::string& key, const std::string& expected) const;
  const Field& field() const { return field_; }

private:
  void add(const YAML::Node& key, const YAML::Node& value, const std::vector<std::string>& known_keys);

  Field field_;
  std::vector<std::pair<std::string, Field>> entries_;
};

/// The one document of a YAML file. Throws LoadError.
Field readYaml(const std::string& path);
}  // namespace ping_pong
