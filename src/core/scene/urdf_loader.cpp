#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <exception>
#include <stdexcept>

#include "ping_pong_sim/scene_loader.h"
#include "scene/materials.h"
#include "scene/text_input.h"
#include "scene/urdf_check.h"

namespace ping_pong
{
namespace
{
/// Keeps what urdfdom has to say for an error message; it would print it. The handler is one per process, so files are
/// loaded by one thread at a time.
class UrdfdomSilencer : public console_bridge::OutputHandler
{
public:
  UrdfdomSilencer() : previous_(console_bridge::getOutputHandler()) { console_bridge::useOutputHandler(this); }
  ~UrdfdomSilencer() override { console_bridge::useOutputHandler(previous_); }
  UrdfdomSilencer(const UrdfdomSilencer&) = delete;
  UrdfdomSilencer& operator=(const UrdfdomSilencer&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override
  {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) heard_.push_back(text);
  }
  std::string heard() const { return joined(heard_); }

private:
  console_bridge::OutputHandler* previous_;
  std::vector<std::string> heard_;
};

Vector3d toEigen(const urdf::Vector3& v)
{
  return {v.x, v.y, v.z};
}

Matrix3d toEigen(const urdf::Rotation& q)
{
  return Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
}

/// False: none of the three kinds that checkUrdf() lets through.
bool readGeometry(const urdf::Geometry* geometry, Shape& shape)
{
  if (const auto* box = dynamic_cast<const urdf::Box*>(geometry))
  {
    shape.kind = ShapeKind::Box;
    shape.half_size = 0.5 * toEigen(box->dim);
  }
  else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(geometry))
  {
    shape.kind = ShapeKind::Cylinder;
    shape.half_size = Vector3d(cylinder->radius, cylinder->radius, 0.5 * cylinder->length);
  }
  else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(geometry))
  {
    shape.kind = ShapeKind::Sphere;
    shape.half_size = Vector3d::Constant(sphere->radius);
  }
  else
    return false;
  return true;
}

urdf::LinkConstSharedPtr readLink(const std::string& text, const FileLine& at)
{
  UrdfdomSilencer silencer;
  try
  {
    const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(text);
    // A model may come back although a part of it was refused: what was said counts too.
    if (model != nullptr && model->getRoot() != nullptr && silencer.heard().empty()) return model->getRoot();
  }
  catch (const std::exception& error)
  {
    failLoad(at, "robot/link", error.what(), "a model that urdfdom accepts");
  }
  failLoad(at, "robot/link", silencer.heard(), "a model that urdfdom accepts");
}

std::string readUrdf(const std::string& path)
{
  try
  {
    return readFile(path);
  }
  catch (const std::runtime_error& error)
  {
    failLoad({path, 1}, "robot", error.what(), "a readable URDF file");
  }
}
}  // namespace

std::vector<Shape> loadShapes(const std::string& urdf_path, std::vector<std::string>& materials)
{
  const std::string text = readUrdf(urdf_path);
  const CheckedUrdf checked = checkUrdf(text, urdf_path);
  const urdf::LinkConstSharedPtr link = readLink(text, {urdf_path, checked.link_line});
  if (link->collision_array.size() != checked.collisions.size())
    failLoad({urdf_path, checked.link_line}, "robot/link", std::to_string(link->collision_array.size()) + " collisions",
             "as many as the file lists, " + std::to_string(checked.collisions.size()));
  std::vector<Shape> shapes(checked.collisions.size());
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    const urdf::Collision& collision = *link->collision_array[i];
    if (!readGeometry(collision.geometry.get(), shapes[i]))
      failLoad({urdf_path, checked.collisions[i].line}, "robot/link/collision", "unknown shape",
               "box, cylinder or sphere");
    shapes[i].p_BS = toEigen(collision.origin.position);
    shapes[i].R_BS = toEigen(collision.origin.rotation);
    shapes[i].material = internMaterial(materials, checked.collisions[i].material);
  }
  return shapes;
}
}  // namespace ping_pong
