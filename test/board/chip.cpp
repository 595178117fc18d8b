// SPDX-License-Identifier: MIT
#include "chip.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "hal/stm32f4/registers/rcc.hpp"

namespace fantail::board {

using devices::RegisterWorld;
using namespace hal::stm32f4::registers;  // NOLINT(google-build-using-namespace): the names of their bits

namespace {

constexpr std::uint32_t apb1_hz = 42'000'000;
constexpr std::uint32_t apb2_hz = 84'000'000;

// In clocks of a bus at its full speed. Without its crystal the processor is slower, and so are they: the wire then
// takes longer than is counted here.
devices::FakeSpi::BusClocks clocks_of(const Timeline& timeline, std::uint32_t bus_hz) {
  return [&timeline, bus_hz] { return static_cast<std::uint64_t>(timeline.now_s() * bus_hz); };
}

std::uint32_t flags_of(ResetKind kind) {
  // Every reset pulls the pin, too.
  switch (kind) {
    case ResetKind::power_on: return rcc_csr_porrst | rcc_csr_borrst | rcc_csr_pinrst;
    case ResetKind::brown_out: return rcc_csr_borrst | rcc_csr_pinrst;
    case ResetKind::pin: return rcc_csr_pinrst;
    case ResetKind::software: return rcc_csr_sftrst | rcc_csr_pinrst;
    case ResetKind::watchdog: return rcc_csr_iwdgrst | rcc_csr_pinrst;
  }
  return 0;
}

}  // namespace

ResetDomain::ResetDomain(RegisterWorld& world, const Timeline& timeline, const devices::FakeClock& clock,
                         devices::FakeCapture::Line imu_line)
    : clocks{world},
      port_a{world},
      port_b{world},
      port_c{world},
      spi_1{world, apb2_hz, clocks_of(timeline, apb2_hz)},
      spi_2{world, apb1_hz, clocks_of(timeline, apb1_hz)},
      spi_3{world, apb1_hz, clocks_of(timeline, apb1_hz)},
      capture{world, clock, 2.0 * apb1_hz, std::move(imu_line)},
      usart{world},
      converter{world},
      random{world},
      watchdog{world},
      slow_oscillator{world, clocks.rcc, [&timeline] { return timeline.now_s(); }},
      can{world, can_registers} {
  clocks.now_s = [&timeline] { return timeline.now_s(); };
}

Chip::Chip(Timeline& timeline, AddressSpace& space, devices::FakeCapture::Line imu_line)
    : timeline_{timeline}, imu_line_{std::move(imu_line)} {
  domain.emplace(world, timeline_, clock, imu_line_);
  add_blocks(space);
}

void Chip::add_blocks(AddressSpace& space) {
  ResetDomain& in = *domain;
  space.add(0x4000'0000, in.capture.registers);
  space.add(0x4000'0C00, in.slow_oscillator.tim5);
  space.add(0x4000'2800, backup.device);
  space.add(0x4000'3000, in.watchdog.registers);
  space.add(0x4000'3800, in.spi_2.block());
  space.add(0x4000'3C00, in.spi_3.block());
  space.add(0x4000'6400, in.can_registers);
  space.add(0x4000'7000, supply.power);
  space.add(0x4001'0000, in.buzzer);
  space.add(0x4001'0400, servo_timer_.registers);
  space.add(0x4001'1000, in.usart.port);
  space.add(0x4001'2000, in.converter.registers);
  space.add(0x4001'2300, in.converter.common);
  space.add(0x4001'3000, in.spi_1.block());
  space.add(0x4001'3C00, supply.lines);
  space.add(0x4002'0000, in.port_a.block());
  space.add(0x4002'0400, in.port_b.block());
  space.add(0x4002'0800, in.port_c.block());
  space.add(0x4002'3870, backup.rcc.bdcr);
  space.add(0x4002'3800, in.clocks.rcc);
  space.add(0x4002'3C00, in.clocks.flash);
  space.add(0x5006'0800, in.random.registers);
}

void Chip::reset(ResetKind kind) {
  for (devices::FakePort* port : {&domain->port_a, &domain->port_b, &domain->port_c}) {
    port->block().bsrr.write(0xFFFF);  // nobody stays selected
  }
  const double slow_hz = domain->slow_oscillator.hz;
  domain.emplace(world, timeline_, clock, imu_line_);
  domain->slow_oscillator.hz = domain->watchdog.oscillator_hz = slow_hz;
  backup.reset_of_the_processor();
  RegisterWorld::poke(domain->clocks.flash.optcr, 0x0FFF'AAE1);  // option bytes: brown-out level 3, BOR_LEV 0
  reset_flags_ = kind == ResetKind::power_on ? flags_of(kind) : reset_flags_ | flags_of(kind);
  Register& csr = domain->clocks.rcc.csr;
  world.on_write(csr, [this, &csr](std::uint32_t value) {
    RegisterWorld::poke(csr, value & rcc_csr_lsion);
    reset_flags_ = (value & rcc_csr_rmvf) != 0 ? 0 : reset_flags_;
  });
  world.on_read(csr, [this, &csr] {
    const std::uint32_t on = RegisterWorld::peek(csr) & rcc_csr_lsion;
    return on | (on != 0 ? rcc_csr_lsirdy : 0U) | reset_flags_;
  });
  servo_timer_.reset();
  hear_pulses();
  timeline_.set_frequency_hz(domain->clocks.core_hz());
}

void Chip::follow() {
  const double now_s = timeline_.now_s();
  const double passed_s = now_s - followed_s_;
  domain->clocks.crystal_starts = crystal_runs;
  domain->clocks.pll_locks = pll_locks;
  followed_s_ = now_s;
  clock.time = hal::Microseconds{static_cast<std::int64_t>(std::floor(now_s * 1e6))};
  timeline_.set_frequency_hz(domain->clocks.core_hz());
  domain->slow_oscillator.timer_hz = domain->clocks.apb1_timers_hz();
  domain->converter.bus_hz = domain->clocks.apb2_hz();
  domain->converter.pass(passed_s);
  domain->watchdog.pass(passed_s);
  backup.pass(passed_s);
  const double timer_hz = domain->clocks.apb2_timers_hz();
  servo_counts_ += passed_s * timer_hz / static_cast<double>(servo_timer_.divider());
  const auto whole = static_cast<std::uint64_t>(servo_counts_);
  servo_counts_ -= static_cast<double>(whole);
  if (paces_.empty() || paces_.back().frequency_hz != timer_hz) {
    paces_.push_back({servo_timer_.clocks(), now_s - passed_s, timer_hz});
  }
  servo_timer_.pass(whole);
  hear_pulses();
}

// Its clocks are of another length while the processor runs on its own oscillator.
double Chip::time_of(std::uint64_t clocks) const {
  const auto after = std::ranges::upper_bound(paces_, clocks, {}, &Pace::clocks);
  const Pace& pace = after == paces_.begin() ? paces_.front() : *std::prev(after);
  return pace.time_s + static_cast<double>(clocks - pace.clocks) / pace.frequency_hz;
}

void Chip::hear_pulses() {
  const auto& all = servo_timer_.pulses();
  for (; converted_ < all.size(); ++converted_) {
    const devices::FakeTimer::Pulse& pulse = all[converted_];
    const double begin_s = time_of(pulse.begin);
    pulses_.push_back({.line = pulse.line,
                       .begin_s = begin_s,
                       .width_us = 1e6 * (time_of(pulse.begin + pulse.width) - begin_s),
                       .whole = pulse.whole});
  }
}

}  // namespace fantail::board
