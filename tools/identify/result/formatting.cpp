// SPDX-License-Identifier: MIT
#include "identify/result/formatting.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::identify::result {
namespace {

using namespace model;
using text::degrees;

constexpr int most_decimals = 4;  // no sensor tells more of a number of this size or larger

// So that two digits of a deviation show, and at most four decimals. What goes with the reference area may be as small
// as that makes it: of such a number five digits.
int decimals(double deviation, double constant = 1.0) {
  const int most = std::max(most_decimals, decimals_for(constant, most_decimals + 1));
  return deviation > 0.0 ? std::clamp(decimals_for(deviation, 2), 0, most) : most;
}

std::string with_places(double value, double deviation, int places) {
  return text::fixed(value, places) + " +- " + text::fixed(deviation, places);
}

std::string subject(std::size_t number, const RollModel& model) {
  if (number < 2) {
    return number == 0 ? "Damping alpha" : "Torque constant beta";
  }
  if (model.node_time_s.size() == 1) {
    return "The disturbance";
  }
  return fmt::format("The disturbance {} s into the window", text::brief(model.node_time_s[number - 2], 2));
}

// "\u00b13.5 %"; never "\u00b10 %".
std::string plus_minus(double half, int places, std::string_view unit) {
  const std::string number = text::brief(half, places);
  return number == "0" ? fmt::format("better than \u00b1{} {}", text::brief(std::pow(10.0, -places), places), unit)
                       : fmt::format("\u00b1{} {}", number, unit);
}

bool share_nodes(const WindowFindings& window) {
  const auto& first = window.results.front().model.node_time_s;
  return std::ranges::all_of(window.results, [&](const Identification& r) { return r.model.node_time_s == first; });
}

// A sentence a node would bury the rest.
std::string all_nodes(const Identification& result) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (std::size_t k = 2; k < result.uncertainty->interval.size(); ++k) {
    const Interval& interval = result.uncertainty->interval[k];
    const double half = 0.5 * degrees(*interval.high - *interval.low);
    least = std::min(least, half);
    most = std::max(most, half);
  }
  return fmt::format("The disturbance is known to \u00b1{} to \u00b1{} deg at its {} nodes (95 %).",
                     text::brief(least, 3), text::brief(most, 3), result.model.node_rad.size());
}

}  // namespace

std::string_view name(Method method) { return method == Method::grid ? "grid" : "continuous"; }

std::string_view name(Loop loop) { return loop == Loop::open ? "open" : "closed"; }

std::string with_deviation(const Identification& result, std::size_t number, double scale) {
  const double value = scale * result.model.numbers()[number];
  if (!result.uncertainty) {
    return text::fixed(value, number < 2 ? decimals(0.0, value) : most_decimals);
  }
  const double deviation = scale * result.uncertainty->standard_deviation[number];
  return number < 2 ? value_with_deviation(value, deviation) : with_places(value, deviation, decimals(deviation));
}

std::string value_with_deviation(double value, double deviation) {
  return with_places(value, deviation, decimals(deviation, value));
}

std::string interval_text(const Interval& interval, double scale) {
  const double low = scale * interval.low.value_or(0.0);
  const double high = scale * interval.high.value_or(0.0);
  const int places = decimals(interval.low && interval.high ? 0.25 * (high - low) : 0.05 * std::abs(low + high),
                              scale == 1.0 ? std::max(std::abs(low), std::abs(high)) : 1.0);
  if (interval.low && interval.high) {
    return text::fixed(low, places) + " to " + text::fixed(high, places);
  }
  if (interval.low) {
    return "above " + text::fixed(low, places);
  }
  return interval.high ? "below " + text::fixed(high, places) : "not bounded by this window";
}

const Interval& interval_of(const Identification& result, std::size_t number) {
  return number == 0 ? result.uncertainty->alpha_profile_m2 : result.uncertainty->interval[number];
}

