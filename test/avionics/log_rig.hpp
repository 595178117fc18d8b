// SPDX-License-Identifier: MIT
#pragma once

#include "avionics/can_frame.hpp"
#include "avionics/log_transfer.hpp"
#include "flash_rig.hpp"
#include "random_stream.hpp"
#include "test.hpp"

namespace fantail::avionics {

/// Takes as many frames a tick as it is told, and keeps them.
class NarrowBus final : public hal::CanBus {
 public:
  bool send(const hal::CanFrame& frame) override {
    if (room == 0) {
      return false;
    }
    room -= 1;
    sent.push_back(*protocol::decode_from_avionics(bus_frame(frame)).message);
    return true;
  }
  std::optional<hal::CanFrame> receive() override { return std::nullopt; }
  [[nodiscard]] hal::CanState state() const override { return hal::CanState::error_active; }
  [[nodiscard]] hal::CanCounters counters() const override { return {}; }

  int room = 0;
  std::vector<protocol::FromAvionics> sent{};
};

/// A flash with a record of so many bytes in it, looked through after power-up.
struct LogRig : FlashRig {
  static constexpr std::uint32_t region_begin = 4 * 4096;
  static constexpr std::uint32_t region_end = 16 * 4096;
  static constexpr std::uint16_t session = 4711;  ///< of the bench that asks

  WatchedFlash watched{flash};
  FlashAccess access{watched};
  FlightRegion flights{access};
  std::array<std::byte, 380> plan_block{};
  LogTransfer log{flights, plan_block};
  LogTransfer::Right right{.safe = true};
  NarrowBus bus{};
  int room_a_tick = 100;
  std::vector<std::byte> record{};

  explicit LogRig(std::size_t bytes, std::uint32_t seed = 1) {
    core::RandomStream random{seed};
    for (std::size_t i = 0; i < bytes; ++i) {
      record.push_back(std::byte{static_cast<std::uint8_t>(random.whole(0, 254))});
    }
    for (std::byte& byte : plan_block) {
      byte = std::byte{static_cast<std::uint8_t>(random.whole(0, 255))};
    }
    std::ranges::copy(record, flash.cells().begin() + region_begin);
    std::ranges::fill(flash.cells().first(region_begin), std::byte{0x5A});  // what else is kept in the flash
    record.resize((bytes + 4095) / 4096 * 4096, std::byte{0xFF});
  }

  void step() {
    bus.sent.clear();
    bus.room = room_a_tick;
    watched.calls = 0;
    watched.bytes_read = 0;
    log.update(world.time, right);
    if (!right.flash_in_use && !log.read(world.time)) {
      flights.update(world.time);
    }
    log.send(world.time, right, bus);
    world.time += tick;
  }
  void power_up() {
    for (int i = 0; i < 100 && !flights.finished(); ++i) {
      step();
    }
    ASSERT_TRUE(flights.finished());
  }

  void ask(protocol::LogAction action, std::uint32_t offset = 0, std::uint16_t size = 0, std::uint8_t tag = 3) {
    log.receive({.action = action, .tag = tag, .offset = offset, .size = size}, right);
  }
  void ask_to_erase() { ask(protocol::LogAction::erase, session); }
  /// Steps until there is a reply, at most for so many ticks. Data on the way there are collected.
  std::optional<protocol::LogReply> reply(int ticks = 1000) {
    for (int i = 0; i < ticks; ++i) {
      step();
      for (const auto& message : bus.sent) {
        if (const auto* part = std::get_if<protocol::LogData>(&message)) {
          data.push_back(*part);
        } else {
          return std::get<protocol::LogReply>(message);
        }
      }
    }
    return std::nullopt;
  }
  /// What it answers to a request, at once.
  protocol::LogFault refusal(protocol::LogAction action, std::uint32_t offset = 0, std::uint16_t size = 0) {
    ask(action, offset, size);
    const auto answer = reply();
    EXPECT_TRUE(answer && answer->state == protocol::LogState::refused && answer->number == 0 && answer->tag == 3);
    return answer ? answer->fault : protocol::LogFault::none;
  }

  [[nodiscard]] std::span<const std::byte> region() {
    return flash.cells().subspan(region_begin, region_end - region_begin);
  }
  [[nodiscard]] std::size_t bytes_in_flash() {
    return static_cast<std::size_t>(std::ranges::count_if(region(), [](std::byte b) { return b != std::byte{0xFF}; }));
  }

  std::vector<protocol::LogData> data{};
};

}  // namespace fantail::avionics
