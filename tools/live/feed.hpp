// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/tick_record.hpp"
#include "hal/clock.hpp"
#include "json/value.hpp"
#include "live/plot_history.hpp"
#include "telemetry/receiver.hpp"

namespace fantail::live {

/// Facts for a page beyond the messages.
struct Source {
  std::string name{};  ///< where the messages come from, for people: "tasha3_launch2, simulated", "udpm://"
  /// How far from its reference the roll comes to rest: disturbance over proportional gain. Known of a simulation
  /// alone.
  std::optional<double> settles_off_rad{};
  /// What has ended when no more comes, for people.
  std::string what_ends{"The program behind this page"};
};

/// Turns the messages of a rocket into frames for the page: the newest values, and what there is to plot since the
/// frame before. take() and frame() are for one thread, greeting() for any.
class Feed {
 public:
  explicit Feed(Source source) : source_{std::move(source)} {}

  /// Whatever came on a channel of LCM. `now` is the listener's clock.
  void take(std::string_view channel, std::span<const std::byte> bytes, hal::Microseconds now);

  /// From here on every frame says that no more comes; for any thread.
  void end();

  /// One line of JSON.
  [[nodiscard]] std::string frame(hal::Microseconds now);
  /// The frame for a new viewer: everything in the frames so far, as far as it is kept.
  [[nodiscard]] std::string greeting(hal::Microseconds now) const;

 private:
  struct Told {
    double time_s;
    std::string text;
  };
  static constexpr std::size_t most_events = 100;

  void follow_state();
  void follow_events();
  [[nodiscard]] json::Value now_json(hal::Microseconds now) const;
  [[nodiscard]] json::Value link_json(hal::Microseconds now) const;
  [[nodiscard]] json::Value canards_json() const;
  [[nodiscard]] json::Value health_json() const;

  Source source_;
  mutable std::mutex mutex_;
  bool ended_ = false;
  std::optional<hal::Microseconds> first_came_;  ///< by the listener's clock
  telemetry::Receiver receiver_;
  PlotHistory plots_{signals};
  std::optional<std::int64_t> run_;            ///< whose plots and events these are
  std::optional<hal::Microseconds> launched_;  ///< the detection of the launch that is flown, by the rocket's clock
  std::optional<core::Phase> phase_;
  std::deque<Told> events_;
  std::size_t untold_events_ = 0;  ///< so many of them, the newest
  std::uint64_t number_ = 0;       ///< of the last frame
};

}  // namespace fantail::live
