// A value that is there or not, outside of its owner: for what few records have, and those for a while only.
#pragma once

#include <cstddef>
#include <new>
#include <utility>

namespace ping_pong
{
/// Memory that is taken and given back again and again, by any thread. What is given back is kept for whoever asks next, so
/// that the heap is asked only when more is in use than ever before. Each thread has some blocks at hand and passes on what
/// it has too many of: one that only takes and one that only gives back need no more blocks than are in use, and a few.
namespace block_pool
{
/// @param size  of the block [B], at most kLargestBlock
void* take(std::size_t size);
void give(void* block, std::size_t size);
/// Takes memory from the heap now, so that so many threads can take so many blocks more without.
void reserve(std::size_t blocks, std::size_t threads, std::size_t size);

constexpr std::size_t kLargestBlock = 320;  // [B]
}  // namespace block_pool

/// Copies are deep; one that is assigned to a value that is there is written into its place.
template <class Value>
class Pooled
{
public:
  Pooled() = default;
  Pooled(const Pooled& other) : value_(other.value_ ? new (take()) Value(*other.value_) : nullptr) {}
  Pooled(Pooled&& other) noexcept : value_(std::exchange(other.value_, nullptr)) {}
  ~Pooled() { reset(); }

  Pooled& operator=(const Pooled& other)
  {
    if (!other.value_)
      reset();
    else if (value_)
      *value_ = *other.value_;
    else
      value_ = new (take()) Value(*other.value_);
    return *this;
  }
  Pooled& operator=(Pooled&& other) noexcept
  {
    if (this == &other) return *this;
    reset();
    value_ = std::exchange(other.value_, nullptr);
    return *this;
  }

  /// The value: a new one if there was none.
  Value& make()
  {
    if (!value_) value_ = new (take()) Value();
    return *value_;
  }
  /// No value from now on.
  void reset()
  {
    if (!value_) return;
    value_->~Value();
    block_pool::give(std::exchange(value_, nullptr), sizeof(Value));
  }

  explicit operator bool() const { return value_ != nullptr; }
  Value& operator*() { return *value_; }
  const Value& operator*() const { return *value_; }
  Value* operator->() { return value_; }
  const Value* operator->() const { return value_; }

  /// Takes memory for so many values more, of so many threads, now.
  static void reserve(std::size_t values, std::size_t threads) { block_pool::reserve(values, threads, sizeof(Value)); }

private:
  static_assert(sizeof(Value) <= block_pool::kLargestBlock && alignof(Value) <= alignof(std::max_align_t),
                "fits a block");

  static void* take() { return block_pool::take(sizeof(Value)); }

  Value* value_ = nullptr;
};
}  // namespace ping_pong
