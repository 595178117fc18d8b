// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/time.hpp"
#include "protocol/little_endian.hpp"
#include "protocol/log_frame.hpp"
#include "protocol/log_notes.hpp"
#include "protocol/log_tick.hpp"

namespace fantail::avionics {

// What waits for the flash. Ticks are numbered from 0 on; whatever else stands in a record stands before the tick whose
// number it bears.

/// Packed ticks: the last half second before a launch, and what the flash has not yet taken after it.
class TickQueue {
 public:
  /// Half a second, what comes in while header and first checkpoint are written at 3 ms a page, and some. Of two gyros
  /// there is room for fewer.
  static constexpr std::uint32_t capacity_of_one_gyro = 556;

  void clear() { head_ = first_ = end_ = 0; }
  /// How large a tick is from now on; nothing is in the queue any more.
  void take_ticks_of(std::size_t tick_size) {
    clear();
    tick_size_ = tick_size;
    capacity_ = static_cast<std::uint32_t>(slots_.size() / slot_size());
  }
  [[nodiscard]] std::uint32_t capacity() const { return capacity_; }
  [[nodiscard]] std::uint32_t size() const { return end_ - first_; }
  [[nodiscard]] bool full() const { return size() == capacity_; }
  /// Number of the oldest one.
  [[nodiscard]] std::uint32_t first() const { return first_; }
  /// Number of the one that comes next.
  [[nodiscard]] std::uint32_t end() const { return end_; }

  /// Not when it is full. Times never run backwards. Where the tick is to be packed: it would cost much to copy one.
  [[nodiscard]] std::span<std::byte> push(core::Microseconds time) {
    const std::uint32_t behind_newest = head_ + size();
    const std::span<std::byte> slot = std::span{slots_}.subspan(
        (behind_newest < capacity_ ? behind_newest : behind_newest - capacity_) * slot_size(), slot_size());
    protocol::put<4>(slot, tick_size_, static_cast<std::uint64_t>(time.count()));
    newest_ = time;
    end_ += 1;
    return slot.first(tick_size_);
  }

  // Of the oldest; not when it is empty.
  [[nodiscard]] std::span<const std::byte> tick() const {
    return std::span{slots_}.subspan(head_ * slot_size(), tick_size_);
  }
  [[nodiscard]] core::Microseconds time() const {
    const auto age = static_cast<std::uint32_t>(static_cast<std::uint64_t>(newest_.count()) -
                                                protocol::get<4>(slots_, head_ * slot_size() + tick_size_));
    return newest_ - core::Microseconds{age};
  }
  void pop() {
    head_ = head_ + 1 < capacity_ ? head_ + 1 : 0;
    first_ += 1;
  }

 private:
  // A tick, and the low half of its time: none is more than an hour older than the newest.
  static constexpr std::size_t time_size = 4;
  [[nodiscard]] std::size_t slot_size() const { return tick_size_ + time_size; }

  std::array<std::byte, capacity_of_one_gyro*(protocol::log_tick_size + time_size)> slots_{};
  std::size_t tick_size_ = protocol::log_tick_size;
  std::uint32_t capacity_ = capacity_of_one_gyro;
  std::uint32_t head_ = 0;
  std::uint32_t first_ = 0;
  std::uint32_t end_ = 0;
  core::Microseconds newest_{};
};

/// An event or a health record.
struct Note {
  core::Microseconds time{};
  std::uint32_t before = 0;  ///< number of the tick that follows
  std::uint32_t lost = 0;    ///< records before it that found no room: their numbers go with them
  protocol::LogRecord type{};
  std::uint8_t size = 0;
  std::array<std::byte, protocol::log_health_size> payload{};
};

class NoteQueue {
 public:
  static constexpr std::uint32_t capacity = 32;

  void clear() { head_ = size_ = 0; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::uint32_t size() const { return size_; }
  void push(const Note& note) {
    notes_[(head_ + size_) % capacity] = note;
    size_ += 1;
  }
  [[nodiscard]] const Note& front() const { return notes_[head_]; }
  void pop() {
    head_ = (head_ + 1) % capacity;
    size_ -= 1;
  }

 private:
  std::array<Note, capacity> notes_{};
  std::uint32_t head_ = 0;
  std::uint32_t size_ = 0;
};

/// A state of the flight law, as a checkpoint's payload. One waits at a time.
struct WaitingCheckpoint {
  std::array<std::byte, 1984> payload{};  // the law that remembers most needs 1980
  std::size_t size = 0;                   ///< 0: none waits
  std::uint32_t before = 0;               ///< number of the tick that follows
  bool in_the_making = false;             ///< and that tick waits for it

  [[nodiscard]] std::span<const std::byte> bytes() const { return std::span{payload}.first(size); }
  /// Of so many bytes. More than there is room for are none: part of a state is none.
  void finish(std::size_t made) {
    size = made <= payload.size() ? made : 0;
    in_the_making = false;
  }
};

struct RecordQueue {
  TickQueue ticks;
  NoteQueue notes;
  WaitingCheckpoint checkpoint;

  void clear() {
    ticks.clear();
    notes.clear();
    checkpoint.size = 0;
    checkpoint.in_the_making = false;
  }
};

}  // namespace fantail::avionics
