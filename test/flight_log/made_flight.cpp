// SPDX-License-Identifier: MIT
#include "flight_log/made_flight.hpp"

#include "avionics/log_tick_of.hpp"
#include "core/autopilot.hpp"
#include "core/flight_plan_fields.hpp"
#include "flight_log/log_maker.hpp"

namespace fantail::flight_log {
namespace {

using core::Microseconds;

constexpr Microseconds tick_time{1'000};
constexpr Microseconds armed_at{3'000'000};
constexpr Microseconds logged_from{5'500'000};
constexpr Microseconds thrust_from{6'000'000};
constexpr Microseconds thrust_until{8'000'000};

std::int16_t thousandths_of_g(Microseconds time) {
  if (time < thrust_from) {
    return 1'000;
  }
  return time < thrust_until ? 8'000 : -300;
}

avionics::RawSamples samples_at(Microseconds time) {
  const bool flies = time >= thrust_from;
  const auto rate = static_cast<std::int16_t>(flies ? 500 : 1);
  const Microseconds since_last{time.count() % 5'000};  // the second accelerometer has a sample every fifth tick
  const auto second = static_cast<std::int16_t>(thousandths_of_g(time - since_last) / 10);
  avionics::RawSamples raw{
      .imu = {.time = time - Microseconds{150},
              .rate = {rate, 2, -1},
              .specific_force = {thousandths_of_g(time), 3, -4},
              .status = hal::Status::ok},
      .accelerometer = {.time = time - since_last, .specific_force = {second, 0, 0}, .status = hal::Status::ok},
      .encoders = {.time = time, .each = {}}};
  for (std::size_t i = 0; i < raw.encoders.each.size(); ++i) {
    raw.encoders.each[i] = {.counts = static_cast<std::uint16_t>(3 * i), .status = hal::Status::ok};
  }
  return raw;
}

class Maker {
 public:
  explicit Maker(const MadeFlightOptions& options)
      : options_{options}, made_{.bytes = {}, .records = {}, .frame_ends = {}, .plan = core::default_plan()} {}

  MadeFlight make() {
    for (Microseconds time{}; time < logged_from + options_.length; time += tick_time) {
      if (time >= logged_from) {
        before_tick(time);
      }
      step(time);
    }
    if (options_.ended) {
      log_.event({.time = logged_from + options_.length - tick_time, .kind = protocol::LogEventKind::recording_ended});
      note_end();
    }
    made_.bytes = log_.bytes();
    return made_;
  }

 private:
  void before_tick(Microseconds time) {
    const Microseconds logged = time - logged_from;
    if (logged % options_.header_every == Microseconds{0}) {
      log_.header(time, some_header(options_.flight), made_.plan);
      note_end();
    }
    if (logged % options_.checkpoint_every == Microseconds{0}) {
      log_.set_times(times_);
      log_.checkpoint(time, law_);
      note_end();
    }
  }

  void step(Microseconds time) {
    const avionics::RawSamples raw = samples_at(time);
    const protocol::LogTick fed{.time = time,
                                .imu_time = raw.imu.time,
                                .rate_counts = raw.imu.rate,
                                .specific_force_counts = raw.imu.specific_force,
                                .imu_status = protocol::DeviceStatus::ok,
                                .accelerometer_time = raw.accelerometer.time,
                                .accelerometer_counts = raw.accelerometer.specific_force,
                                .accelerometer_status = protocol::DeviceStatus::ok,
                                .encoder_counts = {0, 3, 6, 9},
                                .arm_switch_closed = true,
                                .arm_command = time == armed_at};
    const auto header = some_header();
    const avionics::SampleScales scales{
        .imu = {.rate_rad_s = header.rate_scale_rad_s, .specific_force_m_s2 = header.specific_force_scale_m_s2},
        .accelerometer_m_s2 = header.accelerometer_scale_m_s2};
    const core::Inputs inputs = avionics::inputs_of(fed, scales, made_.plan.canards);
    const core::TickRecord& record = law_.step(inputs);
    times_ = {.imu = raw.imu.time, .accelerometer = raw.accelerometer.time};
    if (time < logged_from) {
      phase_ = record.phase;
      return;
    }
    // 100 us, and every hundredth tick 250 us: a mean of 101.5 us.
    const Microseconds duration{time.count() % 100'000 == 0 ? 250 : 100};
    log_.tick(avionics::log_tick_of(record, raw, inputs, duration));
    note_end();
    made_.records.push_back(record);
    note(record);
  }

  void note(const core::TickRecord& record) {
    if (record.phase != phase_) {
      phase_ = record.phase;
      log_.event({.time = record.time,
                  .kind = protocol::LogEventKind::phase,
                  .value = static_cast<std::uint8_t>(record.phase),
                  .detail = static_cast<std::uint8_t>(record.reason)});
      note_end();
    }
    if (record.time.count() % 100'000 == 0) {
      log_.health({.time = record.time, .longest_tick_us = 250});
      note_end();
    }
  }

  void note_end() { made_.frame_ends.push_back(log_.bytes().size()); }

  MadeFlightOptions options_;
  MadeFlight made_;
  LogMaker log_;
  core::Autopilot law_{made_.plan};
  protocol::SampleTimes times_;
  core::Phase phase_ = core::Phase::safe;
};

}  // namespace

MadeFlight make_flight(const MadeFlightOptions& options) { return Maker{options}.make(); }

}  // namespace fantail::flight_log
