// SPDX-License-Identifier: MIT
#include "avionics/crash_record.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <gtest/gtest.h>

namespace fantail::avionics {
namespace {

constexpr CrashRecord crash{.exception = 3,
                            .program_counter = 0x08001234,
                            .link_register = 0x08004321,
                            .stack_pointer = 0x20001FF0,
                            .program_status = 0x61000000,
                            .configurable_fault_status = 0x00000400,
                            .hard_fault_status = 0x40000000,
                            .fault_address = 0xE000ED38};

TEST(CrashRecord, ComesBackAsItWasLeft) { EXPECT_EQ(crash_in(seal(crash)), crash); }

TEST(CrashRecord, OfWhichOneBitHasFlippedIsNone) {
  const auto intact = seal(crash);
  for (std::size_t bit = 0; bit < 8 * intact.size(); ++bit) {
    auto bytes = intact;
    bytes[bit / 8] ^= std::byte{1} << (bit % 8);
    EXPECT_FALSE(crash_in(bytes)) << "bit " << bit;
  }
}

TEST(CrashRecord, IsNotFoundInMemoryThatNobodyWrote) {
  std::array<std::byte, crash_record_size> bytes{};
  EXPECT_FALSE(crash_in(bytes));
  bytes.fill(std::byte{0xFF});
  EXPECT_FALSE(crash_in(bytes));
  // Zeros with the CRC of zeros, as from a seal around nothing.
  EXPECT_FALSE(crash_in(seal(std::array<std::uint32_t, crash_words>{})));
}

TEST(CrashRecord, IsTakenOnce) {
  std::array<std::byte, 256> place{};
  std::ranges::copy(seal(crash), place.begin());
  EXPECT_EQ(take_crash(place), crash);
  EXPECT_FALSE(take_crash(place));
  EXPECT_FALSE(take_crash({}));  // of a board without such memory
}

TEST(CrashRecord, IsToldWithThePlacesThatTheMapFileNames) {
  struct Listener final : hal::Console {
    std::string text;
    void write(std::string_view words) override { text += words; }
  } console;
  tell(crash, console);
  EXPECT_EQ(console.text,
            "crash: exception 0x00000003 at 0x08001234, called from 0x08004321, stack 0x20001ff0\n"
            "crash: CFSR 0x00000400, HFSR 0x40000000, fault address 0xe000ed38, xPSR 0x61000000\n");
}

}  // namespace
}  // namespace fantail::avionics
