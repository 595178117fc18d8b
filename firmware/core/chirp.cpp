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

// Takes whole turns out, so that the sine sees a small phase. |turns| < 1e6.
float fraction(float turns) { return turns - static_cast<float>(static_cast<std::int32_t>(turns)); }

}  // namespace

bool Chirp::varies() const { return plan_.amplitude_variation > Angle{} || plan_.frequency_variation_hz > 0.0F; }

void Chirp::draw(std::uint32_t index) {
  // Turns gathered by the frequency variation, span by span; a tick never skips more than the ones it slept through.
  while (drawn_ && span_.index < index) {
    span_.variation_turns_at_start += 0.5F * span_s * (span_.frequency_at_start + span_.frequency_at_end);
    span_.index += 1;
    span_.frequency_at_start = span_.frequency_at_end;
    span_.frequency_at_end = plan_.frequency_variation_hz * draw_uniform(plan_.variation_seed, 1, span_.index + 1);
  }
  if (!drawn_) {
    span_.index = index;
    span_.frequency_at_start = plan_.frequency_variation_hz * draw_uniform(plan_.variation_seed, 1, index);
    span_.frequency_at_end = plan_.frequency_variation_hz * draw_uniform(plan_.variation_seed, 1, index + 1);
  }
  span_.amplitude_at_start = plan_.amplitude_variation.radians() * draw_uniform(plan_.variation_seed, 0, index);
  span_.amplitude_at_end = plan_.amplitude_variation.radians() * draw_uniform(plan_.variation_seed, 0, index + 1);
  drawn_ = true;
}

Angle Chirp::update(Microseconds since_control_start) {
  if (plan_.form == ExcitationForm::none || since_control_start < plan_.begin || since_control_start >= plan_.end) {
    return Angle{};
  }
  const bool product = plan_.form == ExcitationForm::product;
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
  float turns = 0.0F;
  if (product) {
    const float t = seconds(since_control_start);
    turns = (plan_.product_slope_hz_s * t + plan_.product_offset_hz + varied_hz) * t;
  } else {
    const float t = seconds(since_begin);
    const float slope = (plan_.sweep_last_hz - plan_.sweep_first_hz) / seconds(plan_.end - plan_.begin);
    turns = (plan_.sweep_first_hz + 0.5F * slope * t) * t + varied_turns;
  }
  return Angle::from_radians(amplitude * sin_turns(fraction(turns)));
}

}  // namespace fantail::core
