// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hal/flash.hpp"
#include "hal/nor_memory.hpp"
#include "hal/sim/torn_flash.hpp"
#include "hal/sim/world_side.hpp"

namespace fantail::hal::sim {

/// As a W25Q128.
inline constexpr FlashGeometry flash_16_mib{.size = 16U << 20U, .sector_size = 4096, .page_size = 256};

/// Typical of a W25Q128; its worst case is 3 ms and 400 ms.
struct FlashTiming {
  Microseconds program{1'000};
  Microseconds erase{50'000};
};

/// NOR flash in memory, delivered erased. What it is told to do takes time of the world, and a power cut finds it half
/// done.
class Flash final : public hal::Flash {
 public:
  /// Does everything at once.
  explicit Flash(const FlashGeometry& geometry = flash_16_mib)
      : geometry_{geometry}, cells_(geometry.size, std::byte{0xFF}) {}
  /// The world outlives this object.
  explicit Flash(const WorldSide& world, const FlashGeometry& geometry = flash_16_mib, const FlashTiming& timing = {})
      : world_{&world}, timing_{timing}, geometry_{geometry}, cells_(geometry.size, std::byte{0xFF}) {}

  [[nodiscard]] FlashGeometry geometry() const override { return geometry_; }

  FlashResult read(std::uint32_t address, std::span<std::byte> out) override {
    if (const auto no = refusal(memory().may_read(address, out.size()))) {
      return *no;
    }
    memory().read(address, out);
    for (const StuckBits& stuck : stuck_) {
      if (stuck.address >= address && stuck.address - address < out.size()) {
        std::byte& byte = out[stuck.address - address];
        byte = (byte & ~stuck.mask) | (stuck.value & stuck.mask);
      }
    }
    return FlashResult::ok;
  }

  FlashResult program(std::uint32_t address, std::span<const std::byte> bytes) override {
    if (const auto no = refusal(memory().may_program(address, bytes.size()))) {
      return *no;
    }
    bytes_.assign(bytes.begin(), bytes.end());
    begin(Doing::program, address, timing_.program);
    return FlashResult::ok;
  }

  FlashResult erase_sector(std::uint32_t address) override {
    if (const auto no = refusal(memory().may_erase(address))) {
      return *no;
    }
    begin(Doing::erase, address, timing_.erase);
    return FlashResult::ok;
  }

  [[nodiscard]] bool busy() override {
    if (doing_ != Doing::nothing && (world_ == nullptr || world_->time >= done_at_)) {
      finish();
    }
    return stays_busy_ || doing_ != Doing::nothing;
  }

  // ---- faults ----

  /// Power goes and comes back: what is under way stays as far as the seed says it got.
  void cut_power(std::uint64_t seed) {
    static_cast<void>(busy());  // finds out what has come to its end in time
    const auto cells = std::span{cells_}.subspan(address_);
    if (doing_ == Doing::erase) {
      tear_erase(cells.first(geometry_.sector_size), seed);
    } else if (doing_ == Doing::program) {
      tear_program(cells.first(bytes_.size()), bytes_, seed);
    }
    doing_ = Doing::nothing;
  }
  void set_answers(bool answers) { answers_ = answers; }
  void set_stays_busy(bool stays_busy) { stays_busy_ = stays_busy; }
  /// The bits of the mask read as they do in `value`, whatever is done to them.
  void stick(std::uint32_t address, std::byte mask, std::byte value) { stuck_.push_back({address, mask, value}); }

  /// Programs in the sector that begins here have no effect, and say nothing of it, as a W25Q does.
  void wear_out(std::uint32_t sector) { worn_out_.push_back(sector); }

  /// What lies in the flash, for the world and for tests to look at and to spoil.
  [[nodiscard]] std::span<std::byte> cells() { return cells_; }
  /// Programs and erases begun since power-up.
  [[nodiscard]] std::uint64_t begun() const { return begun_; }

 private:
  enum class Doing : std::uint8_t { nothing, program, erase };
  struct StuckBits {
    std::uint32_t address;
    std::byte mask;
    std::byte value;
  };

  [[nodiscard]] NorMemory memory() { return {cells_, geometry_}; }

  [[nodiscard]] std::optional<FlashResult> refusal(FlashResult range) {
    if (!answers_) {
      return FlashResult::failed;
    }
    if (busy()) {
      return FlashResult::busy;
    }
    return range == FlashResult::ok ? std::nullopt : std::optional{range};
  }

  void begin(Doing what, std::uint32_t address, Microseconds duration) {
    doing_ = what;
    address_ = address;
    begun_ += 1;
    if (world_ == nullptr) {
      finish();
    } else {
      done_at_ = world_->time + duration;
    }
  }

  void finish() {
    if (doing_ == Doing::erase) {
      memory().erase_sector(address_);
    } else if (std::ranges::find(worn_out_, address_ / geometry_.sector_size * geometry_.sector_size) ==
               worn_out_.end()) {
      memory().program(address_, bytes_);
    }
    doing_ = Doing::nothing;
  }

  const WorldSide* world_ = nullptr;
  FlashTiming timing_{};
  FlashGeometry geometry_;
  std::vector<std::byte> cells_;
  Doing doing_ = Doing::nothing;
  std::uint32_t address_ = 0;
  std::vector<std::byte> bytes_;  ///< to be programmed
  Microseconds done_at_{};
  std::uint64_t begun_ = 0;
  std::vector<StuckBits> stuck_;
  std::vector<std::uint32_t> worn_out_;
  bool answers_ = true;
  bool stays_busy_ = false;
};

}  // namespace fantail::hal::sim
