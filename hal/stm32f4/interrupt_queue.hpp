// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>

namespace fantail::hal::stm32f4 {

/// A bounded queue between the control loop and one interrupt handler: one of them puts in, the other takes out.
///
/// No interrupt is ever masked for it. Each index has one writer; an element is written before the index that shows it
/// and read before the index that frees it. The processor has one core and sees its own stores in order, so release and
/// acquire cost no instruction there: they keep the compiler from moving the element past its index. A 32-bit load or
/// store is one instruction, which no interrupt divides.
template <typename T, std::uint32_t size>
class InterruptQueue {
  static_assert((size & (size - 1)) == 0, "the indices run on and wrap at 2^32");
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

 public:
  // ---- the side that puts in ----

  /// False when it is full.
  bool push(const T& element) {
    const std::uint32_t end = end_.load(std::memory_order_relaxed);
    if (end - begin_.load(std::memory_order_acquire) == size) {
      return false;
    }
    elements_[end % size] = element;
    end_.store(end + 1, std::memory_order_release);
    return true;
  }

  // ---- the side that takes out ----

  [[nodiscard]] std::optional<T> pop() {
    const std::uint32_t begin = begin_.load(std::memory_order_relaxed);
    if (begin == end_.load(std::memory_order_acquire)) {
      return std::nullopt;
    }
    const T element = elements_[begin % size];
    begin_.store(begin + 1, std::memory_order_release);
    return element;
  }
  /// How many that were.
  std::uint32_t drop_all() {
    const std::uint32_t end = end_.load(std::memory_order_acquire);
    const std::uint32_t dropped = end - begin_.load(std::memory_order_relaxed);
    begin_.store(end, std::memory_order_release);
    return dropped;
  }

  // ---- both ----

  [[nodiscard]] bool full() const {
    return end_.load(std::memory_order_acquire) - begin_.load(std::memory_order_acquire) == size;
  }

 private:
  std::array<T, size> elements_{};
  std::atomic<std::uint32_t> begin_{0};
  std::atomic<std::uint32_t> end_{0};
};

}  // namespace fantail::hal::stm32f4