std::string precision_sentence(const Identification& result, std::size_t number) {
  constexpr double useful = 0.5;
  const bool angle = number >= 2;
  const double scale = angle ? text::degrees(1.0) : 1.0;
  const std::string_view unit = angle ? "deg" : number == 0 ? "m2" : "m";
  const std::string who = subject(number, result.model);
  const double value = scale * result.model.numbers()[number];
  const Interval& interval = interval_of(result, number);
  if (!interval.low || !interval.high) {
    return fmt::format("{} is estimated at {} {}, but the data do not bound it on both sides: {}.", who,
                       angle ? text::brief(value, 2) : constant_text(value), unit, interval_text(interval, scale));
  }
  const double half = 0.5 * scale * (*interval.high - *interval.low);
  const int places = decimals(0.5 * half, angle ? 1.0 : value);
  const std::string range = fmt::format("between {} and {} {}", text::fixed(scale * *interval.low, places),
                                        text::fixed(scale * *interval.high, places), unit);
  if (angle) {
    return fmt::format("{} lies {} (95 %, {}).", who, range, plus_minus(half, std::min(decimals(half), 3), unit));
  }
  const double share = half / std::abs(value);
  return fmt::format("{} lies {} (95 %, {}{}).", who, range, plus_minus(100.0 * share, share < 0.0995 ? 1 : 0, "%"),
                     share < useful ? "" : ", too uncertain for a prediction");
}

std::string node_label(const WindowFindings& window, std::size_t node) {
  const auto& times = window.results.front().model.node_time_s;
  if (!share_nodes(window)) {
    return fmt::format("node {}", node + 1);
  }
  return times.size() == 1 ? "throughout"
                           : fmt::format("at {} s", text::brief(window.record.window_begin_s + times[node], 2));
}

std::string node_value(const WindowFindings& window, const Identification& result, std::size_t node) {
  if (node >= result.model.node_rad.size()) {
    return "";
  }
  const std::string value = with_deviation(result, node + 2, text::degrees(1.0));
  return share_nodes(window)
             ? value
             : fmt::format("{} at {} s", value,
                           text::brief(window.record.window_begin_s + result.model.node_time_s[node], 2));
}

std::string fitted_lag(const WindowFindings& window) {
  if (!window.lag_is_fitted) {
    return "";
  }
  const auto& known = main_result(window).uncertainty;
  if (!known || !known->lag_s) {
    return " (fitted)";
  }
  constexpr double ms = 1000.0;
  return fmt::format(
      " (fitted; 95 %: {} ms)",
      interval_text({.low = window.lag_s - known->lag_s->reach, .high = window.lag_s + known->lag_s->reach}, ms));
}

std::string servo_interval(double value, const std::optional<Spread>& known, double unit) {
  return known ? interval_text({.low = std::max(0.0, value - known->reach), .high = value + known->reach}, unit)
               : std::string{};
}

namespace {

std::string with_spread(double value, const std::optional<Spread>& known, double unit) {
  const double deviation = known ? unit * known->standard_deviation : 0.0;
  return known ? with_places(unit * value, deviation, decimals(deviation)) : text::brief(unit * value, 2);
}

}  // namespace

std::string servo_lag_text(const Identification& result) {
  return result.servo
             ? with_spread(result.servo->lag_s, result.uncertainty ? result.uncertainty->lag_s : std::nullopt, 1000.0)
             : std::string{};
}

std::string servo_play_text(const Identification& result) {
  if (!result.servo) {
    return "";
  }
  return result.servo->play_rad > 0.0
             ? with_spread(result.servo->play_rad, result.uncertainty ? result.uncertainty->play_rad : std::nullopt,
                           text::degrees(1.0))
             : "0 (no play fits better)";
}

std::string residual_text(const Identification& result, double ResidualTests::* which) {
  const auto& tests = result.residual_tests;
  const bool of_canards = which == &ResidualTests::canard_correlation;
  return tests ? fmt::format("{} (chance {})", text::fixed((*tests).*which, 2),
                             text::fixed(of_canards ? tests->canard_chance : tests->chance, 2))
               : std::string{};
}

