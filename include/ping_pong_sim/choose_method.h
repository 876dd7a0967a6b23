// Which method runs a scene, and what it will have to compute.
#pragma once

#include <string>

#include "ping_pong_sim/scene.h"

namespace ping_pong
{
struct Choice
{
  Method method = Method::Exact;  ///< never Auto
  std::string reason;             ///< one sentence: what is computed and what is not, and why
};

/// The scene's own method if it names one. For Method::Auto the cheapest that meets the scene's tolerance. That is
/// `exact` as far as docs/speed_accuracy.md has measured; what it leaves out follows from what the scene contains.
/// Balls that come later add what they need: a second one the search for pairs, another material its friction.
Choice chooseMethod(const Scene& scene);
}  // namespace ping_pong
