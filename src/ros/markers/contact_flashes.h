// Short-lived discs where impacts were.
#pragma once

#include <deque>

#include "ball_markers.h"

namespace ping_pong_sim
{
class ContactFlashes
{
public:
  /// After each tick.
  void observe(const Simulation& simulation);
  void clear() { flashes_.clear(); }
  /// One marker with all discs; it takes itself away when there is none.
  visualization_msgs::Marker marker(const Simulation& simulation) const;

private:
  struct Flash
  {
    double time;  ///< Simulation::elapsed() [s]
    ping_pong::Vector3d p_W;
    ping_pong::Vector3d n_W;
  };
  static void appendDisc(const Flash& flash, double age, visualization_msgs::Marker& marker);

  std::deque<Flash> flashes_;
};
}  // namespace ping_pong_sim
