#include "state/supports.h"

#include <algorithm>

namespace ping_pong
{
namespace
{
constexpr std::uint32_t kMostShortPaths =
    80;                                 // more change nothing: the grip time is at its longest 15 beyond patience
constexpr std::uint32_t kForgiven = 4;  // by one that is not

Supports::Surface surface(std::size_t body, std::size_t shape)
{
  return {static_cast<std::uint16_t>(body), static_cast<std::uint16_t>(shape)};
}
}  // namespace

bool Supports::List::has(std::size_t body, std::size_t shape) const
{
  for (std::size_t i = 0; i < count; ++i)
    if (surfaces[i].body == body && surfaces[i].shape == shape) return true;
  return false;
}

void Supports::add(std::size_t body, std::size_t shape)
{
  List& list = list_.make();
  if (list.count < kMax && !list.has(body, shape)) list.surfaces[list.count++] = surface(body, shape);
}

void Supports::remove(std::size_t index)
{
  List& list = *list_;
  for (std::size_t i = index; i + 1 < list.count; ++i) list.surfaces[i] = list.surfaces[i + 1];
  if (--list.count == 0) list_.reset();
}

void Supports::replace(std::size_t index, std::size_t body, std::size_t shape)
{
  list_->surfaces[index] = surface(body, shape);
}

void Supports::countShort(bool is_short)
{
  if (!list_) return;
  std::uint32_t& count = list_->short_paths;
  count = is_short ? std::min(count + 1, kMostShortPaths) : count - std::min(count, kForgiven);
}
}  // namespace ping_pong
