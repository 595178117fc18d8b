// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "bench/verdict.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

using text::degrees;
using text::fixed;

constexpr double silent = 0.5;        // share of readings without which nothing else can be said
constexpr double short_share = 0.95;  // of the way; above it a canard is only inexact
constexpr double same_share = 0.15;   // slipping takes about as much from one side as from the other
constexpr double right_share = 0.07;  // off by no more than this, the way is right and only its place is wrong
const double still_rad_s = text::radians(3.0);

std::string signed_degrees(double angle_rad) {
  const std::string number = fixed(degrees(angle_rad), 2);
  return (number.front() == '-' ? number : "+" + number) + " deg";
}

class Diagnoser {
 public:
  Diagnoser(const Figures& figures, std::span<const Check> checks, const Bounds& bounds, std::size_t canard,
            const sim::CanardTolerances& tolerances)
      : f_{figures},
        checks_{checks},
        t_{tolerances},
        limit_rad_{bounds.limit_rad[canard]},
        centre_rad_{bounds.centre_rad[canard]} {}

  // Each test may rely on what the tests before it have ruled out.
  [[nodiscard]] Diagnosis diagnose() const {
    // First what is dangerous, whatever else is wrong.
    if (beyond_limit(f_, limit_rad_)) {
      return {Cause::limit_not_kept,
              fmt::format("it was commanded to {} deg; its limit is {} deg", fixed(degrees(*f_.largest_command_rad), 2),
                          fixed(degrees(limit_rad_), 2)),
              "Do not fly this avionics. Keep this sheet and its JSON file, and find out why before anything else."};
    }
    if (f_.received_ticks == 0) {
      return {Cause::not_measured, "no reports of it were received", "Check the bus, and run again."};
    }
    if (f_.undriven == f_.received_ticks) {
      return {Cause::out_of_tolerance, "the avionics never drove its servo",
              "Check the bus and that the bench session stayed open, and run again."};
    }
    // Without an encoder, and then with one that jumps about, no other figure means anything.
    if (f_.dropout_share() > silent) {
      return {Cause::encoder_unplugged,
              fmt::format("its encoder gave no valid reading in {} % of {} ticks", fixed(100.0 * f_.dropout_share(), 1),
                          f_.received_ticks),
              "Check the encoder's plug and cable, then its supply and the magnet on the shaft."};
    }
    if (f_.noise_rad && *f_.noise_rad > t_.noise_rad) {
      return {Cause::encoder_noisy,
              fmt::format("at rest its encoder scatters by {} deg (standard deviation; allowed {})",
                          fixed(degrees(*f_.noise_rad), 2), fixed(degrees(t_.noise_rad), 2)),
              "Check the encoder's cable, shield and magnet gap. If the canard itself trembles, check its linkage and "
              "servo."};
    }
    // Before "does not move": a servo on the wrong plug leaves its own canard at rest, which would be called dead.
    if (f_.others_moved_rad && *f_.others_moved_rad > most_others_move_rad()) {
      return another_moves();
    }
    // Before all that divides by the movement.
    if (f_.sign == 0) {
      return does_not_move();
    }
    if (f_.sign == -1) {
      return {Cause::reversed,
              f_.told_positive_rad && f_.reached_positive_rad
                  ? fmt::format("commanded to {}, it went to {}", signed_degrees(*f_.told_positive_rad),
                                signed_degrees(*f_.reached_positive_rad))
                  : "it moves against its command",
              "Check the sign of its pulse width per degree in the plan, its servo's direction, and whether horn, "
              "linkage and encoder magnet are mounted the right way round."};
    }
    // Before slipping, backlash and tracking: a late canard has not arrived when these are looked at.
    if (const std::string late = slowness(); !late.empty()) {
      return {Cause::slow, late, "Check the servo's supply voltage under load, friction in the linkage, and its gear."};
    }
    // Before trim: it leaves both sides short; a trim moves both the same way.
    if (slips()) {
      return {
          Cause::slipping,
          fmt::format("it moves the right way but only {} % as far", fixed(100.0 * *f_.gain, 0)) + told_and_reached(),
          "Check the screw that clamps the horn or the shaft, the linkage, and the pulse width per degree in the "
          "plan."};
    }
    if (stands_off()) {
      const std::string off = signed_degrees(*f_.centring_error_rad);
      return {Cause::wrong_trim,
              f_.amplitude_ratio
                  ? fmt::format("it follows the sine, but at rest it is off its trim by {}", off)
                  : fmt::format("it follows the command, but with an offset of {}{}", off,
                                failed(Measure::reached) ? ", at its trim and at the angle commanded" : " everywhere"),
              "Check its pulse centre, trim and encoder zero in the plan, and that the horn sits on the right tooth."};
    }
    return failed_checks();
  }

