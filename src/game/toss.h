// How the ball goes from the palm to the racket: ITTF laws 2.6.1, 2.6.2 and 2.6.4.
#pragma once

#include <optional>
#include <string>

#include "game/court.h"
#include "game/rules.h"

namespace ping_pong::game
{
/// The ball in the frame T of the table at one instant.
struct BallSample
{
  double time = 0.0;                 ///< world time [s]
  Vector3d p_TB = Vector3d::Zero();  ///< centre [m]
  Vector3d v_TB = Vector3d::Zero();  ///< [m/s]
  double spin = 0.0;                 ///< [rad/s]
};

/// A broken law of service. The sentence continues one that begins with the server's name.
struct ServiceFault
{
  const char* law;
  std::string what;
};

class Toss
{
public:
  /// @param end     of the server
  /// @param radius  of the ball [m]
  void begin(End end, double radius);
  bool thrown() const { return thrown_; }

  /// The ball leaves the palm. Each answers with the law that is broken now, if any.
  std::optional<ServiceFault> leave(const Court& court, const Rules& rules, const BallSample& sample);
  /// The ball on its way, not yet struck.
  std::optional<ServiceFault> see(const Court& court, const Rules& rules, const BallSample& sample);
  /// The server's racket touches it.
  std::optional<ServiceFault> strike(const Court& court, const Rules& rules, const BallSample& sample);

private:
  std::optional<ServiceFault> place(const Court& court, const Rules& rules, const BallSample& sample) const;
  void rise(const BallSample& sample);

  End end_ = End::Minus;
  double radius_ = 0.0;
  bool thrown_ = false;
  double palm_ = 0.0;     // height at which it left the palm [m]
  double highest_ = 0.0;  // [m]
  BallSample last_;
};
}  // namespace ping_pong::game
