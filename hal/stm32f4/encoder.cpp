// SPDX-License-Identifier: MIT
#include "hal/stm32f4/encoder.hpp"

#include <algorithm>

#include "hal/stm32f4/as5047p.hpp"

namespace fantail::hal::stm32f4 {
namespace {

constexpr std::uint8_t reads_to_begin = 20;  // power-up takes 10 ms at most
constexpr std::uint8_t most_zeros = 10;
constexpr std::uint16_t near_zero = 64;  // further than a shaft turns in two milliseconds

}  // namespace

EncoderReading Encoder::read() {
  EncoderReading reading{.time = asked_at_};
  asked_at_ = clock_.now();
  for (std::size_t i = 0; i < canards; ++i) {
    Channel& channel = channels_[i];
    const Request request = next_request(i);
    judge(channel, exchange(i, request), request);
    channel.asked = request;
    const auto counts =
        reversed_[i] ? static_cast<std::uint16_t>(encoder_counts_per_turn - channel.angle) : channel.angle;
    reading.each[i] = {.counts = static_cast<std::uint16_t>(counts % encoder_counts_per_turn),
                       .status = channel.status};
  }
  tick_ = static_cast<std::uint8_t>((tick_ + 1) % diagnosis_period);
  return reading;
}

BoardFaults Encoder::faults() const {
  BoardFaults faults;
  if (std::ranges::any_of(channels_, [](const Channel& channel) { return channel.silent > reads_to_begin; })) {
    faults.add(BoardFault::encoder_silent);
  }
  return faults;
}

Encoder::Request Encoder::next_request(std::size_t which) const {
  if (channels_[which].flagged) {
    return Request::errors;
  }
  // One after the other, so that in no tick two of them come without a new angle.
  constexpr std::size_t apart = diagnosis_period / canards;
  return tick_ == apart * which + apart / 2 ? Request::diagnosis : Request::angle;
}

std::optional<std::uint16_t> Encoder::exchange(std::size_t which, Request request) {
  std::uint16_t command = as5047p::read_command(as5047p::angle);
  if (request == Request::errors) {
    command = as5047p::read_command(as5047p::errors);
  } else if (request == Request::diagnosis) {
    command = as5047p::read_command(as5047p::diagnosis);
  }
  const std::array out{static_cast<std::byte>(command >> 8U), static_cast<std::byte>(command & 0xFFU)};
  std::array<std::byte, 2> in{};
  if (!devices_[which].transfer(out, in)) {
    return std::nullopt;
  }
  return static_cast<std::uint16_t>(std::to_integer<std::uint16_t>(in[0]) << 8U |
                                    std::to_integer<std::uint16_t>(in[1]));
}

void Encoder::judge(Channel& channel, std::optional<std::uint16_t> frame, Request sent) {
  constexpr std::uint16_t all_ones = 0xFFFF;
  channel.zeros = frame == 0 ? static_cast<std::uint8_t>(std::min(channel.zeros + 1, most_zeros + 1)) : std::uint8_t{0};
  const bool zero_is_an_answer =
      channel.asked == Request::errors || (channel.asked == Request::angle && may_be_zero(channel));
  if (!frame || frame == all_ones || (frame == 0 && !zero_is_an_answer)) {
    channel.status = Status::no_reading;
    channel.flagged = false;
    channel.silent = static_cast<std::uint8_t>(std::min(channel.silent + 1, reads_to_begin + 1));
    return;
  }
  channel.silent = 0;
  // ERRFL has been asked for: until its content is here, the flag stays as it is.
  channel.flagged = false;
  if (!as5047p::is_even(*frame) || channel.asked == Request::errors) {
    channel.status = Status::error;
  } else if ((*frame & as5047p::error_flag) != 0) {
    channel.status = Status::error;
    channel.flagged = sent != Request::errors;
  } else if (channel.asked == Request::diagnosis) {
    constexpr std::uint16_t bad = as5047p::field_too_low | as5047p::field_too_high | as5047p::cordic_overflow;
    channel.magnet_ok = (*frame & bad) == 0 && (*frame & as5047p::offsets_ready) != 0;
    if (!channel.magnet_ok) {
      channel.status = Status::error;
    }
  } else if (channel.asked == Request::angle) {
    channel.status = judge_angle(channel, *frame);
  }
}

Status Encoder::judge_angle(Channel& channel, std::uint16_t frame) {
  channel.angle = frame & as5047p::data_mask;
  return channel.magnet_ok ? Status::ok : Status::error;
}

// The angle 0 is a frame of zeros, and so is a line that is held down. A shaft gets there from nearby, and its noise of
// some counts does not leave it there.
bool Encoder::may_be_zero(const Channel& channel) {
  const bool nearby = channel.angle < near_zero || channel.angle > encoder_counts_per_turn - near_zero;
  return channel.status != Status::no_reading && nearby && channel.zeros <= most_zeros;
}

}  // namespace fantail::hal::stm32f4
