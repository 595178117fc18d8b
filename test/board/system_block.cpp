// SPDX-License-Identifier: MIT
#include "system_block.hpp"

#include <algorithm>
#include <bit>

namespace fantail::board {

using hal::stm32f4::test::RegisterWorld;
using namespace hal::stm32f4::registers;  // NOLINT(google-build-using-namespace): the names of their bits

SystemBlock::SystemBlock(RegisterWorld& world, Timeline& timeline)
    : timeline_{timeline}, zero_{timeline.add([this] {
        systick_pends_ = systick_pends_ || (ctrl_ & systick_ctrl_tickint) != 0;
        round_ends_ += counts_per_round();
        timeline_.schedule_at_counts(zero_, round_ends_);
      })} {
  RegisterWorld::poke(control_.cpuid, 0x410F'C241);
  world.on_read(timer_.ctrl, [this] { return ctrl_; });
  world.on_write(timer_.ctrl, [this](std::uint32_t value) {
    const bool starts = (value & ~ctrl_ & systick_ctrl_enable) != 0;
    ctrl_ = value;
    if (starts) {
      start_systick();
    } else if ((value & systick_ctrl_enable) == 0) {
      timeline_.cancel(zero_);
    }
  });
  world.on_write(timer_.load, [this](std::uint32_t value) { load_ = value & systick_load_most; });
  world.on_read(timer_.load, [this] { return load_; });
  world.on_write(timer_.val, [this](std::uint32_t) {
    if ((ctrl_ & systick_ctrl_enable) != 0) {
      start_systick();
    }
  });
  world.on_read(timer_.val, [this] { return systick_value(); });
  world.on_read(control_.icsr, [this] { return active_ | (systick_pends_ ? scb_icsr_pendstset : 0U); });
  world.on_write(control_.aircr, [this](std::uint32_t value) {
    if ((value & 0xFFFF'0000U) == scb_aircr_vectkey && (value & scb_aircr_sysresetreq) != 0) {
      reset_asked_ = true;
      if (on_reset_request) {
        on_reset_request();
      }
    }
  });
  for (Register& priority : control_.shpr) {
    world.on_write(priority, [this, &priority](std::uint32_t value) {
      if (value != 0) {
        doubts.push_back("the firmware gives an exception a priority, and this board treats all alike");
      }
      RegisterWorld::poke(priority, value);
    });
  }
  for (std::size_t i = 0; i < enabled_.size(); ++i) {
    world.on_read(nvic_.iser[i], [this, i] { return enabled_[i]; });
    world.on_write(nvic_.iser[i], [this, i](std::uint32_t bits) { enabled_[i] |= bits; });
    world.on_write(nvic_.icer[i], [this, i](std::uint32_t bits) { enabled_[i] &= ~bits; });
    world.on_read(nvic_.ispr[i], [this, i] { return pending_[i]; });
    world.on_write(nvic_.ispr[i], [this, i](std::uint32_t bits) { pending_[i] |= bits; });
  }
  world.on_write(dwt_.cyccnt, [this](std::uint32_t value) {
    counter_began_ = timeline_.counts() - value * Timeline::counts_per_cycle;
  });
  world.on_read(dwt_.cyccnt, [this] {
    return static_cast<std::uint32_t>((timeline_.counts() - counter_began_) / Timeline::counts_per_cycle);
  });
}

void SystemBlock::add_to(AddressSpace& space) {
  space.add(0xE000'1000, dwt_);
  space.add(0xE000'E010, timer_);
  space.add(0xE000'E100, nvic_);
  space.add(0xE000'ED00, control_);
  space.add(0xE000'ED88, coprocessors_);
  space.add(0xE000'ED90, mpu_);
  space.add(0xE000'EDF0, debug_);
}

void SystemBlock::attach(std::uint32_t number, std::function<bool()> level) {
  lines_.push_back({number, std::move(level)});
}

void SystemBlock::set_fault(std::uint32_t configurable, std::uint32_t address) {
  RegisterWorld::poke(control_.cfsr, configurable);
  RegisterWorld::poke(control_.hfsr, 1U << 30U);  // FORCED: the firmware enables no handler of its own for the others
  RegisterWorld::poke(control_.bfar, address);
}

std::optional<std::uint32_t> SystemBlock::waiting() {
  if (nmi_pends_ && active_ != nmi) {
    return nmi;
  }
  if (active_ != 0) {
    return std::nullopt;
  }
  if (systick_pends_) {
    return systick;
  }
  for (const Line& line : lines_) {
    if (line.level()) {
      pending_[line.number / 32] |= 1U << line.number % 32;
    }
  }
  for (std::uint32_t i = 0; i < pending_.size(); ++i) {
    if (const std::uint32_t both = enabled_[i] & pending_[i]; both != 0) {
      return first_interrupt + 32 * i + static_cast<std::uint32_t>(std::countr_zero(both));
    }
  }
  return std::nullopt;
}

void SystemBlock::begin(std::uint32_t exception) {
  active_ = exception;
  if (exception == nmi) {
    nmi_pends_ = false;
  } else if (exception == systick) {
    systick_pends_ = false;
  } else if (exception >= first_interrupt) {
    const std::uint32_t number = exception - first_interrupt;
    pending_[number / 32] &= ~(1U << number % 32);
  }
}

void SystemBlock::reset() {
  timeline_.cancel(zero_);
  enabled_ = pending_ = {};
  active_ = ctrl_ = load_ = 0;
  nmi_pends_ = systick_pends_ = reset_asked_ = false;
  for (Register* place : {&control_.cfsr, &control_.hfsr, &control_.bfar}) {
    RegisterWorld::poke(*place, 0);
  }
}

// The first round is as long as all others: the counter takes its value one cycle after the start.
void SystemBlock::start_systick() {
  round_ends_ = timeline_.counts() + counts_per_round();
  timeline_.schedule_at_counts(zero_, round_ends_);
}

std::uint32_t SystemBlock::systick_value() const {
  if ((ctrl_ & systick_ctrl_enable) == 0) {
    return 0;
  }
  const std::uint64_t now = timeline_.counts();
  const std::uint64_t left = round_ends_ > now ? round_ends_ - now : 0;
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(left / Timeline::counts_per_cycle, load_));
}

}  // namespace fantail::board
