// SPDX-License-Identifier: MIT
#include "hal/stm32f4/servo.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace fantail::hal::stm32f4 {
namespace {

using namespace registers;

constexpr auto frame_ms = static_cast<std::uint32_t>(Servo::frame / std::chrono::milliseconds{1});
constexpr std::uint32_t most_counts = 1U << 16U;

constexpr std::uint32_t counting = tim_cr1_cen | tim_cr1_arpe;
constexpr std::uint32_t pwm_channel = tim_ccmr_ocm_pwm1 | tim_ccmr_ocpe;
constexpr std::uint32_t two_pwm_channels = pwm_channel | pwm_channel << tim_ccmr_bits_per_channel;

constexpr std::uint32_t all_channels() {
  std::uint32_t bits = 0;
  for (std::uint32_t channel = 0; channel < canards; ++channel) {
    bits |= tim_ccer_cce << (channel * tim_ccer_bits_per_channel);
  }
  return bits;
}

constexpr bool in_range(Pulse pulse) { return pulse >= Servo::shortest && pulse <= Servo::longest; }

}  // namespace

Servo::Servo(Tim& timer, std::uint32_t timer_hz) : timer_{&timer} {
  // As fine as a counter of 16 bits allows: 8 at 168 MHz, 1 at 16 MHz.
  const std::uint32_t divider = (timer_hz / 1000 * frame_ms + most_counts - 1) / most_counts;
  const std::uint32_t count_hz = timer_hz / divider;
  counts_per_nanosecond_ = static_cast<std::uint32_t>((std::uint64_t{count_hz} << 32U) / std::nano::den);

  timer.cr1.write(0);
  timer.bdtr.write(0);  // no break input, and no output yet
  timer.psc.write(divider - 1);
  timer.arr.write(count_hz / 1000 * frame_ms - 1);
  timer.rcr.write(0);
  for (Register& compare : timer.ccr) {
    compare.write(0);
  }
  timer.ccmr[0].write(two_pwm_channels);
  timer.ccmr[1].write(two_pwm_channels);
  timer.ccer.write(all_channels());
  timer.egr.write(tim_egr_ug);  // all of these are preloaded; this takes them over
  timer.cr1.write(counting);
}

void Servo::begin_frame_in(Microseconds time) {
  const std::uint32_t counts = timer_->arr.read() + 1;
  const auto ahead = static_cast<std::uint32_t>(time.count() * counts / frame.count());
  timer_->cnt.write((counts - ahead) % counts);
}

void Servo::write(const std::array<std::optional<Pulse>, canards>& pulses) {
  for (std::size_t i = 0; i < canards; ++i) {
    if (!pulses[i]) {
      counts_[i] = 0;
    } else if (in_range(*pulses[i])) {
      counts_[i] = count(*pulses[i]);
    } else {
      refused_ += 1;
    }
  }
  drive(*timer_, counts_);
  if (!on_ && std::ranges::any_of(counts_, [](std::uint32_t each) { return each != 0; })) {
    // In the middle of a frame, whose pulses still have no length.
    timer_->bdtr.write(tim_bdtr_moe);
    on_ = true;
  }
}

Servo::Counts Servo::counts(const std::array<std::optional<Pulse>, canards>& pulses) const {
  Counts result{};
  for (std::size_t i = 0; i < canards; ++i) {
    if (pulses[i] && in_range(*pulses[i])) {
      result[i] = count(*pulses[i]);
    }
  }
  return result;
}

// Meets SRV-1.
void Servo::drive(Tim& timer, const Counts& counts) {
  // Where a frame ends between these writes, it would take over some of them.
  timer.cr1.write(counting | tim_cr1_udis);
  for (std::size_t i = 0; i < canards; ++i) {
    timer.ccr[i].write(counts[i]);
  }
  timer.cr1.write(counting);
}

bool Servo::finish(registers::Tim& timer, const Counts& counts) {
  // By its own count alone, since nothing else can be relied on. Two frames take 1 000 000 cycles at 168 MHz, and a
  // look at the counter no fewer than 5.
  constexpr std::uint32_t most_looks = 250'000;
  drive(timer, counts);
  const std::uint32_t pulses_end = std::ranges::max(counts);
  std::uint32_t last = timer.cnt.read();
  bool begun = false;  // the frame with these pulses, when the counter has fallen
  for (std::uint32_t look = 0; look < most_looks; ++look) {
    const std::uint32_t now = timer.cnt.read();
    begun = begun || now < last;
    if (begun && now > pulses_end) {
      hold_low(timer);
      return true;
    }
    last = now;
  }
  hold_low(timer);
  return false;
}

void Servo::end_without_crystal(registers::Tim& timer, const Counts& counts) {
  // 168 MHz to 16.
  constexpr std::uint32_t slower_by_numerator = 21;
  constexpr std::uint32_t slower_by_denominator = 2;
  // A compare value is taken over as it is written, in the middle of its pulse.
  constexpr std::uint32_t at_once = tim_ccmr_ocm_pwm1 | tim_ccmr_ocm_pwm1 << tim_ccmr_bits_per_channel;
  const std::uint32_t now = timer.cnt.read();
  timer.ccmr[0].write(at_once);
  timer.ccmr[1].write(at_once);
  std::uint32_t last_end = now;
  for (std::size_t i = 0; i < canards; ++i) {
    if (counts[i] > now) {
      const std::uint32_t end = now + (counts[i] - now) * slower_by_denominator / slower_by_numerator;
      timer.ccr[i].write(end);
      last_end = std::max(last_end, end);
    }
  }
  // A pulse of 2.5 ms is 5 000 of the slow counts, and a look takes no less than one.
  constexpr std::uint32_t most_looks = 5'000;
  for (std::uint32_t look = 0; look < most_looks && timer.cnt.read() <= last_end; ++look) {
  }
  hold_low(timer);
}

// One write for all four. Their idle level is that of a reset, low.
void Servo::hold_low(registers::Tim& timer) { timer.bdtr.write(tim_bdtr_ossi); }

std::uint32_t Servo::count(Pulse pulse) const {
  constexpr std::uint64_t half = 1ULL << 31U;
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(pulse.count()) * counts_per_nanosecond_ + half) >> 32U);
}

}  // namespace fantail::hal::stm32f4
