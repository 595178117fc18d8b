// SPDX-License-Identifier: MIT
#include "hal/stm32f4/barometer.hpp"

#include <algorithm>
#include <cstddef>

namespace fantail::hal::stm32f4 {
namespace {

constexpr Microseconds between_resets{20'000};
constexpr std::uint8_t moves_to_believe = 10;
constexpr std::uint32_t all_ones = 0xFFFFFF;  // what a line reads that nobody drives

// What it is specified for.
constexpr std::int64_t least_pa = 1'000;
constexpr std::int64_t most_pa = 120'000;
constexpr std::int64_t coldest = -4'000;  // hundredths of a degree C
constexpr std::int64_t hottest = 8'500;

constexpr std::int64_t square(std::int64_t x) { return x * x; }

/// The maker's application note AN520. The low byte of the last word takes no part.
template <typename Words>
bool crc_is_right(const Words& words) {
  std::uint32_t remainder = 0;
  for (std::size_t byte = 0; byte < 2 * words.size(); ++byte) {
    const std::uint32_t word = words[byte / 2];
    const std::uint32_t next = byte + 1 == 2 * words.size() ? 0 : byte % 2 == 0 ? word >> 8U : word & 0xFFU;
    remainder ^= next;
    for (int bit = 0; bit < 8; ++bit) {
      remainder = (remainder << 1U ^ ((remainder & 0x8000U) != 0 ? 0x3000U : 0U)) & 0xFFFFU;
    }
  }
  return remainder >> 12U == (words.back() & 0xFU);
}

/// The data sheet's compensation of second order, in its names; nothing where the result is out of range. A shift to
/// the right rounds down. Whatever constants and results are, off and sens are below 2^38, and d1 * sens is below 2^61.
template <typename Constants>
std::optional<std::uint32_t> compensated_pa(const Constants& c, std::int64_t d1, std::int64_t d2) {
  const std::int64_t dt = d2 - (std::int64_t{c[5]} << 8);
  std::int64_t temp = 2'000 + (dt * c[6] >> 23);
  std::int64_t off = (std::int64_t{c[2]} << 16) + (c[4] * dt >> 7);
  std::int64_t sens = (std::int64_t{c[1]} << 15) + (c[3] * dt >> 8);
  if (temp < 2'000) {
    const std::int64_t cold = square(temp - 2'000);
    off -= 5 * cold >> 1;
    sens -= 5 * cold >> 2;
    if (temp < -1'500) {
      const std::int64_t very_cold = square(temp + 1'500);
      off -= 7 * very_cold;
      sens -= 11 * very_cold >> 1;
    }
    temp -= square(dt) >> 31;
  }
  const std::int64_t p = ((d1 * sens >> 21) - off) >> 15;
  if (temp < coldest || temp > hottest || p < least_pa || p > most_pa) {
    return std::nullopt;
  }
  return static_cast<std::uint32_t>(p);
}

}  // namespace

BarometerSample Barometer::read() {
  const Microseconds now = clock_.now();
  switch (stage_) {
    case Stage::reset: reset(now); break;
    case Stage::constants: read_constants(now); break;
    case Stage::settling:
    case Stage::temperature:
    case Stage::pressure: carry_on(now); break;
  }
  return sample_;
}

bool Barometer::Results::update(std::uint32_t result) {
  const bool same = result == last_;
  last_ = result;
  repeats_ = same ? static_cast<std::uint8_t>(repeats_ + 1) : std::uint8_t{0};
  if (repeats_ >= most_repeats) {
    repeats_ = 0;
    doubts_ = moves_to_believe;
    return true;
  }
  if (!same && doubts_ > 0) {
    doubts_ -= 1;
  }
  return false;
}

bool Barometer::command(std::uint8_t command) { return device_.transfer(std::array{std::byte{command}}, {}); }

std::optional<std::uint16_t> Barometer::constant(std::uint8_t number) {
  const std::array command{static_cast<std::byte>(ms5611::read_constant + 2U * number)};
  std::array<std::byte, 2> word{};
  if (!device_.transfer({{.out = command}, {.in = word}})) {
    return std::nullopt;
  }
  return static_cast<std::uint16_t>(std::to_integer<std::uint32_t>(word[0]) << 8U |
                                    std::to_integer<std::uint32_t>(word[1]));
}

std::uint32_t Barometer::result() {
  const std::array command{std::byte{ms5611::read_result}};
  std::array<std::byte, 3> bits{};
  if (!device_.transfer({{.out = command}, {.in = bits}})) {
    return 0;
  }
  return std::to_integer<std::uint32_t>(bits[0]) << 16U | std::to_integer<std::uint32_t>(bits[1]) << 8U |
         std::to_integer<std::uint32_t>(bits[2]);
}

void Barometer::restart(Status status) {
  sample_.status = status;
  stage_ = Stage::reset;
}

void Barometer::reset(Microseconds now) {
  if (reset_at_ && now - *reset_at_ < between_resets) {
    return;
  }
  reset_at_ = now;
  next_constant_ = 0;
  if (command(ms5611::reset)) {
    since_ = clock_.now();  // from the end of the command on
    stage_ = Stage::constants;
  } else {
    restart(Status::no_reading);
  }
}

void Barometer::read_constants(Microseconds now) {
  if (now - since_ < ms5611::reset_time) {
    return;
  }
  const auto once = constant(next_constant_);
  const auto again = constant(next_constant_);
  if (!once || once != again) {
    restart(once && again ? Status::error : Status::no_reading);
    return;
  }
  constants_[next_constant_] = *once;
  next_constant_ += 1;
  if (next_constant_ < constants_.size()) {
    return;
  }
  // What a line reads that nobody drives, or that is held down, is nobody; and the CRC of zeros is zero.
  const bool all_equal = std::ranges::all_of(constants_, [&](std::uint16_t word) { return word == constants_[0]; });
  if (all_equal || !crc_is_right(constants_)) {
    restart(all_equal && (constants_[0] == 0x0000 || constants_[0] == 0xFFFF) ? Status::no_reading : Status::error);
    return;
  }
  convert(now, Stage::settling);
}

void Barometer::convert(Microseconds now, Stage stage) {
  since_ = now;
  stage_ = stage;
  if (!command(stage == Stage::pressure ? ms5611::convert_pressure : ms5611::convert_temperature)) {
    restart(Status::no_reading);
  }
}

void Barometer::carry_on(Microseconds now) {
  if (now - since_ < ms5611::longest_conversion) {
    return;
  }
  const std::uint32_t found = result();
  if (found == 0 || found == all_ones) {
    restart(Status::no_reading);
    return;
  }
  if (stage_ == Stage::settling) {
    convert(now, Stage::temperature);
    return;
  }
  if ((stage_ == Stage::pressure ? pressure_ : temperature_).update(found)) {
    restart(Status::error);
    return;
  }
  if (stage_ == Stage::temperature) {
    convert(now, Stage::pressure);
    return;
  }
  take_pressure();
  if (stage_ == Stage::pressure) {
    convert(now, Stage::temperature);
  }
}

void Barometer::take_pressure() {
  const auto pressure_pa = compensated_pa(constants_, pressure_.last(), temperature_.last());
  if (!pressure_pa) {
    restart(Status::error);  // its constants may be spoilt: they are read again
    return;
  }
  sample_ = {.time = since_ + ms5611::typical_conversion / 2,
             .pressure_pa = *pressure_pa,
             .status = pressure_.doubtful() || temperature_.doubtful() ? Status::error : Status::ok};
}

}  // namespace fantail::hal::stm32f4
