// SPDX-License-Identifier: MIT
#include "avionics/crash_record.hpp"

#include <algorithm>
#include <string_view>

namespace fantail::avionics {
namespace {

// Memory after a power-up is anything, and all zeros with the CRC of all zeros would be something: this cannot be.
constexpr std::uint32_t mark = 0x48535243;  // "CRSH"

// Of a record in words, in this order.
using Words = std::array<std::uint32_t, crash_words>;

Words words_of(const CrashRecord& record) {
  return {record.exception ^ mark, record.program_counter,           record.link_register,     record.stack_pointer,
          record.program_status,   record.configurable_fault_status, record.hard_fault_status, record.fault_address};
}

void write_hex(std::string_view label, std::uint32_t value, hal::Console& console) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::array<char, 10> text{'0', 'x'};
  for (std::size_t i = 0; i < 8; ++i) {
    text[2 + i] = digits[value >> (28 - 4 * i) & 0xFU];
  }
  console.write(label);
  console.write({text.data(), text.size()});
}

}  // namespace

std::array<std::byte, crash_record_size> seal(const CrashRecord& record) { return seal(words_of(record)); }

std::optional<CrashRecord> crash_in(std::span<const std::byte, crash_record_size> bytes) {
  const auto words = unseal<crash_words>(bytes);
  // An exception has one of 98 numbers.
  if (!words || ((*words)[0] ^ mark) >= 98) {
    return std::nullopt;
  }
  const Words& w = *words;
  return CrashRecord{.exception = w[0] ^ mark,
                     .program_counter = w[1],
                     .link_register = w[2],
                     .stack_pointer = w[3],
                     .program_status = w[4],
                     .configurable_fault_status = w[5],
                     .hard_fault_status = w[6],
                     .fault_address = w[7]};
}

std::optional<CrashRecord> take_crash(std::span<std::byte> place) {
  if (place.size() < crash_record_size) {
    return std::nullopt;
  }
  const auto bytes = place.first<crash_record_size>();
  const std::optional<CrashRecord> record = crash_in(bytes);
  std::ranges::fill(bytes, std::byte{});
  return record;
}

void tell(const CrashRecord& record, hal::Console& console) {
  write_hex("crash: exception ", record.exception, console);
  write_hex(" at ", record.program_counter, console);
  write_hex(", called from ", record.link_register, console);
  write_hex(", stack ", record.stack_pointer, console);
  write_hex("\ncrash: CFSR ", record.configurable_fault_status, console);
  write_hex(", HFSR ", record.hard_fault_status, console);
  write_hex(", fault address ", record.fault_address, console);
  write_hex(", xPSR ", record.program_status, console);
  console.write("\n");
}

}  // namespace fantail::avionics
