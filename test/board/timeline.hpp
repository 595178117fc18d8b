// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace fantail::board {

/// The time of a virtual board. It goes by with the cycles of its processor, whose length changes with the clock tree,
/// and something may happen at any instant of it.
class Timeline {
 public:
  /// One cycle is this many counts: a processor that takes 1.7 cycles an instruction is counted exactly enough.
  static constexpr std::uint64_t counts_per_cycle = 256;

  /// Of the processor, from now on.
  void set_frequency_hz(double frequency_hz);
  [[nodiscard]] double frequency_hz() const { return frequency_hz_; }

  void spend(std::uint64_t counts) { counts_ += counts; }
  /// Nothing happens before that instant.
  void spend_until(double time_s);
  [[nodiscard]] std::uint64_t counts() const { return counts_; }
  [[nodiscard]] std::uint64_t cycles() const { return counts_ / counts_per_cycle; }
  /// Since power-up.
  [[nodiscard]] double now_s() const { return time_of(counts_); }

  // ---- what happens ----

  /// What happens each time that this event is due; it is not scheduled yet.
  using Event = std::size_t;
  [[nodiscard]] Event add(std::function<void()> what);
  /// Once, at that instant, or as soon as somebody looks when it is over already. Instead of any time before.
  void schedule(Event event, double time_s);
  /// The same, at so many counts of the processor's clock, however long they take.
  void schedule_at_counts(Event event, std::uint64_t counts);
  void cancel(Event event);

  [[nodiscard]] bool is_due() const { return counts_ >= next_; }
  /// All that is due by now, in the order of their times.
  void run();
  /// Sleeps until the next event, and lets it happen. There is one.
  void sleep();

 private:
  struct Entry {
    std::function<void()> what;
    std::optional<double> time_s;
    std::optional<std::uint64_t> at_counts;
  };

  [[nodiscard]] double time_of(std::uint64_t counts) const;
  [[nodiscard]] std::uint64_t counts_at(double time_s) const;
  void find_next();

  std::uint64_t counts_ = 0;
  std::uint64_t base_counts_ = 0;
  double base_s_ = 0.0;
  double frequency_hz_ = 16e6;
  std::uint64_t next_ = UINT64_MAX;
  std::size_t next_entry_ = 0;
  std::vector<Entry> entries_;
};

}  // namespace fantail::board
