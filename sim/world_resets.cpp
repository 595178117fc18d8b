// SPDX-License-Identifier: MIT
#include "sim/nearest_tick.hpp"
#include "sim/world.hpp"

// What a reset of the processor does.
namespace fantail::sim {
namespace {

using core::Microseconds;

bool flies(core::Phase phase) { return phase != core::Phase::safe && phase != core::Phase::armed; }

}  // namespace

// One that comes while the processor is down makes it begin anew once more.
void World::begin_reset(const Reset& reset) {
  if (last_record_ == nullptr) {
    return;  // not yet switched on
  }
  if (!down_until_) {
    gaps_.push_back({.from = now_});
  }
  gaps_.back().cause = reset.cause;
  reset_ = reset;
  down_until_ = now_ + nearest_tick(reset.gap_s);
  follow_reset();
}

void World::follow_reset() {
  // The loop hangs until the watchdog resets the processor, and the timer repeats the pulses without it.
  const bool hangs =
      reset_.cause == hal::ResetCause::watchdog && now_ < *down_until_ - nearest_tick(start_of_firmware_s);
  if (!hangs) {
    hardware_.pulses = {};
  }
  if (now_ >= *down_until_) {
    restart_board();
  }
}

void World::restart_board() {
  const Microseconds before = board_ahead_;
  board_ahead_ = board_->restart(reset_) - now_;
  put_samples_on_clock_of_board(board_ahead_ - before);
  down_until_.reset();
  gaps_.back().to = now_;
}

void World::put_samples_on_clock_of_board(Microseconds ahead) {
  hardware_.imu.time += ahead;
  hardware_.second_imu.time += ahead;
  hardware_.accelerometer.time += ahead;
  hardware_.barometer.time += ahead;
  hardware_.encoders.time += ahead;
}

// Of an avionics that runs by itself, and of which only this is known. Without a reset nothing was lost: it started, or
// a tick was late.
void World::note_own_gap() {
  if (gaps_.empty() || gaps_.back().to) {
    gaps_.push_back({.from = now_});
  }
  Gap& gap = gaps_.back();
  gap.cause = hardware_.restarted_by ? hardware_.restarted_by : gap.cause;
  if (hardware_.had_tick && !gap.cause) {
    gaps_.pop_back();
  } else if (hardware_.had_tick) {
    gap.to = now_;
  }
}

void World::note_resume() { gaps_.back().resumed = gaps_.back().resumed || flies(phase_); }

}  // namespace fantail::sim
