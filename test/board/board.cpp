// SPDX-License-Identifier: MIT
#include "board.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace fantail::board {
namespace {

constexpr double follow_s = 125e-6;
constexpr double slot_s = 130e-6;  // of a frame of 8 bytes at 1 Mbit/s, with the bits that are stuffed
constexpr double byte_s = 10.0 / 115'200;
constexpr double battery_divider = 11.0;
constexpr std::size_t battery_channel = 12;

enum Interrupt : std::uint8_t { can1_tx = 19, can1_rx0 = 20, can1_sce = 22, usart1 = 37 };

bool is_in(std::uint32_t address, std::uint32_t block) { return address - block < 0x400; }

}  // namespace

Board::Board(const Image& image, const Pace& pace)
    : chip{timeline, space_, [this] { return imu.interrupt_1(); }},
      system{chip.world, timeline},
      processor{image, space_, system, timeline, pace},
      imu{chip.clock},
      second_imu{chip.clock},
      accelerometer{chip.clock},
      barometer{chip.clock},
      flash{chip.clock},
      follow_{timeline.add([this] { follow(); })},
      slot_{timeline.add([this] { pass_slot(); })},
      byte_{timeline.add([this] { pass_byte(); })},
      stop_{timeline.add([this] { stop(); })} {
  system.add_to(space_);
  chip.backup.look_s = 0.0;
  chip.backup.crystal_starts_in_s = 0.5;
  system.attach(can1_tx, [this] { return chip.domain->can.transmit_line(); });
  system.attach(can1_rx0, [this] { return chip.domain->can.receive_line(); });
  system.attach(can1_sce, [this] { return chip.domain->can.error_line(); });
  system.attach(usart1, [this] { return chip.domain->usart.interrupts(); });
  // The buses are fast and the devices behind them count microseconds; what counts clocks is led up to this moment.
  space_.before = [this](std::uint32_t address) {
    chip.clock.time = hal::Microseconds{static_cast<std::int64_t>(timeline.now_s() * 1e6)};
    // Before the clocks change, too: what has passed has passed at the old ones.
    if (is_in(address, 0x4002'3800) || is_in(address, 0x4001'0400) || is_in(address, 0x4000'2800) ||
        is_in(address, 0x4000'3000)) {
      chip.follow();
    }
  };
  space_.after_write = [this](std::uint32_t address) {
    if (is_in(address, 0x4002'3800) || is_in(address, 0x4002'3C00)) {
      chip.follow();
    }
  };
}

void Board::switch_on() { begin(ResetKind::power_on); }

void Board::reset(ResetKind kind) {
  reset_asked_ = kind;
  processor.stop();
}

void Board::begin(ResetKind kind) {
  chip.follow();
  restarts.push_back({timeline.now_s(), kind});
  const std::vector<std::string> found = violations();
  old_violations_.assign(found.begin(), found.end());
  chip.reset(kind);
  connect();
  processor.reset();
  crystal_is_missed_ = false;
  timeline.schedule(follow_, timeline.now_s());
  timeline.schedule(slot_, timeline.now_s() + slot_s);
  timeline.schedule(byte_, timeline.now_s() + byte_s);
}

// As docs/hardware.md.
void Board::connect() {
  ResetDomain& in = *chip.domain;
  const auto at = [this](devices::SpiSlave& device) -> devices::SpiSlave& { return wire ? wire(device) : device; };
  in.spi_1.attach(in.port_a, 4, at(imu));
  in.spi_2.attach(in.port_b, 12, at(encoders[0]));
  in.spi_2.attach(in.port_b, 0, at(encoders[1]));
  in.spi_2.attach(in.port_b, 1, at(encoders[2]));
  in.spi_2.attach(in.port_c, 5, at(encoders[3]));
  in.spi_3.attach(in.port_c, 4, at(accelerometer));
  in.spi_3.attach(in.port_a, 15, at(flash));
  in.spi_3.attach(in.port_b, 11, at(second_imu));
  in.spi_3.attach(in.port_b, 10, at(barometer));
}

void Board::set_crystal(bool runs) {
  chip.follow();
  chip.crystal_runs = runs;
  follow();
}

void Board::run_until(double time_s) {
  if (time_s <= timeline.now_s()) {
    return;
  }
  timeline.schedule(stop_, time_s);
  stopped_ = false;
  while (!stopped_ && timeline.now_s() < time_s) {
    processor.run();
    if (system.reset_asked()) {
      reset_asked_ = ResetKind::software;
    }
    if (reset_asked_) {
      begin(*std::exchange(reset_asked_, std::nullopt));
      timeline.schedule(stop_, time_s);
    }
  }
}

void Board::follow() {
  ResetDomain& in = *chip.domain;
  chip.follow();
  in.converter.volts[battery_channel] = battery_v / battery_divider;
  devices::RegisterWorld::poke(in.port_c.block().idr,
                               (arm_switch_closed ? 1U << 3U : 0U) | (abort_contact_closed ? 0U : 1U << 1U));
  if (in.clocks.crystal_is_watched() && !in.clocks.crystal_starts && !std::exchange(crystal_is_missed_, true)) {
    system.pend_nmi();
  }
  if (in.watchdog.has_reset) {
    reset(ResetKind::watchdog);
  }
  timeline.schedule(follow_, timeline.now_s() + follow_s);
}

// One frame's time on the bus. Who comes next is decided by turns and not by identifiers.
void Board::pass_slot() {
  chip.clock.time = hal::Microseconds{static_cast<std::int64_t>(timeline.now_s() * 1e6)};
  devices::CanModel& can = chip.domain->can;
  own_turn_ = !own_turn_;
  const bool sent = own_turn_ && can.slot();
  if (!sent && !arriving_.empty()) {
    (void)can.arrive(arriving_.front());
    traffic.push_back({timeline.now_s(), arriving_.front()});
    arriving_.pop_front();
  } else if (!sent && !own_turn_) {
    (void)can.slot();
  }
  for (const hal::CanFrame& frame : can.wire) {
    traffic.push_back({timeline.now_s(), frame});
    sent_.push_back(frame);
  }
  can.wire.clear();
  timeline.schedule(slot_, timeline.now_s() + slot_s);
}

void Board::pass_byte() {
  devices::FakeUsart& usart = chip.domain->usart;
  usart.pass_byte();
  console += std::exchange(usart.wire, {});
  timeline.schedule(byte_, timeline.now_s() + byte_s);
}

std::vector<hal::CanFrame> Board::take_sent() { return std::exchange(sent_, {}); }

std::string Board::state(const Image& image) const {
  return fmt::format("it is at {}. {}It said: {}", image.where(processor.program_counter()),
                     processor.complaints.empty() ? "" : "First " + processor.complaints.front().what + ". ", console);
}

std::vector<std::string> Board::violations() const {
  std::set<std::string> all{old_violations_.begin(), old_violations_.end()};
  const auto add = [&all](const char* whose, const std::vector<std::string>& found) {
    for (const std::string& each : found) {
      all.insert(std::string{whose} + ": " + each);
    }
  };
  add("SPI1", chip.domain->spi_1.violations);
  add("SPI2", chip.domain->spi_2.violations);
  add("SPI3", chip.domain->spi_3.violations);
  add("IMU", imu.violations);
  add("second IMU", second_imu.violations);
  add("accelerometer", accelerometer.violations);
  add("barometer", barometer.violations);
  return {all.begin(), all.end()};
}

}  // namespace fantail::board
