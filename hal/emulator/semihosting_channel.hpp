// SPDX-License-Identifier: MIT
#pragma once

#include "hal/emulator/channel.hpp"

namespace fantail::hal::emulator {

/// Two pipes that the emulator was started with: it reads descriptor 3 and writes descriptor 4. When the other end is
/// gone, the emulator ends.
class SemihostingChannel final : public Channel {
 public:
  SemihostingChannel();
  [[nodiscard]] std::size_t read(std::span<std::byte> out) override;
  void write(std::span<const std::byte> bytes) override;

 private:
  int in_;
  int out_;
};

}  // namespace fantail::hal::emulator
