// SPDX-License-Identifier: MIT
#include "boards/stm32f405/crash.hpp"

#include <algorithm>
#include <cstdint>

#include "avionics/backup_map.hpp"
#include "avionics/crash_record.hpp"
#include "boards/stm32f405/hardware.hpp"
#include "hal/stm32f4/registers/processor.hpp"
#include "hal/stm32f4/servo.hpp"

extern "C" {
extern std::uint32_t stack_bottom[];
extern std::uint32_t stack_top[];
}

namespace fantail::boards::stm32f405 {
namespace {

const avionics::Avionics* flying = nullptr;

// What the processor puts on the stack before it calls a handler: r0 to r3, r12, lr, pc, xPSR. (Armv7-M B1.5.6)
constexpr std::size_t frame_words = 8;
// Nothing but the clock security system raises it. (RM0090 section 7.2.7)
constexpr std::uint32_t nmi = 2;

avionics::CrashRecord describe(const std::uint32_t* frame, std::uint32_t link_register) {
  avionics::CrashRecord record{.exception = scb().icsr.read() & registers::scb_icsr_vectactive,
                               .program_counter = link_register,
                               .stack_pointer = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(frame)),
                               .configurable_fault_status = scb().cfsr.read(),
                               .hard_fault_status = scb().hfsr.read(),
                               .fault_address = scb().bfar.read()};
  // A stack that ran over has no frame; and who called this as a function left none.
  const bool there = frame >= stack_bottom && frame + frame_words <= stack_top;
  if (there && record.exception != 0) {
    record.link_register = frame[5];
    record.program_counter = frame[6];
    record.program_status = frame[7];
  }
  return record;
}

}  // namespace

void centre_on_crash(const avionics::Avionics& avionics) { flying = &avionics; }

// On a fresh stack, whatever happened to the old one.
// Meets SRV-2.
extern "C" [[noreturn, gnu::used]] void after_crash(const std::uint32_t* frame, std::uint32_t link_register) {
  registers::mask_interrupts();
  Hardware* const hardware = running_hardware();
  // First: the rocket is in the air, and nobody steers it. Should this crash in turn, the watchdog resets.
  hal::stm32f4::Servo::Counts at_trim{};
  // From then on the timer counts at a tenth of its speed: a pulse at trim would be one of 15 ms, and the watchdog
  // faster than its end.
  const bool crystal_stopped = (scb().icsr.read() & registers::scb_icsr_vectactive) == nmi;
  if (crystal_stopped) {
    hal::stm32f4::Servo::end_without_crystal(tim8(), hardware != nullptr ? hardware->servo().counts() : at_trim);
  } else if (hardware != nullptr && flying != nullptr) {
    at_trim = hardware->servo().counts(flying->pulses_at_trim());
    hal::stm32f4::Servo::drive(tim8(), at_trim);
  }
  if (hardware != nullptr) {
    // Empty where that memory could not be opened.
    if (const auto place = avionics::crash_place(hardware->backup_memory().bytes()); !place.empty()) {
      std::ranges::copy(avionics::seal(describe(frame, link_register)), place.begin());
    }
  }
  // A pulse that the reset cuts off in the middle is another command: 0.7 ms of 1.5 is full deflection.
  if (hardware != nullptr && flying != nullptr && !crystal_stopped) {
    static_cast<void>(hal::stm32f4::Servo::finish(tim8(), at_trim));
  }
  scb().aircr.write(registers::scb_aircr_vectkey | registers::scb_aircr_sysresetreq);
  for (;;) {
  }
}

// Every fault, every interrupt that nobody handles, and whoever calls it.
extern "C" [[gnu::naked]] void crash_handler() {
  __asm(
      "mrs r0, msp\n"
      "mov r1, lr\n"
      "ldr r2, =stack_top\n"
      "mov sp, r2\n"
      "b after_crash\n");
}

}  // namespace fantail::boards::stm32f405