 private:
  [[nodiscard]] Diagnosis another_moves() const {
    const std::size_t other = *f_.other_canard + 1;
    if (f_.sign.value_or(0) == 0) {
      return {Cause::wrong_canard_moves,
              fmt::format("it stood still, and canard {} moved by {} deg instead", other,
                          fixed(degrees(*f_.others_moved_rad), 2)),
              fmt::format("Check whether the servo plugs, or the encoder plugs, of this canard and canard {} are "
                          "swapped.",
                          other)};
    }
    return {Cause::wrong_canard_moves,
            fmt::format("canard {} moved too, by {} deg, although only this one was commanded", other,
                        fixed(degrees(*f_.others_moved_rad), 2)),
            fmt::format("Check for a shared or shorted servo signal and a linkage that touches canard {}.", other)};
  }

  /// An exercise that does not stop at the limits knows no such angles.
  [[nodiscard]] std::string told_and_reached() const {
    if (!f_.told_positive_rad || !f_.reached_positive_rad) {
      return {};
    }
    if (!f_.told_negative_rad || !f_.reached_negative_rad) {  // a step
      return fmt::format(": commanded to {}, it reached {}", signed_degrees(*f_.told_positive_rad),
                         signed_degrees(*f_.reached_positive_rad));
    }
    return fmt::format(": commanded to {} and {}, it reached {} and {}", signed_degrees(*f_.told_positive_rad),
                       signed_degrees(*f_.told_negative_rad), signed_degrees(*f_.reached_positive_rad),
                       signed_degrees(*f_.reached_negative_rad));
  }

  // At the shaft's zero too: a servo without power does not know the trim.
  [[nodiscard]] Diagnosis does_not_move() const {
    const double stands_rad = f_.stands_at_rad.value_or(centre_rad_);
    std::string where = "it did not move";
    if (f_.told_positive_rad && f_.told_negative_rad) {
      where += fmt::format(" when commanded to {} and {}", signed_degrees(*f_.told_positive_rad),
                           signed_degrees(*f_.told_negative_rad));
    }
    if (f_.stands_at_rad) {
      where += fmt::format(", and stands at {}", signed_degrees(*f_.stands_at_rad));
    }
    const double off_rad = std::min(std::abs(stands_rad - centre_rad_), std::abs(stands_rad));
    if (off_rad > t_.centring_rad) {
      return {Cause::stuck, where, "Find what jams the canard or its linkage, and free it with the power off."};
    }
    return {Cause::dead, where,
            "Check the servo's power and signal plug. Its gear may be broken, or the canard may be jammed there."};
  }

  // Empty when it is fast enough. A canard that moves less far has less far to go, so its speed is held against its
  // own way.
  [[nodiscard]] std::string slowness() const {
    const bool late = f_.step_time_s && *f_.step_time_s > t_.longest_step_time_s;
    const double gain = std::clamp(std::abs(f_.gain.value_or(1.0)), 0.1, 1.0);
    const double required_rad_s = required_slew_rad_s(f_.slew_way_rad.value_or(0.0), t_);
    const bool weak = f_.slew_rad_s && *f_.slew_rad_s / gain < required_rad_s;
    const bool drifting = f_.drift_rad_s && *f_.drift_rad_s > still_rad_s;
    if (!late && !weak && !drifting) {
      return {};
    }
    std::string text;
    if (f_.step_time_s) {
      text += fmt::format("10 to 90 % of a step took {} s (allowed {})", fixed(*f_.step_time_s, 3),
                          fixed(t_.longest_step_time_s, 3));
    } else {
      text += "the time of a step could not be measured";
    }
    if (f_.slew_rad_s) {
      text += fmt::format(", and it moved at no more than {} deg/s (required {})", fixed(degrees(*f_.slew_rad_s), 0),
                          fixed(degrees(required_rad_s), 0));
    }
    if (drifting) {
      text += ", and it was still moving when it should have been at rest";
    }
    return text;
  }

  [[nodiscard]] bool slips() const {
    if (failed(Measure::reached)) {  // play leaves a step short, too, but not its centre where it was
      return f_.gain && *f_.gain < short_share && std::abs(*f_.from_above_rad) <= t_.centring_rad &&
             std::abs(*f_.from_below_rad) <= t_.centring_rad;
    }
    return f_.gain && f_.positive_share && f_.negative_share && *f_.positive_share < short_share &&
           *f_.negative_share < short_share && std::abs(*f_.positive_share - *f_.negative_share) < same_share &&
           (failed(Measure::reached_positive) || failed(Measure::reached_negative));
  }

