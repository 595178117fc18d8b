// SPDX-License-Identifier: MIT
#include "hal/stm32f4/imu.hpp"

#include <algorithm>

#include "hal/stm32f4/icm42688.hpp"
#include "hal/stm32f4/imu_samples.hpp"
#include "hal/stm32f4/imu_settings.hpp"

namespace fantail::hal::stm32f4 {
namespace {

namespace icm = icm42688;

constexpr std::uint8_t self_tests_at_power_up = 3;  // a rocket that is carried about fails one
constexpr Microseconds reset_time{1'000};           // section 14.1: no access before
constexpr Microseconds longest_reset{20'000};
// Section 3.1: the gyro's drive takes 30 ms to start; 14.36: it stays on for 45 ms at least.
constexpr Microseconds warm_up_time{45'000};
constexpr Microseconds longest_without_sample{10'000};
constexpr std::uint8_t most_misses = 5;
// All six axes: with half of the data sheet's noise a run grows by one with a probability of 0.03.
constexpr std::uint8_t most_the_same = 12;

bool has_flag(std::span<const std::byte> burst, std::uint8_t flag) {
  return (std::to_integer<std::uint8_t>(burst.back()) & flag) != 0;
}

}  // namespace

void Imu::start(SensorStart how) {
  const bool in_flight = how == SensorStart::in_flight;
  stage_ = in_flight ? Stage::adopt : Stage::reset;
  self_tests_left_ = in_flight ? 0 : self_tests_at_power_up;
  self_test_failed_ = false;
}

ImuSample Imu::read() {
  const Microseconds now = clock_.now();
  switch (stage_) {
    case Stage::adopt: adopt(now); break;
    case Stage::reset: reset(); break;
    case Stage::wait_for_reset: wait_for_reset(now); break;
    case Stage::self_test: carry_on_self_test(now); break;
    case Stage::warm_up:
      if (now >= stage_ends_) {
        begin_running(now);
        run(now);
      }
      break;
    case Stage::running: run(now); break;
  }
  return sample_;
}

ImuScale Imu::scale() const {
  constexpr float full_scale_counts = 32768.0F;
  constexpr float rad_per_deg = 0.017453292519943295F;
  constexpr float g_m_s2 = 9.80665F;
  return {.rate_rad_s = 2000.0F * rad_per_deg / full_scale_counts,
          .specific_force_m_s2 = 16.0F * g_m_s2 / full_scale_counts};
}

BoardFaults Imu::faults() const {
  BoardFaults faults;
  if (silent_) {
    faults.add(BoardFault::imu_silent);
  }
  if (wrong_id_) {
    faults.add(BoardFault::imu_wrong_id);
  }
  if (self_test_failed_) {
    faults.add(BoardFault::imu_self_test_failed);
  }
  if (gyro_.frozen()) {
    faults.add(BoardFault::gyro_frozen);
  }
  if (accelerometer_.frozen()) {
    faults.add(BoardFault::imu_accelerometer_frozen);
  }
  if (edges_.lost()) {
    faults.add(BoardFault::imu_line_lost);
  }
  return faults;
}

void Imu::restart() {
  sample_.status = Status::no_reading;
  stage_ = Stage::reset;
}

void Imu::begin_running(Microseconds now) {
  stage_ = Stage::running;
  last_new_ = now;
  misses_ = 0;
}

void Imu::settle_for(Microseconds now, Microseconds duration) { stage_ends_ = now + duration; }

bool Imu::check_id(std::uint8_t id) {
  if (id == icm::id) {
    return true;
  }
  // What a line reads that nobody drives, or that is held down.
  silent_ = id == 0x00 || id == 0xFF;
  wrong_id_ = !silent_;
  return false;
}

void Imu::adopt(Microseconds now) {
  // The processor may have been reset while another bank was selected.
  const bool answers = registers_.write(icm::bank_select, 0);
  if (answers && registers_.read(icm::who_am_i) == icm::id &&
      registers_.read(icm::power_management_0) == icm::both_on && is_configured()) {
    begin_running(now);
  } else {
    restart();
  }
}

void Imu::reset() {
  const bool sent = registers_.write(icm::bank_select, 0) && registers_.write(icm::device_config, icm::soft_reset);
  if (!sent) {
    silent_ = true;
    return;
  }
  settle_for(clock_.now(), reset_time);  // from the end of the command on
  stage_ = Stage::wait_for_reset;
}

void Imu::wait_for_reset(Microseconds now) {
  if (now <= stage_ends_) {
    return;
  }
  const auto id = registers_.read(icm::who_am_i);
  const auto status = registers_.read(icm::interrupt_status);
  if (id != icm::id || !status || (*status & icm::reset_done) == 0) {
    // At power-up it may not be there yet: it is only named when its time is over.
    if (now - stage_ends_ > longest_reset) {
      silent_ = check_id(id.value_or(0)) || silent_;
      restart();
    }
    return;
  }
  if (self_tests_left_ > 0) {
    self_tests_left_ -= 1;
    self_test_.begin();
    stage_ = Stage::self_test;
  } else if (configure() && is_configured() && registers_.write(icm::power_management_0, icm::both_on)) {
    settle_for(now, warm_up_time);
    stage_ = Stage::warm_up;
  } else {
    restart();
  }
}

void Imu::carry_on_self_test(Microseconds now) {
  const ImuSelfTest::State state = self_test_.step(registers_, now);
  if (state == ImuSelfTest::State::running) {
    return;
  }
  if (state == ImuSelfTest::State::passed) {
    self_tests_left_ = 0;
  }
  self_test_failed_ = state != ImuSelfTest::State::passed;
  restart();  // and with that all that the test has set is forgotten
}

bool Imu::configure() {
  return icm::for_each_setting(
      registers_, [this](const icm::Setting& setting) { return registers_.write(setting.address, setting.value); });
}

bool Imu::is_configured() {
  return icm::for_each_setting(
      registers_, [this](const icm::Setting& setting) { return registers_.read(setting.address) == setting.value; });
}

bool Imu::read_twice(Readings& readings) {
  const std::byte flags = readings.burst.back();
  const bool answered = registers_.read(icm::temperature_data, readings.burst) &&
                        registers_.read(icm::accelerometer_data, readings.again);
  readings.burst.back() |= flags;  // they are cleared by each
  return answered;
}

void Imu::run(Microseconds now) {
  Readings readings;
  const EdgeTimer::Edge count = data_ready_.now();
  const bool others = data_ready_.take_overrun();
  EdgeTimer::Edge edge = data_ready_.last_edge();
  bool answered = read_twice(readings);
  if (const EdgeTimer::Edge later = data_ready_.last_edge(); answered && later != edge && edges_.trusted()) {
    // A sample came meanwhile: before its counts were read, or behind them. Now it is there, and no other for a while.
    answered = read_twice(readings);
    edge = later;
  }
  const auto id = registers_.read(icm::who_am_i);
  if (!answered || !check_id(id.value_or(0))) {
    sample_.status = wrong_id_ ? Status::error : Status::no_reading;
    misses_ += 1;
    // One answer may be spoilt by a disturbance; to reset the device for it would cost 50 ms.
    if (misses_ >= most_misses) {
      silent_ = !wrong_id_;
      restart();
    }
    return;
  }
  misses_ = 0;
  silent_ = false;
  wrong_id_ = false;
  if (has_flag(readings.burst, icm::reset_done) && registers_.read(icm::power_management_0) != icm::both_on) {
    restart();  // a brown-out of its own: it sleeps, with nothing configured
    return;
  }
  take(now, readings,
       {.count = edge, .time = now + Microseconds{static_cast<std::int32_t>(edge - count)}, .others = others});
  if (now - last_new_ > longest_without_sample) {
    restart();
  }
}

void Imu::take(Microseconds now, const Readings& readings, const LatestEdge& edge) {
  const auto data = std::span{readings.burst}.subspan<2, 12>();  // behind the temperature
  if (!std::ranges::equal(data, readings.again)) {
    return;
  }
  const bool ready = has_flag(readings.burst, icm::data_ready);
  // A sample that came between data and flag was not in the data, and its flag is cleared: it is found by its values.
  if (!ready && std::ranges::equal(data, last_data_)) {
    return;
  }
  const Counts specific_force = big_endian_counts(data.first<6>());
  const Counts rate = big_endian_counts(data.last<6>());
  if (!are_valid(specific_force) || !are_valid(rate)) {
    return;
  }
  std::ranges::copy(data, last_data_.begin());
  last_new_ = now;
  sample_ = {.time = edges_.take(edge.count, edge.others) ? edge.time - filter_delay : now - age_when_found,
             .rate = with_true_ends(rate),
             .specific_force = with_true_ends(specific_force),
             .status = Status::ok};
  judge_counts();
  sample_.rate = gyro_.frozen() ? no_counts : sample_.rate;
  sample_.specific_force = accelerometer_.frozen() ? no_counts : sample_.specific_force;
}

void Imu::judge_counts() {
  static_cast<void>(accelerometer_.update(sample_.specific_force));
  bool gyro_is_found_frozen = gyro_.update(sample_.rate);
  all_the_same_ = gyro_.repeated() && accelerometer_.repeated() ? all_the_same_ + 1 : 0;
  if (all_the_same_ == most_the_same) {
    gyro_.condemn();
    accelerometer_.condemn();
    gyro_is_found_frozen = true;
  }
  if (gyro_is_found_frozen) {
    all_the_same_ = 0;
    restart();
  }
}

}  // namespace fantail::hal::stm32f4
