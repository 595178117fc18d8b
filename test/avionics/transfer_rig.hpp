// SPDX-License-Identifier: MIT
#pragma once

#include "avionics/flash_service.hpp"
#include "flash_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {

/// A board that has been powered up and has counted it, with a bus that delivers what it is given.
struct TransferRig : FlashRig {
  WatchedFlash watched{flash};
  FlashService service{watched};
  StoredPlan found{};
  bool safe = true;
  std::optional<protocol::PlanReply> reply{};  ///< the last one
  std::optional<core::FlightPlan> taken{};

  TransferRig() { power_up(); }
  explicit TransferRig(std::span<const std::byte> cells) : FlashRig{cells} { power_up(); }
  void power_up() {
    found = service.load_plan(world.time).value_or(StoredPlan{.flash_failed = true});
    run(60);
  }

  void begin(const Bytes& block) { begin(static_cast<std::uint16_t>(block.size()), protocol::plan_block_crc(block)); }
  void begin(std::uint16_t size, std::uint32_t crc) {
    service.transfer().receive(world.time, protocol::PlanBegin{.size = size, .block_crc = crc}, safe);
  }
  void data(const Bytes& block, std::size_t index) {
    protocol::PlanData frame{.index = static_cast<std::uint8_t>(index)};
    for (std::size_t i = 0; i < 7 && 7 * index + i < block.size(); ++i) {
      frame.bytes[i] = block[7 * index + i];
    }
    service.transfer().receive(world.time, frame, safe);
  }

  /// The reply of this tick.
  std::optional<protocol::PlanReply> step() {
    service.update(world.time, safe);
    world.time += tick;
    const auto new_reply = service.transfer().reply();
    reply = new_reply ? new_reply : reply;
    if (const auto plan = service.transfer().take_plan()) {
      EXPECT_FALSE(taken.has_value()) << "handed out twice";
      taken = plan;
    }
    return new_reply;
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      step();
    }
  }

  /// Everything but the ticks that the write takes.
  void send(const Bytes& block) {
    begin(block);
    step();
    for (std::size_t index = 0; 7 * index < block.size(); ++index) {
      data(block, index);
      step();
    }
  }

  [[nodiscard]] protocol::TransferState state() const { return reply ? reply->state : protocol::TransferState::idle; }
  [[nodiscard]] protocol::TransferFault fault() const { return reply ? reply->fault : protocol::TransferFault::none; }
  /// The number of the plan that the next power-up finds; 0: none.
  [[nodiscard]] int stored_number() {
    FlashRig again{cells()};
    FlashAccess access{again.flash};
    const auto stored = PlanStore{access}.load({});
    return stored && stored->plan ? number_of(*stored->plan) : 0;
  }
};

inline Bytes flash_holding(int number) {
  TransferRig rig;
  rig.send(block_of(numbered_plan(number)));
  rig.run(100);
  EXPECT_EQ(rig.state(), protocol::TransferState::stored);
  return rig.cells();
}

inline const Bytes seven = block_of(numbered_plan(7));
inline const Bytes eight = block_of(numbered_plan(8));

/// A board that holds plan 7.
struct PlanTransferTest : testing::Test {
  TransferRig rig{flash_holding(7)};

  void expect_refused(protocol::TransferFault fault) {
    EXPECT_EQ(rig.state(), protocol::TransferState::refused);
    EXPECT_EQ(rig.fault(), fault);
    EXPECT_FALSE(rig.taken.has_value());
    EXPECT_EQ(rig.stored_number(), 7);
  }
  /// And what was refused stands in the way of nothing.
  void expect_next_one_is_stored() {
    rig.safe = true;
    rig.send(eight);
    rig.run(100);
    EXPECT_EQ(rig.state(), protocol::TransferState::stored);
    EXPECT_EQ(rig.stored_number(), 8);
  }
};

}  // namespace fantail::avionics
