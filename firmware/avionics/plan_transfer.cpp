// SPDX-License-Identifier: MIT
#include "avionics/plan_transfer.hpp"

#include <algorithm>
#include <utility>

#include "protocol/plan_block.hpp"

namespace fantail::avionics {

using protocol::TransferFault;
using protocol::TransferState;

void PlanTransfer::become(TransferState state, TransferFault fault) {
  state_ = state;
  fault_ = fault;
  block_fault_.reset();
  field_.reset();
  reply_due_ = true;
}

// Meets BUS-1.
void PlanTransfer::receive(core::Microseconds now, const protocol::PlanBegin& begin, bool safe) {
  // Said again by a bench that did not hear, or by another one: what is being written ends first, and is handed out.
  if (writing() || plan_waits_) {
    reply_due_ = true;
    return;
  }
  const bool wrong_size = begin.size == 0 || begin.size > protocol::largest_plan_block;
  if (!safe || wrong_size) {
    const TransferFault fault = safe ? TransferFault::wrong_size : TransferFault::not_safe;
    if (state_ == TransferState::receiving) {
      refusal_ = {.state = TransferState::refused, .fault = fault};
    } else {
      next_index_ = 0;
      become(TransferState::refused, fault);
    }
    return;
  }
  next_index_ = 0;
  begin_ = begin;
  last_progress_ = now;
  become(TransferState::receiving);
}

void PlanTransfer::receive(core::Microseconds now, const protocol::PlanData& data, bool safe) {
  if (state_ == TransferState::idle) {
    become(TransferState::refused, TransferFault::out_of_order);
  }
  reply_due_ = true;  // also when the transfer has ended: then its last frame has come again, its answer being lost
  if (state_ != TransferState::receiving) {
    return;
  }
  if (!safe) {
    become(TransferState::refused, TransferFault::not_safe);
    return;
  }
  if (data.index > next_index_ || (data.index == next_index_ && complete())) {
    fault_ = TransferFault::out_of_order;
    return;
  }
  fault_ = TransferFault::none;
  if (data.index == next_index_) {
    const std::size_t at = std::size_t{next_index_} * bytes_a_frame;
    const auto room = std::span{buffer_}.first(begin_.size).subspan(at);
    for (std::size_t i = 0; i < std::min(room.size(), data.bytes.size()); ++i) {  // std::copy would be the only memmove
      room[i] = data.bytes[i];
    }
    next_index_ += 1;
    last_progress_ = now;
  }
}

void PlanTransfer::update(core::Microseconds now, bool safe) {
  if (state_ == TransferState::writing) {
    follow_write(safe);
  }
  if (state_ != TransferState::receiving) {
    return;
  }
  if (!safe) {
    become(TransferState::refused, TransferFault::not_safe);
  } else if (complete()) {
    check_block();
  } else if (now - last_progress_ >= patience) {
    become(TransferState::refused, TransferFault::timed_out);
  }
}

// Meets PLN-3.
void PlanTransfer::check_block() {
  protocol::PlanBlockReading reading{.plan = {}, .fault = protocol::PlanBlockFault::wrong_checksum};
  if (protocol::plan_block_crc(block()) == begin_.block_crc) {
    reading = protocol::read_plan_block(block());
  }
  if (!reading.plan) {
    become(TransferState::refused, TransferFault::bad_block);
    block_fault_ = reading.fault;
    if (reading.plan_fault) {
      field_ = static_cast<std::uint8_t>(reading.plan_fault->field);
    }
    return;
  }
  plan_waits_ = true;
  store_.begin_write(block());
  become(TransferState::writing);
}

void PlanTransfer::follow_write(bool safe) {
  switch (store_.write()) {
    case PlanWrite::under_way:
      if (!safe && store_.withdraw()) {
        become(TransferState::refused, TransferFault::not_safe);
      }
      break;
    case PlanWrite::stored:
      if (safe) {
        become(TransferState::stored);
      }
      break;
    case PlanWrite::none:
    case PlanWrite::flash_failed: become(TransferState::refused, TransferFault::flash_failed); break;
    case PlanWrite::read_back_differs: become(TransferState::refused, TransferFault::read_back_differs); break;
  }
  if (state_ == TransferState::refused) {
    plan_waits_ = false;
  }
}

std::optional<protocol::PlanReply> PlanTransfer::reply() {
  if (auto refusal = std::exchange(refusal_, std::nullopt)) {
    return refusal;
  }
  if (!std::exchange(reply_due_, false)) {
    return std::nullopt;
  }
  return protocol::PlanReply{
      .state = state_, .fault = fault_, .next_index = next_index_, .block_fault = block_fault_, .field = field_};
}

std::optional<core::FlightPlan> PlanTransfer::take_plan() {
  if (state_ != TransferState::stored || !std::exchange(plan_waits_, false)) {
    return std::nullopt;
  }
  return protocol::read_plan_block(block()).plan;  // not a copy, which would cost the memory of one all the time
}

}  // namespace fantail::avionics
