// SPDX-License-Identifier: MIT
#include "board_in_world.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "avionics/can_frame.hpp"
#include "avionics/flash_access.hpp"
#include "avionics/plan_store.hpp"
#include "protocol/bus_codec.hpp"
#include "protocol/plan_block.hpp"
#include "text/error.hpp"

namespace fantail::board {
namespace {

constexpr double tick_s = 1e-3;
constexpr double most_start_s = 5.0;
/// Behind the end of a tick: the next one has not begun, and a longer one would have ended.
constexpr double idle_s = 0.2e-3;
constexpr double standard_gravity_m_s2 = 9.80665;
/// A servo that has heard none for so long is on its own: fifteen frames.
constexpr double silence_s = 0.045;
constexpr int counts_per_turn = hal::encoder_counts_per_turn;
/// An encoder without noise at 0 is as a line that is held down.
constexpr int least_counts = 1;
constexpr const char* wait_function = "_ZN7fantail6boards9stm32f4058Hardware13wait_for_tickEv";
constexpr const char* tick_function = "_ZN7fantail8avionics8Avionics4tickEv";

// Read out of the memory of a 32-bit processor: no pointers in it, and every type as long there as here.
static_assert(std::is_trivially_copyable_v<core::TickRecord>);

std::array<double, 3> times(const hal::Counts& counts, double scale) {
  return {counts[0] * scale, counts[1] * scale, counts[2] * scale};
}

hal::ResetCause cause_of(ResetKind kind) {
  switch (kind) {
    case ResetKind::power_on: return hal::ResetCause::power_on;
    case ResetKind::brown_out: return hal::ResetCause::brown_out;
    case ResetKind::pin: return hal::ResetCause::pin;
    case ResetKind::software: return hal::ResetCause::software;
    case ResetKind::watchdog: break;
  }
  return hal::ResetCause::watchdog;
}

std::uint32_t function_of(const Image& image, const char* name) {
  const auto address = image.address_of(name);
  if (!address) {
    throw text::Error{text::ErrorKind::bad_data,
                      fmt::format("{}: no avionics is in it: there is no function {}", image.file().string(), name)};
  }
  return *address;
}

constexpr double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

}  // namespace

std::vector<std::byte> new_flash() { return std::vector<std::byte>(hal::sim::flash_16_mib.size, std::byte{0xFF}); }

std::vector<std::byte> flash_with(const core::FlightPlan& plan, const hal::FlashGeometry& geometry) {
  hal::sim::Flash cells{geometry};
  avionics::FlashAccess access{cells};
  avionics::PlanStore store{access};
  (void)store.load({});
  std::array<std::byte, protocol::largest_plan_block> block{};
  store.begin_write(std::span{block}.first(protocol::write_plan_block(plan, block)));
  while (store.write() == avionics::PlanWrite::under_way) {
    store.update({});
  }
  return {cells.cells().begin(), cells.cells().end()};
}

BoardInWorld::BoardInWorld(const Image& image, const Pace& pace, const core::FlightPlan& plan,
                           const sim::BoardPorts& ports)
    : BoardInWorld{image, pace, flash_with(plan, ports.flash.geometry()), ports} {
  board_.flash.on_change = [this](std::size_t address, std::size_t size) { mirror(address, size); };
}

BoardInWorld::BoardInWorld(const Image& image, const Pace& pace, std::vector<std::byte> flash,
                           const sim::BoardPorts& ports)
    : image_{image}, board_{image, pace}, ports_{ports} {
  board_.processor.on_return_of(function_of(image, wait_function), [this](std::uint32_t) { has_begun_ = true; });
  board_.processor.on_return_of(function_of(image, tick_function),
                                [this](std::uint32_t record) { take_record(record); });
  board_.barometer.noise_counts = 10.0;
  for (devices::FakeAs5047p& encoder : board_.encoders) {
    encoder.angle = least_counts;
  }
  board_.flash.id[2] = static_cast<std::uint8_t>(std::bit_width(flash.size()) - 1);
  board_.flash.cells = std::move(flash);
  board_.imu.force_g = board_.second_imu.force_g = board_.accelerometer.force_g = {1.0, 0.0, 0.0};
  board_.switch_on();
}

const core::TickRecord& BoardInWorld::tick() {
  show_world();
  while (!board_.bus_is_full()) {
    const auto frame = ports_.can_bus.receive();
    if (!frame) {
      break;
    }
    board_.send(*frame);
  }
  until_s_ += tick_s;
  has_begun_ = has_record_ = false;
  board_.run_until(until_s_);
  note_attendance();
  for (const hal::CanFrame& frame : board_.take_sent()) {
    (void)ports_.can_bus.send(frame);
    note_report(frame);
  }
  if (!board_.console.empty()) {
    ports_.console.write(std::exchange(board_.console, {}));
  }
  hear_pulses();
  return record_;
}

// From its power-up on there are none for as long as it starts. A tick may end in the millisecond behind the one in
// which it began. The world's ticks follow those of a board that has begun anew, which are at other instants.
void BoardInWorld::note_attendance() {
  const bool had_tick_before = hardware_.had_tick;
  hardware_.had_tick = has_record_ || (had_tick_before && has_begun_);
  if (had_tick_before) {
    hardware_.restarted_by.reset();
  }
  for (; restarts_ < board_.restarts.size(); ++restarts_) {
    hardware_.restarted_by = cause_of(board_.restarts[restarts_].kind);
  }
  if (!has_ever_ticked_ && !has_record_ && board_.now_s() > most_start_s) {
    throw text::Error{text::ErrorKind::bad_data, fmt::format("the image has not come to its first tick in {} s; {}",
                                                             most_start_s, board_.state(image_))};
  }
  has_ever_ticked_ = has_ever_ticked_ || has_record_;
  if (has_record_ && !had_tick_before) {
    until_s_ = last_tick_ended_s_ + idle_s;
    board_.run_until(until_s_);
  }
}

void BoardInWorld::show_world() {
  board_.accelerometer.noisy = false;  // the world's sensors are noisy enough
  board_.imu.gyro_noise_deg_s = board_.imu.accelerometer_noise_g = 0.0;
  board_.second_imu.noise_counts = 0.0;
  const auto show = [](auto& device, const hal::ImuSample& sample, const hal::ImuScale& scale) {
    device.rate_deg_s = times(sample.rate, degrees(double{scale.rate_rad_s}));
    device.force_g = times(sample.specific_force, double{scale.specific_force_m_s2} / standard_gravity_m_s2);
  };
  show(board_.imu, hardware_.imu, hardware_.imu_scale);
  // One that is dead has no time either, and the device here answers nothing at all.
  const auto repeats = [](auto& device, const auto& sample, core::Microseconds& before) {
    const bool dead = sample.status == hal::Status::no_reading;
    device.stuck_at = dead ? std::optional<std::uint8_t>{0} : std::nullopt;
    return !dead && std::exchange(before, sample.time) == sample.time;
  };
  board_.imu.frozen = repeats(board_.imu, hardware_.imu, imu_time_);
  board_.second_imu.stopped = !hardware_.second_imu_is_fitted;
  board_.barometer.stuck_at = hardware_.barometer_is_fitted ? std::nullopt : std::optional<std::uint8_t>{0xFF};
  if (hardware_.second_imu_is_fitted) {
    show(board_.second_imu, hardware_.second_imu, hardware_.second_imu_scale);
    board_.second_imu.stopped = repeats(board_.second_imu, hardware_.second_imu, second_imu_time_);
  }
  board_.accelerometer.force_g =
      times(hardware_.accelerometer.specific_force, double{hardware_.accelerometer_scale_m_s2} / standard_gravity_m_s2);
  board_.accelerometer.frozen = repeats(board_.accelerometer, hardware_.accelerometer, accelerometer_time_);
  if (hardware_.barometer_is_fitted) {
    board_.barometer.pressure_pa = hardware_.barometer.pressure_pa;
  }
  for (std::size_t i = 0; i < hal::canards; ++i) {
    const hal::EncoderSample& sample = hardware_.encoders.each[i];
    board_.encoders[i].angle = sample.counts;
    board_.encoders[i].stuck_at =
        sample.status == hal::Status::no_reading ? std::optional<std::uint8_t>{0} : std::nullopt;
  }
  board_.arm_switch_closed = hardware_.arm_switch_closed;
  board_.abort_contact_closed = hardware_.abort_contact_closed;
}

void BoardInWorld::hear_pulses() {
  board_.chip.follow();
  const std::vector<HeardPulse>& pulses = board_.chip.pulses();
  for (; heard_ < pulses.size(); ++heard_) {
    const HeardPulse& pulse = pulses[heard_];
    hardware_.pulses[pulse.line] = hal::Pulse{std::lround(1e3 * pulse.width_us)};
    heard_s_[pulse.line] = pulse.end_s();
  }
  for (std::size_t i = 0; i < hal::canards; ++i) {
    if (board_.now_s() - heard_s_[i] > silence_s) {
      hardware_.pulses[i].reset();
    }
  }
}

void BoardInWorld::note_report(const hal::CanFrame& frame) {
  const auto decoded = protocol::decode_from_avionics(avionics::bus_frame(frame));
  if (decoded.message) {
    if (const auto* report = std::get_if<protocol::BoardReport>(&*decoded.message)) {
      report_ = *report;
    }
  }
}

void BoardInWorld::mirror(std::size_t address, std::size_t size) {
  const auto place = static_cast<std::uint32_t>(address);
  if (size == ports_.flash.geometry().page_size) {
    (void)ports_.flash.program(place, std::span{board_.flash.cells}.subspan(address, size));
  } else {
    (void)ports_.flash.erase_sector(place);
  }
}

void BoardInWorld::take_record(std::uint32_t address) {
  core::TickRecord record;
  try {
    board_.processor.read_memory(address, std::as_writable_bytes(std::span{&record, 1}));
  } catch (const std::out_of_range&) {
    return;  // a bit of the register that leads there has flipped
  }
  record_ = record;
  has_record_ = true;
  last_tick_ended_s_ = board_.now_s();
}

core::Microseconds BoardInWorld::restart(const sim::Reset& /*reset*/) {
  throw text::Error{
      text::ErrorKind::bad_configuration,
      "faults.kind = \"reset\" cannot be flown on a virtual board: what resets the flashed image takes its own time"};
}

}  // namespace fantail::board
