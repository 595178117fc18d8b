// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "hal/emulator/stopwatch.hpp"
#include "hal/flash.hpp"
#include "world_link/flash_call.hpp"
#include "world_link/link.hpp"

namespace fantail::world_link {

/// The world's flash. Every call crosses the link and comes back, so that it gives the world's own answer whatever is
/// the matter with it there.
class Flash final : public hal::Flash {
 public:
  /// Link and stopwatch outlive this object.
  Flash(Link& link, hal::emulator::Stopwatch& stopwatch) : link_{link}, stopwatch_{stopwatch} {}
  void set_geometry(const hal::FlashGeometry& geometry) { geometry_ = geometry; }

  [[nodiscard]] hal::FlashGeometry geometry() const override { return geometry_; }
  hal::FlashResult read(std::uint32_t address, std::span<std::byte> out) override;
  hal::FlashResult program(std::uint32_t address, std::span<const std::byte> bytes) override;
  hal::FlashResult erase_sector(std::uint32_t address) override;
  [[nodiscard]] bool busy() override;

 private:
  hal::FlashResult call(FlashCall what, std::uint32_t address, std::span<const std::byte> in, std::span<std::byte> out);

  Link& link_;
  hal::emulator::Stopwatch& stopwatch_;
  hal::FlashGeometry geometry_{};
};

}  // namespace fantail::world_link
