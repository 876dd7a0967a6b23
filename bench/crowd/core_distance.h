// How far processors are from each other.
#pragma once

namespace ping_pong::bench
{
/// What it takes a line of the cache to get from one of the first two processors that this process may use to the other, the
/// least of some hundred times there and back; 0 if there is only one [ns]
double coreDistance();
}  // namespace ping_pong::bench
