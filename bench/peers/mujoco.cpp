// MuJoCo 2.2.2. It has no restitution: contacts are springs and dampers. How e becomes one, and all settings:
// README.md.
#include <mujoco/mujoco.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "peers.h"
#include "stepped_engine.h"

namespace ping_pong::bench
{
namespace
{
// Length of a bounce in steps, "best": few, for it comes that much late; more for shorter steps, so that e is met ever
// better.
constexpr double kStepsInContact = 6.0;  // at kStep
constexpr double kStep = 1e-3;           // [s]
constexpr double kGrowth = 1.0 / 3.0;    // steps in contact grow with this power of 1 / step
constexpr double kMaxDamping = 2.0;      // damping ratio that stands for e = 0 and all that is nearly so
constexpr double kHeavy = 1e6;           // mass of a driven body / mass of a ball
constexpr std::size_t kContactsPerBall = 6;
constexpr double kAlwaysGrips = 1e6;

// Speed after / before on a spring and damper that cannot pull (Schwager and Poeschel 2007, with time in 1/omega_0):
// x'' + 2 zeta x' + x = 0 from x = 0, x' = 1 until the force 2 zeta x' + x is 0.
double restitutionOf(double zeta)
{
  if (std::abs(zeta - 1.0) < 1e-9) zeta += 2e-9;
  if (zeta < 1.0)
  {
    const double w = std::sqrt(1.0 - zeta * zeta);
    const double t = (M_PI - std::atan2(2.0 * zeta * w, 1.0 - 2.0 * zeta * zeta)) / w;
    return -std::exp(-zeta * t) * (std::cos(w * t) - zeta / w * std::sin(w * t));
  }
  const double s = std::sqrt(zeta * zeta - 1.0);
  const double t = std::atanh(2.0 * zeta * s / (2.0 * zeta * zeta - 1.0)) / s;
  return -std::exp(-zeta * t) * (std::cosh(s * t) - zeta / s * std::sinh(s * t));
}

double dampingRatio(double restitution)
{
  if (restitution >= 1.0) return 0.0;
  double low = 0.0, high = kMaxDamping;
  if (restitutionOf(high) > restitution) return high;
  for (int i = 0; i < 60; ++i) (restitutionOf(0.5 * (low + high)) > restitution ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

class MujocoEngine : public SteppedEngine
{
public:
  MujocoEngine(const Scene& scene, bool best, double step);

private:
  BallState stateNow(std::size_t ball) const override;
  void stepOnce() override;
  bool rough() const;  // any friction at all
  std::string xml() const;
  // Half a period of the contact's spring is its time in contact [1/s].
  double springRate() const { return M_PI / (kStepsInContact * std::pow(kStep / step_, kGrowth) * step_); }
  std::string contactAttributes(const Surface& law) const;
  void writeBall(std::ostream& out, std::size_t index) const;
  void writeBody(std::ostream& out, std::size_t index) const;
  void moveDriven();
  void addFlight(mjData* data) const;
  void dampSlip(mjData* data) const;
  static void passive(const mjModel*, mjData* data) { current_->addFlight(data); }
  static void control(const mjModel*, mjData* data) { current_->dampSlip(data); }

  // The callbacks of MuJoCo are global and know no user.
  static thread_local const MujocoEngine* current_;
  const bool best_;
  std::unique_ptr<mjModel, void (*)(mjModel*)> model_{nullptr, mj_deleteModel};
  std::unique_ptr<mjData, void (*)(mjData*)> data_{nullptr, mj_deleteData};
  std::vector<int> driven_dof_, driven_qpos_;  // by body; -1: static
};

thread_local const MujocoEngine* MujocoEngine::current_ = nullptr;

std::string text(const Vector3d& v)
{
  std::ostringstream out;
  out.precision(17);
  out << '"' << v.x() << ' ' << v.y() << ' ' << v.z() << '"';
  return out.str();
}

std::string text(const Quaterniond& q)
{
  std::ostringstream out;
  out.precision(17);
  out << '"' << q.w() << ' ' << q.x() << ' ' << q.y() << ' ' << q.z() << '"';
  return out.str();
}

MujocoEngine::MujocoEngine(const Scene& scene, bool best, double step) : SteppedEngine(scene, step), best_(best)
{
  mju_user_warning = [](const char*) {};                                            // else it writes a log file
  mju_user_error = [](const char* message) { throw std::runtime_error(message); };  // else it ends the process
  const std::string source = xml();
  mjVFS files;
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, "scene.xml", static_cast<int>(source.size()));
  source.copy(static_cast<char*>(files.filedata[0]), source.size());
  char error[1000] = "";
  model_.reset(mj_loadXML("scene.xml", &files, error, sizeof(error)));
  mj_deleteVFS(&files);
  if (!model_) throw std::runtime_error(std::string("MuJoCo: ") + error);
  data_.reset(mj_makeData(model_.get()));
  for (std::size_t i = 0; i < scene_.balls.size(); ++i)
  {
    const BallState& state = scene_.balls[i].state;
    const Vector3d spin = state.q_WB.conjugate() * state.w_WB;
    std::copy_n(state.v_WB.data(), 3, data_->qvel + 6 * i);
    std::copy_n(spin.data(), 3, data_->qvel + 6 * i + 3);
  }
  int free_joint = static_cast<int>(scene_.balls.size());
  for (const Body& body : scene_.bodies)
  {
    const bool driven = body.kind == BodyKind::Kinematic;
    driven_dof_.push_back(driven ? 6 * free_joint : -1);
    driven_qpos_.push_back(driven ? 7 * free_joint : -1);
    if (driven) ++free_joint;
  }
}

std::string MujocoEngine::contactAttributes(const Surface& law) const
{
  const double zeta = dampingRatio(law.restitution);
  std::ostringstream out;
  out.precision(17);
  if (best_)
  {
    const double rate = springRate();
    out << " solref=\"" << -rate * rate << ' ' << -2.0 * zeta * rate << "\" solimp=\"0.9999 0.9999 0.001 0.5 2\"";
  }
  else if (zeta > 0.0)
    out << " solref=\"0.02 " << zeta << '"';  // 0.02 s: the default time constant
  else
    out << " solref=\"-1000 0\"";  // what its documentation proposes for e = 1
  out << " friction=\"" << std::min(law.friction, kAlwaysGrips) << " 0 0\"";
  out << " condim=\"" << (law.friction > 0.0 ? 3 : 1) << '"';
  return out.str();
}

void MujocoEngine::writeBall(std::ostream& out, std::size_t index) const
{
  const SceneBall& ball = scene_.balls[index];
  const Surface law = scene_.balls.size() > 1 ? ballLaw(scene_, index, index == 0 ? 1 : 0) : Surface();
  const double inertia = inertiaOf(ball.params);
  out << "<body pos=" << text(ball.state.p_WB) << " quat=" << text(ball.state.q_WB) << "><freejoint/>"
      << "<inertial pos='0 0 0' mass='" << ball.params.mass << "' diaginertia=" << text(Vector3d::Constant(inertia))
      << "/><geom type='sphere' size='" << ball.params.radius << "' contype='1' conaffinity='3'"
      << contactAttributes(law) << "/></body>\n";
}

// Bodies have a higher priority than balls: the law of a contact is that of the body, between balls that of balls.
void MujocoEngine::writeBody(std::ostream& out, std::size_t index) const
{
  const Body& body = scene_.bodies[index];
  const bool driven = body.kind == BodyKind::Kinematic;
  out << "<body pos=" << text(body.pose.p) << " quat=" << text(body.pose.q) << ">";
  if (driven)
  {
    const double mass = kHeavy * (scene_.balls.empty() ? 1.0 : scene_.balls[0].params.mass);
    out << "<freejoint/><inertial pos='0 0 0' mass='" << mass << "' diaginertia=" << text(Vector3d::Constant(mass))
        << "/>";
  }
  for (const Shape& shape : body.shapes)
  {
    const bool plane = shape.kind == ShapeKind::HalfSpace;
    const Surface law = scene_.balls.empty() ? Surface() : shapeLaw(scene_, 0, shape);
    out << "<geom type='" << (plane ? "plane" : "box") << "' size=" << text(plane ? Vector3d(0, 0, 1) : shape.half_size)
        << " pos=" << text(shape.p_BS) << " quat=" << text(Quaterniond(shape.R_BS))
        << " contype='2' conaffinity='0' priority='1'" << contactAttributes(law) << "/>";
  }
  out << "</body>\n";
}

bool MujocoEngine::rough() const
{
  const SharedLaws laws = sharedLaws(scene_);
  bool any = laws.ball_ball.friction > 0.0;
  for (const auto& body : laws.ball_shape)
    for (const Surface& law : body) any = any || law.friction > 0.0;
  return any;
}

std::string MujocoEngine::xml() const
{
  const std::size_t contacts = kContactsPerBall * scene_.balls.size() + 16;
  const std::size_t rows = rough() ? 4 * contacts : contacts;  // memory goes with their square
  std::ostringstream out;
  out.precision(17);
  out << "<mujoco><option timestep='" << step_ << "' gravity=" << text(engineGravity());
  if (best_) out << " integrator='RK4' cone='elliptic' tolerance='0' iterations='100'";
  out << "/><size nconmax='" << contacts << "' njmax='" << rows << "'/><worldbody>\n";
  for (std::size_t i = 0; i < scene_.balls.size(); ++i) writeBall(out, i);
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b) writeBody(out, b);
  out << "</worldbody></mujoco>\n";
  return out.str();
}

// MuJoCo's own moving scenery has no velocity in contacts, so that a driven body is a very heavy free one, put right
// each step.
void MujocoEngine::moveDriven()
{
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b)
  {
    if (driven_dof_[b] < 0) continue;
    const Pose pose = poseAt(b, time());
    const Vector3d spin = pose.q.conjugate() * twistOf(b).w;
    mjtNum* qpos = data_->qpos + driven_qpos_[b];
    std::copy_n(pose.p.data(), 3, qpos);
    const double quaternion[] = {pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z()};
    std::copy_n(quaternion, 4, qpos + 3);
    std::copy_n(twistOf(b).v.data(), 3, data_->qvel + driven_dof_[b]);
    std::copy_n(spin.data(), 3, data_->qvel + driven_dof_[b] + 3);
  }
}

void MujocoEngine::stepOnce()
{
  current_ = this;
  mjcb_passive = onlyGravity() ? nullptr : passive;
  mjcb_control = best_ ? control : nullptr;
  moveDriven();
  mj_step(model_.get(), data_.get());
  mjcb_passive = nullptr;
  mjcb_control = nullptr;
}

BallState stateIn(const mjData* data, std::size_t ball)
{
  const mjtNum *qpos = data->qpos + 7 * ball, *qvel = data->qvel + 6 * ball;
  BallState state;
  state.p_WB = Vector3d(qpos[0], qpos[1], qpos[2]);
  state.q_WB = Quaterniond(qpos[3], qpos[4], qpos[5], qpos[6]);
  state.v_WB = Vector3d(qvel[0], qvel[1], qvel[2]);
  state.w_WB = state.q_WB * Vector3d(qvel[3], qvel[4], qvel[5]);
  return state;
}

void MujocoEngine::addFlight(mjData* data) const
{
  for (std::size_t i = 0; i < scene_.balls.size(); ++i)
  {
    const BallState state = stateIn(data, i);
    const Vector3d force = flightForce(i, state), torque = state.q_WB.conjugate() * flightTorque(i, state);
    for (int k = 0; k < 3; ++k)
    {
      data->qfrc_passive[6 * i + k] += force[k];
      data->qfrc_passive[6 * i + 3 + k] += torque[k];
    }
  }
}

// The damper of a bounce with e near 1 is far too weak to stop the slip within it. Later versions have `solreffriction`
// for this; here the reference acceleration of the slip is set by hand. The rate is a compromise: a lower one leaves
// slip, a higher one lifts the ball, since in this contact model slip that friction cannot stop opens the contact.
void MujocoEngine::dampSlip(mjData* data) const
{
  for (int i = 0; i < data->ncon; ++i)
  {
    const mjContact& contact = data->contact[i];
    if (contact.efc_address < 0 || contact.dim < 3) continue;
    for (int row = contact.efc_address + 1; row < contact.efc_address + contact.dim; ++row)
      data->efc_aref[row] = -springRate() * data->efc_vel[row];
  }
}

BallState MujocoEngine::stateNow(std::size_t ball) const
{
  return stateIn(data_.get(), ball);
}

std::string refuse(const Scene& scene, const std::string&)
{
  if (!sharedLaws(scene).shared) return "balls with different laws are not mapped";
  for (const Body& body : scene.bodies)
    for (const Shape& shape : body.shapes)
      if (body.kind == BodyKind::Kinematic && shape.kind == ShapeKind::HalfSpace) return "its planes cannot move";
  return refuseForAll(scene);
}
}  // namespace

EngineKind mujocoKind()
{
  return {"mujoco", {"default", "best"}, refuse, makeEngine<MujocoEngine>};
}
}  // namespace ping_pong::bench
