// SPDX-License-Identifier: MIT
#include "core/chirp.hpp"

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

// Turns of the phase frequency * t without the whole turns, in integers: over minutes a float phase keeps no usable
// fraction. Valid below 30 kHz (the products then stay within 64 bits).
float fraction_of_turns(std::int64_t frequency_phz, Microseconds t) {
  constexpr std::int64_t million = 1'000'000;
  constexpr std::int64_t turn = million * million;
  const std::int64_t whole_s = t.count() / million;
  const std::int64_t rest_us = t.count() % million;
  const std::int64_t phase =
      frequency_phz % turn * whole_s + frequency_phz / million * rest_us + frequency_phz % million * rest_us / million;
  return static_cast<float>(phase % turn) / static_cast<float>(turn);
}

float product_turns(const ExcitationPlan& plan, Microseconds t, float varied_hz) {
  const std::int64_t constant_uhz = millionths(plan.product_offset_hz) + millionths(varied_hz);
  return fraction_of_turns(constant_uhz * 1'000'000 + millionths(plan.product_slope_hz_s) * t.count(), t);
}

// Half the slope, because the phase is the integral of the frequency.
float sweep_turns(const ExcitationPlan& plan, Microseconds t) {
  const std::int64_t first_uhz = millionths(plan.sweep_first_hz);
  const std::int64_t rise_uhz = millionths(plan.sweep_last_hz) - first_uhz;
  const std::int64_t half_slope_nhz_s = rise_uhz * 500'000'000 / (plan.end - plan.begin).count();
  return fraction_of_turns(first_uhz * 1'000'000 + half_slope_nhz_s * t.count() / 1000, t);
}

}  // namespace

bool Chirp::varies() const { return plan_.amplitude_variation > Angle{} || plan_.frequency_variation_hz > 0.0F; }

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

Angle Chirp::update(Microseconds since_control_start) {
  if (plan_.form == ExcitationForm::none || since_control_start < plan_.begin || since_control_start >= plan_.end) {
    return Angle{};
  }
  const Microseconds since_begin = since_control_start - plan_.begin;
  float amplitude = plan_.amplitude.radians();
  float varied_hz = 0.0F;
  float varied_turns = 0.0F;
  if (varies()) {
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
  const float turns = plan_.form == ExcitationForm::product ? product_turns(plan_, since_control_start, varied_hz)
                                                            : sweep_turns(plan_, since_begin) + varied_turns;
  return Angle::from_radians(amplitude * sin_turns(turns));
}

}  // namespace fantail::core
