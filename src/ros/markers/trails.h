// Where balls were during the last moments.
#pragma once

#include <deque>
#include <map>

#include "ball_markers.h"

namespace ping_pong_sim
{
class Trails
{
public:
  /// After each tick.
  void observe(const Simulation& simulation);
  void clear() { paths_.clear(); }
  /// Of a ball that was put elsewhere.
  void clear(ping_pong::BallId ball) { paths_.erase(ball); }
  /// One marker with the trails of all balls; it takes itself away when there is none.
  visualization_msgs::Marker marker(const Simulation& simulation) const;

private:
  struct Point
  {
    double time;  ///< Simulation::elapsed() [s]
    ping_pong::Vector3d p_W;
  };
  using Path = std::deque<Point>;

  void add(Path& path, const Point& point) const;

  std::map<ping_pong::BallId, Path> paths_;
};
}  // namespace ping_pong_sim
