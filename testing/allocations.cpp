// The operators new and delete of a whole program: arrays and standard containers stand on these.
#include "allocations.h"

#include <cstdlib>
#include <new>

namespace ping_pong
{
std::atomic<long> allocations{0};
std::atomic<long> allocated{0};

namespace
{
void* counted(std::size_t size, void* memory)
{
  ++allocations;
  allocated += static_cast<long>(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
}  // namespace
}  // namespace ping_pong

void* operator new(std::size_t size)
{
  return ping_pong::counted(size, std::malloc(size));
}

// For types that begin at a line of the cache.
void* operator new(std::size_t size, std::align_val_t alignment)
{
  const auto line = static_cast<std::size_t>(alignment);
  return ping_pong::counted(size, std::aligned_alloc(line, (size + line - 1) / line * line));
}

void operator delete(void* memory) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
  std::free(memory);
}
