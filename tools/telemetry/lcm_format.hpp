// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::telemetry {

// How LCM sends messages and keeps them in a log, as far as messages of ours go. It is read here and not by LCM's own
// library, because that of Debian 12 (1.3.1) copies a fragment of a long message to wherever its sender says: two
// packets of a stranger end the program, or write into it.

/// Every channel of ours begins so.
inline constexpr std::string_view channel_prefix = "FANTAIL_";
/// No message of ours is a fifth as long.
inline constexpr std::size_t longest_datagram = 1'500;

/// A message in the bytes of somebody else.
struct MessageView {
  std::string_view channel;
  std::span<const std::byte> bytes;
};

/// The message of one UDP packet; empty for a fragment, for what is not LCM, and for one that is longer.
[[nodiscard]] std::optional<MessageView> read_datagram(std::span<const std::byte> datagram);

/// An LCM log, event by event. What is damaged is passed over, up to the next word that an event begins with.
class LcmLog {
 public:
  /// Fills the place with what comes next; 0 at the end.
  using Read = std::function<std::size_t(std::span<char>)>;
  struct Event {
    std::int64_t time_us = 0;  ///< by the clock of whoever wrote the log
    std::string channel;
    std::vector<std::byte> bytes;  ///< empty on a channel of somebody else
  };

  explicit LcmLog(Read read) : read_{std::move(read)} {}

  /// Empty at the end.
  [[nodiscard]] std::optional<Event> next();

  /// Bytes so far that belong to no whole event; at the end of a log that was cut off, those of its last one.
  [[nodiscard]] std::uint64_t foreign_bytes() const { return passed_ - whole_; }

 private:
  [[nodiscard]] std::optional<std::uint8_t> byte();
  [[nodiscard]] std::optional<std::uint64_t> number(std::size_t bytes);
  [[nodiscard]] bool find_event();
  template <typename Bytes>
  [[nodiscard]] bool take(Bytes& to, std::size_t size);
  [[nodiscard]] bool skip(std::uint64_t size);

  Read read_;
  std::vector<char> portion_;
  std::size_t used_ = 0;  ///< of the portion
  std::uint64_t passed_ = 0;
  std::uint64_t whole_ = 0;  ///< of them, those of the events that were given
};

}  // namespace fantail::telemetry
