// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "hal/can_bus.hpp"

namespace fantail::hal::sim {

class CanBus;

/// The wire between several nodes of one process: what one sends, all others have received at once and in that order.
/// There is no arbitration, because nothing here happens at the same time.
class CanWire {
 public:
  static constexpr std::size_t most_nodes = 8;

  /// What every node then sees: `down` and `bus_off` let nothing through.
  void set_state(CanState state) { state_ = state; }
  [[nodiscard]] CanState state() const { return state_; }
  [[nodiscard]] bool carries() const { return state_ != CanState::down && state_ != CanState::bus_off; }

 private:
  friend class CanBus;
  std::array<CanBus*, most_nodes> nodes_{};  ///< the first so many of them
  std::size_t node_count_ = 0;
  CanState state_ = CanState::error_active;
};

/// One node. It outlives no wire.
class CanBus final : public hal::CanBus {
 public:
  static constexpr std::size_t queue_length = 64;

  explicit CanBus(CanWire& wire) : wire_{wire} {
    if (wire_.node_count_ < CanWire::most_nodes) {
      wire_.nodes_[wire_.node_count_++] = this;
    }
  }
  ~CanBus() override {
    const auto end = wire_.nodes_.begin() + static_cast<std::ptrdiff_t>(wire_.node_count_);
    wire_.node_count_ = static_cast<std::size_t>(std::remove(wire_.nodes_.begin(), end, this) - wire_.nodes_.begin());
  }
  CanBus(const CanBus&) = delete;  // the wire points to it
  CanBus& operator=(const CanBus&) = delete;

  bool send(const CanFrame& frame) override {
    if (!wire_.carries()) {
      counters_.unsent += 1;
      return false;
    }
    counters_.sent += 1;
    for (std::size_t i = 0; i < wire_.node_count_; ++i) {
      if (wire_.nodes_[i] != this) {
        wire_.nodes_[i]->arrive(frame);
      }
    }
    return true;
  }

  std::optional<CanFrame> receive() override {
    if (waiting_ == 0) {
      return std::nullopt;
    }
    const CanFrame frame = queue_[first_];
    first_ = (first_ + 1) % queue_length;
    waiting_ -= 1;
    counters_.received += 1;
    return frame;
  }

  /// As if all that has arrived had been received.
  void pass_over() {
    counters_.received += static_cast<std::uint32_t>(waiting_);
    first_ = (first_ + waiting_) % queue_length;
    waiting_ = 0;
  }

  [[nodiscard]] CanState state() const override { return wire_.state(); }
  [[nodiscard]] CanCounters counters() const override { return counters_; }

 private:
  void arrive(const CanFrame& frame) {
    if (waiting_ == queue_length) {
      counters_.overrun += 1;
      return;
    }
    queue_[(first_ + waiting_) % queue_length] = frame;
    waiting_ += 1;
  }

  CanWire& wire_;
  CanCounters counters_{};
  std::array<CanFrame, queue_length> queue_{};
  std::size_t first_ = 0;
  std::size_t waiting_ = 0;
};

}  // namespace fantail::hal::sim
