// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "avionics/sealed_words.hpp"
#include "hal/console.hpp"

namespace fantail::avionics {

/// What a processor that crashed leaves behind: where it was, and what it says of the fault. (Armv7-M Architecture
/// Reference Manual, B1.5.6 and B3.2.)
struct CrashRecord {
  std::uint32_t exception =
      0;  ///< its number: 3 hard fault, 4 memory, 5 bus, 6 usage; 16 and more: an interrupt nobody handles
  std::uint32_t program_counter = 0;
  std::uint32_t link_register = 0;
  std::uint32_t stack_pointer = 0;
  std::uint32_t program_status = 0;
  std::uint32_t configurable_fault_status = 0;  ///< CFSR
  std::uint32_t hard_fault_status = 0;          ///< HFSR
  std::uint32_t fault_address = 0;              ///< BFAR or MMFAR, where CFSR says that it is valid
  friend bool operator==(const CrashRecord&, const CrashRecord&) = default;
};

inline constexpr std::size_t crash_words = 8;
inline constexpr std::size_t crash_record_size = sealed_size<crash_words>;

/// As it lies in memory that the reset leaves alone.
[[nodiscard]] std::array<std::byte, crash_record_size> seal(const CrashRecord& record);

/// Empty when no intact record lies there.
[[nodiscard]] std::optional<CrashRecord> crash_in(std::span<const std::byte, crash_record_size> bytes);

/// The record that lies at the beginning of `place`, which has room for one or is empty. It is told once: afterwards
/// none lies there.
[[nodiscard]] std::optional<CrashRecord> take_crash(std::span<std::byte> place);

/// For a person with the map file of the image.
void tell(const CrashRecord& record, hal::Console& console);

}  // namespace fantail::avionics
