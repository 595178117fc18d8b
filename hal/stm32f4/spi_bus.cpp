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
  // What a transfer that was given up has left behind. Reading DR and then SR also clears an overrun.
  if (block_.sr.any(received | overrun)) {
    static_cast<void>(block_.dr.read());
    static_cast<void>(block_.sr.read());
  }
  return true;
}

bool SpiBus::exchange(const SpiSegment& segment) {
  const std::size_t size = std::max(segment.out.size(), segment.in.size());
  for (std::size_t i = 0; i < size; ++i) {
    if (!wait_for(block_.sr, transmit_empty, transmit_empty, most_looks_)) {
      return false;
    }
    block_.dr.write(i < segment.out.size() ? std::to_integer<std::uint32_t>(segment.out[i]) : 0);
    if (!wait_for(block_.sr, received, received, most_looks_)) {
      return false;
    }
    const std::uint32_t data = block_.dr.read();
    if (i < segment.in.size()) {
      segment.in[i] = static_cast<std::byte>(data);
    }
  }
  return true;
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
  bool done = std::ranges::all_of(segments, [this](const SpiSegment& segment) { return exchange(segment); });
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
