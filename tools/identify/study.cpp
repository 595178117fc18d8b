// SPDX-License-Identifier: MIT
#include "identify/study.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "identify/choices.hpp"
#include "identify/doubts.hpp"
#include "identify/model/least_squares.hpp"
#include "identify/result/residual.hpp"
#include "identify/result/words.hpp"
#include "input/messages.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::identify {
namespace {

using namespace model;
using namespace result;

// Lags that are tried first, 5 ms apart, so that a side valley is not taken for the deepest.
constexpr int places = 21;
constexpr double stride_s = 2.0 * largest_fitted_lag_s / (places - 1);

// The same samples for every lag that is tried, or the comparison would favour the shortest record.
Window with_room(const logs::RollLog& log, Window window) {
  const double first = log.time_s.front() + largest_fitted_lag_s;
  const double last = log.time_s.back() - largest_fitted_lag_s;
  window.from_s = std::max(window.from_s.value_or(first), first);
  window.to_s = std::min(window.to_s.value_or(last), last);
  return window;
}

// Even nodes divide the window as it was asked for, whatever a lag takes off its ends: they are times, too.
NodeChoice nodes_on_clock(const logs::RollLog& log, const Window& window, const Question& question) {
  RecordOptions as_logged = question.record;
  as_logged.lag_s = 0.0;
  const Record whole = make_record(log, window, as_logged);
  NodeChoice nodes = find_nodes(log, whole, question.nodes);
  if (const auto* even = std::get_if<EvenNodes>(&nodes)) {
    NodeTimes times = even_nodes(whole, even->intervals);
    for (double& time_s : times) {
      time_s += whole.window_begin_s;
    }
    return times;
  }
  return nodes;
}

std::vector<std::string> remarks_on(const Record& record, const Question& question) {
  std::vector<std::string> remarks;
  if (const std::size_t gaps = record.segment_begin.size() - 1; gaps > 0) {
    remarks.push_back(
        fmt::format("{} {} in the window; the model restarts after each.", gaps, gaps == 1 ? "gap" : "gaps"));
  }
  for (auto& remark :
       {remark_on_inertia(record, question.record.roll_inertia), remark_on_mach(record, question.grows_with_mach)}) {
    if (remark) {
      remarks.push_back(*remark);
    }
  }
  return remarks;
}

std::string remark_on_loss(const RobustFit& fit, std::size_t samples) {
  return fmt::format(
      "Huber's loss: angle errors beyond {:.2g} deg ({} of {} samples) count in proportion to their size, not to its "
      "square. The initial values are fitted.{}",
      text::degrees(fit.threshold_rad), fit.beyond, samples,
      fit.settled ? "" : " The search stopped before it converged, so the result may be inaccurate.");
}

// The control law needs its reference; an excitation that nobody logged was most likely not there.
void prepare_closed_loop(const logs::RollLog& log, const closed_loop::Control& control, WindowFindings& found) {
  Record& record = found.record;
  if (record.reference_rad.empty()) {
    throw text::Error{text::ErrorKind::bad_data, log.name +
                                                     ": no column reference_deg with a number in every row of window " +
                                                     record.window + "; the closed loop needs it"};
  }
  if (record.excitation_rad.empty()) {
    record.excitation_rad.assign(record.size(), 0.0);
    found.remarks.emplace_back("The log has no excitation; the closed loop is simulated without one.");
  }
  const auto is_zero = [](double estimate_rad) { return estimate_rad == 0.0; };
  if (control.offset_rejection == core::OffsetRejection::none &&
      !std::ranges::all_of(record.offset_estimate_rad, is_zero)) {
    found.remarks.emplace_back(
        "The law that flew subtracted an estimate of the fin offset from its command, and the chosen law does not. "
        "The closed loop is simulated with the estimate of the log.");
  }
}

std::optional<std::string> unexpected_servo(const std::optional<double>& told_s, const Identification& found) {
  if (!told_s || !found.servo || !found.uncertainty || !found.uncertainty->lag_s ||
      std::abs(*told_s - found.servo->lag_s) <= found.uncertainty->lag_s->reach) {
    return {};
  }
  const double reach_s = found.uncertainty->lag_s->reach;
  return fmt::format(
      "The fitted lag of the servos is {} ms (95 %: {} ms), not the {} ms of --servo-lag. The result uses the fitted "
      "lag; a delay counts as lag.",
      text::brief(1e3 * found.servo->lag_s, 1),
      interval_text({std::max(0.0, found.servo->lag_s - reach_s), found.servo->lag_s + reach_s}, 1e3),
      text::brief(1e3 * *told_s, 1));
}

// Few of many beside "identifiable" looks like a contradiction.
std::optional<std::string> about_effective_samples(const Identification& found) {
  constexpr double few = 30.0;
  const auto& u = found.uncertainty;
  if (!u || u->effective_samples >= few || !u->alpha_identifiable || !u->beta_identifiable) {
    return {};
  }
  return "There are few effective samples: an error that changes slowly, or that of the measured first angle and rate, "
         "counts only once. The intervals include that. A longer window or more canard motion would narrow them.";
}

// What the angle alone says so well is not known while the rate says otherwise.
void refute(Uncertainty& known) {
  known.verdict =
      "alpha and beta cannot be determined from this window: they fit the roll angle, but the roll rate contradicts "
      "them";
  known.alpha_identifiable = known.beta_identifiable = false;
}

WindowFindings identify_window(const logs::RollLog& log, const Window& window, const Question& question) {
  WindowFindings found;
  RecordOptions how = question.record;
  const NodeChoice nodes = nodes_on_clock(log, window, question);
  Window inside = window;
  if (question.fit_lag) {
    const LagFit fit = fit_lag(log, window, how, question.airframe, nodes, question.options);
    how.lag_s = fit.lag_s;
    how.lag_is_fitted = true;
    inside = with_room(log, window);
    if (fit.at_the_edge) {
      found.remarks.push_back(
          fmt::format("The fitted lag is at the end of the search range, {} ms; the true lag may be larger.",
                      input::plain_number(1000.0 * largest_fitted_lag_s)));
    }
  }
  found.record = make_record(log, inside, how);
  const std::vector<std::string> of_record = remarks_on(found.record, question);
  found.remarks.insert(found.remarks.begin(), of_record.begin(), of_record.end());
  found.lag_s = how.lag_s;
  found.lag_is_fitted = question.fit_lag;
  if (question.options.closed_loop) {
    prepare_closed_loop(log, *question.options.closed_loop, found);
  }
  for (const Method method : question.methods) {
    Options options = question.options;
    options.method = method;
    options.nodes = nodes_in(found.record, nodes);
    found.results.push_back(identify(found.record, question.airframe, options));
    Identification& result = found.results.back();
    result.residual_tests = test_residual(found.record, result.simulation);
    if (result.loop == Loop::open) {
      result.frequency_response = frequency_response(found.record, result.simulation);
    }
    if (result.uncertainty && result.uncertainty->alpha_identifiable && result.uncertainty->beta_identifiable &&
        is_refuted(found.record, result)) {
      refute(*result.uncertainty);
    }
    if (auto doubt = misfit(found.record, result)) {
      result.remarks.push_back(std::move(*doubt));
    }
    if (auto other = unexpected_servo(question.told_servo_lag_s, result)) {
      result.remarks.push_back(std::move(*other));
    }
    if (auto meaning = about_effective_samples(result)) {
      result.remarks.push_back(std::move(*meaning));
    }
    const Record& judged = result.robust ? result.robust->pseudo_record : found.record;
    for (std::string& doubt : doubts(judged, question.airframe, options.start, result)) {
      result.remarks.push_back(std::move(doubt));
    }
    if (result.robust) {
      result.remarks.push_back(remark_on_loss(*result.robust, found.record.size()));
    }
  }
  return found;
}

}  // namespace

