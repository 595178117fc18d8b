// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>

namespace fantail::telemetry {

/// How well one channel is heard. Of the numbers from the first one heard to the highest, each is received or lost.
struct ChannelFigures {
  std::int64_t received = 0;    ///< different messages
  std::int64_t lost = 0;        ///< numbers that have not come; one that comes late is lost no more
  std::int64_t late = 0;        ///< came after one with a higher number
  std::int64_t duplicate = 0;   ///< came again
  std::int64_t ignored = 0;     ///< of another sender, or so far off that it cannot belong here
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
  /// Nobody loses more in one piece and is still the same: 100 s of the fastest channel.
  static constexpr std::int64_t longest_gap = 10'000;

  Arrival take(std::int64_t sequence, ChannelFigures& figures);
  void begin_anew() { *this = SequenceWatch{}; }

 private:
  std::optional<std::int64_t> first_;
  std::int64_t highest_ = 0;
  std::bitset<window> seen_;  ///< bit i: highest_ - i was here
};

}  // namespace fantail::telemetry
