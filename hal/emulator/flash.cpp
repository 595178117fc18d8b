// SPDX-License-Identifier: MIT
#include "hal/emulator/flash.hpp"

#include <algorithm>

#include "protocol/hil_codec.hpp"

namespace fantail::hal::emulator {

FlashResult Flash::read(std::uint32_t address, std::span<std::byte> out) {
  return call(FlashCall::read, address, {}, out);
}

FlashResult Flash::program(std::uint32_t address, std::span<const std::byte> bytes) {
  return call(FlashCall::program, address, bytes, {});
}

FlashResult Flash::erase_sector(std::uint32_t address) { return call(FlashCall::erase, address, {}, {}); }

bool Flash::busy() { return call(FlashCall::busy, 0, {}, {}) == FlashResult::busy; }

FlashResult Flash::call(FlashCall what, std::uint32_t address, std::span<const std::byte> in,
                        std::span<std::byte> out) {
  const Stopwatch::Pause pause{stopwatch_};
  const auto room = static_cast<std::uint32_t>(out.size());
  protocol::HilWriter writer{link_.payload()};
  writer(what);
  writer(address);
  writer(room);
  writer.bytes(in);
  if (!writer.ok()) {
    return FlashResult::failed;
  }
  const auto answer = link_.ask(protocol::HilType::flash_request, writer.size());
  if (!answer || answer->head.type != static_cast<std::uint8_t>(protocol::HilType::flash_answer)) {
    return FlashResult::failed;
  }
  protocol::HilReader reader{answer->payload};
  FlashResult result = FlashResult::failed;
  reader(result);
  const auto bytes = reader.bytes();
  if (!reader.ok() || (result == FlashResult::ok && bytes.size() != out.size())) {
    return FlashResult::failed;
  }
  if (result == FlashResult::ok) {
    std::ranges::copy(bytes, out.begin());
  }
  return result;
}

}  // namespace fantail::hal::emulator
