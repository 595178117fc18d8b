// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <optional>

#include "protocol/bus_choices.hpp"
#include "protocol/bus_codec.hpp"
#include "protocol/bus_frames.hpp"
#include "protocol/bus_log_choices.hpp"

namespace fantail::protocol {
namespace {

std::optional<BenchRequest> read_request(const BenchRequestFrame::Raw& raw) {
  const auto angles = signals::asked.angles(raw);
  if (!angles) {
    return std::nullopt;
  }
  // The angle of a canard that is not signals::asked has no meaning, so its bits must be zero like all others without
  // one.
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    if (raw.*signals::asked.given[i] == 0 && raw.*signals::asked.angle[i] != 0) {
      return std::nullopt;
    }
  }
  return BenchRequest{.angle = *angles};
}

std::optional<BenchSession> read_session(const BenchSessionFrame::Raw& raw) {
  const auto action = known<SessionAction>(raw.action);
  return action ? std::optional{BenchSession{.action = *action, .session = raw.session}} : std::nullopt;
}

std::optional<ArmRequest> read_arm(const ArmRequestFrame::Raw& raw) {
  const auto action = known<ArmAction>(raw.action);
  return action ? std::optional{ArmRequest{.action = *action, .nonce = raw.nonce}} : std::nullopt;
}

// Of any size and index: what a transfer cannot use it refuses with a reason of its own.
std::optional<PlanBegin> read_begin(const PlanBeginFrame::Raw& raw) {
  return PlanBegin{.size = raw.size, .block_crc = raw.block_crc};
}

std::optional<PlanData> read_data(const PlanDataFrame::Raw& raw) {
  PlanData message{.index = raw.index};
  for (std::size_t i = 0; i < message.bytes.size(); ++i) {
    message.bytes[i] = std::byte{raw.*signals::bytes<PlanDataFrame::Raw>[i]};
  }
  return message;
}

// Of any place and size, as above.
std::optional<LogRequest> read_log(const LogRequestFrame::Raw& raw) {
  const auto action = known<LogAction>(raw.action);
  return action ? std::optional{LogRequest{.action = *action, .tag = raw.tag, .offset = raw.offset, .size = raw.size}}
                : std::nullopt;
}

}  // namespace

Decoded<FromBench> decode_from_bench(const BusFrame& frame, std::optional<std::uint16_t> session) {
  constexpr bool strict = true;
  switch (frame.id) {
    case BenchRequestFrame::id:
      if (!session && frame.length == BenchRequestFrame::length) {
        return {.rejection = Rejection::stale};
      }
      return decode_as<FromBench, BenchRequestFrame, strict>(frame, read_request, session);
    case BenchSessionFrame::id: return decode_as<FromBench, BenchSessionFrame, strict>(frame, read_session);
    case ArmRequestFrame::id: return decode_as<FromBench, ArmRequestFrame, strict>(frame, read_arm);
    case PlanBeginFrame::id: return decode_as<FromBench, PlanBeginFrame, strict>(frame, read_begin);
    case PlanDataFrame::id: return decode_as<FromBench, PlanDataFrame, strict>(frame, read_data);
    case LogRequestFrame::id: return decode_as<FromBench, LogRequestFrame, strict>(frame, read_log);
    default: return {.rejection = Rejection::unknown_id};
  }
}

}  // namespace fantail::protocol
