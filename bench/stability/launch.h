// How the ball of a random scene starts.
#pragma once

#include "ping_pong_sim/ball.h"
#include "stage.h"

namespace ping_pong::stability
{
struct Launch
{
  const char* name;
  BallState state;  ///< in the frame of the stage
};

Launch drawLaunch(Dice& dice, const Stage& stage, double radius);
}  // namespace ping_pong::stability
