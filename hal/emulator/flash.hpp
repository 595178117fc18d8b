// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "hal/emulator/flash_call.hpp"
#include "hal/emulator/link.hpp"
#include "hal/emulator/stopwatch.hpp"
#include "hal/flash.hpp"

namespace fantail::hal::emulator {

/// The world's flash. Every call crosses the link and comes back, so that it gives the world's own answer whatever is
/// the matter with it there.
class Flash final : public hal::Flash {
 public:
  /// Link and stopwatch outlive this object.
  Flash(Link& link, Stopwatch& stopwatch) : link_{link}, stopwatch_{stopwatch} {}
  void set_geometry(const FlashGeometry& geometry) { geometry_ = geometry; }

  [[nodiscard]] FlashGeometry geometry() const override { return geometry_; }
  FlashResult read(std::uint32_t address, std::span<std::byte> out) override;
  FlashResult program(std::uint32_t address, std::span<const std::byte> bytes) override;
  FlashResult erase_sector(std::uint32_t address) override;
  [[nodiscard]] bool busy() override;

 private:
  FlashResult call(FlashCall what, std::uint32_t address, std::span<const std::byte> in, std::span<std::byte> out);

  Link& link_;
  Stopwatch& stopwatch_;
  FlashGeometry geometry_{};
};

}  // namespace fantail::hal::emulator
