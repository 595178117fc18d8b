// SPDX-License-Identifier: MIT
#include "core/chirp.hpp"

#include <algorithm>
#include <bit>

#include "core/trig.hpp"

namespace fantail::core {
namespace {

constexpr std::uint32_t span_us = 100'000;
constexpr float span_s = 0.1F;

// A number in [-1, 1) that depends on nothing but its arguments (the finaliser of MurmurHash3).
float draw_uniform(std::uint32_t seed, std::uint32_t stream, std::uint32_t index) {
  std::uint32_t h = seed * 0x9E3779B1U + stream * 0x85EBCA77U + index;
  h ^= h >> 16U;
  h *= 0x85EBCA6BU;
  h ^= h >> 13U;
  h *= 0xC2B2AE35U;
  h ^= h >> 16U;
  return static_cast<float>(h >> 8U) * (1.0F / 8388608.0F) - 1.0F;
}

// A number below 2^60 by 2^twos * odd. A 64-bit division is a call of 150 instructions on the Cortex-M4: this is long
// division in digits of 18 bits, so that a remainder and the next digit share 32 bits.
template <unsigned twos, std::uint32_t odd>
std::uint64_t divide(std::uint64_t number) {
  static_assert(twos >= 3 && odd < 1U << 14U);
  constexpr std::uint32_t digit = (1U << 18U) - 1U;
  const std::uint64_t dividend = number >> twos;
  const auto first = static_cast<std::uint32_t>(dividend >> 36U);
  const std::uint32_t second = (first % odd) << 18U | (static_cast<std::uint32_t>(dividend >> 18U) & digit);
  const std::uint32_t third = (second % odd) << 18U | (static_cast<std::uint32_t>(dividend) & digit);
  return std::uint64_t{first / odd} << 36U | std::uint64_t{second / odd} << 18U | third / odd;
}

std::uint64_t by_a_million(std::uint64_t number) { return divide<6, 15625>(number); }

std::uint64_t magnitude(std::int64_t number) { return static_cast<std::uint64_t>(number < 0 ? -number : number); }

std::int64_t by_a_thousand(std::int64_t number) {
  const auto quotient = static_cast<std::int64_t>(divide<3, 125>(magnitude(number)));
  return number < 0 ? -quotient : quotient;
}

// The nearest one to a number below 2^63. A conversion of 64 bits is a call on the Cortex-M4, of 32 bits one
// instruction; a last bit that says whether anything was cut off makes it round as the whole number would.
float to_float(std::uint64_t number) {
  const auto cut = static_cast<unsigned>(std::bit_width(static_cast<std::uint32_t>(number >> 32U)));
  const std::uint32_t scale = 1U << cut;
  const std::uint32_t rest = static_cast<std::uint32_t>(number) & (scale - 1U);
  return static_cast<float>(static_cast<std::uint32_t>(number >> cut) | (rest != 0 ? 1U : 0U)) *
         static_cast<float>(scale);
}

// Turns of the phase frequency * t without the whole turns, in integers: over minutes a float phase keeps no usable
// fraction. Valid below 30 kHz and for 0 <= t <= 1 h (the product then has 87 bits).
float fraction_of_turns(std::int64_t frequency_phz, Microseconds t) {
  constexpr std::uint64_t turn = 1'000'000'000'000'000'000;  // pHz us
  constexpr std::uint64_t turns_in_2_to_the_88 = (std::uint64_t{1} << 60U) / (turn >> 28U);
  const std::uint64_t frequency = magnitude(frequency_phz);
  const auto since_us = static_cast<std::uint32_t>(t.count());
  const std::uint64_t upper_55_bits = (frequency >> 32U) * since_us + ((frequency & UINT32_MAX) * since_us >> 32U);
  const std::uint64_t whole_turns = (upper_55_bits >> 24U) * turns_in_2_to_the_88 >> 32U;  // or one fewer
  const std::uint64_t phase = frequency * since_us - whole_turns * turn;                   // below two turns
  const float fraction = to_float(by_a_million(phase < turn ? phase : phase - turn)) / 1e12F;
  return frequency_phz < 0 ? 0.0F - fraction : fraction;
}

}  // namespace

Chirp::Chirp(const ExcitationPlan& plan)
    : plan_{plan},
      varies_{plan.amplitude_variation > Angle{} || plan.frequency_variation_hz > 0.0F},
      product_offset_uhz_{millionths(plan.product_offset_hz)},
      product_slope_uhz_s_{millionths(plan.product_slope_hz_s)},
      sweep_first_uhz_{millionths(plan.sweep_first_hz)},
      sweep_half_slope_nhz_s_{(millionths(plan.sweep_last_hz) - sweep_first_uhz_) * 500'000'000 /
                              std::max((plan.end - plan.begin).count(), std::int64_t{1})} {}

float Chirp::product_turns(Microseconds since_control_start, float varied_hz) const {
  const std::int64_t constant_uhz = product_offset_uhz_ + (varies_ ? millionths(varied_hz) : 0);
  return fraction_of_turns(constant_uhz * 1'000'000 + product_slope_uhz_s_ * since_control_start.count(),
                           since_control_start);
}

float Chirp::sweep_turns(Microseconds since_begin) const {
  return fraction_of_turns(sweep_first_uhz_ * 1'000'000 + by_a_thousand(sweep_half_slope_nhz_s_ * since_begin.count()),
                           since_begin);
}

void Chirp::draw(std::uint32_t index) {
  if (!drawn_) {
    span_.frequency_at_start = plan_.frequency_variation_hz * draw_uniform(plan_.variation_seed, 1, 0);
    span_.frequency_at_end = plan_.frequency_variation_hz * draw_uniform(plan_.variation_seed, 1, 1);
    drawn_ = true;
  }
  // Turns gathered by the frequency variation, span by span; a tick never skips more than the ones it slept through.
  while (span_.index < index) {
    const float turns =
        span_.variation_turns_at_start + 0.5F * span_s * (span_.frequency_at_start + span_.frequency_at_end);
    span_.variation_turns_at_start = turns - static_cast<float>(static_cast<std::int32_t>(turns));
    span_.index += 1;
    span_.frequency_at_start = span_.frequency_at_end;
    span_.frequency_at_end = plan_.frequency_variation_hz * draw_uniform(plan_.variation_seed, 1, span_.index + 1);
  }
  span_.amplitude_at_start = plan_.amplitude_variation.radians() * draw_uniform(plan_.variation_seed, 0, index);
  span_.amplitude_at_end = plan_.amplitude_variation.radians() * draw_uniform(plan_.variation_seed, 0, index + 1);
}

// Meets LIM-2.
Angle Chirp::update(Microseconds since_control_start) {
  if (plan_.form == ExcitationForm::none || since_control_start < plan_.begin || since_control_start >= plan_.end) {
    return Angle{};
  }
  const Microseconds since_begin = since_control_start - plan_.begin;
  float amplitude = plan_.amplitude.radians();
  float varied_hz = 0.0F;
  float varied_turns = 0.0F;
  if (varies_) {
    const auto elapsed = static_cast<std::uint32_t>(since_begin.count());
    if (!drawn_ || elapsed / span_us != span_.index) {
      draw(elapsed / span_us);
    }
    const float into_span_s = static_cast<float>(elapsed % span_us) * 1e-6F;
    const float share = into_span_s / span_s;
    amplitude += span_.amplitude_at_start + share * (span_.amplitude_at_end - span_.amplitude_at_start);
    varied_hz = span_.frequency_at_start + share * (span_.frequency_at_end - span_.frequency_at_start);
    varied_turns = span_.variation_turns_at_start + 0.5F * into_span_s * (span_.frequency_at_start + varied_hz);
  }
  const float turns = plan_.form == ExcitationForm::product ? product_turns(since_control_start, varied_hz)
                                                            : sweep_turns(since_begin) + varied_turns;
  return Angle::from_radians(amplitude * sin_turns(turns));
}

}  // namespace fantail::core
