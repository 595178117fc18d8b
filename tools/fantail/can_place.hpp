// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hal/linux/can_bus.hpp"
#include "hal/linux/clock.hpp"
#include "link/place.hpp"

namespace fantail::tool {

/// At a real bus. Ctrl-C ends a wait with Interrupted, once: whoever catches it can still centre the canards.
class CanPlace final : public link::Place {
 public:
  /// Throws hal::on_linux::CanError with what to do about it.
  explicit CanPlace(const std::string& interface) : bus_{interface} {}

  [[nodiscard]] hal::on_linux::CanBus& bus() override { return bus_; }
  [[nodiscard]] hal::Microseconds now() const override { return clock_.now(); }
  void wait(hal::Microseconds at_most) override;

 private:
  hal::on_linux::CanBus bus_;
  hal::on_linux::Clock clock_;
};

}  // namespace fantail::tool
