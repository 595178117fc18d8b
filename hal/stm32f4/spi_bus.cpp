// SPDX-License-Identifier: MIT
#include "hal/stm32f4/spi_bus.hpp"

#include <algorithm>

namespace fantail::hal::stm32f4 {
namespace {

using namespace registers::spi;
using registers::wait_for;

constexpr std::uint32_t slowest_prescaler = 7;

}  // namespace

std::uint32_t SpiBus::prescaler(const SpiSettings& settings) const {
  std::uint32_t result = 0;
  while (result < slowest_prescaler && (bus_hz_ >> (result + 1)) > settings.most_hz) {
    ++result;
  }
  return result;
}

std::uint32_t SpiBus::clock_hz(const SpiSettings& settings) const { return bus_hz_ >> (prescaler(settings) + 1); }

bool SpiBus::prepare(const SpiSettings& settings) {
  const std::uint32_t divider = prescaler(settings);
  const std::uint32_t mode = static_cast<std::uint32_t>(settings.mode);
  const std::uint32_t control = (mode & 1U ? clock_phase : 0) | (mode & 2U ? clock_polarity : 0) | master |
                                (divider << prescaler_shift) | internal_select | software_select;
  // A look takes at least one cycle of the bus clock: it is a read across that bus. So many looks last longer than a
  // byte and a half, and a block that never answers costs no more than about a dozen bytes would.
  most_looks_ = 24U << divider;
  if (control_ != control) {
    // Section 28.5.1: mode and prescaler must not change while the block is enabled, and 28.3.8: it must not be
    // disabled while it is busy, unless it never ends to be.
    control_.reset();
    const bool idle = wait_for(block_.sr, busy, 0, most_looks_);
    block_.cr1.clear(enable);
    if (!idle) {
      return false;
    }
    block_.cr2.write(0);
    block_.cr1.write(control);
    block_.cr1.write(control | enable);
    control_ = control;
  }
  if (block_.sr.any(received | overrun)) {
    drop_received();  // what a transfer that was given up has left behind
  }
  return true;
}

// Section 28.3.7, transmit-only procedure: the next byte is written while one is under way, and the wire never rests.
// What comes in meanwhile overruns, and is dropped at the end.
bool SpiBus::send(std::span<const std::byte> out) {
  registers::Spi& block = block_;
  for (const std::byte byte : out) {
    if (!wait_for(block.sr, transmit_empty, transmit_empty, most_looks_)) {
      return false;
    }
    block.dr.write(std::to_integer<std::uint32_t>(byte));
  }
  const bool done = wait_for(block.sr, transmit_empty | busy, transmit_empty, 2 * most_looks_);
  drop_received();
  return done;
}

// One byte at a time: if the next one were written before this one is read, an interrupt longer than a byte (0.4 us at
// 21 MHz) would lose one.
bool SpiBus::exchange(const SpiSegment& segment) {
  registers::Spi& block = block_;
  const std::uint32_t most_looks = most_looks_;
  const std::span<const std::byte> out = segment.out;
  const std::span<std::byte> in = segment.in;
  const std::size_t size = std::max(out.size(), in.size());
  if (!wait_for(block.sr, transmit_empty, transmit_empty, most_looks)) {
    return false;
  }
  for (std::size_t i = 0; i < size; ++i) {
    block.dr.write(i < out.size() ? std::to_integer<std::uint32_t>(out[i]) : 0);
    if (!wait_for(block.sr, received, received, most_looks)) {
      return false;
    }
    const std::uint32_t data = block.dr.read();
    if (i < in.size()) {
      in[i] = static_cast<std::byte>(data);
    }
  }
  return true;
}

// Reading DR and then SR also clears an overrun (section 28.3.10).
void SpiBus::drop_received() {
  static_cast<void>(block_.dr.read());
  static_cast<void>(block_.sr.read());
}

bool SpiBus::transfer(const SpiSettings& settings, Pin& select, std::span<const SpiSegment> segments) {
  if (!prepare(settings)) {
    return false;
  }
  select.low();
  constexpr std::uint32_t kilo = 1000;
  constexpr std::uint32_t mega = 1'000'000;
  for (std::uint32_t look = 0; look < settings.select_ns * (bus_hz_ / mega) / kilo + 1; ++look) {
    static_cast<void>(block_.sr.read());
  }
  bool done = std::ranges::all_of(segments, [this](const SpiSegment& segment) {
    return segment.in.empty() ? send(segment.out) : exchange(segment);
  });
  // The last byte has been received half a clock before its last edge: a device that is deselected before that would
  // count too few edges.
  done = wait_for(block_.sr, busy, 0, most_looks_) && done;
  select.high();
  if (!done) {
    control_.reset();  // the next transfer begins with a block that was switched off and on
  }
  return done;
}

}  // namespace fantail::hal::stm32f4
