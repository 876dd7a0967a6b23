#include "window_contacts.h"

#include <algorithm>

namespace ping_pong
{
namespace
{
// Not of an earlier run of its island: what balls have recorded before their island went back to the start has not
// happened.
bool happened(const WorldState& world, const ContactOrigin& origin)
{
  return origin.run == (world.islands.isBusy(origin.ball) ? world.islands.busy(origin.ball).run : 0u);
}

// Of the contacts from the first on, those that have happened.
void dropVoid(WorldState& world, std::size_t first)
{
  std::size_t kept = first;
  for (std::size_t c = first; c < world.origins.size(); ++c)
  {
    if (!happened(world, world.origins[c])) continue;
    if (kept != c)
    {
      if (world.keep_contacts) world.contacts[kept] = world.contacts[c];
      world.origins[kept] = world.origins[c];
    }
    ++kept;
  }
  world.origins.resize(kept);
  if (world.keep_contacts) world.contacts.resize(kept);
}
}  // namespace

void lendContacts(WorldState& world)
{
  std::swap(world.contacts, world.islands.work.front().contacts);
  std::swap(world.origins, world.islands.work.front().origins);
}

// Contacts are large: their order is found first, and each is moved once.
void sortContacts(WorldState& world, std::size_t first)
{
  std::vector<IslandRecords::Place>& order = world.islands.order;
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

// All contacts of a ball that have happened are in the list of one worker, in their order: which one does not matter.
void takeContacts(WorldState& world)
{
  const std::size_t first = world.islands.first_contact;
  lendContacts(world);  // and back
  dropVoid(world, first);
  for (std::size_t worker = 1; worker < world.islands.work.size(); ++worker)
  {
    IslandWork& work = world.islands.work[worker];
    for (std::size_t c = 0; c < work.origins.size(); ++c)
    {
      if (!happened(world, work.origins[c])) continue;
      if (world.keep_contacts) world.contacts.push_back(work.contacts[c]);
      world.origins.push_back(work.origins[c]);
    }
  }
  world.status.contacts += world.origins.size() - first;
  if (world.keep_contacts)
    sortContacts(world, first);
  else
    world.origins.resize(first);
}
}  // namespace ping_pong