std::string worth_text(const Uncertainty& known) {
  return known.effective_samples < 1.0 ? "fewer than 1" : text::fixed(known.effective_samples, 0);
}

std::string effective_text(const Identification& result) {
  return result.uncertainty ? fmt::format("{} of {}", worth_text(*result.uncertainty), result.samples) : std::string{};
}

std::string extent(const Record& record) {
  return fmt::format("{} s to {} s on the log's clock, {} samples", text::brief(record.window_begin_s, 3),
                     text::brief(record.window_begin_s + record.time_s.back(), 3), record.size());
}

std::vector<std::string> remarks(const WindowFindings& window, const Identification& result) {
  std::vector<std::string> all = window.remarks;
  all.insert(all.end(), result.remarks.begin(), result.remarks.end());
  return all;
}

const Identification& main_result(const WindowFindings& window) {
  const auto continuous = std::ranges::find(window.results, Method::continuous, &Identification::method);
  return continuous == window.results.end() ? window.results.front() : *continuous;
}

bool determines_both(const WindowFindings& window) {
  const auto& u = main_result(window).uncertainty;
  return u && u->alpha_identifiable && u->beta_identifiable;
}

std::vector<std::string> precision_sentences(const Identification& result) {
  const std::size_t nodes = result.model.node_rad.size();
  constexpr std::size_t few = 2;
  const std::size_t told = 2 + (nodes <= few ? nodes : 0);
  std::vector<std::string> all;
  all.reserve(told + 1);
  for (std::size_t k = 0; k < told; ++k) {
    all.push_back(printable(precision_sentence(result, k)));
  }
  if (nodes > few) {
    all.push_back(all_nodes(result));
  }
  const Uncertainty& u = *result.uncertainty;
  constexpr double tied = 0.9;
  if (std::abs(u.correlation(0, 1)) > tied) {
    all.push_back(
        fmt::format("Alpha and beta are strongly correlated ({}): the log determines a combination of the two better "
                    "than either alone.",
                    text::fixed(u.correlation(0, 1), 2)));
  }
  const std::string strength = text::brief(degrees(u.residual_rms_rad), 3);
  const std::string worth = worth_text(u);
  if (u.effective_samples > 0.5 * static_cast<double>(result.samples)) {
    all.push_back(
        fmt::format("The residual, {} deg RMS, is hardly correlated: the {} samples tell alpha and beta as well as "
                    "about {} independent ones.",
                    strength, result.samples, worth));
  } else if (u.effective_samples < 2.0 * static_cast<double>(u.interval.size())) {
    all.push_back(
        fmt::format("The residual, {} deg RMS, is correlated over {} s: the {} samples average hardly anything out and "
                    "determine alpha and beta only as well as {} independent {}. The intervals include that{}.",
                    strength, text::fixed(u.residual_correlation_s, 2), result.samples, worth == "1" ? "one" : worth,
                    worth == "1" || u.effective_samples < 1.0 ? "sample would" : "samples would",
                    u.alpha_identifiable && u.beta_identifiable
                        ? "; they are as narrow as they are because the residual is small beside the motion"
                        : ""));
  } else {
    all.push_back(fmt::format(
        "The residual, {} deg RMS, is correlated over {} s: the {} samples determine alpha and beta as well as {} "
        "independent samples would. Faster sampling would not help; a longer window or more canard motion would.",
        strength, text::fixed(u.residual_correlation_s, 2), result.samples, worth));
  }
  return all;
}

std::string printable(std::string text) {
  for (const auto& [plain, printed] :
       {std::pair{"+-", "\u00b1"}, std::pair{" m2", " m\u00b2"}, std::pair{"kg/m3", "kg/m\u00b3"}}) {
    for (std::size_t at = text.find(plain); at != std::string::npos; at = text.find(plain)) {
      text.replace(at, std::string_view{plain}.size(), printed);
    }
  }
  return text;
}

std::string sentence(std::string text) {
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + ".";
}

}  // namespace fantail::identify::result
