// SPDX-License-Identifier: MIT
#include "sim/nearest_tick.hpp"
#include "sim/world.hpp"

// What goes wrong in a run.
namespace fantail::sim {
namespace {

using core::Microseconds;

ServoFault servo_fault(FaultKind kind) {
  switch (kind) {
    case FaultKind::canard_stuck: return ServoFault::stuck;
    case FaultKind::canard_hardover: return ServoFault::hardover;
    case FaultKind::canard_dead: return ServoFault::dead;
    case FaultKind::canard_slipping: return ServoFault::slipping;
    case FaultKind::canard_reversed: return ServoFault::reversed;
    case FaultKind::canard_slow: return ServoFault::slow;
    case FaultKind::canard_wrong_trim: return ServoFault::wrong_trim;
    default: return ServoFault::none;
  }
}

bool flies(core::Phase phase) { return phase != core::Phase::safe && phase != core::Phase::armed; }

}  // namespace

void World::apply_faults() {
  imu_fault_ = second_imu_fault_ = ImuFault{};
  accelerometer_hangs_ = false;
  for (std::size_t i = 0; i < scenario_.faults.size(); ++i) {
    const Fault& fault = scenario_.faults[i];
    if (is_of_device(fault.kind) || now_ < ignition_ + nearest_tick(fault.from_s)) {
      continue;
    }
    if (is_of_sensor(fault.kind)) {
      if (now_ < ignition_ + nearest_tick(fault.until_s)) {
        break_sensor(fault);
      }
    } else if (!fault_is_applied_[i]) {
      fault_is_applied_[i] = true;
      if (is_reset(fault.kind)) {
        begin_reset(fault.reset);
      } else {
        break_canard(fault);
      }
    }
  }
}

void World::break_sensor(const Fault& fault) {
  switch (fault.kind) {
    case FaultKind::imu_dropout: imu_fault_.hangs = true; break;
    case FaultKind::imu_frozen: imu_fault_.frozen = true; break;
    case FaultKind::imu_offset: imu_fault_.rate_offset_rad_s += fault.rate_offset_rad_s; break;
    case FaultKind::second_imu_dropout: second_imu_fault_.hangs = true; break;
    case FaultKind::second_imu_frozen: second_imu_fault_.frozen = true; break;
    case FaultKind::second_imu_offset: second_imu_fault_.rate_offset_rad_s += fault.rate_offset_rad_s; break;
    default: accelerometer_hangs_ = true;
  }
}

void World::break_canard(const Fault& fault) {
  switch (fault.kind) {
    case FaultKind::encoder_unplugged: canards_.unplug_encoder(fault.canard); break;
    case FaultKind::encoder_noisy: canards_.make_encoder_noisy(fault.canard, fault.noise_counts); break;
    default: canards_.fail(fault.canard, servo_fault(fault.kind), fault.angle_rad);
  }
}

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
  hardware_.encoders.time += ahead;
}

void World::note_resume() { gaps_.back().resumed = gaps_.back().resumed || flies(phase_); }

}  // namespace fantail::sim
