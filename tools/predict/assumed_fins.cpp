// SPDX-License-Identifier: MIT
#include "predict/assumed_fins.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include <fmt/core.h>

#include "airframe/model/build_up.hpp"
#include "flight/model_end.hpp"
#include "predict/decision.hpp"
#include "predict/margins.hpp"
#include "predict/sentences.hpp"
#include "runs/runner.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

struct Factors {
  double damping;
  double torque;
};
constexpr std::array factors{Factors{1.0, 1.0}, Factors{1.0 / assumed_spread, 1.0 / assumed_spread},
                             Factors{1.0 / assumed_spread, assumed_spread},
                             Factors{assumed_spread, 1.0 / assumed_spread}, Factors{assumed_spread, assumed_spread}};

// 0, +1, -1, +2, ...: those of one size together.
constexpr std::size_t offsets_of_an_airframe = 2 * assumed_offset_steps + 1;
double offset_at(std::size_t place, double largest_rad) {
  const auto step = static_cast<double>((place + 1) / 2);
  return (place % 2 == 1 ? step : -step) * largest_rad / assumed_offset_steps + 0.0;
}

TunnelStep airframe_of(const sim::Scenario& flown, std::size_t flight, double largest_rad) {
  const Factors& by = factors.at(flight / offsets_of_an_airframe);
  const double offset_rad = offset_at(flight % offsets_of_an_airframe, largest_rad);
  return {.damping_m2 = by.damping * flown.vehicle.roll_plant.damping_m2,
          .torque_m = by.torque * flown.vehicle.roll_plant.torque_m,
          .offset_begin_rad = offset_rad,
          .offset_end_rad = offset_rad};
}

std::string as_clause(std::string sentence) {
  if (!sentence.empty() && sentence.front() >= 'A' && sentence.front() <= 'Z') {
    sentence.front() = static_cast<char>(sentence.front() - 'A' + 'a');
  }
  return sentence;
}

/// Why a run is no go; empty: it is none.
std::string objection(const Run& run, const AssumedAirframe& airframe, double asked_rad) {
  if (run.outcome == report::Outcome::outside_model) {
    return "outside the model, " + flight::how_far_beyond(run.extremes);
  }
  if (run.outcome != report::Outcome::held) {
    return as_clause(cause(run));
  }
  if (run.begun_on_guide_s) {
    return "control begins inside the launch guide";
  }
  return airframe.phase_margin_rad && *airframe.phase_margin_rad < asked_rad
             ? fmt::format("the least phase margin is {} degrees, below the {} that are asked for",
                           text::fixed(text::degrees(*airframe.phase_margin_rad), 1),
                           text::brief(text::degrees(asked_rad), 1))
             : "";
}

AssumedAirframe judged(const AssumedFins& all, std::size_t number) {
  const auto first = all.runs.begin() + static_cast<std::ptrdiff_t>(number * offsets_of_an_airframe);
  const std::vector<Run> runs{first, first + offsets_of_an_airframe};
  AssumedAirframe found{.damping_factor = factors.at(number).damping,
                        .torque_factor = factors.at(number).torque,
                        .damping_m2 = runs.front().airframe.damping_m2,
                        .torque_m = runs.front().airframe.torque_m};
  for (const MarginsAtSpeed& at : margins_over_speed(all.flown, {runs.front()}, speeds_flown(all.flown.plan, runs))) {
    found.phase_margin_rad =
        std::min(found.phase_margin_rad.value_or(at.phase_margin_rad.p50), at.phase_margin_rad.p50);
  }
  for (const Run& run : runs) {
    const double offset_rad = run.airframe.offset_begin_rad;
    const std::string why = objection(run, found, all.asked_phase_margin_rad);
    (why.empty() ? found.held_rad : found.failed_rad).push_back(offset_rad);
    if (!why.empty() && !found.fails_at_rad) {
      found.fails_at_rad = std::abs(offset_rad);
      found.why = why;
    }
  }
  for (const double offset_rad : found.held_rad) {
    if (!found.fails_at_rad || std::abs(offset_rad) < *found.fails_at_rad) {
      found.held_to_rad = std::max(found.held_to_rad.value_or(0.0), std::abs(offset_rad));
    }
  }
  return found;
}

std::optional<double> offset_per_cant(const sim::Vehicle& vehicle) {
  if (!vehicle.geometry) {
    return std::nullopt;
  }
  const airframe::model::BuildUp shape = airframe::model::build_up(vehicle);
  const double torque_m3 = vehicle.roll_plant.reference_area_m2 * vehicle.roll_plant.torque_m;
  return shape.cant_as_canards && shape.roll_torque_m3 && torque_m3 > 0.0 && shape.cant_as_canards->value > 0.0
             ? std::optional{shape.cant_as_canards->value * shape.roll_torque_m3->value / torque_m3}
             : std::nullopt;
}

}  // namespace

std::size_t assumed_flights() { return factors.size() * offsets_of_an_airframe; }

AssumedFins assume_fins(const sim::Scenario& scenario, const Options& options, double asked_phase_margin_rad,
                        const std::function<void(std::size_t)>& look) {
  require_launch(scenario);
  AssumedFins all{.scenario = scenario.name,
                  .vehicle = scenario.vehicle.name,
                  .plan_name = scenario.plan_name,
                  .seed = scenario.seed,
                  .request = options.request,
                  .flown = with_servo(scenario, options),
                  .asked_phase_margin_rad = asked_phase_margin_rad,
                  .runs = std::vector<Run>(assumed_flights())};
  all.flown.wind_spread = {};  // one wind for all: the stated one
  all.largest_offset_rad = std::max(
      {0.0, std::abs(canard_reach(all.flown, 1.0).angle_rad), std::abs(canard_reach(all.flown, -1.0).angle_rad)});
  const auto fly_one = [&](std::uint64_t flight) {
    return fly_run(all.flown, airframe_of(all.flown, flight, all.largest_offset_rad), all.seed);
  };
  runs::run(runs::rows_into<Run>(all.runs, offsets_of_an_airframe, "", fly_one), options.kept, options.threads, look);
  if (all.flown.motion == sim::FlightMotion::six_dof) {
    for (Run& run : all.runs) {
      run.wind = all.flown.wind;
    }
  }
  for (std::size_t number = 0; number < factors.size(); ++number) {
    all.airframes.push_back(judged(all, number));
  }
  all.flight_notes = notes_of(all.runs);
  const Prediction of_all{.flown = all.flown, .runs = all.runs};
  if (const auto tilt = tilt_limit(of_all); tilt && tilt->judgement == Judgement::not_met) {
    all.tilt = tilt->clause;
    all.tilt_advice = advice_on_tilt(of_all);
  }
  if (std::ranges::count(all.runs, report::Outcome::outside_model, &Run::outcome) > 0) {
    std::vector<flight::Extremes> extremes;
    std::ranges::transform(all.runs, std::back_inserter(extremes), &Run::extremes);
    all.beyond_model = flight::which_are_beyond(extremes);
  }
  all.offset_per_cant = offset_per_cant(all.flown.vehicle);
  return all;
}

}  // namespace fantail::predict
