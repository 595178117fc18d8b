// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "address_space.hpp"
#include "hal/stm32f4/registers/dwt.hpp"
#include "hal/stm32f4/registers/mpu.hpp"
#include "hal/stm32f4/registers/nvic.hpp"
#include "hal/stm32f4/registers/systick.hpp"
#include "register_world.hpp"
#include "timeline.hpp"

namespace fantail::board {

/// What belongs to the processor and not to the chip: SysTick, the interrupt controller, the system control block, the
/// cycle counter (PM0214 section 4, Armv7-M B3). Which exception waits and which runs is known here; the processor
/// asks. All interrupts have the priority of a reset, so that none interrupts another: a firmware that sets a priority
/// is told in `doubts`. The memory protection unit is memory: nothing is enforced.
class SystemBlock {
 public:
  static constexpr std::uint32_t nmi = 2;
  static constexpr std::uint32_t hard_fault = 3;
  static constexpr std::uint32_t systick = 15;
  static constexpr std::uint32_t first_interrupt = 16;

  SystemBlock(hal::stm32f4::test::RegisterWorld& world, Timeline& timeline);
  void add_to(AddressSpace& space);

  /// An interrupt waits as long as this says so. `number` as in RM0090 table 62.
  void attach(std::uint32_t number, std::function<bool()> level);
  void pend_nmi() { nmi_pends_ = true; }
  /// What the hard fault handler finds.
  void set_fault(std::uint32_t configurable, std::uint32_t address);

  /// The exception that is to be taken now, if interrupts were let in; empty when none waits or one of its rank runs.
  [[nodiscard]] std::optional<std::uint32_t> waiting();
  /// Does anything wait that ends a sleep?
  [[nodiscard]] bool wakes() { return waiting().has_value(); }
  /// The handler begins; it stands for its own pending bit.
  void begin(std::uint32_t exception);
  /// It has returned to this one, 0 being the program.
  void return_to(std::uint32_t exception) { active_ = exception; }
  [[nodiscard]] std::uint32_t active() const { return active_; }

  /// The firmware has asked for one, since the last reset().
  [[nodiscard]] bool reset_asked() const { return reset_asked_; }
  void reset();

  std::function<void()> on_reset_request{};
  std::vector<const char*> doubts{};

 private:
  void start_systick();
  [[nodiscard]] std::uint32_t systick_value() const;
  [[nodiscard]] std::uint64_t counts_per_round() const { return (load_ + 1ULL) * Timeline::counts_per_cycle; }

  Timeline& timeline_;
  Timeline::Event zero_;
  hal::stm32f4::registers::SysTick timer_{};
  hal::stm32f4::registers::Scb control_{};
  hal::stm32f4::registers::Nvic nvic_{};
  hal::stm32f4::registers::Register coprocessors_{};  ///< CPACR
  hal::stm32f4::registers::Mpu mpu_{};
  hal::stm32f4::registers::Dwt dwt_{};
  hal::stm32f4::registers::CoreDebug debug_{};
  struct Line {
    std::uint32_t number;
    std::function<bool()> level;
  };
  std::vector<Line> lines_;
  std::array<std::uint32_t, 3> enabled_{};
  std::array<std::uint32_t, 3> pending_{};
  std::uint32_t active_ = 0;
  bool nmi_pends_ = false;
  bool systick_pends_ = false;
  bool reset_asked_ = false;
  std::uint32_t ctrl_ = 0;
  std::uint32_t load_ = 0;
  std::uint64_t round_ends_ = 0;  ///< at these counts it reaches zero
  std::uint64_t counter_began_ = 0;
};

}  // namespace fantail::board
