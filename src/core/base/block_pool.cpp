#include <array>
#include <mutex>
#include <vector>

#include "base/pooled.h"

namespace ping_pong
{
namespace
{
constexpr std::size_t kUnit = 16;  // of sizes of blocks [B]
constexpr std::size_t kSizes = block_pool::kLargestBlock / kUnit;
constexpr std::size_t kBatch = 32;  // blocks that go from hand to hand at a time

std::size_t indexOf(std::size_t size)
{
  return (size - 1) / kUnit;
}
std::size_t sizeOf(std::size_t index)
{
  return (index + 1) * kUnit;
}

// A free block, with what comes after it written into it.
struct Block
{
  Block* next;        // of the same batch
  Block* next_batch;  // known to the first block of a batch in the common pool
};

struct Stack
{
  Block* top = nullptr;
  std::size_t size = 0;

  void push(void* memory)
  {
    top = new (memory) Block{top, nullptr};
    ++size;
  }
  void* pop()
  {
    Block* block = top;
    top = block->next;
    --size;
    return block;
  }
};

// Of blocks of one size, for all threads.
class Common
{
public:
  Stack takeBatch(std::size_t index)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!batches_) return carve(index);
    const Stack batch{batches_, kBatch};
    batches_ = batches_->next_batch;
    free_ -= kBatch;
    return batch;
  }
  void giveBatch(const Stack& batch)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    keep(batch);
  }
  void giveOne(void* block)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    odd_.push(block);
    if (odd_.size == kBatch) keep(std::exchange(odd_, Stack()));
  }
  void reserve(std::size_t blocks, std::size_t index)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (blocks > free_) takeFromHeap(blocks - free_, index);
  }

private:
  // Blocks that nobody has used yet. They are not written to before: the system gives memory only to whoever does.
  struct Stretch
  {
    char* next;
    std::size_t left;
  };

  void keep(const Stack& batch)
  {
    batch.top->next_batch = batches_;
    batches_ = batch.top;
    free_ += kBatch;
  }
  void takeFromHeap(std::size_t blocks, std::size_t index)
  {
    const std::size_t batches = (blocks + kBatch - 1) / kBatch;
    stretches_.push_back({static_cast<char*>(::operator new(batches* kBatch* sizeOf(index))), batches * kBatch});
    free_ += batches * kBatch;
  }
  Stack carve(std::size_t index)
  {
    if (stretches_.empty()) takeFromHeap(kBatch, index);
    Stretch& stretch = stretches_.back();
    Stack batch;
    for (std::size_t k = kBatch; k-- > 0;) batch.push(stretch.next + k * sizeOf(index));
    stretch.next += kBatch * sizeOf(index);
    stretch.left -= kBatch;
    free_ -= kBatch;
    if (stretch.left == 0) stretches_.pop_back();
    return batch;
  }

  std::mutex mutex_;
  std::size_t free_ = 0;  // blocks of all batches and stretches
  Block* batches_ = nullptr;
  std::vector<Stretch> stretches_;
  Stack odd_;  // fewer than a batch, of threads that have ended
};

// Never destroyed: whoever owns a block may live as long as the program.
Common& common(std::size_t index)
{
  static auto& all = *new std::array<Common, kSizes>;
  return all[index];
}

// Two stacks, so that a thread that takes and gives in turn does not pass on a batch each time.
struct AtHand
{
  Stack now, spare;
};

// Others' destructors give blocks back when a thread has ended, too: these have none.
thread_local std::array<AtHand, kSizes> at_hand;
thread_local bool ended = false;

struct GiveBackAtTheEnd
{
  ~GiveBackAtTheEnd()
  {
    ended = true;
    for (std::size_t index = 0; index < kSizes; ++index)
    {
      AtHand& its = at_hand[index];
      while (its.now.size > 0) common(index).giveOne(its.now.pop());
      while (its.spare.size > 0) common(index).giveOne(its.spare.pop());
    }
  }
};

// To be called before a thread has anything at hand.
void giveBackAtTheEnd()
{
  static thread_local GiveBackAtTheEnd at_the_end;
  static_cast<void>(at_the_end);
}

void fetch(AtHand& its, std::size_t index)
{
  giveBackAtTheEnd();
  if (its.spare.size > 0)
    std::swap(its.now, its.spare);
  else
    its.now = common(index).takeBatch(index);
}

void passOn(AtHand& its, std::size_t index)
{
  if (its.spare.size > 0) common(index).giveBatch(its.spare);
  its.spare = std::exchange(its.now, Stack());
}
}  // namespace

void* block_pool::take(std::size_t size)
{
  const std::size_t index = indexOf(size);
  AtHand& its = at_hand[index];
  if (its.now.size == 0) fetch(its, index);
  return its.now.pop();
}

void block_pool::give(void* block, std::size_t size)
{
  const std::size_t index = indexOf(size);
  if (ended) return common(index).giveOne(block);
  AtHand& its = at_hand[index];
  if (its.now.size == 0) giveBackAtTheEnd();
  if (its.now.size == kBatch) passOn(its, index);
  its.now.push(block);
}

void block_pool::reserve(std::size_t blocks, std::size_t threads, std::size_t size)
{
  const std::size_t index = indexOf(size);
  common(index).reserve(blocks + 2 * kBatch * threads, index);
}
}  // namespace ping_pong
