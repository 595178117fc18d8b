// SPDX-License-Identifier: MIT
// From any state of PlanTransfer, while the phase is not Safe (or the plan must not change for another reason: `safe`
// is what Avionics::plan_may_change() says), one message or one tick:
//   - begins no transfer, takes no data, and begins no write to the flash;
//   - makes no plan ready to be handed out: one becomes so only in a tick in which the plan may change, and only when
//     its write has ended;
//   - ends a transfer of which nothing has been written.
// And Safe or not: a plan is handed out only if it was ready, and once; a write begins only of a block whose checksum
// is the announced one and that is a valid plan; the announced size is never more than the buffer's.
// take_plan() itself does not ask whether the plan may change. Avionics::tick() calls it first of all, before anything
// that could change what plan_may_change() said at the end of the tick before; that is not proved but tested
// (NewPlan.OneThatIsWrittenWhileTheRocketIsCarriedIsNotInForceBeforeItRestsAgain).
#include "avionics/plan_transfer.cpp"

#include <cstdlib>

#include "proof.hpp"

using namespace fantail;
using namespace fantail::avionics;
using namespace fantail::proof;

namespace {

bool checksum_agrees = false;
bool block_is_valid = false;

}  // namespace

// In the place of the block's reader: any answer.
namespace fantail::protocol {

PlanBlockReading read_plan_block(std::span<const std::byte>) {
  PlanBlockReading reading{};
  block_is_valid = nondet_bool();
  if (block_is_valid) {
    reading.plan = core::FlightPlan{};
  }
  return reading;
}

std::uint32_t announced = 0;
std::uint32_t plan_block_crc(std::span<const std::byte>) {
  const std::uint32_t crc = nondet_u32();
  checksum_agrees = crc == announced;
  return crc;
}

}  // namespace fantail::protocol

int main() {
  // Not by its constructor: the prover cannot bind a member that is a reference.
  PlanTransfer& transfer = *static_cast<PlanTransfer*>(std::malloc(sizeof(PlanTransfer)));
  transfer.state_ = any_of<protocol::TransferState>(5);
  transfer.fault_ = any_of<protocol::TransferFault>(8);
  transfer.begin_ = {.size = nondet_u16(), .block_crc = nondet_u32()};
  protocol::announced = transfer.begin_.block_crc;
  transfer.next_index_ = nondet_u8();
  transfer.last_progress_ = any_instant();
  transfer.plan_waits_ = nondet_bool();
  assume(transfer.begin_.size <= protocol::largest_plan_block);  // kept by every step below

  const protocol::TransferState before = transfer.state_;
  const std::uint8_t index = transfer.next_index_;
  const bool waited = transfer.plan_waits_;
  const bool was_ready = before == protocol::TransferState::stored && waited;
  const bool safe = nondet_bool();
  const core::Microseconds now = any_instant();
  using enum protocol::TransferState;

  const std::uint8_t step = nondet_u8();
  if (step == 0) {
    transfer.receive(now, protocol::PlanBegin{.size = nondet_u16(), .block_crc = nondet_u32()}, safe);
    CLAIM(safe || transfer.state_ != receiving || before == receiving);
    REACHABLE(1, transfer.state_ == receiving && before == stored);
  } else if (step == 1) {
    protocol::PlanData data{};
    data.index = nondet_u8();
    transfer.receive(now, data, false);
    CLAIM(transfer.next_index_ == index);
    CLAIM(transfer.state_ != receiving);
  } else if (step == 2) {
    transfer.update(now, safe);
    CLAIM(writes_begun == 0 || (writes_begun == 1 && safe && before == receiving && checksum_agrees && block_is_valid));
    CLAIM(transfer.state_ != stored || before == stored || (safe && before == writing));
    CLAIM(safe || transfer.state_ != receiving);
    CLAIM(!transfer.plan_waits_ || waited || writes_begun == 1);
    REACHABLE(2, writes_begun == 1);
    REACHABLE(3, transfer.state_ == stored && before == writing);
  } else {
    CLAIM(!transfer.take_plan() || (was_ready && !transfer.plan_waits_));
    REACHABLE(4, was_ready);
  }
  CLAIM(transfer.state_ != stored || !transfer.plan_waits_ || was_ready || (step == 2 && safe));
  CLAIM(transfer.begin_.size <= protocol::largest_plan_block);
  CLAIM(step == 2 || writes_begun == 0);
  return 0;
}
