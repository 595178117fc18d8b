// SPDX-License-Identifier: MIT
#include "avionics/recorder.hpp"

#include <algorithm>
#include <utility>

#include "avionics/flash_facts.hpp"
#include "avionics/write_state.hpp"
#include "protocol/log_schema.hpp"

namespace fantail::avionics {

using core::Microseconds;
using core::Phase;
using protocol::LogBegin;
using protocol::LogEnd;
using protocol::LogEventKind;
using protocol::StateExtent;

namespace {

// Header, first checkpoint and the half second before launch: a record that ends ahead of its launch is none.
constexpr std::uint32_t least_record_bytes = 40'000;

constexpr std::uint8_t ticks_of_a_push = 50;  // a knock is shorter
constexpr std::uint8_t most_records_in_safe = 3;
constexpr Microseconds longest_outside_flight{60'000'000};

bool flies(Phase phase) { return phase != Phase::safe && phase != Phase::armed; }

}  // namespace

void Recorder::take_plan(const core::FlightPlan& plan) {
  protocol::write_plan_block(plan, plan_block_);
  canards_ = plan.canards;
  has_barometer_ = plan.sensors.barometer != core::BarometerUse::none;
  queue_.ticks.take_ticks_of(
      protocol::log_tick_size_with(plan.sensors.gyros == core::GyroRule::two_agree, has_barometer_));
  rest_time_ = plan.motion.rest_time;
  threshold_m_s2_ = plan.recording.threshold_m_s2;
  stage_ = Stage::idle;
}

void Recorder::note(const Tick& tick, core::Autopilot& law) {
  const Phase phase = tick.record.phase;
  if (queue_.checkpoint.in_the_making) {
    go_on_with_first_checkpoint();
  }
  switch (stage_) {
    case Stage::idle:
      if ((may_wait(tick) || (resumed_ && flies(phase) && region_.finished())) &&
          region_.free_bytes().value_or(least_record_bytes) >= least_record_bytes) {
        begin_on_pad(tick, law);
      }
      break;
    case Stage::on_pad: wait_on_pad(tick, law); break;
    case Stage::flying: fly_on(tick, law); break;
    case Stage::closing: break;
  }
}

void Recorder::wait_on_pad(const Tick& tick, core::Autopilot& law) {
  const Phase phase = tick.record.phase;
  if (const bool pushed = is_pushed(tick.inputs); flies(phase) || pushed) {
    begin_flight(tick, flies(phase) ? LogBegin::flight : LogBegin::acceleration);
    if (stage_ == Stage::flying) {
      fly_on(tick, law);
    }
    return;
  }
  // What comes before it belongs to another phase, and no replay knows a request.
  if (phase != told_.phase || tick.record.reason != told_.reason || tick.inputs.canard_request) {
    resumed_.reset();
    stage_ = Stage::idle;
    if (may_wait(tick)) {
      begin_on_pad(tick, law);
    }
    return;
  }
  if (queue_.ticks.size() == queue_.ticks.capacity() - PadRing::room_beside) {
    ring_.retire_oldest(queue_.ticks);
  }
  queue_tick(tick);
}

bool Recorder::may_wait(const Tick& tick) const {
  const bool waits_in_safe = tick.record.phase == Phase::safe && tick.record.motion.at_rest_for >= rest_time_ &&
                             records_in_safe_ < most_records_in_safe && region_.finished() &&
                             !tick.inputs.canard_request;
  return tick.record.phase == Phase::armed || waits_in_safe;
}

bool Recorder::is_pushed(const core::Inputs& inputs) {
  const float threshold_squared = threshold_m_s2_ * threshold_m_s2_;
  const bool beyond = std::ranges::any_of(inputs.accelerometers, [&](const core::AccelerometerSample& sample) {
    const core::Vector3& f = sample.specific_force_m_s2;
    const bool measures =
        sample.quality == core::SampleQuality::valid || sample.quality == core::SampleQuality::saturated;
    return measures && f.x * f.x + f.y * f.y + f.z * f.z > threshold_squared;
  });
  pushed_ticks_ = beyond ? static_cast<std::uint8_t>(pushed_ticks_ + 1U) : std::uint8_t{0};
  return pushed_ticks_ >= ticks_of_a_push;
}

void Recorder::begin_on_pad(const Tick& tick, core::Autopilot& law) {
  state_layout_ = state_layout(law);
  queue_.clear();
  told_ = {.phase = tick.record.phase, .reason = tick.record.reason};
  times_ = sample_times(tick.raw);
  ring_.begin(law, times_, tick.scales, canards_);
  pushed_ticks_ = 0;
  stage_ = Stage::on_pad;
}

void Recorder::begin_flight(const Tick& tick, LogBegin why) {
  const auto flight = region_.open();
  if (!flight) {
    stage_ = Stage::idle;
    return;
  }
  stream_.begin(
      {.flight = *flight,
       .power_up = tick.power_up.value_or(0),
       .state_layout = state_layout_,
       .rate_scale_rad_s = tick.scales.imu.rate_rad_s,
       .specific_force_scale_m_s2 = tick.scales.imu.specific_force_m_s2,
       .accelerometer_scale_m_s2 = tick.scales.accelerometer_m_s2,
       .second_rate_scale_rad_s = tick.raw.second_imu ? std::optional{tick.scales.second_rate_rad_s} : std::nullopt,
       .firmware_version = identity_.firmware_version,
       .git_hash = identity_.git_hash,
       .vehicle = identity_.vehicle,
       .sensors = identity_.sensors,
       .plan_block = plan_block_,
       .schema = tick.raw.second_imu ? protocol::log_schema_of_two_gyros() : protocol::log_schema(),
       .rest_of_schema = has_barometer_ ? protocol::log_schema_of_barometer() : ""});
  stage_ = Stage::flying;
  overflowed_ = false;
  dropped_ = 0;
  longest_tick_ = {};
  longest_tick_cycles_ = 0;
  if (tick.board != nullptr) {
    (void)tick.board->take_longest_tick_cycles();  // of the pad
  }
  longest_queue_ = 0;
  ticks_to_health_ = 0;
  over_since_.reset();
  records_in_safe_ = static_cast<std::uint8_t>(records_in_safe_ + (tick.record.phase == Phase::safe ? 1U : 0U));
  const Microseconds time = queue_.ticks.size() > 0 ? queue_.ticks.time() : tick.record.time;
  begin_first_checkpoint();
  // Not in the ticks in which the flight memory writes out the same state.
  checkpoint_due_ = tick.record.time + checkpoint_period + Microseconds{3'000};
  queue_event(
      {.time = time, .kind = LogEventKind::recording_began, .value = static_cast<std::uint8_t>(why), .number = *flight},
      queue_.ticks.first());
  if (const auto resumed = std::exchange(resumed_, std::nullopt)) {
    queue_event({.time = time,
                 .kind = LogEventKind::resumed,
                 .value = static_cast<std::uint8_t>(resumed->cause),
                 .number = resumed->resumes},
                queue_.ticks.first());
  }
  queue_event({.time = time,
               .kind = LogEventKind::phase,
               .value = static_cast<std::uint8_t>(told_.phase),
               .detail = static_cast<std::uint8_t>(told_.reason)},
              queue_.ticks.first());
}

void Recorder::queue_tick(const Tick& tick) {
  overflowed_ = overflowed_ || queue_.ticks.full();
  if (overflowed_) {
    dropped_ += 1;
    ticks_dropped_ += 1;
    checkpoint_due_.reset();  // a replay cannot go on behind a gap
    times_ = sample_times(tick.raw);
    overflowed_ = queue_.ticks.size() > queue_.ticks.capacity() / 2 || queue_.checkpoint.size > 0;
  } else {
    pack(log_tick_of(tick.record, tick.raw, tick.inputs, tick.duration_before), times_,
         queue_.ticks.push(tick.record.time));
  }
}

void Recorder::fly_on(const Tick& tick, core::Autopilot& law) {
  const Microseconds time = tick.record.time;
  queue_changes(tick.record);
  if (tick.faults != told_.faults) {
    queue_faults(tick);
  }
  queue_tick(tick);
  queue_health(tick);
  if (!overflowed_) {
    tell_what_was_dropped(time);
    // Outside a flight a state is large: only where a replay could not go on without it.
    const bool in_flight = flies(tick.record.phase);
    if (queue_.checkpoint.size == 0 && (!checkpoint_due_ || (in_flight && time >= *checkpoint_due_))) {
      queue_checkpoint(time, law, in_flight ? StateExtent::in_flight : StateExtent::whole);
    }
  }
  if (const auto end = reason_to_end(tick)) {
    queue_event({.time = time, .kind = LogEventKind::recording_ended, .value = static_cast<std::uint8_t>(*end)},
                queue_.ticks.end());
    stream_.finish();
    stage_ = Stage::closing;
  }
}

std::optional<LogEnd> Recorder::reason_to_end(const Tick& tick) {
  const core::TickRecord& record = tick.record;
  if (core::is_flight(record.phase)) {
    over_since_.reset();
    return std::nullopt;
  }
  over_since_ = over_since_.value_or(record.time);
  const Microseconds over_for = record.time - *over_since_;
  if (record.phase == Phase::finished) {
    return over_for >= recorded_after_control ? std::optional{LogEnd::flight_over} : std::nullopt;
  }
  const bool ends =
      record.motion.at_rest_for >= rest_time_ || over_for >= longest_outside_flight || tick.inputs.canard_request;
  return ends ? std::optional{LogEnd::returned_to_pad} : std::nullopt;
}

// Meets REC-2.
void Recorder::update(Microseconds now) {
  stream_.update(now);
  if (!busy() && stage_ != Stage::on_pad) {
    stage_ = Stage::idle;
  }
}

}  // namespace fantail::avionics
