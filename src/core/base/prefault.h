// Memory that is there before it is needed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ping_pong
{
/// Room for so many records. An empty list has its first page written to, since the system gives a page only to whoever
/// writes to it, and that takes longer than many an event.
template <class Record>
void takeMemory(std::vector<Record>& list, std::size_t records)
{
  constexpr std::size_t kWritten = 4096;  // [B]
  list.reserve(records);
  if (!list.empty()) return;
  list.resize(std::min(records, kWritten / sizeof(Record)));
  list.clear();
}
}  // namespace ping_pong
