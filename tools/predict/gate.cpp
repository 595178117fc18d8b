// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "predict/criteria.hpp"
#include "predict/sentences.hpp"
#include "text/apart.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

using text::degrees;
using text::fixed;

/// Why the gate stays closed in a run that it stays closed in.
std::string why_closed(const Prediction& p) {
  using core::DormantUntil;
  const core::DormancyPlan& plan = p.flown.plan.dormancy;
  const bool waits_for_height = plan.until == DormantUntil::height || plan.until == DormantUntil::burn_out_and_height ||
                                plan.until == DormantUntil::max_dynamic_pressure_and_height;
  const auto asked_m = static_cast<double>(plan.height_m);
  std::vector<double> apogees_m;
  for (const Run& run : p.runs) {
    if (run.gate_stays_closed && run.apogee_m) {
      apogees_m.push_back(*run.apogee_m);
    }
  }
  if (!waits_for_height || apogees_m.empty()) {
    return "it does not open before apogee";
  }
  const double highest_m = std::ranges::max(apogees_m);
  return highest_m < asked_m
             ? fmt::format("the apogee of {} m or less is below dormancy.height_m = {}",
                           text::apart(highest_m, asked_m, 0), text::brief(asked_m, 1))
             : fmt::format("it waits for the low end of the height's error to pass dormancy.height_m = {}",
                           text::brief(asked_m, 1));
}

std::size_t reopened(const Prediction& p) {
  return static_cast<std::size_t>(
      std::ranges::count_if(p.runs, [](const Run& run) { return run.opening && run.opening->reopenings > 0; }));
}

/// Medians.
std::string how_it_opens(const Prediction& p) {
  return fmt::format(
      "the gate {}opens at {} s, {} m, {} m/s through the air; the rocket then turns at {} deg/s (medians)",
      reopened(p) > 0 ? "first " : "", fixed(p.gate_time_s->p50, 2), fixed(p.gate_height_m->p50, 0),
      fixed(p.gate_speed_m_s->p50, 0), fixed(degrees(p.gate_rate_rad_s->p50), 0));
}

/// What the canards leave of the rotation in runs whose offset they cannot balance; empty: there are none.
std::string not_stopped(const Prediction& p) {
  std::vector<double> left_rad_s;
  for (const Run& run : p.runs) {
    if (run.opening && run.spin_rate_rad_s && run.top_speed_m_s > 0.0) {
      left_rad_s.push_back(std::abs(*run.spin_rate_rad_s) * run.opening->speed_m_s / run.top_speed_m_s);
    }
  }
  if (left_rad_s.empty()) {
    return {};
  }
  const std::size_t count = left_rad_s.size();
  return fmt::format("in {} of {} the canards cannot stop the rotation: about {} deg/s remain at the speed of the gate",
                     count, runs(p.runs.size()), fixed(degrees(campaign::quantiles(std::move(left_rad_s)).p50), 0));
}

std::string how_it_is_captured(const Prediction& p) {
  const std::size_t again = reopened(p);
  const std::string_view since = again > 0 ? " of the last opening" : "";
  if (p.captured.count == 0) {
    return fmt::format("the roll is captured in none of these runs{}", again > 0 ? " after the last opening" : "");
  }
  return fmt::format("the roll is captured in {} of {}, 95 % of them within {} s{}", p.captured.count,
                     text::counted(p.captured.of, "run"), fixed(std::ceil(100.0 * p.captured_after_s->p95) / 100.0, 2),
                     since);
}

}  // namespace

std::optional<Criterion> gate(const Prediction& p, double threshold) {
  if (!has_gate(p.flown.plan)) {
    return std::nullopt;
  }
  Criterion c = share_asked("gate", "The plan's gate opens", p.opened, threshold);
  std::vector<std::string> clauses;
  if (too_few_runs(p.opened, threshold)) {
    clauses.push_back(more_runs(p.opened, threshold));
  }
  const auto closed = static_cast<std::size_t>(std::ranges::count_if(p.runs, &Run::gate_stays_closed));
  if (closed > 0) {
    const std::string many = closed == p.runs.size()
                                 ? "the gate is not reached"
                                 : fmt::format("in {} of {} the gate is not reached", closed, runs(p.runs.size()));
    clauses.push_back(
        fmt::format("{}: {}. Control never begins{}", many, why_closed(p), closed == p.runs.size() ? "" : " there"));
  }
  if (p.opened.count > 0) {
    clauses.push_back(how_it_opens(p));
    if (const std::size_t again = reopened(p); again > 0) {
      clauses.push_back(fmt::format("in {} of {} it closes and reopens", again, runs(p.runs.size())));
    }
    clauses.push_back(how_it_is_captured(p));
    clauses.push_back(not_stopped(p));
  }
  std::erase(clauses, "");
  c.clause = as_sentences(clauses);
  return c;
}

}  // namespace fantail::predict
