// SPDX-License-Identifier: MIT
#include "fake_spi.hpp"

#include <algorithm>

namespace fantail::hal::stm32f4::test {
namespace {

using namespace registers::spi;

constexpr std::uint64_t looks_per_byte = 3;
constexpr std::uint64_t looks_of_the_last_edge = 2;  // RXNE comes half a clock before the last edge, BSY goes after it

std::uint32_t speed_and_mode(std::uint32_t control) {
  return control & (clock_phase | clock_polarity | prescaler_mask | master | software_select | internal_select);
}

}  // namespace

FakePort::FakePort(RegisterWorld& world) {
  world.on_write(block_.bsrr, [this](std::uint32_t value) {
    const std::uint32_t before = level_;
    level_ = ((level_ & ~(value >> 16U)) | value) & 0xFFFFU;
    for (const auto& [pin, watcher] : watchers_) {
      if (((before ^ level_) >> pin & 1U) != 0) {
        watcher((level_ >> pin & 1U) != 0);
      }
    }
  });
}

FakeSpi::FakeSpi(RegisterWorld& world, std::uint32_t bus_hz, BusClocks clocks)
    : bus_hz_{bus_hz}, clocks_{std::move(clocks)} {
  world.on_read(block_.sr, [this] { return look(); });
  world.on_read(block_.cr1, [this] { return control_; });
  world.on_write(block_.cr1, [this](std::uint32_t value) { write_control(value); });
  world.on_write(block_.dr, [this](std::uint32_t value) { write_data(value); });
  world.on_read(block_.dr, [this] { return read_data(); });
}

void FakeSpi::attach(FakePort& port, std::uint8_t pin, SpiSlave& slave) {
  port.watch(pin, [this, &slave](bool level) { select(slave, level); });
}

std::uint32_t FakeSpi::clock_hz() const { return bus_hz_ >> (((control_ & prescaler_mask) >> prescaler_shift) + 1U); }

void FakeSpi::select(SpiSlave& slave, bool level) {
  follow();
  if (is_busy()) {
    violations.emplace_back("chip select moved while the block was busy");
  }
  if (level) {
    std::erase(selected_, &slave);
    slave.deselected();
    return;
  }
  selected_.push_back(&slave);
  if (selected_.size() > 1) {
    violations.emplace_back("two devices selected at once");
  }
  clocked_ = false;
  selected_at_ = now();
  slave.selected();
}

std::uint32_t FakeSpi::look() {
  looks_ += 1;
  follow();
  const std::uint32_t status = (full_ ? received : 0) | (waiting_ || stopped_ ? 0 : transmit_empty) |
                               (overrun_ ? overrun : 0) | (is_busy() ? busy : 0);
  if (data_was_read_) {
    overrun_ = false;
  }
  data_was_read_ = false;
  return status;
}

// What has ended since somebody looked.
void FakeSpi::follow() {
  while (shifting_ && !stopped_ && now() >= ends_at_) {
    if (full_) {
      overrun_ = true;  // and what came is lost
    } else {
      received_ = *shifting_;
      full_ = true;
    }
    shifting_.reset();
    if (on_byte) {
      on_byte();
    }
    idle_at_ = ends_at_ + (clocks_ ? std::uint64_t{bus_hz_ / clock_hz() / 2} : looks_of_the_last_edge);
    if (waiting_) {
      const std::uint8_t next = *waiting_;
      waiting_.reset();
      begin(next, ends_at_);
    }
  }
}

void FakeSpi::write_control(std::uint32_t value) {
  follow();
  const bool is_on = (control_ & enable) != 0;
  if (is_on && is_busy() && !stopped_) {
    violations.emplace_back("CR1 written while busy");
  }
  if (is_on && speed_and_mode(value) != speed_and_mode(control_)) {
    violations.emplace_back("mode or speed changed while enabled");
  }
  if ((value & enable) == 0) {
    shifting_.reset();
    waiting_.reset();
    idle_at_ = 0;
  }
  if (!selected_.empty()) {
    violations.emplace_back("CR1 written while a device was selected");
  }
  control_ = value;
}

void FakeSpi::write_data(std::uint32_t value) {
  constexpr std::uint32_t runs = enable | master | software_select | internal_select;
  if ((control_ & runs) != runs) {
    violations.emplace_back("data written to a block that is not an enabled master");
    return;
  }
  follow();
  const auto out = static_cast<std::uint8_t>(value);
  if (!shifting_) {
    begin(out, now());
  } else if (!waiting_) {
    waiting_ = out;
  } else {
    violations.emplace_back("data written into a full transmit buffer");
  }
  for (int i = 0; i < interrupt_looks_; ++i) {
    static_cast<void>(look());
  }
}

std::uint32_t FakeSpi::read_data() {
  follow();
  full_ = false;
  data_was_read_ = true;
  return received_;
}

void FakeSpi::begin(std::uint8_t out, std::uint64_t at) {
  bytes_ += 1;
  wire_us_ += 8.0e6 / clock_hz();
  ends_at_ = at + (clocks_ ? 8ULL * (bus_hz_ / clock_hz()) : looks_per_byte);
  shifting_ = 0xFF;  // nobody drives the line: its pull-up does
  for (SpiSlave* slave : selected_) {
    const SpiSlave::Needs needs = slave->needs();
    const auto mode =
        static_cast<std::uint8_t>((control_ & clock_phase ? 1U : 0U) | (control_ & clock_polarity ? 2U : 0U));
    if (!std::ranges::count(needs.modes, mode)) {
      violations.emplace_back("a device was spoken to in a mode that it does not understand");
    }
    if (clock_hz() > needs.most_hz) {
      violations.emplace_back("a device was clocked too fast");
    }
    // One look is at least one cycle of the bus clock.
    if (!clocked_ && static_cast<double>(at - selected_at_) / bus_hz_ * 1e9 < needs.select_ns) {
      violations.emplace_back("a device was clocked too soon after its chip select");
    }
    shifting_ = slave->exchange(out);
  }
  if (selected_.empty()) {
    violations.emplace_back("a byte was sent to nobody");
  }
  clocked_ = true;
}

}  // namespace fantail::hal::stm32f4::test
