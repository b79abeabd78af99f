// Arrays for short-lived objects of similar size, thousands of them. The thread keeps and reuses
// their memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace flexslip {

// The memory that a thread keeps: a few blocks.
class KeptMemory {
 public:
  using Block = std::vector<double>;

  // A block of at least `size` doubles.
  static Block take(std::size_t size) {
    const auto found = std::find_if(kept.begin(), kept.end(), [&](const Block& block) { return block.size() >= size; });
    if (found == kept.end()) return Block(size + size / 4);
    Block block = std::move(*found);
    kept.erase(found);
    return block;
  }
  static void put(Block block) {
    if (kept.size() == max_blocks) kept.erase(kept.begin());
    kept.push_back(std::move(block));
  }

 private:
  static constexpr std::size_t max_blocks = 8;
  static inline thread_local std::vector<Block> kept;
};

// An array of uninitialised values.
template <class T>
class KeptArray {
  static_assert(std::is_trivially_default_constructible_v<T> && std::is_trivially_destructible_v<T> &&
                alignof(T) <= alignof(double));

 public:
  KeptArray() = default;
  explicit KeptArray(std::size_t size)
      : block_(KeptMemory::take((size * sizeof(T) + sizeof(double) - 1) / sizeof(double))) {
    std::uninitialized_default_construct_n(data(), size);
  }
  KeptArray(KeptArray&& other) noexcept : block_(std::exchange(other.block_, {})) {}
  KeptArray& operator=(KeptArray&& other) noexcept {
    std::swap(block_, other.block_);
    return *this;
  }
  ~KeptArray() {
    if (!block_.empty()) KeptMemory::put(std::move(block_));
  }
  T* data() { return reinterpret_cast<T*>(block_.data()); }
  const T* data() const { return reinterpret_cast<const T*>(block_.data()); }
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }

 private:
  KeptMemory::Block block_;
};

}  // namespace flexslip
