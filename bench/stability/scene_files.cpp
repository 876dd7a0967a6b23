#include "scene_files.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace ping_pong::stability
{
namespace
{
std::ofstream opened(const std::string& path)
{
  std::ofstream file(path);
  file.precision(std::numeric_limits<double>::max_digits10);
  if (!file) throw std::runtime_error(path + ": cannot be written");
  return file;
}

struct Listed
{
  const Vector3d& x;
  const char* between;
};

std::ostream& operator<<(std::ostream& out, const Listed& listed)
{
  return out << listed.x.x() << listed.between << listed.x.y() << listed.between << listed.x.z();
}

Listed yaml(const Vector3d& x)
{
  return {x, ", "};
}
Listed xml(const Vector3d& x)
{
  return {x, " "};
}

// As in URDF: about the fixed axes x, y, z, one after the other.
Vector3d rollPitchYaw(const Matrix3d& R)
{
  return {std::atan2(R(2, 1), R(2, 2)), std::atan2(-R(2, 0), std::hypot(R(2, 1), R(2, 2))),
          std::atan2(R(1, 0), R(0, 0))};
}

void writeGeometry(std::ostream& out, const Shape& shape)
{
  const Vector3d size = 2.0 * shape.half_size;
  if (shape.kind == ShapeKind::Box)
    out << "<box size=\"" << xml(size) << "\"/>";
  else if (shape.kind == ShapeKind::Cylinder)
    out << "<cylinder radius=\"" << shape.half_size.x() << "\" length=\"" << size.z() << "\"/>";
  else
    out << "<sphere radius=\"" << shape.half_size.x() << "\"/>";
}

void writeUrdf(const Scene& scene, const Body& body, const std::string& path)
{
  std::ofstream out = opened(path);
  out << "<robot name=\"" << body.name << "\"><link name=\"" << body.name << "\">\n";
  for (const Shape& shape : body.shapes)
  {
    const Vector3d rpy = rollPitchYaw(shape.R_BS);
    out << "  <collision name=\"" << scene.materials[shape.material] << "\"><origin xyz=\"" << xml(shape.p_BS)
        << "\" rpy=\"" << xml(rpy) << "\"/><geometry>";
    writeGeometry(out, shape);
    out << "</geometry></collision>\n";
  }
  out << "</link></robot>\n";
}

void writeForces(std::ostream& out, const Forces& forces)
{
  out << "forces:\n  gravity: [" << yaml(forces.gravity) << "]\n";
  if (forces.drag) out << "  drag: default\n";
  if (forces.magnus) out << "  magnus: default\n";
  if (forces.buoyancy) out << "  buoyancy: true\n";
  if (forces.added_mass) out << "  added_mass: true\n";
  if (forces.spin_decay > 0.0) out << "  spin_decay: " << forces.spin_decay << '\n';
  if (!forces.wind.isZero(0.0) && forces.dependOnVelocity()) out << "  wind: [" << yaml(forces.wind) << "]\n";
}

void writeBody(std::ostream& out, const Body& body)
{
  const Vector3d rpy = rollPitchYaw(body.pose.q.toRotationMatrix());
  const DriveLimits& limits = body.limits;
  out << "  - {name: " << body.name << ", urdf: " << body.name
      << ".urdf, kind: " << (body.kind == BodyKind::Static ? "static" : "kinematic") << ", position: ["
      << yaml(body.pose.p) << "], rpy: [" << yaml(rpy) << ']';
  if (body.kind == BodyKind::Kinematic)
    out << ", limits: {speed: " << limits.speed << ", acceleration: " << limits.acceleration
        << ", angular_speed: " << limits.angular_speed << ", angular_acceleration: " << limits.angular_acceleration
        << '}';
  out << "}\n";
}

bool isFloor(const Body& body)
{
  return body.shapes[0].kind == ShapeKind::HalfSpace;
}

void writeBodies(std::ostream& out, const Scene& scene, const std::string& folder)
{
  bool others = false;
  for (const Body& body : scene.bodies)
    if (isFloor(body))
      out << "floor: {height: " << body.pose.p.z() << ", material: " << scene.materials[body.shapes[0].material]
          << "}\n";
    else
      others = true;
  if (!others) return;
  out << "bodies:\n";
  for (const Body& body : scene.bodies)
  {
    if (isFloor(body)) continue;
    writeBody(out, body);
    writeUrdf(scene, body, folder + '/' + body.name + ".urdf");
  }
}

void writeBall(std::ostream& out, const SceneBall& ball)
{
  out << "balls:\n  - {position: [" << yaml(ball.state.p_WB) << "], velocity: [" << yaml(ball.state.v_WB)
      << "], spin: [" << yaml(ball.state.w_WB) << "], radius: " << ball.params.radius << ", mass: " << ball.params.mass
      << ", inertia: " << (ball.params.inertia == kShellInertia ? "shell" : "solid") << "}\n";
}

bool used(const Scene& scene, std::size_t material)
{
  for (const Body& body : scene.bodies)
    for (const Shape& shape : body.shapes)
      if (shape.material == material) return true;
  return false;
}

void writeSurfaces(std::ostream& out, const Scene& scene)
{
  out << "surfaces:\n";
  for (std::size_t i = 1; i < scene.materials.size(); ++i)
  {
    if (!used(scene, i)) continue;
    const Surface& law = scene.surfaces.at(0, static_cast<MaterialId>(i));
    out << "  - {pair: [ball, " << scene.materials[i] << "], restitution: " << law.restitution;
    if (law.restitution_slope > 0.0) out << ", restitution_slope: " << law.restitution_slope;
    if (std::isinf(law.friction))
      out << ", friction: .inf";
    else if (law.friction > 0.0)
      out << ", friction: " << law.friction;
    if (law.tangential_restitution != 0.0) out << ", tangential_restitution: " << law.tangential_restitution;
    if (law.rolling_resistance > 0.0) out << ", rolling_resistance: " << law.rolling_resistance;
    if (law.spin_friction > 0.0) out << ", spin_friction: " << law.spin_friction;
    out << "}\n";
  }
}

void writeCommands(std::ostream& out, const RandomScene& drawn)
{
  for (const TimedCommand& each : drawn.commands)
  {
    const PaddleCommand& command = each.command;
    out << "# from " << each.time << " s on: " << drawn.scene.bodies[each.body].name;
    if (command.mode == PaddleCommand::Mode::Acceleration)
      out << ", acceleration [" << yaml(command.a_W) << "], angular [" << yaml(command.alpha_W) << "]\n";
    else if (command.mode == PaddleCommand::Mode::Velocity)
      out << ", velocity [" << yaml(command.twist.v) << "], angular [" << yaml(command.twist.w) << "]\n";
    else
      out << ", hold\n";
  }
}
}  // namespace

void dumpScene(const RandomScene& drawn, const std::string& folder)
{
  std::filesystem::create_directories(folder);
  std::ofstream out = opened(folder + "/scene.yaml");
  const Scene& scene = drawn.scene;
  out << "# stability --random 1 --seed " << drawn.seed << " --first " << drawn.index << ": " << drawn.category
      << ", a ball " << drawn.launch << ", ticks of " << drawn.tick << " s for " << drawn.duration << " s\n";
  writeCommands(out, drawn);
  out << "name: " << scene.name << '\n';
  writeForces(out, scene.forces);
  writeBodies(out, scene, folder);
  writeBall(out, scene.balls[0]);
  writeSurfaces(out, scene);
  out << "method: exact\ntolerance: " << scene.tolerance << '\n';
}
}  // namespace ping_pong::stability
