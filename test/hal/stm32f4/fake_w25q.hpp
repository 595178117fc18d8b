// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "fake_clock.hpp"
#include "fake_spi.hpp"

namespace fantail::hal::stm32f4::test {

/// A W25Q of the JV family as its data sheet describes it: instructions in section 8.2, status registers in 7.1.
class FakeW25q final : public SpiSlave {
 public:
  /// Its size is 2 to the power of the capacity.
  explicit FakeW25q(const FakeClock& clock, std::uint8_t capacity = 0x14)
      : id{0xEF, 0x40, capacity}, cells(std::size_t{1} << capacity, std::byte{0xFF}), clock_{clock} {}

  std::array<std::uint8_t, 3> id;
  std::vector<std::byte> cells;
  Microseconds program_time{700};
  Microseconds erase_time{45'000};

  // ---- faults ----
  std::optional<std::uint8_t> stuck_at{};  ///< answers nothing but this
  bool always_busy = false;
  bool ignores_write_enable = false;
  bool asleep = false;                   ///< power-down
  bool status_locked = false;            ///< its status registers cannot be written
  std::array<std::uint8_t, 3> status{};  ///< without BUSY and WEL
  /// Of this byte these bits stay ones. No status bit tells: the family has none for a program that failed.
  struct WornBits {
    std::size_t address;
    std::byte mask;
  };
  std::optional<WornBits> worn{};
  void cut_power(std::uint64_t seed);

  /// Called when a page was programmed or a sector erased, with where and how much.
  std::function<void(std::size_t address, std::size_t size)> on_change{};

  int programs = 0;  ///< begun
  int erases = 0;

  [[nodiscard]] Needs needs() const override { return {.modes = {0, 3}, .most_hz = 50'000'000, .select_ns = 5}; }
  void selected() override { bytes_.clear(); }
  std::uint8_t exchange(std::uint8_t out) override;
  void deselected() override;

 private:
  enum class Doing : std::uint8_t { nothing, program, erase };

  [[nodiscard]] bool busy();
  [[nodiscard]] std::uint8_t answer() const;
  [[nodiscard]] std::size_t address() const;
  [[nodiscard]] bool is_protected() const;
  void obey();
  void begin(Doing what);
  void finish();

  const FakeClock& clock_;
  std::vector<std::uint8_t> bytes_;  ///< since chip select
  bool write_enabled_ = false;
  bool volatile_enabled_ = false;
  bool ignored_ = false;
  Doing doing_ = Doing::nothing;
  Microseconds done_at_{};
  std::size_t address_ = 0;
  std::vector<std::byte> page_;  ///< what will be programmed, a whole page
};

}  // namespace fantail::hal::stm32f4::test
