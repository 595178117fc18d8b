// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "sil/bench_at_world.hpp"

namespace fantail::sil {

/// The same bench behind a cable that changes or swallows what the rocket sends.
class BusFilter final : public link::Place, public hal::CanBus {
 public:
  /// `change` is asked for every frame: false, and it does not arrive.
  using Change = std::function<bool(hal::CanFrame&)>;
  BusFilter(BenchAtWorld& place, Change change) : place_{place}, change_{std::move(change)} {}

  [[nodiscard]] hal::CanBus& bus() override { return *this; }
  [[nodiscard]] hal::Microseconds now() const override { return place_.now(); }
  void wait(hal::Microseconds at_most) override { place_.wait(at_most); }

  bool send(const hal::CanFrame& frame) override { return place_.bus().send(frame); }
  std::optional<hal::CanFrame> receive() override {
    while (auto frame = place_.bus().receive()) {
      if (change_(*frame)) {
        return frame;
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] hal::CanState state() const override { return place_.pc_bus.state(); }
  [[nodiscard]] hal::CanCounters counters() const override { return place_.pc_bus.counters(); }

 private:
  BenchAtWorld& place_;
  Change change_;
};

}  // namespace fantail::sil
