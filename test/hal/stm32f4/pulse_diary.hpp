// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>

#include "avionics/flying_rig.hpp"
#include "fake_timer.hpp"
#include "hal/stm32f4/servo.hpp"
#include "register_world.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4::test {

/// The flying rocket of the avionics' tests, with the board's servo driver and timer behind it: every pulse that the
/// servos hear is written down. Times are in microseconds since power-up.
class PulseDiary : public avionics::FlyingRig {
  RegisterWorld world_;

 public:
  static constexpr double boot_us = 5'000;  ///< from a reset to the first tick: an estimate, nobody has measured it

  FakeTimer timer{world_};

  explicit PulseDiary(const core::FlightPlan& plan = core::default_plan()) : FlyingRig{plan} {
    servo.driver = &every_millisecond_;
    boot(0);
  }

  /// What firmware/boards/stm32f405/crash.cpp does with the servos; the reset itself takes its time.
  void crash() {
    const std::uint64_t begin = timer.clocks();
    timer.counts_per_access = 3;
    EXPECT_TRUE(Servo::finish(timer.registers, driver_->counts(avionics().pulses_at_trim())));
    timer.counts_per_access = 0;
    crash_took_us = us(timer.clocks() - begin);
    pass(20);
  }

  /// What the same file does when the crystal of the processor has stopped.
  void stop_crystal() {
    timer.counts_per_access = 1;
    Servo::end_without_crystal(timer.registers, driver_->counts());
    timer.counts_per_access = 0;
    pass(20);
  }

  /// Of the processor: the driver begins anew, and the world goes on meanwhile, since `ended_us`. `later_us`: how much
  /// later than usual the timer is set up.
  void reset_processor_after(hal::ResetCause cause, double ended_us, double later_us = 0) {
    timer.reset();
    boot(later_us);
    reset(cause, Microseconds{static_cast<std::int64_t>(now_us() - ended_us)});
  }

  void pass(double time_us) {
    const double clocks = time_us * clocks_per_us + rest_;
    const std::uint64_t counts = static_cast<std::uint64_t>(clocks) / timer.divider();
    rest_ = clocks - static_cast<double>(counts * timer.divider());
    timer.pass(counts);
  }
  [[nodiscard]] double now_us() const { return us(timer.clocks()); }

  struct Heard {
    std::size_t line = 0;
    double begin_us = 0;
    double width_us = 0;
    bool whole = true;
  };
  /// Those that began at that time or later, in the order of their beginnings.
  [[nodiscard]] std::vector<Heard> since(double begin_us) const {
    std::vector<Heard> result;
    for (const FakeTimer::Pulse& pulse : timer.pulses()) {
      if (us(pulse.begin) >= begin_us) {
        result.push_back({pulse.line, us(pulse.begin), us(pulse.width), pulse.whole});
      }
    }
    std::ranges::sort(result, {}, [](const Heard& each) { return std::pair{each.begin_us, each.line}; });
    return result;
  }
  /// A row a frame: its beginning, in milliseconds after the event, and four widths in microseconds, with a stroke
  /// behind each that was cut.
  [[nodiscard]] std::string page(double event_us, double from_us, double to_us) const {
    std::string text;
    double row_us = -1;
    for (const Heard& pulse : since(event_us + from_us)) {
      if (pulse.begin_us > event_us + to_us) {
        break;
      }
      if (pulse.begin_us != row_us) {
        row_us = pulse.begin_us;
        text += print("\n%7.2f:", (row_us - event_us) / 1000.0);
      }
      text += print(pulse.whole ? " %.0f" : " %.0f/", pulse.width_us);
    }
    return text + "\n";
  }

  double crash_took_us = 0;

 private:
  static constexpr double clocks_per_us = 168;

  static double us(std::uint64_t clocks) { return static_cast<double>(clocks) / clocks_per_us; }
  static std::string print(const char* format, double number) {
    std::array<char, 32> text{};
    return {text.data(), static_cast<std::size_t>(std::snprintf(text.data(), text.size(), format, number))};
  }

  // Between two writes of the servos lies a tick.
  struct EveryMillisecond final : hal::Servo {
    explicit EveryMillisecond(PulseDiary& diary) : diary_{diary} {}
    void write(const avionics::Pulses& pulses) override {
      diary_.pass(1000);
      diary_.driver_->write(pulses);
    }
    PulseDiary& diary_;
  };

  void boot(double later_us) {
    pass(boot_us - 1000 + later_us);
    driver_.emplace(timer.registers, 168'000'000);
  }

  std::optional<stm32f4::Servo> driver_;
  EveryMillisecond every_millisecond_{*this};
  double rest_ = 0;
};

}  // namespace fantail::hal::stm32f4::test
