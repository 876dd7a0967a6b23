#include "ping_pong_sim/state_hash.h"

#include <cstring>

namespace ping_pong
{
namespace
{
class Hash
{
public:
  void add(std::uint64_t word)
  {
    word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9u;
    word = (word ^ (word >> 27)) * 0x94d049bb133111ebu;
    value_ = (value_ ^ word ^ (word >> 31)) * 1099511628211u;
  }
  void add(double number)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &number, sizeof bits);
    add(bits);
  }
  void add(const Vector3d& vector)
  {
    for (int i = 0; i < 3; ++i) add(vector[i]);
  }
  std::uint64_t value() const { return value_; }

private:
  std::uint64_t value_ = 14695981039346656037u;
};
}  // namespace

std::uint64_t stateHash(const World& world)
{
  Hash hash;
  hash.add(world.time());
  for (std::size_t i = 0; i < world.ballCount(); ++i)  // a world keeps its balls in the order of ids
  {
    const BallState state = world.ballState(i);
    hash.add(static_cast<std::uint64_t>(world.ballId(i)));
    hash.add(state.p_WB);
    for (int k = 0; k < 4; ++k) hash.add(state.q_WB.coeffs()[k]);
    hash.add(state.v_WB);
    hash.add(state.w_WB);
  }
  return hash.value();
}
}  // namespace ping_pong
