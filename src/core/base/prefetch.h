// Asks for memory before it is needed.
#pragma once

namespace ping_pong
{
/// The line of the cache at `address` will be read.
inline void fetchToRead(const void* address)
{
  __builtin_prefetch(address);
}

/// It will be written: no other core keeps a copy that it would have to be asked to drop. For x86-64 in general GCC has no
/// instruction for that, though all of them take it; those that do not know it do nothing.
inline void fetchToWrite(const void* address)
{
#if defined(__x86_64__)
  asm volatile("prefetchw %0" : : "m"(*static_cast<const char*>(address)));
#else
  __builtin_prefetch(address, 1);
#endif
}
}  // namespace ping_pong
