// SPDX-License-Identifier: MIT
#include "predict/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "predict/airframe.hpp"
#include "predict/margins.hpp"
#include "predict/run.hpp"
#include "runs/runner.hpp"
#include "stability/roll_loop.hpp"
#include "stability/speed_range.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

using text::fixed;

template <typename ValueOf>
Quantiles spread_of(const std::vector<Run>& runs, ValueOf value_of) {
  std::vector<double> values;
  std::ranges::transform(runs, std::back_inserter(values), value_of);
  return campaign::quantiles(std::move(values));
}

template <typename ValueOf>
std::optional<Quantiles> spread_where_known(const std::vector<Run>& runs, ValueOf value_of) {
  std::vector<double> values;
  for (const Run& run : runs) {
    if (const std::optional<double> value = value_of(run)) {
      values.push_back(*value);
    }
  }
  return values.empty() ? std::nullopt : std::optional{campaign::quantiles(std::move(values))};
}

std::optional<double> size_of(const std::optional<double>& value) {
  return value ? std::optional{std::abs(*value)} : std::nullopt;
}

void count(Prediction& p) {
  const auto number = [&p](auto is_so) { return static_cast<std::size_t>(std::ranges::count_if(p.runs, is_so)); };
  const auto came_to = [&number](report::Outcome outcome) {
    return number([outcome](const Run& run) { return run.outcome == outcome; });
  };
  p.authority = share(number([](const Run& run) { return run.authority_margin_rad > same_angle_rad; }), p.runs.size());
  p.not_judged = came_to(report::Outcome::not_judged);
  p.without_control = number([](const Run& run) { return !run.lowest_speed_m_s; });
  p.held = share(came_to(report::Outcome::held), p.runs.size());
  p.outside_model = number([](const Run& run) { return flight::is_beyond_model(run.extremes); });
}

/// As long as all fly that left the pad.
Band band(const std::vector<Run>& runs) {
  std::vector<std::span<const double>> angles;
  std::vector<std::span<const double>> rates;
  for (const Run& run : runs) {
    if (run.roll_angle_rad.size() > 1) {
      angles.emplace_back(run.roll_angle_rad);
      rates.emplace_back(run.roll_rate_rad_s);
    }
  }
  Band all{.time_s = {},
           .roll_angle_rad = campaign::quantiles_over(angles, 1.0),
           .roll_rate_rad_s = campaign::quantiles_over(rates, 1.0)};
  for (std::size_t i = 0; i < all.roll_angle_rad.size(); ++i) {
    all.time_s.push_back(track_step_s * static_cast<double>(i));
  }
  return all;
}

bool has_opened(const Run& run) { return run.opening.has_value(); }
bool is_captured(const Run& run) { return run.opening && run.opening->captured_after_s; }

/// `value_of` an opening.
template <typename ValueOf>
std::optional<Quantiles> spread_of_openings(const std::vector<Run>& runs, ValueOf value_of) {
  return spread_where_known(runs, [&](const Run& run) -> std::optional<double> {
    return run.opening ? std::optional<double>{value_of(*run.opening)} : std::nullopt;
  });
}

void find_gate(Prediction& p) {
  using dormancy::Opening;
  p.opened = share(static_cast<std::size_t>(std::ranges::count_if(p.runs, &has_opened)), p.runs.size());
  p.captured = share(static_cast<std::size_t>(std::ranges::count_if(p.runs, &is_captured)), p.opened.count);
  if (!has_gate(p.flown.plan)) {
    return;
  }
  p.gate_time_s = spread_of_openings(p.runs, [](const Opening& o) { return o.time_s; });
  p.gate_height_m = spread_of_openings(p.runs, [](const Opening& o) { return o.height_m; });
  p.gate_speed_m_s = spread_of_openings(p.runs, [](const Opening& o) { return o.speed_m_s; });
  p.gate_rate_rad_s = spread_of_openings(p.runs, [](const Opening& o) { return o.rate_rad_s; });
  p.captured_after_s = spread_where_known(
      p.runs, [](const Run& run) { return run.opening ? run.opening->captured_after_s : std::nullopt; });
}

