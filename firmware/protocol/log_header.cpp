// SPDX-License-Identifier: MIT
#include "protocol/log_header.hpp"

#include <algorithm>
#include <bit>

#include "protocol/little_endian.hpp"

namespace fantail::protocol {
namespace {

constexpr std::size_t scales_at = 16;
constexpr std::size_t texts_at = 28;
static_assert(texts_at + 4 * log_text_size == log_header_fixed_size);

void put_float(std::span<std::byte> out, std::size_t at, float value) {
  put<4>(out, at, std::bit_cast<std::uint32_t>(value));
}

float get_float(std::span<const std::byte> in, std::size_t at) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(get<4>(in, at)));
}

void put_text(std::span<std::byte> out, std::size_t index, std::string_view text) {
  const auto room = out.subspan(texts_at + index * log_text_size, log_text_size);
  std::ranges::transform(text.substr(0, log_text_size), room.begin(), [](char c) { return static_cast<std::byte>(c); });
}

std::string_view view(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};  // NOLINT: bytes seen as the text they are
}

std::string_view get_text(std::span<const std::byte> in, std::size_t index) {
  const std::string_view room = view(in.subspan(texts_at + index * log_text_size, log_text_size));
  return room.substr(0, room.find('\0'));
}

}  // namespace

std::array<std::byte, log_header_fixed_size> encode(const LogHeader& header) {
  std::array<std::byte, log_header_fixed_size> out{};
  put<2>(out, 0, header.second_rate_scale_rad_s ? log_format_version_of_two_gyros : header.format_version);
  put<2>(out, 2, header.plan_block.size());
  put<4>(out, 4, header.flight);
  put<4>(out, 8, header.power_up);
  put<4>(out, 12, header.state_layout);
  put_float(out, scales_at, header.rate_scale_rad_s);
  put_float(out, scales_at + 4, header.specific_force_scale_m_s2);
  put_float(out, scales_at + 8, header.accelerometer_scale_m_s2);
  put_text(out, 0, header.firmware_version);
  put_text(out, 1, header.git_hash);
  put_text(out, 2, header.vehicle);
  put_text(out, 3, header.sensors);
  return out;
}

std::array<std::byte, second_rate_scale_size> encode_second_rate_scale(const LogHeader& header) {
  std::array<std::byte, second_rate_scale_size> out{};
  put_float(out, 0, header.second_rate_scale_rad_s.value_or(0.0F));
  return out;
}

std::optional<LogHeader> decode_log_header(std::span<const std::byte> payload) {
  if (payload.size() < log_header_fixed_size) {
    return std::nullopt;
  }
  const auto plan_size = static_cast<std::size_t>(get<2>(payload, 2));
  auto rest = payload.subspan(log_header_fixed_size);
  std::optional<float> second_rate_scale_rad_s;
  if (get<2>(payload, 0) == log_format_version_of_two_gyros) {
    if (rest.size() < second_rate_scale_size) {
      return std::nullopt;
    }
    second_rate_scale_rad_s = get_float(rest, 0);
    rest = rest.subspan(second_rate_scale_size);
  }
  if (plan_size > rest.size()) {
    return std::nullopt;
  }
  return LogHeader{.format_version = static_cast<std::uint16_t>(get<2>(payload, 0)),
                   .flight = static_cast<std::uint32_t>(get<4>(payload, 4)),
                   .power_up = static_cast<std::uint32_t>(get<4>(payload, 8)),
                   .state_layout = static_cast<std::uint32_t>(get<4>(payload, 12)),
                   .rate_scale_rad_s = get_float(payload, scales_at),
                   .specific_force_scale_m_s2 = get_float(payload, scales_at + 4),
                   .accelerometer_scale_m_s2 = get_float(payload, scales_at + 8),
                   .second_rate_scale_rad_s = second_rate_scale_rad_s,
                   .firmware_version = get_text(payload, 0),
                   .git_hash = get_text(payload, 1),
                   .vehicle = get_text(payload, 2),
                   .sensors = get_text(payload, 3),
                   .plan_block = rest.first(plan_size),
                   .schema = view(rest.subspan(plan_size))};
}

}  // namespace fantail::protocol
