// SPDX-License-Identifier: MIT
#include "hal/stm32f4/imu.hpp"

#include <algorithm>

#include "hal/stm32f4/icm42688.hpp"
#include "hal/stm32f4/imu_samples.hpp"

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

struct Setting {
  std::uint8_t bank;
  std::uint8_t address;
  std::uint8_t value;
};
// Both sensors are off while these are written (section 12.9). Reserved bits keep their reset values but for bits 7:6
// of INTF_CONFIG1: as 01 they switch off what else lets an axis of the gyro repeat itself for 1 to 2 ms whenever it
// passes 100 deg/s (ArduPilot, issue 25025; not in the data sheet).
constexpr auto settings = std::to_array<Setting>({
    {0, icm::interface_config_0, 0x33},      // big-endian, -32768 until the first sample, no I2C
    {0, icm::interface_config_1, 0x51},      // the gyro's oscillator as clock: 1 % instead of 8 % (section 4.10)
    {0, icm::gyro_config_0, 0x06},           // 2000 deg/s, 1 kHz
    {0, icm::accelerometer_config_0, 0x06},  // 16 g, 1 kHz
    {0, icm::gyro_config_1, 0x16},           // second-order filter
    {0, icm::filter_config_0, 0x00},         // 493 Hz (section 5.5)
    {0, icm::accelerometer_config_1, 0x0D},  // second-order filter
    {0, icm::interrupt_config_0, 0x00},      // data-ready is cleared by reading INT_STATUS
    // INT1: push-pull, active high, and a pulse, because a line that stays high until it is served would swallow the
    // edge of the second of two samples between two ticks. Section 12.6: without INT_ASYNC_RESET, or it does not work.
    {0, icm::interrupt_config, 0x03},
    {0, icm::interrupt_config_1, 0x00},  // of 100 us
    {0, icm::interrupt_source_0, 0x08},  // data-ready alone
    // 258 Hz (section 5.3): delta 6, its square 36, shift 10.
    {1, icm::gyro_config_static_3, 6},
    {1, icm::gyro_config_static_4, 36},
    {1, icm::gyro_config_static_5, 10U << 4U},
    {2, icm::accelerometer_config_static_2, 6U << 1U},
    {2, icm::accelerometer_config_static_3, 36},
    {2, icm::accelerometer_config_static_4, 10U << 4U},
});
constexpr std::uint8_t both_on = icm::gyro_low_noise | icm::accelerometer_low_noise;

/// Ends in bank 0, where it begins; false when `visit` was for one of them.
template <typename Visit>
bool for_each_setting(SpiRegisters& registers, Visit visit) {
  std::uint8_t bank = 0;
  for (const Setting& setting : settings) {
    if (setting.bank != bank && !registers.write(icm::bank_select, setting.bank)) {
      return false;
    }
    bank = setting.bank;
    if (!visit(setting)) {
      return false;
    }
  }
  return registers.write(icm::bank_select, 0);
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
    case Stage::reset: reset(now); break;
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
  if (answers && registers_.read(icm::who_am_i) == icm::id && registers_.read(icm::power_management_0) == both_on &&
      is_configured()) {
    begin_running(now);
  } else {
    restart();
  }
}

void Imu::reset(Microseconds now) {
  const bool sent = registers_.write(icm::bank_select, 0) && registers_.write(icm::device_config, icm::soft_reset);
  if (!sent) {
    silent_ = true;
    return;
  }
  settle_for(now, reset_time);
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
  } else if (configure() && is_configured() && registers_.write(icm::power_management_0, both_on)) {
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
  return for_each_setting(registers_,
                          [this](const Setting& setting) { return registers_.write(setting.address, setting.value); });
}

bool Imu::is_configured() {
  return for_each_setting(registers_,
                          [this](const Setting& setting) { return registers_.read(setting.address) == setting.value; });
}

void Imu::run(Microseconds now) {
  std::array<std::byte, burst_size> burst{};
  const EdgeTimer::Edge count = data_ready_.now();
  const bool others = data_ready_.take_overrun();
  EdgeTimer::Edge edge = data_ready_.last_edge();
  bool answered = registers_.read(icm::temperature_data, burst);
  if (const EdgeTimer::Edge later = data_ready_.last_edge(); answered && later != edge && edges_.trusted()) {
    // A sample came meanwhile: before its counts were read, or behind them. Now it is there, and no other for a while.
    const std::byte flags = burst.back();
    answered = registers_.read(icm::temperature_data, burst);
    burst.back() |= flags;
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
  if ((std::to_integer<std::uint8_t>(burst.back()) & icm::reset_done) != 0) {
    restart();  // a brown-out of its own: it sleeps, with nothing configured
    return;
  }
  take(now, burst,
       {.count = edge, .time = now + Microseconds{static_cast<std::int32_t>(edge - count)}, .others = others});
  if (now - last_new_ > longest_without_sample) {
    restart();
  }
}

void Imu::take(Microseconds now, std::span<const std::byte> burst, const LatestEdge& edge) {
  const auto data = burst.subspan<2, 12>();  // behind the temperature
  const bool ready = (std::to_integer<std::uint8_t>(burst.back()) & icm::data_ready) != 0;
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
