// The state of a simulation as messages.
#pragma once

#include <tf2_msgs/TFMessage.h>

#include <string>

#include "ping_pong_sim/BallStates.h"
#include "ping_pong_sim/Contact.h"
#include "ping_pong_sim/PaddleStates.h"
#include "ros/simulation/simulation.h"

namespace ping_pong_sim
{
std::string ballFrame(ping_pong::BallId id);

// They fill a message that may be used again and again: at 500 Hz its memory is worth keeping.
void fillBalls(const Simulation& simulation, BallStates& message);
void fillPaddles(const Simulation& simulation, PaddleStates& message);
/// Everything that moves: paddles and balls; of a crowd only the first balls.
void fillMovingFrames(const Simulation& simulation, tf2_msgs::TFMessage& message);
/// Everything that only a person moves.
void fillStaticFrames(const Simulation& simulation, tf2_msgs::TFMessage& message);
Contact toContact(const Simulation& simulation, const ping_pong::Contact& contact);
}  // namespace ping_pong_sim
