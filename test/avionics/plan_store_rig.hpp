// SPDX-License-Identifier: MIT
#pragma once

#include "avionics/plan_store.hpp"
#include "flash_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {

inline constexpr std::size_t slot_header_size = 16;

/// A board that has just been powered up on this flash, and keeps nothing in it but a plan.
struct PlanBoard : FlashRig {
  FlashAccess access{flash};
  PlanStore store{access};
  StoredPlan found{};

  explicit PlanBoard(const hal::FlashGeometry& geometry = small_flash) : FlashRig{geometry} { load(); }
  explicit PlanBoard(std::span<const std::byte> cells, const hal::FlashGeometry& geometry = small_flash)
      : FlashRig{cells, geometry} {
    load();
  }
  void load() {
    const auto loaded = store.load(world.time);
    ASSERT_TRUE(loaded.has_value());
    found = *loaded;
  }
  /// 0: no plan.
  [[nodiscard]] int number() const { return found.plan ? number_of(*found.plan) : 0; }

  /// Number of ticks it took.
  int write(const Bytes& block, int most_ticks = 10'000) {
    store.begin_write(block);
    int ticks = 0;
    for (; store.write() == PlanWrite::under_way && ticks < most_ticks; ++ticks) {
      store.update(world.time);
      world.time += tick;
    }
    return ticks;
  }
};

inline Bytes flash_with(std::initializer_list<int> numbers, const hal::FlashGeometry& geometry = small_flash) {
  PlanBoard board{geometry};
  for (const int number : numbers) {
    board.write(block_of(numbered_plan(number)));
    EXPECT_EQ(board.store.write(), PlanWrite::stored);
  }
  return board.cells();
}

}  // namespace fantail::avionics
