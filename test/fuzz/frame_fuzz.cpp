// SPDX-License-Identifier: MIT
// Any bytes as a frame on the bus, a plan block, a frame between a flight computer and its world, or a record of a log:
// a message whose values lie in their ranges, or none.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/flight_plan_fields.hpp"
#include "protocol/bus_codec.hpp"
#include "protocol/crc32c.hpp"
#include "protocol/hil_frame.hpp"
#include "protocol/little_endian.hpp"
#include "protocol/log_header.hpp"
#include "protocol/log_notes.hpp"
#include "protocol/plan_block.hpp"
#include "target.hpp"

namespace fantail::fuzz {
namespace {

void bus(std::span<const std::byte> bytes) {
  if (bytes.size() < 5) {
    return;
  }
  protocol::BusFrame frame{.id = static_cast<std::uint16_t>(protocol::get<2>(bytes, 0) & 0x7FFU),
                           .length = static_cast<std::uint8_t>(std::min<std::size_t>(bytes.size() - 5, 8))};
  for (std::size_t i = 0; i < frame.length; ++i) {
    frame.data[i] = static_cast<std::uint8_t>(bytes[5 + i]);
  }
  const auto session = static_cast<std::uint16_t>(protocol::get<2>(bytes, 2));
  const auto told = protocol::decode_from_bench(frame, bytes[4] == std::byte{} ? std::nullopt : std::optional{session});
  if (told.message) {
    if (const auto* request = std::get_if<protocol::BenchRequest>(&*told.message)) {
      require(bytes[4] != std::byte{});  // none is understood while no session is open
      for (const auto& angle : request->angle) {
        require(!angle || std::abs(angle->radians()) <= 0.8F);
      }
    }
  }
  const auto heard = protocol::decode_from_avionics(frame);
  require(heard.message.has_value() || !heard.counter.has_value());
}

void plan(std::vector<std::byte> bytes, bool sealed) {
  // A checksum lets one mutation in four thousand million through: here it is made right.
  if (sealed && bytes.size() > 4) {
    protocol::put<4>(bytes, bytes.size() - 4, protocol::crc32c(std::span{bytes}.first(bytes.size() - 4)));
  }
  const protocol::PlanBlockReading reading = protocol::read_plan_block(bytes);
  if (reading.plan) {
    require(!core::validate(*reading.plan));
    std::vector<std::byte> again(protocol::plan_block_size);
    require(protocol::write_plan_block(*reading.plan, again) == bytes.size());
    // Values beyond the end of a list are not part of a plan: the second writing is the one that is always the same.
    const protocol::PlanBlockReading second = protocol::read_plan_block(again);
    require(second.plan.has_value());
    std::vector<std::byte> twice(protocol::plan_block_size);
    require(protocol::write_plan_block(*second.plan, twice) == again.size() && twice == again);
  }
}

void link(std::span<const std::byte> bytes) {
  protocol::HilFrameIn in;
  for (std::size_t frames = 0; !bytes.empty() && frames <= 4096; ++frames) {
    const std::span<std::byte> room = in.room();
    require(!room.empty());
    const std::size_t taken = std::min(room.size(), bytes.size());
    std::ranges::copy(bytes.first(taken), room.begin());
    in.arrived(taken);
    bytes = bytes.subspan(taken);
    while (const auto frame = in.next()) {
      require(frame->payload.size() <= protocol::largest_hil_payload);
    }
  }
}

void record(std::span<const std::byte> bytes) {
  if (const auto event = protocol::unpack_event({}, bytes)) {
    require(!protocol::name(event->kind).empty());
  }
  (void)protocol::unpack_health({}, bytes);
  (void)protocol::decode_log_header(bytes);
}

std::string text(std::span<const std::byte> bytes, char kind) {
  return kind + std::string{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::vector<std::string> seeds() {
  const protocol::BusFrame frame =
      protocol::encode(protocol::BenchRequest{{core::Angle::from_degrees(3.0F)}}, 3, 0x1234);
  std::vector<std::byte> bus{std::byte(frame.id & 0xFFU), std::byte(frame.id >> 8U), std::byte{0x34}, std::byte{0x12},
                             std::byte{1}};
  for (std::size_t i = 0; i < frame.length; ++i) {
    bus.push_back(std::byte{frame.data[i]});
  }
  std::vector<std::byte> block(protocol::plan_block_size);
  (void)protocol::write_plan_block(core::default_plan(), block);
  protocol::HilFrameOut out;
  const auto sealed = out.seal(protocol::HilType::tick, 7, 40);
  return {text(bus, '\0'), text(block, '\1'), text(block, '\2'), text(sealed, '\3'),
          text(std::array<std::byte, 40>{}, '\4')};
}

}  // namespace fantail::fuzz

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fantail::fuzz;
  if (size == 0) {
    return 0;
  }
  const auto bytes = std::as_bytes(std::span{data, size}).subspan(1);
  switch (data[0] % 5) {  // the first byte chooses what the rest is
    case 0: bus(bytes); break;
    case 1: plan({bytes.begin(), bytes.end()}, false); break;
    case 2: plan({bytes.begin(), bytes.end()}, true); break;
    case 3: link(bytes); break;
    default: record(bytes);
  }
  return 0;
}
