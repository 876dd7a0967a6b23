// A match told to an umpire touch by touch: what tests of the rules share.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "game/umpire.h"
#include "ping_pong_sim/scene_loader.h"

namespace ping_pong::game
{
/// Table, floor and air of scene `rally`, a paddle behind each end, no ball.
inline Scene matchScene()
{
  static const Scene rally = loadScene(std::string(SCENES_DIR) + "/rally.yaml");
  Scene scene = rally;
  scene.balls.clear();
  for (Body& body : scene.bodies)
    if (body.kind == BodyKind::Kinematic) body.name = "paddle_a";
  Body second = scene.bodies[0];
  for (const Body& body : scene.bodies)
    if (body.kind == BodyKind::Kinematic) second = body;
  second.name = "paddle_b";
  second.pose.p.x() *= -1.0;
  second.pose.q = Quaterniond(Eigen::AngleAxisd(M_PI, Vector3d::UnitZ()));
  scene.bodies.push_back(second);
  return scene;
}

inline Court matchCourt()
{
  static const Court court = findCourt(matchScene());
  return court;
}

/// Speaks of `server()` and `receiver()`, so that each clause is told from both sides. Every touch is 0.2 s after the last.
class MatchScript
{
public:
  explicit MatchScript(Player server, const Rules& rules = Rules())
      : scene_(matchScene()), umpire_(findCourt(scene_), rules, server)
  {
  }

  Umpire& umpire() { return umpire_; }
  double time = 1.0;
  double gap = 0.2;  // between touches [s]

  End server() const { return umpire_.endOf(umpire_.score().server); }
  End receiver() const { return other(server()); }

  // ---- the ball
  BallState ball(double x, double y, double z, const Vector3d& v = Vector3d::Zero()) const
  {
    BallState state;
    state.p_WB = Vector3d(x, y, z + kTableHeight);
    state.v_WB = v;
    return state;
  }
  Vector3d palm(End end) const { return Vector3d(sign(end) * 1.6, 0.3, 0.2); }  // of the ball, above the table

  Refusal hold() { return umpire_.putInPlay(time, {kBall, kBallRadius, std::nullopt}); }
  void throwUp(double height)
  {
    const Vector3d p = palm(server());
    umpire_.thrown(time, ball(p.x(), p.y(), p.z(), {0, 0, std::sqrt(2.0 * 9.81 * height)}));
  }
  /// The server's racket meets the ball as it has fallen back to the palm.
  void strikeTossed(double height)
  {
    time += 2.0 * std::sqrt(2.0 * height / 9.81);
    strike(server(), palm(server()), {0, 0, -std::sqrt(2.0 * 9.81 * height)});
  }
  void service(double height = 0.2)
  {
    if (hold()) throw std::logic_error("the service was refused");
    throwUp(height);
    strikeTossed(height);
  }
  void goodService()
  {
    service();
    court(server());
    court(receiver());
  }
  /// A rally in which `end` has struck last, and the ball is on its way to the other court.
  void rallyUpToStrokeBy(End end)
  {
    goodService();
    racket(receiver());
    if (end == receiver()) return;
    court(server());
    racket(server());
  }
  void seen(const BallState& state) { umpire_.ballAt(time, state); }

  // ---- touches
  void court(End end, double x = 0.7) { touch("table", {sign(end) * x, 0.1, 0.0}, Vector3d::UnitZ()); }
  void side(End end) { touch("table", {sign(end) * 0.7, 0.7625, -0.01}, Vector3d::UnitY()); }
  void edge(End end) { touch("table", {sign(end) * 0.7, 0.7625, 0.0}, Vector3d(0, std::sqrt(0.99), 0.1)); }
  void net() { touch("net", {0.001, 0.2, 0.14}, Vector3d::UnitX()); }
  void post() { touch("post", {0.0, 0.92, 0.1}, Vector3d::UnitX()); }
  void floor() { touch("floor", {2.2, 0.3, -kTableHeight}, Vector3d::UnitZ()); }
  void leg() { touch("leg", {0.97, 0.5, -0.4}, Vector3d::UnitX()); }
  void racket(End end) { racketAt(end, {sign(end) * 1.6, 0.0, 0.2}, {sign(end) * 5.0, 0.0, 0.0}); }
  void racketAt(End end, const Vector3d& p_TB, const Vector3d& v)
  {
    time += gap;
    strike(end, p_TB, v);
  }
  void anotherBall()
  {
    time += gap;
    Contact contact;
    contact.time = time;
    contact.ball = 77;
    contact.with_ball = true;
    contact.other_ball = kBall;
    umpire_.contact(contact);
  }

  // ---- what came of it
  const Call& call() const
  {
    if (umpire_.calls().empty()) throw std::logic_error("nothing was called");
    return umpire_.calls().front();
  }
  std::size_t calls() const { return umpire_.calls().size(); }
  /// "point 2.10.1.3 A" as one text, "" if nothing was called.
  std::string said() const
  {
    if (umpire_.calls().empty()) return "";
    std::string text = std::string(name(call().kind)) + " " + call().law;
    if (call().winner) text += std::string(" ") + name(*call().winner);
    return text;
  }

  static constexpr BallId kBall = 3;

private:
  void strike(End end, const Vector3d& p_TB, const Vector3d& v)
  {
    Contact contact;
    contact.time = time;
    contact.ball = kBall;
    contact.body = umpire_.court().racket[index(end)];
    contact.shape = 0;
    contact.n_W = Vector3d(-sign(end), 0, 0);
    contact.p_WC = p_TB + Vector3d(0, 0, kTableHeight) - kBallRadius * contact.n_W;
    contact.v_before = v;
    umpire_.contact(contact);
  }

  void touch(const std::string& material, const Vector3d& p_TC, const Vector3d& n)
  {
    time += gap;
    Contact contact;
    contact.time = time;
    contact.ball = kBall;
    contact.p_WC = p_TC + Vector3d(0, 0, kTableHeight);
    contact.n_W = n;
    find(material, contact);
    umpire_.contact(contact);
  }

  void find(const std::string& material, Contact& contact) const
  {
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b)
      for (std::size_t s = 0; s < scene_.bodies[b].shapes.size(); ++s)
        if (scene_.materials[scene_.bodies[b].shapes[s].material] == material)
        {
          contact.body = b;
          contact.shape = s;
          return;
        }
    throw std::logic_error("no shape of material " + material);
  }

  Scene scene_;
  Umpire umpire_;
};
}  // namespace ping_pong::game
