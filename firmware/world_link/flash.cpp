// SPDX-License-Identifier: MIT
#include "world_link/flash.hpp"

#include <algorithm>

#include "protocol/hil_codec.hpp"

namespace fantail::world_link {

hal::FlashResult Flash::read(std::uint32_t address, std::span<std::byte> out) {
  return call(FlashCall::read, address, {}, out);
}

hal::FlashResult Flash::program(std::uint32_t address, std::span<const std::byte> bytes) {
  return call(FlashCall::program, address, bytes, {});
}

hal::FlashResult Flash::erase_sector(std::uint32_t address) { return call(FlashCall::erase, address, {}, {}); }

bool Flash::busy() { return call(FlashCall::busy, 0, {}, {}) == hal::FlashResult::busy; }

hal::FlashResult Flash::call(FlashCall what, std::uint32_t address, std::span<const std::byte> in,
                             std::span<std::byte> out) {
  const hal::emulator::Stopwatch::Pause pause{stopwatch_};
  const auto room = static_cast<std::uint32_t>(out.size());
  protocol::HilWriter writer{link_.payload()};
  writer(what);
  writer(address);
  writer(room);
  writer.bytes(in);
  if (!writer.ok()) {
    return hal::FlashResult::failed;
  }
  const auto answer = link_.ask(protocol::HilType::flash_request, writer.size());
  if (!answer || answer->head.type != static_cast<std::uint8_t>(protocol::HilType::flash_answer)) {
    return hal::FlashResult::failed;
  }
  protocol::HilReader reader{answer->payload};
  hal::FlashResult result = hal::FlashResult::failed;
  reader(result);
  const auto bytes = reader.bytes();
  if (!reader.ok() || (result == hal::FlashResult::ok && bytes.size() != out.size())) {
    return hal::FlashResult::failed;
  }
  if (result == hal::FlashResult::ok) {
    std::ranges::copy(bytes, out.begin());
  }
  return result;
}

}  // namespace fantail::world_link
