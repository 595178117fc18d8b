// SPDX-License-Identifier: MIT
#include "identify/study.hpp"

#include <utility>

#include <fmt/core.h>

#include "identify/lag_fit.hpp"
#include "identify/misfit.hpp"
#include "identify/node_choice.hpp"
#include "sim/input/messages.hpp"
#include "sim/input_error.hpp"

namespace fantail::identify {
namespace {

std::vector<std::string> remarks_on(const Record& record) {
  std::vector<std::string> remarks;
  if (const std::size_t gaps = record.segment_begin.size() - 1; gaps > 0) {
    remarks.push_back(
        fmt::format("{} {} in the window; behind each the model starts anew from what was measured there.", gaps,
                    gaps == 1 ? "gap" : "gaps"));
  }
  return remarks;
}

// The control law needs its reference; an excitation that nobody logged was most likely not there.
void prepare_closed_loop(const logs::RollLog& log, WindowFindings& found) {
  Record& record = found.record;
  if (record.reference_rad.empty()) {
    throw sim::InputError{sim::InputFault::bad_data,
                          log.name + ": no column reference_deg with a number in every row of window " + record.window +
                              "; the closed loop needs what the controller was asked for"};
  }
  if (record.excitation_rad.empty()) {
    record.excitation_rad.assign(record.size(), 0.0);
    found.remarks.emplace_back("The log has no excitation; the closed loop was computed without one.");
  }
}

WindowFindings look_at(const logs::RollLog& log, const Window& window, const Question& question) {
  WindowFindings found;
  RecordOptions how = question.record;
  found.record = make_record(log, window, how);
  found.remarks = remarks_on(found.record);
  const NodeChoice nodes = find_nodes(log, found.record, question.nodes);
  if (question.fit_lag) {
    const LagFit fit = fit_lag(log, window, how, question.airframe, nodes, question.options);
    how.lag_s = fit.lag_s;
    found.record = make_record(log, window, how);
    if (fit.at_the_edge) {
      found.remarks.push_back(fmt::format("The fitted lag lies at the edge of what is tried, {} ms; it may be longer.",
                                          sim::input::shown(1000.0 * largest_fitted_lag_s)));
    }
  }
  found.lag_s = how.lag_s;
  found.lag_is_fitted = question.fit_lag;
  if (question.options.closed_loop) {
    prepare_closed_loop(log, found);
  }
  for (const Method method : question.methods) {
    Options options = question.options;
    options.method = method;
    options.nodes = nodes;
    found.results.push_back(identify(found.record, question.airframe, options));
    if (auto doubt = misfit(found.record, found.results.back())) {
      found.results.back().remarks.push_back(std::move(*doubt));
    }
  }
  return found;
}

}  // namespace

Study study(const logs::RollLog& log, const Question& question) {
  Study result;
  result.data = log.name;
  result.airframe = question.airframe;
  result.warnings = log.warnings;
  for (const Window& window : question.windows) {
    result.windows.push_back(look_at(log, window, question));
  }
  return result;
}

}  // namespace fantail::identify
