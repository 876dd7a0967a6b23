#include "windows/window_contacts.h"

#include <algorithm>

namespace ping_pong
{
namespace
{
// Not of an earlier run of its island: what balls have recorded before their island went back to the start has not
// happened.
bool happened(const WorldWithWindows& world, const ContactProvenance& origin)
{
  return origin.run == (world.islands.isBusy(origin.ball) ? world.islands.busy(origin.ball).run : 0u);
}
}  // namespace

void lendContacts(WorldWithWindows& world)
{
  std::swap(world.contacts, world.islands.work.front().contacts);
  std::swap(world.provenances, world.islands.work.front().provenances);
}

// Contacts are large: their order is found first, and each is moved once.
void sortContacts(WorldWithWindows& world, std::size_t first)
{
  std::vector<IslandRecords::ContactOrder>& order = world.islands.order;
  order.clear();
  bool sorted = true;
  for (std::size_t c = first; c < world.contacts.size(); ++c)
  {
    order.push_back({world.contacts[c].time, world.contacts[c].ball, static_cast<std::uint32_t>(c)});
    sorted &= c == first || !(order.back() < order[order.size() - 2]);
  }
  if (sorted) return;
  std::sort(order.begin(), order.end());
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    std::size_t from = order[k].contact;
    while (from < first + k) from = order[from - first].contact;  // it has been moved away from there
    order[k].contact = static_cast<std::uint32_t>(from);
    std::swap(world.contacts[first + k], world.contacts[from]);
  }
}

// The first worker's list is the world's.
void dropVoidContacts(const WorldWithWindows& world, IslandWork& list)
{
  std::size_t kept = list.worker == 0 ? world.islands.first_contact : 0;
  for (std::size_t c = kept; c < list.provenances.size(); ++c)
  {
    if (!happened(world, list.provenances[c])) continue;
    if (kept != c)
    {
      if (world.keep_contacts) list.contacts[kept] = list.contacts[c];
      list.provenances[kept] = list.provenances[c];
    }
    ++kept;
  }
  list.provenances.resize(kept);
  if (world.keep_contacts) list.contacts.resize(kept);
}

// All contacts of a ball that have happened are in the list of one worker, in their order: which one does not matter.
void takeContacts(WorldWithWindows& world)
{
  const std::size_t first = world.islands.first_contact;
  lendContacts(world);  // and back
  std::size_t contacts = world.provenances.size() - first;
  for (std::size_t worker = 1; worker < world.islands.work.size(); ++worker)
  {
    const IslandWork& work = world.islands.work[worker];
    contacts += work.provenances.size();
    if (!world.keep_contacts) continue;
    world.contacts.insert(world.contacts.end(), work.contacts.begin(), work.contacts.end());
    world.provenances.insert(world.provenances.end(), work.provenances.begin(), work.provenances.end());
  }
  world.status.contacts += contacts;
  if (world.keep_contacts)
    sortContacts(world, first);
  else
    world.provenances.resize(first);
}
}  // namespace ping_pong