void find_margins(Prediction& p) {
  p.speeds_m_s = speeds_flown(p.flown.plan, p.runs);
  p.over_speed = margins_over_speed(p.flown, p.runs, p.speeds_m_s);
  const auto worst = std::ranges::min_element(p.over_speed, {}, [](const auto& at) { return at.phase_margin_rad.p5; });
  if (worst != p.over_speed.end()) {
    p.worst_speed = *worst;
  }
}

/// Those of vehicle and scenario are anybody's words: nobody can tell which of them are about what the runs draw.
std::vector<std::string> assumptions(const sim::Scenario& scenario, const TunnelResult& tunnel) {
  std::vector<std::string> all = scenario.vehicle.assumed;
  all.insert(all.end(), scenario.assumed.begin(), scenario.assumed.end());
  if (!all.empty()) {
    all.insert(
        all.begin(),
        fmt::format("Damping, canard torque and fin offset are drawn from the rows of {}. They replace the values "
                    "that the next {}, from vehicle and scenario, may state.",
                    tunnel.name, all.size() == 1 ? "sentence" : fmt::format("{} sentences", all.size())));
  }
  return all;
}

std::vector<std::string> notes(const sim::Scenario& scenario, const TunnelResult& tunnel) {
  std::vector<std::string> all = assumptions(scenario, tunnel);
  all.push_back(whose_rows(scenario, tunnel));
  all.push_back(which_area(scenario, tunnel));
  if (auto sentence = wash_in_rows(scenario, tunnel)) {
    all.push_back(std::move(*sentence));
  }
  if (scenario.imposed_roll) {
    all.emplace_back("The roll that the scenario imposes is left out: it is unknown before the flight.");
  }
  return all;
}

void require(const sim::Scenario& scenario, const TunnelResult& tunnel, const Options& options) {
  require_launch(scenario);
  if (!options.other_vehicle) {
    require_same_vehicle(scenario, tunnel);
  }
}

AirframeSpread spread_of_airframes(const sim::Scenario& scenario, const TunnelResult& tunnel, const Options& options) {
  const TunnelResult own = for_vehicle(scenario, tunnel);
  return {own.steps, options.damping, area_factor(scenario, tunnel), own.standard_errors};
}

std::string airframe_sentence(const sim::Scenario& scenario, std::size_t number, const TunnelStep& airframe) {
  const bool others_follow = !scenario.vehicle.assumed.empty() || !scenario.assumed.empty();
  return fmt::format(
      "Run {} of the prediction with seed {}: damping {} m2, torque {} m, fin offset from {} to {} deg.{}", number,
      scenario.seed, fixed(airframe.damping_m2, 3), fixed(airframe.torque_m, 3),
      fixed(text::degrees(airframe.offset_begin_rad), 2), fixed(text::degrees(airframe.offset_end_rad), 2),
      others_follow ? " They replace the values that sentences of vehicle and scenario below may state." : "");
}

/// What a run comes to is read back from its text, as is that of one that was flown before an interruption.
void fly_runs(Prediction& p, const AirframeSpread& airframes, const Options& options,
              const std::function<void(std::size_t)>& look) {
  constexpr std::uint64_t runs_of_a_part = 16;
  const auto fly_one = [&](std::uint64_t i) {
    return fly_run(p.flown, airframes.draw(runs::key_of_run(p.seed, i)), runs::seed_of_run(p.seed, i));
  };
  runs::run(runs::rows_into<Run>(p.runs, runs_of_a_part, "", fly_one), options.kept, options.threads, look);
  if (p.flown.motion == sim::FlightMotion::six_dof) {
    for (Run& run : p.runs) {
      run.wind = drawn_wind(p.flown.wind, p.flown.wind_spread, run.seed);
    }
  }
}

}  // namespace

double usual_offset_rad(const std::vector<Run>& runs) {
  return spread_of(runs, [](const Run& run) { return run.offset_rad; }).p50;
}

void require_launch(const sim::Scenario& scenario) {
  if (scenario.surroundings != sim::Surroundings::flight) {
    throw text::Error{
        text::ErrorKind::bad_configuration,
        scenario.name +
            ": environment.surroundings is not a flight; allowed: \"flight\", because a prediction is for a launch"};
  }
}