  [[nodiscard]] bool stands_off() const {
    if (!f_.centring_error_rad || std::abs(*f_.centring_error_rad) <= t_.centring_rad) {
      return false;
    }
    if (f_.amplitude_ratio) {
      return !failed(Measure::amplitude_ratio);
    }
    if (!f_.gain || !f_.reached_positive_rad || std::abs(*f_.gain - 1.0) > right_share) {
      return false;
    }
    if (failed(Measure::reached)) {
      return same_offset(*f_.reached_positive_rad, *f_.told_positive_rad) &&
             std::abs(*f_.from_above_rad - *f_.from_below_rad) <= t_.backlash_rad;
    }
    return f_.reached_negative_rad &&
           same_offset(*f_.reached_positive_rad, f_.told_positive_rad.value_or(limit_rad_)) &&
           same_offset(*f_.reached_negative_rad, f_.told_negative_rad.value_or(-limit_rad_));
  }

  // A reading at the end of the bus's range is of a canard that stands there or beyond.
  [[nodiscard]] bool same_offset(double reached_rad, double told_rad) const {
    const double expected_rad = told_rad + *f_.centring_error_rad;
    return std::abs(reached_rad - expected_rad) <= t_.reach_rad ||
           (beyond_bus(reached_rad) && expected_rad * reached_rad > 0.0 &&
            std::abs(expected_rad) > std::abs(reached_rad));
  }

  [[nodiscard]] bool failed(Measure measure) const {
    return std::ranges::any_of(checks_, [measure](const Check& c) { return c.measure == measure && !c.passed; });
  }

  [[nodiscard]] Diagnosis failed_checks() const {
    std::string text;
    for (const Check& check : checks_) {
      if (check.passed) {
        continue;
      }
      const MeasureText& about = text_of(check.measure);
      std::string label{about.label};
      label.front() = static_cast<char>(label.front() | 0x20);  // in the middle of a sentence
      text += text.empty() ? "" : "; ";
      text += check.measure == Measure::limit_reported
                  ? "the avionics did not report that the request was beyond the limit"
                  : fmt::format("{} {}{}", label, check.value ? fixed(*check.value, about.decimals) : "not measured",
                                check.value && !about.unit.empty() ? fmt::format(" {}", about.unit) : "");
      if (check.value && check.measure != Measure::limit_reported) {
        const bool reach = check.measure == Measure::reached_positive || check.measure == Measure::reached_negative ||
                           check.measure == Measure::reached;
        text += reach && beyond_bus(text::radians(*check.value)) ? " or farther" : "";
        text += fmt::format(" (must be {})", allowed_text(check));
      }
    }
    if (text.empty()) {
      return {Cause::healthy, "every judged figure is within its tolerance", ""};
    }
    // What nobody measured accuses nobody.
    if (std::ranges::none_of(checks_, [](const Check& check) { return !check.passed && check.value; })) {
      return {Cause::not_measured, text, "Run again with nothing else running on this PC."};
    }
    if (failed(Measure::amplitude_ratio)) {
      return {Cause::out_of_tolerance, text, "A sine does not show why: fantail bench limits looks for the cause."};
    }
    return {Cause::out_of_tolerance, text,
            "Look at its plots: no single fault explains these figures. Check linkage, play and cable, and run again."};
  }

  const Figures& f_;
  std::span<const Check> checks_;
  const sim::CanardTolerances& t_;
  double limit_rad_;
  double centre_rad_;
};

}  // namespace

Diagnosis diagnose(const Figures& figures, std::span<const Check> checks, const Bounds& bounds, std::size_t canard,
                   const sim::CanardTolerances& tolerances) {
  return Diagnoser{figures, checks, bounds, canard, tolerances}.diagnose();
}

std::string sentence(std::size_t canard, const Diagnosis& diagnosis) {
  return sentence(canard, cause_text(diagnosis.cause), diagnosis);
}

std::string sentence(std::size_t canard, std::string_view cause, const Diagnosis& diagnosis) {
  return fmt::format("Canard {} {}: {}.{}{}", canard + 1, cause, diagnosis.seen, diagnosis.look_at.empty() ? "" : " ",
                     diagnosis.look_at);
}

}  // namespace fantail::bench
