// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>

#include "protocol/bus_messages.hpp"

namespace fantail::protocol {

/// A frame with an 11-bit identifier.
struct BusFrame {
  std::uint16_t id = 0;
  std::uint8_t length = 0;
  alignas(4) std::array<std::uint8_t, 8> data{};
  friend bool operator==(const BusFrame&, const BusFrame&) = default;
};

// Values outside what a frame can hold are clamped before they are encoded, never wrapped; what is not a number becomes
// zero (in a canard's angle: an absent one). The counter of a frame that has one is its sender's, 0 to 15, one more
// with every frame of that kind.

/// `session`: the sender's own.
[[nodiscard]] BusFrame encode(const BenchRequest& message, std::uint8_t counter, std::uint16_t session);
[[nodiscard]] BusFrame encode(const BenchSession& message, std::uint8_t counter);
[[nodiscard]] BusFrame encode(const ArmRequest& message, std::uint8_t counter);
[[nodiscard]] BusFrame encode(const PlanBegin& message, std::uint8_t counter);
[[nodiscard]] BusFrame encode(const PlanData& message);
[[nodiscard]] BusFrame encode(const LogRequest& message, std::uint8_t counter);

[[nodiscard]] BusFrame encode(const CommandReport& message, std::uint8_t counter);
[[nodiscard]] BusFrame encode(const EncoderReport& message, std::uint8_t counter);
[[nodiscard]] BusFrame encode(const StatusReport& message);
[[nodiscard]] BusFrame encode(const MotionReport& message);
[[nodiscard]] BusFrame encode(const SessionReply& message);
[[nodiscard]] BusFrame encode(const ArmReply& message);
[[nodiscard]] BusFrame encode(const PlanReply& message);
[[nodiscard]] BusFrame encode(const LogReply& message);
[[nodiscard]] BusFrame encode(const HealthReport& message);
[[nodiscard]] BusFrame encode(const RejectionReport& message);
[[nodiscard]] BusFrame encode(const LimitReport& message);
[[nodiscard]] BusFrame encode(const BoardReport& message);
[[nodiscard]] BusFrame encode(const GyroReport& message);
[[nodiscard]] BusFrame encode(const AccelerometerReport& message);
[[nodiscard]] BusFrame encode(const HeartbeatReport& message);
[[nodiscard]] BusFrame encode(const LogData& message);

using FromBench = std::variant<BenchRequest, BenchSession, ArmRequest, PlanBegin, PlanData, LogRequest>;
using FromAvionics = std::variant<CommandReport, EncoderReport, StatusReport, MotionReport, SessionReply, ArmReply,
                                  PlanReply, LogReply, HealthReport, RejectionReport, LimitReport, BoardReport,
                                  GyroReport, AccelerometerReport, HeartbeatReport, LogData>;

template <typename Message>
struct Decoded {
  std::optional<Message> message{};
  Rejection rejection{};                  ///< when there is no message
  std::optional<std::uint8_t> counter{};  ///< of a message that has one; whether it follows on, a Sequence knows
};

/// The messages to the avionics. Every bit is looked at: identifier, length, CRC-8, and every value against the range
/// that the database states. `session`: the one that is open; a request for another one has a wrong CRC-8, and while
/// none is open every request is stale.
[[nodiscard]] Decoded<FromBench> decode_from_bench(const BusFrame& frame, std::optional<std::uint16_t> session);

/// A request for one of the two sessions is never taken for one of the other. A CRC-8 cannot do that for all pairs of
/// numbers: of 256 it takes one for the same.
[[nodiscard]] bool told_apart(std::uint16_t session, std::uint16_t other);

/// The messages that a bench may receive.
[[nodiscard]] Decoded<FromAvionics> decode_from_avionics(const BusFrame& frame);

/// The 4-bit counter of one kind of frame, at its sender: 0 to 15, and around.
class FrameCounter {
 public:
  [[nodiscard]] std::uint8_t next() { return counter_++ & 0x0FU; }

 private:
  std::uint8_t counter_ = 0;
};

/// The same at its receiver.
class Sequence {
 public:
  /// How many frames were lost just before this one, 0 to 14, or empty when it is a repetition of the last one. The
  /// first frame follows on by definition; every frame becomes the new last one.
  std::optional<std::uint8_t> lost_before(std::uint8_t counter);

 private:
  std::optional<std::uint8_t> last_;
};

}  // namespace fantail::protocol
