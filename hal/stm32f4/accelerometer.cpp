// SPDX-License-Identifier: MIT
#include "hal/stm32f4/accelerometer.hpp"

#include "hal/stm32f4/kx134.hpp"

namespace fantail::hal::stm32f4 {
namespace {

// On and in full resolution, data-ready reported, 32 g.
constexpr std::uint8_t control_1_value = 0xF0;
// 1600 Hz, low-pass at a ninth of it.
constexpr std::uint8_t output_rate_value = 0x0B;

constexpr Microseconds reset_time{2'000};      // TN027
constexpr Microseconds longest_reset{60'000};  // at power-up it takes up to 50 ms to answer (TN027)
constexpr Microseconds longest_without_sample{10'000};
constexpr std::uint8_t most_misses = 5;

}  // namespace

AccelerometerSample Accelerometer::read() {
  const Microseconds now = clock_.now();
  switch (stage_) {
    case Stage::adopt: adopt(now); break;
    case Stage::reset: reset(); break;
    case Stage::wait_for_reset: wait_for_reset(now); break;
    case Stage::running: run(now); break;
  }
  return sample_;
}

float Accelerometer::scale() const {
  constexpr float full_scale_m_s2 = 32.0F * 9.80665F;
  return full_scale_m_s2 / 32768.0F;
}

BoardFaults Accelerometer::faults() const {
  BoardFaults faults;
  if (silent_) {
    faults.add(BoardFault::accelerometer_silent);
  }
  if (wrong_id_) {
    faults.add(BoardFault::accelerometer_wrong_id);
  }
  if (counts_.frozen()) {
    faults.add(BoardFault::accelerometer_frozen);
  }
  return faults;
}

void Accelerometer::restart() {
  sample_.status = Status::no_reading;
  stage_ = Stage::reset;
}

void Accelerometer::begin_running(Microseconds now) {
  stage_ = Stage::running;
  last_new_ = now;
  misses_ = 0;
}

bool Accelerometer::check_id(std::uint8_t id) {
  if (id == kx134::id) {
    return true;
  }
  // What a line reads that nobody drives, or that is held down.
  silent_ = id == 0x00 || id == 0xFF;
  wrong_id_ = !silent_;
  return false;
}

void Accelerometer::adopt(Microseconds now) {
  if (registers_.read(kx134::who_am_i) == kx134::id && registers_.read(kx134::control_1) == control_1_value &&
      registers_.read(kx134::output_rate) == output_rate_value) {
    begin_running(now);
  } else {
    restart();
  }
}

void Accelerometer::reset() {
  if (!registers_.write(kx134::unnamed, 0) || !registers_.write(kx134::control_2, 0) ||
      !registers_.write(kx134::control_2, kx134::soft_reset)) {
    silent_ = true;
    return;
  }
  reset_at_ = clock_.now();  // from the end of the command on
  stage_ = Stage::wait_for_reset;
}

void Accelerometer::wait_for_reset(Microseconds now) {
  if (now - reset_at_ <= reset_time) {
    return;
  }
  const auto id = registers_.read(kx134::who_am_i);
  const auto control = registers_.read(kx134::control_1);
  if (id == kx134::id && control && *control != 0) {
    restart();  // it was not listening when it was told to reset
    return;
  }
  // The rate only changes while the device stands by, as it does after a reset and at power-up.
  if (id == kx134::id && registers_.read(kx134::command_test_response) == kx134::test_response &&
      registers_.write(kx134::output_rate, output_rate_value) && registers_.write(kx134::control_1, control_1_value) &&
      registers_.read(kx134::output_rate) == output_rate_value &&
      registers_.read(kx134::control_1) == control_1_value) {
    begin_running(now);
  } else if (now - reset_at_ > longest_reset) {
    silent_ = check_id(id.value_or(0)) || silent_;
    restart();
  }
}

void Accelerometer::miss() {
  sample_.status = wrong_id_ ? Status::error : Status::no_reading;
  misses_ += 1;
  if (misses_ >= most_misses) {
    silent_ = !wrong_id_;
    restart();
  }
}

void Accelerometer::run(Microseconds now) {
  // From the id to the data-ready flag: five registers in one go.
  std::array<std::byte, kx134::interrupt_source_2 - kx134::who_am_i + 1> state{};
  const bool answered = registers_.read(kx134::who_am_i, state);
  if (!check_id(answered ? std::to_integer<std::uint8_t>(state.front()) : 0)) {
    miss();
    return;
  }
  if ((std::to_integer<std::uint8_t>(state.back()) & kx134::data_ready) != 0) {
    std::array<std::byte, 6> data{};
    if (!registers_.read(kx134::output, data)) {
      miss();
      return;
    }
    Counts counts{};
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const auto low = std::to_integer<std::uint16_t>(data[2 * i]);
      const auto high = std::to_integer<std::uint16_t>(data[2 * i + 1]);
      counts[i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(high << 8U | low));
    }
    take(now, counts);
  }
  misses_ = 0;
  silent_ = false;
  wrong_id_ = false;
  // Also what a device does that has reset itself: it stands by.
  if (now - last_new_ > longest_without_sample) {
    restart();
  }
}

void Accelerometer::take(Microseconds now, const Counts& counts) {
  last_new_ = now;
  if (counts_.update(counts)) {
    stage_ = Stage::reset;
  }
  sample_ = {
      .time = now - age_when_found, .specific_force = counts, .status = counts_.frozen() ? Status::error : Status::ok};
}

}  // namespace fantail::hal::stm32f4
