// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "bench/zero.hpp"
#include "json/value.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

using json::rounded;
using text::degrees;
using text::fixed;

std::string with_interval(const Measured& measured, int decimals) {
  return fmt::format("{} +- {}", fixed(measured.value, decimals), fixed(measured.plus_minus, decimals));
}

std::string row(const char* field, const Measured& present, const Measured& measured, int decimals) {
  return fmt::format("  {:<22}{:>10}   {}\n", field, fixed(present.value, decimals),
                     measured.plus_minus > 0.0 ? with_interval(measured, decimals) : "unchanged");
}

json::Value value(const Measured& measured) {
  return {{"value", rounded(measured.value)}, {"plus_minus", rounded(measured.plus_minus)}};
}

}  // namespace

std::string zero_text(std::span<const CanardZero> zeros, const core::CanardsPlan& plan, Trusted trusted) {
  std::string out;
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    const CanardZero& zero = zeros[i];
    const ZeroFields present = present_fields(plan.each[i]);
    const ZeroFields measured = measured_fields(plan.each[i], zero, trusted);
    out += fmt::format(
        "canard {}: encoder at command zero {} deg, per degree commanded {}, play {} deg\n"
        "  {:<22}{:>10}   measured\n",
        i + 1,
        with_interval({.value = degrees(zero.centre_rad.value), .plus_minus = degrees(zero.centre_rad.plus_minus)}, 2),
        with_interval(zero.scale, 4), fixed(degrees(zero.play_rad), 2), "", "present");
    out += row("pulse_centre_us", present.pulse_centre_us, measured.pulse_centre_us, 1);
    out += row("pulse_per_degree_us", present.pulse_per_degree_us, measured.pulse_per_degree_us, 3);
    out += row("encoder_zero_deg", present.encoder_zero_deg, measured.encoder_zero_deg, 2);
  }
  out += fmt::format("\n+-: 95 % interval of the mean of the runs. Trusted at the centre: the {}.\n{}\n",
                     trusted == Trusted::encoder ? "encoder" : "servo", what_an_encoder_cannot_show());
  return out;
}

std::string zero_json(std::span<const CanardZero> zeros, const core::CanardsPlan& plan, Trusted trusted,
                      const result::Made& made) {
  json::Value canards = json::Value::array();
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    const CanardZero& zero = zeros[i];
    const ZeroFields present = present_fields(plan.each[i]);
    const ZeroFields measured = measured_fields(plan.each[i], zero, trusted);
    const auto field = [](const Measured& before, const Measured& now) {
      return json::Value{{"present", rounded(before.value)}, {"measured", value(now)}};
    };
    canards.push_back({{"canard", i + 1},
                       {"centre_deg", value({.value = degrees(zero.centre_rad.value),
                                             .plus_minus = degrees(zero.centre_rad.plus_minus)})},
                       {"scale", value(zero.scale)},
                       {"play_deg", rounded(degrees(zero.play_rad))},
                       {"pulse_centre_us", field(present.pulse_centre_us, measured.pulse_centre_us)},
                       {"pulse_per_degree_us", field(present.pulse_per_degree_us, measured.pulse_per_degree_us)},
                       {"encoder_zero_deg", field(present.encoder_zero_deg, measured.encoder_zero_deg)}});
  }
  json::Value all{{"trusted", trusted == Trusted::encoder ? "encoder" : "servo"},
                  {"canards", canards},
                  {"not_shown", what_an_encoder_cannot_show()}};
  result::put_answer(all, result::Answer::none, what_an_encoder_cannot_show(), made);
  return all.pretty();
}

}  // namespace fantail::bench
