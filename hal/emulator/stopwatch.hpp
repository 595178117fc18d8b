// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fantail::hal::emulator {

/// Time of the processor's own clock, and a way to leave a part of it out.
class Stopwatch {
 public:
  virtual ~Stopwatch() = default;
  /// Counts of the clock up to now, wrapped around.
  [[nodiscard]] virtual std::uint32_t counts() = 0;

  /// Counts that asking takes, which are left out too.
  [[nodiscard]] std::uint32_t cost() const { return cost_; }
  void find_cost() {
    const std::uint32_t before = counts();
    cost_ = counts() - before;
  }

  void begin() {
    left_out_ = 0;
    begin_ = counts();
  }
  [[nodiscard]] std::uint32_t end() { return counts() - begin_ - left_out_ - cost_; }
  void leave_out(std::uint32_t counts) { left_out_ += counts; }

  /// While it exists, time is left out.
  class Pause {
   public:
    explicit Pause(Stopwatch& stopwatch) : stopwatch_{stopwatch}, begin_{stopwatch.counts()} {}
    ~Pause() { stopwatch_.leave_out(stopwatch_.counts() - begin_ + stopwatch_.cost()); }
    Pause(const Pause&) = delete;
    Pause& operator=(const Pause&) = delete;

   private:
    Stopwatch& stopwatch_;
    std::uint32_t begin_;
  };

 private:
  std::uint32_t begin_ = 0;
  std::uint32_t left_out_ = 0;
  std::uint32_t cost_ = 0;
};

}  // namespace fantail::hal::emulator
