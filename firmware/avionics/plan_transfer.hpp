// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "avionics/plan_store.hpp"
#include "core/flight_plan.hpp"
#include "core/time.hpp"
#include "protocol/bus_messages.hpp"

namespace fantail::avionics {

/// A flight plan from the bench, seven bytes a frame, each answered before the next one is sent. The block is checked
/// as a whole, stored and read back before its plan comes into force, and until then nothing has happened to the old
/// one. A frame that was lost, doubled or overtaken is answered with the index that is waited for, and spoils nothing;
/// nor does a beginning that is refused.
///
/// `safe`: the phase is Safe. When it ends, so does a transfer of which nothing has been written; one that is being
/// written goes on to its end, and its plan is kept back until the phase is Safe again.
class PlanTransfer {
 public:
  /// A transfer ends this long after the last frame that took it further.
  static constexpr core::Microseconds patience{1'000'000};

  /// The store outlives this object and is updated by its owner.
  explicit PlanTransfer(PlanStore& store) : store_{store} {}

  void receive(core::Microseconds now, const protocol::PlanBegin& begin, bool safe);
  void receive(core::Microseconds now, const protocol::PlanData& data, bool safe);

  /// Once a tick, after what it received. At most one block is checked.
  void update(core::Microseconds now, bool safe);

  /// What is to be sent in this tick, if there is something new to say.
  std::optional<protocol::PlanReply> reply();

  /// The plan that has come into force, once; no other transfer begins before it has been taken.
  std::optional<core::FlightPlan> take_plan();
  /// protocol::plan_block_crc() of the plan just taken.
  [[nodiscard]] std::uint32_t block_crc() const { return begin_.block_crc; }

  /// A write is under way, or its plan is kept back: arming should wait.
  [[nodiscard]] bool writing() const { return state_ == protocol::TransferState::writing; }

 private:
  [[nodiscard]] std::span<const std::byte> block() const { return std::span{buffer_}.first(begin_.size); }
  [[nodiscard]] bool complete() const { return std::size_t{next_index_} * bytes_a_frame >= begin_.size; }
  void become(protocol::TransferState state, protocol::TransferFault fault = protocol::TransferFault::none);
  void check_block();
  void follow_write(bool safe);

  static constexpr std::size_t bytes_a_frame = 7;

  PlanStore& store_;
  protocol::TransferState state_ = protocol::TransferState::idle;
  protocol::TransferFault fault_ = protocol::TransferFault::none;
  std::optional<protocol::PlanBlockFault> block_fault_;
  std::optional<std::uint8_t> field_;
  bool reply_due_ = false;
  std::optional<protocol::PlanReply> refusal_;  ///< of a beginning, while another transfer goes on

  protocol::PlanBegin begin_{};
  std::uint8_t next_index_ = 0;
  core::Microseconds last_progress_{};
  std::array<std::byte, protocol::largest_plan_block> buffer_{};
  bool plan_waits_ = false;  ///< the block is checked, and its plan not yet handed out
};

}  // namespace fantail::avionics
