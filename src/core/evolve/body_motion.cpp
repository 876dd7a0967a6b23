#include <cmath>

#include "ping_pong_sim/motion.h"

namespace ping_pong
{
namespace
{
// Left Jacobian of the rotation group, J(d) = I + B [d]x + C [d]x^2, with its factors and their derivatives by theta = |d|,
// each divided by theta. Source: Sola et al., "A micro Lie theory" (2018), eq. 145. Series below 0.3 rad: the closed forms
// cancel there; the first term left out is below 1e-14.
struct JacobianFactors
{
  double B, C, dB, dC;
};

JacobianFactors jacobianFactors(double theta2)
{
  if (theta2 < 0.09)
  {
    const double x = theta2;
    return {1.0 / 2 - x / 24 + x * x / 720 - x * x * x / 40320 + x * x * x * x / 3628800,
            1.0 / 6 - x / 120 + x * x / 5040 - x * x * x / 362880,
            -1.0 / 12 + x / 180 - x * x / 6720 + x * x * x / 453600,
            -1.0 / 60 + x / 1260 - x * x / 60480 + x * x * x / 4989600};
  }
  const double theta = std::sqrt(theta2);
  const double sine = std::sin(theta);
  const double cosine = std::cos(theta);
  return {(1.0 - cosine) / theta2, (theta - sine) / (theta2 * theta),
          (theta * sine - 2.0 * (1.0 - cosine)) / (theta2 * theta2),
          (3.0 * sine - theta * (2.0 + cosine)) / (theta2 * theta2 * theta)};
}

Quaterniond rotationVectorToQuaternion(const Vector3d& d)
{
  const double theta = d.norm();
  if (theta == 0.0) return Quaterniond::Identity();
  const Vector3d axis = d / theta;
  const double sine = std::sin(0.5 * theta);
  return Quaterniond(std::cos(0.5 * theta), sine * axis.x(), sine * axis.y(), sine * axis.z());
}

// w = J(d) d', and w' = dJ/ds d' + J(d) d''.
void angularVelocity(const Vector3d& d, const Vector3d& d1, const Vector3d& d2, Vector3d& w, Vector3d& alpha)
{
  const JacobianFactors f = jacobianFactors(d.squaredNorm());
  const Vector3d c = d.cross(d1);
  const double rate = d.dot(d1);  // theta * theta'
  w = d1 + f.B * c + f.C * d.cross(c);
  alpha =
      d2 + f.dB * rate * c + f.B * d.cross(d2) + f.dC * rate * d.cross(c) + f.C * (d1.cross(c) + d.cross(d.cross(d2)));
}
}  // namespace

bool BodyMotion::turning() const
{
  return !twist.w.isZero(0.0) || !alpha_WB.isZero(0.0);
}

bool BodyMotion::still() const
{
  return !turning() && twist.v.isZero(0.0) && a_WB.isZero(0.0);
}

Pose BodyMotion::poseAt(double s) const
{
  Pose now = pose;
  now.p += s * twist.v + (0.5 * s * s) * a_WB;
  if (turning()) now.q = (rotationVectorToQuaternion(s * twist.w + (0.5 * s * s) * alpha_WB) * pose.q).normalized();
  return now;
}

Twist BodyMotion::twistAt(double s) const
{
  const BodyFrame frame = frameAt(*this, s);
  return {frame.v_WB, frame.w_WB};
}

BodyFrame frameAt(const BodyMotion& motion, double s)
{
  const Pose pose = motion.poseAt(s);
  BodyFrame frame;
  frame.R_WB = pose.q.toRotationMatrix();
  frame.p_WB = pose.p;
  frame.v_WB = motion.twist.v + s * motion.a_WB;
  frame.a_WB = motion.a_WB;
  if (motion.turning())
  {
    const Vector3d d1 = motion.twist.w + s * motion.alpha_WB;
    angularVelocity(s * motion.twist.w + (0.5 * s * s) * motion.alpha_WB, d1, motion.alpha_WB, frame.w_WB,
                    frame.alpha_WB);
  }
  return frame;
}
}  // namespace ping_pong
