// The geometry that an umpire needs: playing surface, net assembly, and which racket belongs to which end.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "game/sides.h"
#include "ping_pong_sim/contact.h"
#include "ping_pong_sim/scene.h"

namespace ping_pong::game
{
/// What a ball can touch, in the words of the laws.
enum class Part : unsigned char
{
  Court,   ///< playing surface, the edges of its top included (2.1.1)
  Side,    ///< vertical sides of the table top, below the edge (2.1.2), and its underside
  Net,     ///< net assembly: net, posts, clamps (2.2.1)
  Racket,  ///< handle included: a stroke with the hand below the wrist is one, too (2.5.7)
  Ball,    ///< another ball
  Other    ///< floor, legs, anything else
};

/// One touch of the ball B in play, in the frame T of the table.
struct Touch
{
  double time = 0.0;                 ///< world time [s]
  Part part = Part::Other;           ///< what it touched
  End end = End::Minus;              ///< whose, if Court or Racket
  Vector3d p_TB = Vector3d::Zero();  ///< centre of B [m]
  Vector3d v_TB = Vector3d::Zero();  ///< just before [m/s]
  std::size_t body = kNone;          ///< index of the body, or kNone
  std::size_t shape = kNone;         ///< index of its shape, or kNone
};

/// Frame T: origin in the middle of the playing surface, x along its length, z up; +x is the way that points more to +x of
/// the world (+y if the table stands across). The end `Minus` is at -x of T.
struct Court
{
  Pose X_WT;                                        ///< where the playing surface is
  double half_length = 0.0;                         ///< along x of T [m]
  double half_width = 0.0;                          ///< along y [m]
  double net_height = 0.0;                          ///< above the playing surface [m]
  double net_half_width = 0.0;                      ///< along y [m]
  std::size_t table = kNone;                        ///< index of the body that has the playing surface
  Pose X_WB;                                        ///< of that body
  Pose X_BT;                                        ///< T in the frame of that body
  std::array<std::size_t, 2> racket{kNone, kNone};  ///< index of the paddle at each end, by index(End)
  std::array<double, 2> racket_reach{};             ///< of any point of it from its body's origin [m]
  double net_reach = 0.0;                           ///< of any point of the net assembly from the plane x = 0 of T [m]

  struct ShapeRole
  {
    Part part = Part::Other;  ///< Court stands for the whole table top
    std::string name;         ///< its material, for sentences
  };
  std::vector<std::vector<ShapeRole>> roles;  ///< by body and shape

  /// What the contact is in the words of the laws, for the ball `ball` in play, whether it is B of the record or the other.
  /// @param radius  of that ball [m]
  Touch touchOf(const Contact& contact, BallId ball, double radius) const;
  /// "the floor", "the net", ... for sentences.
  std::string nameOf(const Touch& touch) const;

  Vector3d positionInT(const Vector3d& p_W) const { return X_WT.toB(p_W); }
  Vector3d vectorInT(const Vector3d& v_W) const { return X_WT.q.conjugate() * v_W; }

  /// All of the ball is outside of the playing surface, behind that end line, which has no ends (2.5.15).
  bool behindEndLine(End end, const Vector3d& p_TB, double radius) const;
  /// Some of the ball is over the playing surface, at any height above its level.
  bool overSurface(const Vector3d& p_TB, double radius) const;
  /// "Above or travelling towards the playing surface" (2.5.8): over it, or above its level on a course, seen from above, that
  /// leads over it.
  bool mayStillLand(const Vector3d& p_TB, const Vector3d& v_TB, double radius) const;

  /// The table was moved: takes over its new pose X_WB.
  void moveTable(const Pose& X_WB_new);
};

/// Finds the court of a scene: of static bodies a box of material `table` (the largest) is the table top, shapes of materials
/// `net` and `post` are the net assembly (urdf/table.urdf); kinematic bodies are rackets. Throws std::invalid_argument
/// "scene 'NAME': ..." if there is no table, no net, more than one table, or not exactly one racket on each side.
Court findCourt(const Scene& scene);
}  // namespace ping_pong::game