sim::Scenario with_servo(const sim::Scenario& scenario, const Options& options) {
  sim::Scenario changed = scenario;
  sim::ServoParameters& servo = changed.vehicle.servo;
  servo.lag_s = options.servo_lag_s.value_or(servo.lag_s);
  if (options.servo_delay_s) {
    // A delay from command to canard holds the wait for the pulse frame, which the simulated servo adds by itself.
    const double waiting_s = stability::loop_delay_s(changed.vehicle) - changed.vehicle.imu.delay_s - servo.delay_s;
    servo.delay_s = std::max(0.0, *options.servo_delay_s - waiting_s);
  }
  return changed;
}

RepeatedRun repeat_run(const sim::Scenario& scenario, const TunnelResult& tunnel, const Options& options,
                       std::size_t number) {
  require(scenario, tunnel, options);
  const sim::Scenario flown = with_servo(scenario, options);
  const std::uint64_t seed = runs::seed_of_run(scenario.seed, number);
  const TunnelStep airframe =
      spread_of_airframes(scenario, tunnel, options).draw(runs::key_of_run(scenario.seed, number));
  flight::Flight flight = fly_airframe(flown, airframe, seed, fly::Log::kept);
  flight.notes.insert(flight.notes.begin(), airframe_sentence(scenario, number, airframe));
  return {.run = run_of(flight, flown, airframe), .flight = std::move(flight)};
}

Prediction predict(const sim::Scenario& scenario, const TunnelResult& tunnel, const Options& options,
                   const std::function<void(std::size_t)>& look) {
  require(scenario, tunnel, options);
  Prediction p{.scenario = scenario.name,
               .vehicle = scenario.vehicle.name,
               .plan_name = scenario.plan_name,
               .seed = scenario.seed,
               .tunnel = for_vehicle(scenario, tunnel),
               .request = options.request,
               .damping = options.damping,
               .area = area_factor(scenario, tunnel),
               .notes = notes(scenario, tunnel),
               .flown = with_servo(scenario, options),
               .runs = std::vector<Run>(options.runs)};
  p.servo_lag_s = p.flown.vehicle.servo.lag_s;
  p.delay_s = stability::loop_delay_s(p.flown.vehicle);
  const AirframeSpread airframes = spread_of_airframes(scenario, tunnel, options);
  fly_runs(p, airframes, options, look);
  p.reach = canard_reach(scenario, usual_offset_rad(p.runs));
  count(p);
  p.offset_size_rad = spread_of(p.runs, [](const Run& run) { return std::abs(run.offset_rad); });
  p.authority_margin_rad = spread_of(p.runs, [](const Run& run) { return run.authority_margin_rad; });
  p.top_speed_m_s = spread_of(p.runs, [](const Run& run) { return run.top_speed_m_s; });
  if (p.flown.motion == sim::FlightMotion::six_dof) {
    p.wind_m_s = spread_of(p.runs, [](const Run& run) { return run.wind.value().speed_m_s; });
    p.apogee_m = spread_where_known(p.runs, [](const Run& run) { return run.apogee_m; });
    p.drift_m = spread_where_known(p.runs, [](const Run& run) { return run.drift_m; });
  }
  p.settle_rad = spread_where_known(p.runs, [](const Run& run) { return run.settle_rad; });
  p.settle_reference_rad = spread_where_known(p.runs, [](const Run& run) { return run.settle_reference_rad; });
  p.settle_off_rad = spread_where_known(p.runs, [](const Run& run) {
    return run.settle_rad ? std::optional{std::abs(*run.settle_rad - *run.settle_reference_rad)} : std::nullopt;
  });
  p.saturated_share = spread_where_known(p.runs, [](const Run& run) { return run.saturated_share; });
  p.spin_rate_rad_s = spread_where_known(p.runs, [](const Run& run) { return size_of(run.spin_rate_rad_s); });
  p.band = band(p.runs);
  p.resonance = roll_resonance(p.flown, p.runs, std::abs(p.reach.angle_rad));
  p.authority_over_speed = authority_over_speed(p.flown, p.runs, climb(p.flown, p.runs.front()), p.reach.angle_rad);
  p.flight_notes = notes_of(p.runs);
  find_gate(p);
  find_margins(p);
  return p;
}

}  // namespace fantail::predict