LagFit fit_lag(const logs::RollLog& log, const Window& window, const RecordOptions& record_options,
               const Airframe& airframe, const NodeChoice& nodes, const Options& options) {
  Options quick = options;
  quick.method = Method::continuous;
  quick.closed_loop.reset();
  quick.with_uncertainty = false;
  quick.with_error_map = false;
  // One choice of nodes for all lags; the most that could be chosen leaves the least of the disturbance in the error.
  const auto* automatic = std::get_if<AutomaticNodes>(&nodes);
  quick.nodes = automatic != nullptr ? NodeChoice{EvenNodes{automatic->most}} : nodes;
  const Window inside = with_room(log, window);
  const auto error = [&](double lag_s) {
    RecordOptions shifted = record_options;
    shifted.lag_s = lag_s;
    const Record record = make_record(log, inside, shifted);
    Options here = quick;
    here.nodes = nodes_in(record, quick.nodes);
    return identify(record, airframe, here).simulation.rms_angle_error_rad;
  };

  const double lag_s = least_over(error, {.low = -largest_fitted_lag_s, .high = largest_fitted_lag_s}, places, 1e-3);
  return {.lag_s = lag_s, .at_the_edge = std::abs(lag_s) > largest_fitted_lag_s - 0.5 * stride_s};
}

Study study(const logs::RollLog& log, const Question& asked) {
  Study result;
  result.data = log.name;
  result.airframe = asked.airframe;
  result.warnings = log.warnings;
  Question question = asked;
  question.record.grows_with_mach = asked.grows_with_mach.value_or(false);
  if (question.record.roll_inertia.empty()) {
    question.record.roll_inertia = inertia_on_clock(log, asked.inertia_since_ignition, result.warnings);
  }
  for (const Window& window : question.windows) {
    result.windows.push_back(identify_window(log, window, question));
  }
  return result;
}

}  // namespace fantail::identify
