// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "core/inputs.hpp"
#include "hal/can_bus.hpp"
#include "hal/clock.hpp"
#include "link/frame_order.hpp"
#include "link/heartbeats.hpp"
#include "link/place.hpp"
#include "protocol/bus_codec.hpp"

namespace fantail::link {

template <typename T>
using Each = std::array<T, core::canard_count>;

/// The avionics' reports of one millisecond.
struct Tick {
  std::int64_t number = 0;                    ///< milliseconds by the frames' own counter
  Each<std::optional<double>> command_rad{};  ///< empty: not driven
  Each<std::optional<double>> encoder_rad{};  ///< empty: no valid reading
  Each<bool> limited{};                       ///< as last reported
  std::size_t stretch = 0;                    ///< of the exercise; may begin some milliseconds early
};

/// The ticks of one exercise, in order. Bounded: it holds no more than `longest` and spans no more than that many
/// milliseconds, whatever numbers come in.
class Recording {
 public:
  static constexpr std::size_t two_minutes = 120'000;
  /// Takes its memory here: to move what is recorded takes longer, on a slow PC, than the avionics waits for a
  /// heartbeat.
  explicit Recording(std::size_t longest = two_minutes) : longest_{longest} {
    ticks_.reserve(std::min(longest, two_minutes));
  }

  /// False, and nothing kept: not after the last one, or beyond the longest span.
  bool add(const Tick& tick);

  [[nodiscard]] std::span<const Tick> ticks() const { return ticks_; }
  /// Numbers between the first and the last tick that never came.
  [[nodiscard]] std::size_t lost_ticks() const;
  /// Ticks that came out of order, twice, or too late to be kept.
  [[nodiscard]] std::size_t refused_ticks() const { return refused_; }

 private:
  std::size_t longest_;
  std::size_t refused_ = 0;
  std::vector<Tick> ticks_;
};

/// How well the bench receives.
struct LinkFigures {
  std::uint64_t frames = 0;     ///< from the avionics, valid
  std::uint64_t foreign = 0;    ///< with an unknown identifier, or from another bench
  std::uint64_t damaged = 0;    ///< from the avionics, but invalid: length, CRC-8 or range
  std::uint64_t lost = 0;       ///< command and encoder frames that never came, by their counters
  std::uint64_t wire_bits = 0;  ///< of all frames, stuff bits included
};

/// The newest message of one kind.
template <typename Message>
struct Heard {
  Message message{};
  hal::Microseconds time{};  ///< when it came
  std::uint64_t count = 0;   ///< how many there have been
};

/// Receives from the avionics: the newest message of every kind with its time, and the ticks in order.
class AvionicsLink {
 public:
  explicit AvionicsLink(hal::CanBus& bus) : bus_{bus} {}

  /// Takes in what has arrived: all of it, unless frames come faster than they are read. True: there is more.
  bool listen(hal::Microseconds now, int most_frames = 1'000);
  /// There were status reports, but none for the last two seconds of receiving.
  [[nodiscard]] bool has_fallen_silent() const { return silent_; }

  /// Empty when no such message has ever come.
  template <typename Message>
  [[nodiscard]] const std::optional<Heard<Message>>& newest() const {
    return std::get<std::optional<Heard<Message>>>(heard_);
  }
  /// The newest message. Throws LinkError if none has ever arrived; `what` names it in the sentence: "canard limits".
  template <typename Message>
  [[nodiscard]] const Message& reported(const char* what) const {
    const auto& heard = newest<Message>();
    if (!heard) {
      throw LinkError{std::string{"the avionics has not reported its "} + what};
    }
    return heard->message;
  }
  /// How many there have been.
  template <typename Message>
  [[nodiscard]] std::uint64_t count() const {
    return newest<Message>() ? newest<Message>()->count : 0;
  }
  /// The newest message, when it is not older than `age`.
  template <typename Message>
  [[nodiscard]] std::optional<Message> recent(hal::Microseconds now, hal::Microseconds age) const {
    const auto& heard = newest<Message>();
    return heard && now - heard->time <= age ? std::optional{heard->message} : std::nullopt;
  }

  /// The oldest tick not yet taken. A tick is a command and an encoder report with the same counter; its number is that
  /// counter, unwrapped, so it counts milliseconds while the avionics reports every one.
  std::optional<Tick> take_tick();
  void forget_ticks() { ticks_.clear(); }

  /// The oldest piece of the flight record not yet taken.
  std::optional<protocol::LogData> take_log_data();
  void forget_log_data() { log_data_.clear(); }

  [[nodiscard]] const LinkFigures& figures() const { return figures_; }
  /// Frames that reached this PC and were lost there, because nobody read them in time.
  [[nodiscard]] std::uint32_t overrun() const { return bus_.counters().overrun; }
  /// Throws TwoRockets as soon as the received reports cannot come from one avionics.
  void expect_one_rocket() const {
    if (const auto why = two_rockets()) {
      throw TwoRockets{*why};
    }
  }
  /// The message that it throws; empty: only one rocket.
  [[nodiscard]] std::optional<std::string> two_rockets() const;
  /// The newest report of the board, with every fault that any of its reports had.
  [[nodiscard]] const std::optional<protocol::BoardReport>& board() const { return board_; }
  /// The rocket's own clock less our count of its ticks, by the newest heartbeat. While every tick is reported it
  /// changes only when ticks were lost that their counter, modulo 16, could not show.
  [[nodiscard]] std::optional<std::int64_t> uncounted_ms() const { return uncounted_ms_; }

 private:
  template <typename Variant>
  struct OneOfEach;
  template <typename... Messages>
  struct OneOfEach<std::variant<Messages...>> {
    using Tuple = std::tuple<std::optional<Heard<Messages>>...>;
  };

  /// The counter of the command and encoder reports: 4 bits.
  using FrameNumber = WrappingCounter<16>;

  template <typename Message>
  void keep(const Message& message, hal::Microseconds now);
  void take(const protocol::CommandReport& report, std::uint8_t counter);
  void take(const protocol::EncoderReport& report, std::uint8_t counter);
  void take(const protocol::BoardReport& report);
  void take(const protocol::HeartbeatReport& report, hal::Microseconds now);
  void unwrap(std::optional<FrameNumber>& last, std::uint8_t counter);

  hal::CanBus& bus_;
  OneOfEach<protocol::FromAvionics>::Tuple heard_{};
  LinkFigures figures_{};
  std::optional<Timeout> silence_;
  bool silent_ = false;
  Heartbeats heartbeats_;
  std::optional<hal::Microseconds> emptied_{};             ///< when there was last nothing more to listen to
  std::optional<hal::Microseconds> heartbeat_no_older_{};  ///< the newest one came no earlier
  FrameOrder command_order_;
  std::optional<protocol::BoardReport> board_;
  std::optional<FrameNumber> last_command_;
  std::optional<FrameNumber> last_encoder_;
  std::optional<std::int64_t> uncounted_ms_;
  protocol::CommandReport command_{};
  std::deque<Tick> ticks_;
  std::deque<protocol::LogData> log_data_;
};

}  // namespace fantail::link
