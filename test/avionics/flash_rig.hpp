// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/flight_plan_fields.hpp"
#include "hal/sim/flash.hpp"
#include "protocol/crc32c.hpp"
#include "protocol/plan_block.hpp"

namespace fantail::avionics {

using Bytes = std::vector<std::byte>;

inline constexpr hal::FlashGeometry small_flash{.size = 65'536, .sector_size = 4096, .page_size = 256};
/// Slow enough that there is a tick in the middle of everything, and no slower.
inline constexpr hal::sim::FlashTiming two_and_four_ticks{.program = hal::Microseconds{2'000},
                                                          .erase = hal::Microseconds{4'000}};
inline constexpr hal::Microseconds tick{1'000};

/// The flash of a board between two power cuts.
struct FlashRig {
  hal::sim::WorldSide world{};
  hal::sim::Flash flash;

  explicit FlashRig(const hal::FlashGeometry& geometry = small_flash) : flash{world, geometry, two_and_four_ticks} {}
  explicit FlashRig(std::span<const std::byte> cells, const hal::FlashGeometry& geometry = small_flash)
      : FlashRig{geometry} {
    std::ranges::copy(cells, flash.cells().begin());
  }
  FlashRig(const FlashRig&) = delete;
  FlashRig& operator=(const FlashRig&) = delete;

  [[nodiscard]] Bytes cells() { return {flash.cells().begin(), flash.cells().end()}; }
};

/// Counts what a tick asks of the flash.
class WatchedFlash final : public hal::Flash {
 public:
  explicit WatchedFlash(hal::Flash& flash) : flash_{flash} {}
  [[nodiscard]] hal::FlashGeometry geometry() const override { return flash_.geometry(); }
  hal::FlashResult read(std::uint32_t address, std::span<std::byte> out) override {
    calls += 1;
    bytes_read += out.size();
    return flash_.read(address, out);
  }
  hal::FlashResult program(std::uint32_t address, std::span<const std::byte> bytes) override {
    calls += 1;
    return flash_.program(address, bytes);
  }
  hal::FlashResult erase_sector(std::uint32_t address) override {
    calls += 1;
    return flash_.erase_sector(address);
  }
  [[nodiscard]] bool busy() override { return flash_.busy(); }

  int calls = 0;
  std::size_t bytes_read = 0;

 private:
  hal::Flash& flash_;
};

/// A plan that is known by its number, 1 to 100.
inline core::FlightPlan numbered_plan(int number) {
  core::FlightPlan plan = core::default_plan();
  plan.run.control_time = core::Microseconds{10'000'000 + number};
  return plan;
}
inline int number_of(const core::FlightPlan& plan) {
  return static_cast<int>(plan.run.control_time.count() - 10'000'000);
}

inline Bytes block_of(const core::FlightPlan& plan) {
  std::array<std::byte, protocol::largest_plan_block> out{};
  const std::size_t size = protocol::write_plan_block(plan, out);
  return {out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size)};
}

}  // namespace fantail::avionics
