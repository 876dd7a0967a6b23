// A match in a world: balls fly and bounce by the physics, strokes are set or made by a paddle, an umpire looks on.
#pragma once

#include <string>

#include "game/observe.h"
#include "match_script.h"

namespace ping_pong::game
{
class FlownMatch
{
public:
  /// @param paddle_at  where the paddles wait, x for the +x end [m]; far off by default
  explicit FlownMatch(Player server, const Vector3d& paddle_at = {3.5, 2.5, 1.0}, Method method = Method::Exact)
      : scene_(placed(paddle_at, method)), world(scene_), umpire(findCourt(scene_), Rules(), server)
  {
  }

  /// Throws the ball up at p and puts it on its way from there as it falls back, as if struck.
  void serve(const BallState& struck, double height = 0.2)
  {
    const End server = umpire.endOf(umpire.score().server);
    toss(struck.p_WB, height);
    while (world.ballState(0).p_WB.z() >= struck.p_WB.z() && umpire.calls().empty()) tick();
    strike(server, struck);
  }
  void toss(const Vector3d& p, double height)
  {
    BallState held;
    held.p_WB = p;
    held.v_WB.z() = std::sqrt(2.0 * 9.81 * height) + 0.1;  // drag and buoyancy take some
    world.spawnBall(BallParams(), held, &ball_);
    umpire.putInPlay(world.time(), {ball_, kBallRadius, std::nullopt});
    umpire.thrown(world.time(), held);
  }
  /// As if the racket of that end did it.
  void strike(End end, const BallState& struck)
  {
    Contact contact;
    contact.time = world.time();
    contact.ball = ball_;
    contact.body = umpire.court().racket[index(end)];
    contact.shape = 0;
    contact.n_W = struck.v_WB.normalized();
    contact.v_before = world.ballState(0).v_WB;
    contact.p_WC = world.ballState(0).p_WB - kBallRadius * contact.n_W;
    umpire.contact(contact);
    world.setBallState(ball_, struck);
  }
  /// Until something is called, at most for so long [s].
  void fly(double longest = 8.0)
  {
    for (const double end = world.time() + longest; world.time() < end && umpire.calls().empty();) tick();
  }
  void flyUntil(Phase phase, double longest = 3.0)
  {
    for (const double end = world.time() + longest;
         world.time() < end && umpire.calls().empty() && umpire.phase() != phase;)
      tick();
  }
  void tick(double duration = 1e-3)
  {
    world.advance(duration);
    for (const Contact& contact : world.contacts()) touches += letterOf(contact);
    observe(world, umpire);
  }

  std::string said() const
  {
    if (umpire.calls().empty()) return "";
    const Call& call = umpire.calls().front();
    return std::string(name(call.kind)) + " " + call.law + (call.winner ? std::string(" ") + name(*call.winner) : "");
  }
  BallId ball() const { return ball_; }

private:
  Scene scene_;
  BallId ball_ = 0;

  static Scene placed(const Vector3d& paddle_at, Method method)
  {
    Scene scene = matchScene();
    scene.method = method;
    for (Body& body : scene.bodies)
      if (body.kind == BodyKind::Kinematic)
        body.pose.p = Vector3d((body.name == "paddle_a" ? -1 : 1) * paddle_at.x(), paddle_at.y(), paddle_at.z());
    return scene;
  }
  /// - and +: the playing surface at that end; s: the side of the top; n: net, post; r: a paddle; f: anything else. In the
  /// words of the scene alone: no code is shared with the court.
  char letterOf(const Contact& contact) const
  {
    const Body& body = scene_.bodies[contact.body];
    const std::string& material = scene_.materials[body.shapes[contact.shape].material];
    if (body.kind == BodyKind::Kinematic) return 'r';
    if (material == "net" || material == "post") return 'n';
    if (material != "table") return 'f';
    if (contact.p_WC.z() < kTableHeight - 1e-6) return 's';
    return contact.p_WC.x() < 0.0 ? '-' : '+';
  }

public:
  World world;
  Umpire umpire;
  std::string touches;  // all that the ball has touched, in order
};

inline BallState flying(const Vector3d& p, const Vector3d& v, const Vector3d& w = Vector3d::Zero())
{
  BallState state;
  state.p_WB = p;
  state.v_WB = v;
  state.w_WB = w;
  return state;
}
}  // namespace ping_pong::game
