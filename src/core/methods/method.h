// What the world asks of the method that moves its balls. A scene names one; World chooses its functions when it starts.
#pragma once

#include "windows/window_state.h"

namespace ping_pong
{
struct MethodFunctions
{
  /// Takes the memory for so many balls, beyond what all methods need.
  void (*reserve)(WorldWithWindows& world, std::size_t balls);
  /// Bodies or many balls have been changed from outside: all that was known about what comes is void.
  void (*start)(WorldWithWindows& world);
  /// The ball at this index is new, or its state has been changed from outside.
  void (*ballChanged)(WorldWithWindows& world, std::size_t ball);
  /// Moves all balls from world.time to `end` [s]; the motions of all bodies are smooth until then.
  void (*advance)(WorldWithWindows& world, double end);
  bool needs_room = false;      ///< balls that overlap at the start are put clear of each other first
  bool flies_in_steps = false;  ///< see WorldState
};

/// @param method  not Auto
const MethodFunctions& functionsOf(Method method);
}  // namespace ping_pong
