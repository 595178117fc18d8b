// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "hal/clock.hpp"
#include "telemetry/messages.hpp"
#include "telemetry/sequence_watch.hpp"

namespace fantail::telemetry {

/// The newest message of one kind, and when it came by the receiver's clock.
template <typename Content>
struct Heard {
  Content content{};
  Stamp stamp{};
  hal::Microseconds came{};
};

/// What a listener knows of one sender, over a link that may lose, reorder and repeat: an older message never takes the
/// place of a newer one.
class Receiver {
 public:
  /// As long as nothing new comes, what is known is old after this time.
  static constexpr hal::Microseconds stale_after{1'000'000};
  /// So long back go the recent figures.
  static constexpr hal::Microseconds recent_time{5'000'000};
  /// So many messages in rising order are another start: of a sender, or of a log that is played again.
  static constexpr int restart_after = 50;

  /// `start`: by the receiver's clock.
  explicit Receiver(hal::Microseconds start = {}) : marks_{{.time = start, .totals = {}}} {}

  /// Whatever came on a channel of LCM.
  void take(std::string_view channel, std::span<const std::byte> bytes, hal::Microseconds now);

  [[nodiscard]] const std::optional<Heard<State>>& state() const { return state_; }
  [[nodiscard]] const std::optional<Heard<Canards>>& canards() const { return canards_; }
  [[nodiscard]] const std::optional<Heard<Health>>& health() const { return health_; }
  /// Since the last call, in the order of their time. A late one is still told.
  [[nodiscard]] std::vector<Heard<Event>> take_events();

  [[nodiscard]] const ChannelFigures& total(Channel channel) const { return totals_[index(channel)]; }
  /// In the last five seconds, as far as look() has been called. `lost` is less than nothing when something that had
  /// been missed came late.
  [[nodiscard]] ChannelFigures recent(Channel channel) const;
  [[nodiscard]] hal::Microseconds recent_span() const;
  /// Marks the time for recent().
  void look(hal::Microseconds now);

  [[nodiscard]] int restarts() const { return restarts_; }

 private:
  struct Suspect {
    std::int64_t run = 0;
    std::int64_t sequence = 0;
    int rising = 0;
  };
  struct Mark {
    hal::Microseconds time{};
    std::array<ChannelFigures, channel_count> totals{};
  };

  static std::size_t index(Channel channel) { return static_cast<std::size_t>(channel); }
  void take(Channel channel, const Decoded& message, hal::Microseconds now);
  [[nodiscard]] bool is_another_start(Channel channel, const Stamp& stamp);
  void begin_anew(std::int64_t run);
  void keep(const Decoded& message, Arrival arrival, hal::Microseconds now);

  std::optional<std::int64_t> run_;
  std::set<std::int64_t> earlier_runs_;
  int restarts_ = 0;
  hal::Microseconds last_news_{};
  std::array<SequenceWatch, channel_count> sequences_{};
  std::array<Suspect, channel_count> suspects_{};
  std::array<ChannelFigures, channel_count> totals_{};
  std::deque<Mark> marks_;
  std::optional<Heard<State>> state_;
  std::optional<Heard<Canards>> canards_;
  std::optional<Heard<Health>> health_;
  std::vector<Heard<Event>> events_;
};

}  // namespace fantail::telemetry
