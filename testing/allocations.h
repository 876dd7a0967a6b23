// What a test program takes from the heap, on any thread. A program is counted if allocations.cpp is linked into it.
#pragma once

#include <atomic>

namespace ping_pong
{
extern std::atomic<long> allocations;
extern std::atomic<long> allocated;  ///< bytes, given back or not
}  // namespace ping_pong
