// A strict look at a URDF file before urdfdom reads it: urdfdom is lenient, and knows no line numbers.
#pragma once

#include <string>
#include <vector>

namespace ping_pong
{
/// One <collision> of the file.
struct CheckedCollision
{
  int line = 1;
  std::string material;  ///< name of the collision, or of the link
};

struct CheckedUrdf
{
  int link_line = 1;
  std::vector<CheckedCollision> collisions;  ///< in the order of the file
};

/// Well-formed XML; one robot with one link; in each collision nothing but a name, an origin and one box, cylinder or
/// sphere of finite sizes > 0. Throws LoadError.
CheckedUrdf checkUrdf(const std::string& text, const std::string& path);
}  // namespace ping_pong
