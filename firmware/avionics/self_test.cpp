// SPDX-License-Identifier: MIT
#include "avionics/self_test.hpp"

#include <algorithm>

#include "core/finite.hpp"

namespace fantail::avionics {

using core::Angle;
using core::Microseconds;
using protocol::SelfTestFailure;
using protocol::SelfTestState;
using namespace core::literals;

namespace {

constexpr Microseconds still_time{3'000'000};
constexpr Microseconds patience{12'000'000};  // for the still seconds and the count of the flash

constexpr Angle largest_swing = 3_deg;
constexpr Microseconds move_time{400'000};     // a sound servo arrives within a tenth of it
constexpr Microseconds watched_from{300'000};  // the encoders are averaged from here on: one reading is noisy

}  // namespace

// Meets BEN-8, BUS-1.
protocol::ArmRefusal SelfTest::start(const Situation& now, bool session_open) {
  using protocol::ArmRefusal;
  if (running()) {
    return ArmRefusal::none;
  }
  if (now.phase != core::Phase::safe) {
    return ArmRefusal::not_safe;
  }
  if (session_open) {
    return ArmRefusal::session_open;
  }
  if (now.board_faulty) {
    return ArmRefusal::board_fault;
  }
  state_ = SelfTestState::running;
  failure_ = SelfTestFailure::none;
  canard_.reset();
  started_ = gyros_agreed_ = now.time;
  stage_ = Stage::still;
  restart_averages(now.time);
  gyro_zeros_ = {};
  return ArmRefusal::none;
}

// Meets ARM-3, ARM-4.
void SelfTest::update(const core::Inputs& inputs, const core::TickRecord& record, const FlashFacts& flash,
                      bool board_faulty) {
  const bool moves = record.motion.at_rest_for == Microseconds{0};
  if (state_ == SelfTestState::passed && moves) {  // what was tested is not what stands there now
    if (record.phase == core::Phase::safe) {
      fail(SelfTestFailure::moved);
    } else {
      state_ = SelfTestState::not_run;  // a flight is no failure, but whoever disarms needs another test
    }
  }
  if (!running()) {
    return;
  }
  if (record.phase != core::Phase::safe) {
    fail(SelfTestFailure::not_safe);
  } else if (board_faulty) {
    fail(SelfTestFailure::board_fault);
  } else if (const auto failure = judge_gyros(record)) {
    fail(*failure);
  } else if (record.motion.gyro == core::SensorState::failed && !record.gyro_vote) {
    fail(SelfTestFailure::gyro_failed);
  } else if (stage_ == Stage::still) {
    stand_still(inputs, record, flash);
  } else if (moves) {
    fail(SelfTestFailure::moved);
  } else {
    move_canards(record);
  }
}

// Meets ARM-5.
void SelfTest::stand_still(const core::Inputs& inputs, const core::TickRecord& record, const FlashFacts& flash) {
  if (!average(inputs)) {
    // Where the whole IMU is silent, its gyro is named, as without a second one.
    const bool without_imu = record.gyro_vote == core::GyroVote::second || record.gyro_vote == core::GyroVote::neither;
    return fail(without_imu ? SelfTestFailure::gyro_failed : SelfTestFailure::accelerometer_failed);
  }
  gyro_zeros_[0].take(inputs.gyro);
  gyro_zeros_[1].take(inputs.second_gyro.value_or(core::GyroSample{}));
  if (record.motion.at_rest_for == Microseconds{0}) {
    restart_averages(inputs.time);
  }
  const bool still = inputs.time - stage_started_ >= still_time && record.motion.at_rest_for >= still_time;
  const bool counted = (flash.free_bytes && flash.plan) || flash.failed;
  if (!still || !counted) {
    if (inputs.time - started_ >= patience) {
      // A rocket in which a sensor is off by more than the plan's tolerance is never at rest: that is the better name.
      fail(still ? SelfTestFailure::timed_out : judge_averages().value_or(SelfTestFailure::moved));
    }
    return;
  }
  if (const auto failure = judge_averages()) {
    fail(*failure);
  } else if (barometer_fails(record)) {
    fail(SelfTestFailure::barometer_failed);
  } else if (const auto of_flash = judge_flash(flash)) {
    fail(*of_flash);
  } else {
    begin_move(inputs.time, Stage::centre, 0);
  }
}

void SelfTest::restart_averages(Microseconds now) {
  stage_started_ = now;
  for (Average& average : averages_) {
    average = {.last_sample = average.last_sample, .last_news = now};
  }
}

// False when an accelerometer that the plan needs has had nothing usable for longer than the plan allows.
bool SelfTest::average(const core::Inputs& inputs) {
  pressure_pa_ = inputs.barometer ? inputs.barometer->pressure_pa : pressure_pa_;
  for (std::size_t i = 0; i < needed_accelerometers(); ++i) {
    const core::AccelerometerSample& sample = inputs.accelerometers[i];
    Average& average = averages_[i];
    const float axial_m_s2 = sample.specific_force_m_s2.x;
    if (sample.quality == core::SampleQuality::valid && sample.time != average.last_sample &&
        core::is_finite(axial_m_s2)) {
      average.sum_m_s2 += axial_m_s2;
      average.samples += 1.0F;
      average.last_sample = sample.time;
      average.last_news = inputs.time;
    } else if (inputs.time - average.last_news > plan_->motion.stale_time) {
      return false;
    }
  }
  return true;
}

void SelfTest::begin_move(Microseconds now, Stage stage, std::size_t canard) {
  stage_ = stage;
  stage_started_ = now;
  canard_ = canard;
  encoder_sum_ = {};
  encoder_samples_ = {};
}

void SelfTest::move_canards(const core::TickRecord& record) {
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    if (record.verdicts[i] == core::CanardVerdict::dead) {
      return fail(SelfTestFailure::encoder_silent, i);
    }
    if (record.time - stage_started_ >= watched_from && record.encoders[i]) {
      encoder_sum_[i] += *record.encoders[i];
      encoder_samples_[i] += 1.0F;
    }
  }
  if (record.time - stage_started_ < move_time) {
    return;
  }
  judge_canards();
  if (!running()) {
    return;
  }
  if (stage_ == Stage::centre) {
    begin_move(record.time, Stage::out, 0);
  } else if (stage_ == Stage::out) {
    begin_move(record.time, Stage::back, *canard_);
  } else if (*canard_ + 1 < core::canard_count) {
    begin_move(record.time, Stage::out, *canard_ + 1);
  } else {
    state_ = SelfTestState::passed;
    ended_ = record.time;
    canard_.reset();
  }
}

void SelfTest::judge_canards() {
  // The one whose turn it is comes last: where two servos or two encoders are swapped, both stand wrong, and the other
  // one says more.
  for (std::size_t k = 1; k <= core::canard_count; ++k) {
    const std::size_t i = (*canard_ + k) % core::canard_count;
    if (encoder_samples_[i] < 1.0F) {
      return fail(SelfTestFailure::encoder_silent, i);
    }
    const Angle off = encoder_sum_[i] / encoder_samples_[i] - asked_of(i);
    if (abs(off) > swing(*canard_) / 3.0F) {
      const bool its_turn = i == *canard_ || stage_ == Stage::centre;
      return fail(its_turn ? SelfTestFailure::canard_did_not_follow : SelfTestFailure::another_canard_moved, i);
    }
  }
}

std::optional<std::array<Angle, core::canard_count>> SelfTest::canard_request() const {
  if (!running() || stage_ == Stage::still) {
    return std::nullopt;
  }
  std::array<Angle, core::canard_count> angles;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    angles[i] = asked_of(i);
  }
  return angles;
}

Angle SelfTest::asked_of(std::size_t canard) const {
  const Angle trim = plan_->canards.each[canard].trim;
  const bool its_turn = stage_ == Stage::out && canard_ == canard;
  return its_turn ? trim + swing(canard) : trim;
}

// Inside the plan limit, on whichever side the trim lies.
Angle SelfTest::swing(std::size_t canard) const {
  return std::min(largest_swing, plan_->controller.canard_limit - abs(plan_->canards.each[canard].trim));
}

std::size_t SelfTest::needed_accelerometers() const {
  return plan_->launch_detection.accelerometers == core::AccelerometerRule::two_agree ? 2 : 1;
}

void SelfTest::fail(SelfTestFailure failure, std::optional<std::size_t> canard) {
  state_ = SelfTestState::failed;
  failure_ = failure;
  canard_ = canard;
}

}  // namespace fantail::avionics
