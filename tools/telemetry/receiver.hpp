// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bitset>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include "hal/clock.hpp"
#include "telemetry/messages.hpp"
#include "telemetry/url.hpp"

namespace fantail::telemetry {

/// Receives our channels from an LCM network, or from a log at its own pace.
class Subscription {
 public:
  /// Takes one message: its channel and its bytes.
  using Take = std::function<void(std::string_view channel, std::span<const std::byte> bytes)>;

  /// Throws TelemetryError.
  explicit Subscription(const Url& url);
  ~Subscription();
  Subscription(const Subscription&) = delete;
  Subscription& operator=(const Subscription&) = delete;

  /// Until something has come, at most so long; a signal ends it early.
  void wait(std::chrono::milliseconds at_most) const;

  /// Hands over all that has come. False: the log has ended.
  bool listen(const Take& take);

  /// Of a log, so far: bytes that belong to no whole event.
  [[nodiscard]] std::uint64_t foreign_bytes() const;

 private:
  class Network;
  class Log;
  std::unique_ptr<Network> network_;  ///< one of the two
  std::unique_ptr<Log> log_;
};

/// How well one channel is received. Of the numbers from the first received to the highest, each is received or lost.
struct ChannelFigures {
  std::int64_t received = 0;    ///< different messages
  std::int64_t lost = 0;        ///< numbers that have not come; one that comes late is lost no more
  std::int64_t late = 0;        ///< came after one with a higher number
  std::int64_t duplicate = 0;   ///< came again
  std::int64_t ignored = 0;     ///< from another sender, or with a number far from the others
  std::int64_t unreadable = 0;  ///< no message of this channel's type
  friend bool operator==(const ChannelFigures&, const ChannelFigures&) = default;
};

[[nodiscard]] ChannelFigures difference(const ChannelFigures& now, const ChannelFigures& before);

enum class Arrival : std::uint8_t {
  newest,     ///< higher than all before: the only one that may replace what is known
  late,       ///< fills a gap
  duplicate,  ///< has been here
  far_off,    ///< so far from the others that it cannot be told what it is
};

/// Follows the numbers of one channel of one sender, and counts.
class SequenceWatch {
 public:
  /// Numbers so far below the highest can still be told apart, late from twice: 10 s of the fastest channel.
  static constexpr std::int64_t window = 1024;
  /// A larger gap means another sender: 100 s of the fastest channel.
  static constexpr std::int64_t longest_gap = 10'000;

  Arrival take(std::int64_t sequence, ChannelFigures& figures);
  void begin_anew() { *this = SequenceWatch{}; }

 private:
  std::optional<std::int64_t> first_;
  std::int64_t highest_ = 0;
  std::bitset<window> seen_;  ///< bit i: highest_ - i was here
};

/// The newest message of one kind, and when it came by the receiver's clock.
template <typename Content>
struct Heard {
  Content content{};
  Stamp stamp{};
  hal::Microseconds came{};
};

/// The state of one sender, received over a link that may lose, reorder and repeat: an older message never takes the
/// place of a newer one.
class Receiver {
 public:
  /// Without new messages, values are old after this time.
  static constexpr hal::Microseconds stale_after{1'000'000};
  /// So long back go the recent figures.
  static constexpr hal::Microseconds recent_time{5'000'000};
  /// So many messages in rising order are another start: of a sender, or of a log that is played again.
  static constexpr int restart_after = 50;

  /// `start`: by the receiver's clock.
  explicit Receiver(hal::Microseconds start = {}) : marks_{{.time = start, .totals = {}}} {}

  /// Whatever came on a channel of LCM.
  void take(std::string_view channel, std::span<const std::byte> bytes, hal::Microseconds now);

  [[nodiscard]] const std::optional<Heard<State>>& state() const { return std::get<0>(heard_); }
  [[nodiscard]] const std::optional<Heard<Canards>>& canards() const { return std::get<1>(heard_); }
  [[nodiscard]] const std::optional<Heard<Health>>& health() const { return std::get<3>(heard_); }
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
  std::tuple<std::optional<Heard<State>>, std::optional<Heard<Canards>>, std::optional<Heard<Event>>,
             std::optional<Heard<Health>>>
      heard_;  ///< the newest of each channel
  std::vector<Heard<Event>> events_;
};

}  // namespace fantail::telemetry
