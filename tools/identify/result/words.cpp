// SPDX-License-Identifier: MIT
#include "identify/result/words.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::identify::result {
namespace {

namespace output = fantail::result;
using namespace model;
using text::degrees;

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

std::string_view name(Instrument instrument) {
  switch (instrument) {
    case Instrument::canards: return "canards";
    case Instrument::excitation: return "excitation";
    case Instrument::reference: break;
  }
  return "reference";
}

std::string constant_text(double value) {
  return text::brief(value, std::max(2, std::abs(value) < 1.0 ? output::decimals_for(value, 4) : 0));
}

std::string change_text(double now, double before, std::string_view unit) {
  constexpr double same = 1e-4;
  if (std::abs(now - before) < same * std::abs(before)) {
    return fmt::format("{} {} as before", constant_text(before), unit);
  }
  const int places = std::max(2, output::decimals_for(now - before, 2));
  return fmt::format("{} {} instead of {}", text::brief(now, places), unit, text::brief(before, places));
}

output::Uncertain uncertain(const Identification& result, std::size_t number) {
  return {result.model.numbers()[number], result.uncertainty ? result.uncertainty->standard_deviation[number] : 0.0};
}

std::string with_deviation(const Identification& result, std::size_t number) {
  return output::shown({}, uncertain(result, number));
}

std::string interval_text(const Interval& interval, double scale) {
  return output::shown({.unit = {.per_si = scale}}, interval);
}

const Interval& interval_of(const Identification& result, std::size_t number) {
  return number == 0 ? result.uncertainty->alpha_profile_m2 : result.uncertainty->interval[number];
}

std::string precision_sentence(const Identification& result, std::size_t number) {
  constexpr double useful = 0.5;
  const bool angle = number >= 2;
  const std::string_view unit = angle ? "deg" : number == 0 ? "m2" : "m";
  const std::string who = subject(number, result.model);
  const double value = result.model.numbers()[number];
  const Interval& interval = interval_of(result, number);
  std::string range = interval_text(interval, angle ? degrees(1.0) : 1.0);
  if (!interval.low || !interval.high) {
    return fmt::format("{} is estimated at {} {}, but the data bound it on one side at most: {}.", who,
                       angle ? text::brief(degrees(value), 2) : constant_text(value), unit, range);
  }
  const double half = 0.5 * (*interval.high - *interval.low);
  const double share = half / std::abs(value);
  return fmt::format("{} lies between {} {} (95 %, {}{}).", who, range.replace(range.find(" to "), 4, " and "), unit,
                     angle ? plus_minus(degrees(half), std::clamp(output::decimals_for(degrees(half), 2), 0, 3), unit)
                           : plus_minus(100.0 * share, share < 0.0995 ? 1 : 0, "%"),
                     angle || share < useful ? "" : ", too uncertain for a prediction");
}

std::vector<std::string> precision_sentences(const Identification& result) {
  const std::size_t nodes = result.model.node_rad.size();
  constexpr std::size_t few = 2;
  const std::size_t told = 2 + (nodes <= few ? nodes : 0);
  std::vector<std::string> all;
  all.reserve(told + 1);
  for (std::size_t k = 0; k < told; ++k) {
    all.push_back(precision_sentence(result, k));
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
  const std::string worth = text::fixed(u.effective_samples, 0);
  if (u.effective_samples > 0.5 * static_cast<double>(result.samples)) {
    all.push_back(
        fmt::format("The residual, {} deg RMS, is hardly correlated. The {} samples determine alpha and beta as well "
                    "as about {} independent ones.",
                    strength, result.samples, worth));
  } else if (u.effective_samples < 2.0 * static_cast<double>(u.interval.size())) {
    all.push_back(
        fmt::format("The residual, {} deg RMS, is correlated over {} s, so few of the {} samples are independent. The "
                    "intervals include that. A longer window or more canard motion would help; faster sampling would "
                    "not.",
                    strength, text::fixed(u.residual_correlation_s, 2), result.samples));
  } else {
    all.push_back(fmt::format(
        "The residual, {} deg RMS, is correlated over {} s. The {} samples determine alpha and beta as well as {} "
        "independent samples would. A longer window or more canard motion would help; faster sampling would not.",
        strength, text::fixed(u.residual_correlation_s, 2), result.samples, worth));
  }
  return all;
}

std::string lag_sentence(const WindowFindings& window) {
  if (!window.lag_is_fitted && window.lag_s == 0.0) {
    return "";
  }
  const auto& known = main_result(window).uncertainty;
  std::string fitted = window.lag_is_fitted ? " (fitted)" : "";
  if (window.lag_is_fitted && known && known->lag_s) {
    const double reach_s = known->lag_s->reach;
    fitted =
        fmt::format(" (fitted; 95 %: {} ms)", interval_text({window.lag_s - reach_s, window.lag_s + reach_s}, 1e3));
  }
  return fmt::format("Canard angles are used {} ms {} than they are logged{}.",
                     text::brief(1e3 * std::abs(window.lag_s), 1), window.lag_s < 0.0 ? "earlier" : "later", fitted);
}

std::string worth_text(double effective_samples) {
  return effective_samples < 1.0 ? "fewer than 1" : text::fixed(effective_samples, 0);
}

std::string extent(const Record& record) {
  return fmt::format("{} s to {} s on the log's clock, {} samples", text::brief(record.window_begin_s, 3),
                     text::brief(record.window_begin_s + record.time_s.back(), 3), record.size());
}

std::string frequency_sentence(const FrequencyResponse& response) {
  if (!response.obstacle.empty()) {
    return response.obstacle;
  }
  const FrequencyCount count = count_lines(response);
  const std::string needed = text::fixed(least_coherence, 1);
  if (count.told == 0) {
    return fmt::format(
        "The coherence reaches {} at none of {} frequencies up to {} Hz, so the log shows no frequency response.",
        needed, response.lines.size(), text::brief(response.lines.back().frequency_hz, 1));
  }
  return fmt::format(
      "The coherence reaches {} at {} of {} frequencies, between {} and {} Hz; the model's gain is "
      "inside the 95 % interval at {} of them.",
      needed, count.told, response.lines.size(), text::brief(count.lowest_hz, 1), text::brief(count.highest_hz, 1),
      count.agreed);
}

std::string instrument_sentence(const FrequencyResponse& response) {
  if (response.instrument != Instrument::canards) {
    return fmt::format(
        "The log has the {} of a controller. Cross spectra are taken with it, so noise and disturbances that reach "
        "the canards through the controller do not bias the estimate.",
        name(response.instrument));
  }
  if (response.loop_was_closed) {
    return "The log has the reference of a controller, but it did not move, and there was no excitation. Noise and "
           "disturbances that reach the canards through the controller therefore bias this estimate. The fit over "
           "time does not use it.";
  }
  return "The log does not show why the canards moved. If a roll controller moved them, noise and disturbances that "
         "came back through it bias this estimate. The fit over time does not use it.";
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

std::string sentence(std::string text) {
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + ".";
}

}  // namespace fantail::identify::result
