// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "identify/result/answer.hpp"
#include "identify/result/parts.hpp"
#include "text/input_file.hpp"

// Every figure of a result: its key, label, unit and rounding in all outputs, and its meaning for the manual.
namespace fantail::identify::result {
namespace {

using F = Found;

template <auto member>
Cell of_study(const F& f) {
  return f.study.*member;
}
template <auto member>
Cell known(const F& f) {
  return f.result.uncertainty ? Cell{(*f.result.uncertainty).*member} : Cell{};
}
template <auto member>
Cell tests(const F& f) {
  return f.result.residual_tests ? Cell{(*f.result.residual_tests).*member} : Cell{};
}
Cell deviation(const F& f, std::size_t number) {
  return f.result.uncertainty ? Cell{f.result.uncertainty->standard_deviation[number]} : Cell{};
}
Cell interval(const F& f, std::size_t number) {
  return f.result.uncertainty ? Cell{interval_of(f.result, number)} : Cell{};
}

/// A lag or a play that was fitted, and how well it is known.
struct Fitted {
  double value;
  const std::optional<Spread>& spread;
};
/// Of the canards in the open loop, of the servos in the closed one.
std::optional<Fitted> lag_of_canards(const F& f) {
  return f.result.uncertainty && !f.result.servo ? std::optional{Fitted{f.window.lag_s, f.result.uncertainty->lag_s}}
                                                 : std::nullopt;
}
std::optional<Fitted> lag_of_servo(const F& f) {
  return f.result.uncertainty && f.result.servo
             ? std::optional{Fitted{f.result.servo->lag_s, f.result.uncertainty->lag_s}}
             : std::nullopt;
}
std::optional<Fitted> play_of_servo(const F& f) {
  return f.result.uncertainty && f.result.servo
             ? std::optional{Fitted{f.result.servo->play_rad, f.result.uncertainty->play_rad}}
             : std::nullopt;
}
Cell value_of(const std::optional<Fitted>& fitted) {
  return fitted ? Cell{output::Uncertain{fitted->value, fitted->spread ? fitted->spread->standard_deviation : 0.0}}
                : Cell{};
}
Cell deviation_of(const std::optional<Fitted>& fitted) {
  return fitted && fitted->spread ? Cell{fitted->spread->standard_deviation} : Cell{};
}
Cell range_of(const std::optional<Fitted>& fitted, double lowest) {
  return fitted && fitted->spread ? Cell{output::Range{std::max(lowest, fitted->value - fitted->spread->reach),
                                                       fitted->value + fitted->spread->reach}}
                                  : Cell{};
}
Cell servo_play(const F& f) {
  return f.result.servo && f.result.servo->play_rad == 0.0 ? Cell{0.0} : value_of(play_of_servo(f));
}
std::string play_words(double /*zero*/) { return "0, no play fits better"; }

constexpr auto found_fields = output::fields<F>({
    {"data", "log", u::none, 0, of_study<&Study::data>, "the log"},
    {"window", "window", u::none, 0, [](const F& f) { return Cell{f.window.record.window}; },
     "the window as requested"},
    {"window_begin", "window begins", u::s, 3, [](const F& f) { return Cell{f.window.record.window_begin_s}; },
     "begin of the window on the log's clock"},
    {"method", "method", u::none, 0, [](const F& f) { return Cell{std::string{name(f.result.method)}}; },
     "grid or continuous"},
    {"loop", "loop", u::none, 0, [](const F& f) { return Cell{std::string{name(f.result.loop)}}; },
     "open: canards as measured; closed: as the controller commands in the model"},
    {"loss", "loss", u::none, 0, [](const F& f) { return Cell{std::string{f.result.robust ? "huber" : "squares"}}; },
     "huber or squares"},
    {"samples", "samples", u::none, 0, [](const F& f) { return Cell{std::uint64_t{f.result.samples}}; },
     "samples in the window"},
    {"seconds", "length in seconds", u::none, 3, [](const F& f) { return Cell{f.result.seconds}; },
     "length of the window in seconds"},
    {"alpha", "damping alpha", u::m2, 4, [](const F& f) { return Cell{uncertain(f.result, 0)}; },
     "damping; in text with its standard deviation"},
    {"beta", "torque constant beta", u::m, 4, [](const F& f) { return Cell{uncertain(f.result, 1)}; },
     "canard torque, likewise"},
    {"mean_abs_angle_error", "mean angle error", u::deg, 3,
     [](const F& f) { return Cell{f.result.simulation.mean_abs_angle_error_rad}; },
     "mean absolute difference of modelled and measured roll angle"},
    {"mean_abs_rate_error", "mean rate error", u::deg_s, 2,
     [](const F& f) { return Cell{f.result.simulation.mean_abs_rate_error_rad_s}; }, "the same of the roll rate"},
    {"huber_threshold", "Huber's threshold", u::deg, 3,
     [](const F& f) { return f.result.robust ? Cell{f.result.robust->threshold_rad} : Cell{}; },
     "angle error beyond which an error counts less than its square"},
    {"huber_samples_beyond", "samples beyond it", u::none, 0,
     [](const F& f) { return f.result.robust ? Cell{std::uint64_t{f.result.robust->beyond}} : Cell{}; },
     "samples with a larger one"},
    {"alpha_sd", "its standard deviation", u::m2, 4, [](const F& f) { return deviation(f, 0); },
     "standard deviation of alpha"},
    {"beta_sd", "its standard deviation", u::m, 4, [](const F& f) { return deviation(f, 1); },
     "standard deviation of beta"},
    {"alpha_interval", "95 % of alpha", u::m2, 4, [](const F& f) { return interval(f, 0); },
     "95 % interval of alpha; null: an open end"},
    {"beta_interval", "95 % of beta", u::m, 4, [](const F& f) { return interval(f, 1); }, "95 % interval of beta"},
    {"effective_samples", "effective samples", u::none, 0, known<&Uncertainty::effective_samples>,
     "independent samples that would determine alpha and beta as well", output::Worse::neither, worth_text},
    {"degrees_of_freedom", "degrees of freedom", u::none, 0, known<&Uncertainty::degrees_of_freedom>,
     "of the Student distribution used for the intervals"},
    {"alpha_identifiable", "alpha is identifiable", u::none, 0, known<&Uncertainty::alpha_identifiable>,
     "known within a factor of four"},
    {"beta_identifiable", "beta is identifiable", u::none, 0, known<&Uncertainty::beta_identifiable>, "likewise"},
    {"verdict", "verdict", u::none, 0, known<&Uncertainty::verdict>, "a clause on what is identifiable and why"},
    {"lag", "lag of the canards", ms, 2, [](const F& f) { return Cell{f.window.lag_s}; },
     "assumed lag of the canard column"},
    {"lag_fitted", "the lag is fitted", u::none, 0, [](const F& f) { return Cell{f.window.lag_is_fitted}; },
     "whether that lag was fitted here"},
    {"lag_sd", "its standard deviation", ms, 2, [](const F& f) { return deviation_of(lag_of_canards(f)); },
     "its standard deviation, where it was fitted"},
    {"lag_interval", "95 % of the lag", ms, 2, [](const F& f) { return range_of(lag_of_canards(f), -1.0); },
     "its 95 % interval"},
    {"servo_lag", "servo lag, fitted", ms, 2, [](const F& f) { return value_of(lag_of_servo(f)); },
     "lag of the servos, fitted in the closed loop"},
    {"servo_lag_sd", "its standard deviation", ms, 2, [](const F& f) { return deviation_of(lag_of_servo(f)); },
     "its standard deviation"},
    {"servo_lag_interval", "95 % of that lag", ms, 2, [](const F& f) { return range_of(lag_of_servo(f), 0.0); },
     "its 95 % interval"},
    {"servo_play", "servo play, fitted", u::deg, 2, servo_play, "play of the servos, likewise", output::Worse::neither,
     play_words},
    {"servo_play_sd", "its standard deviation", u::deg, 2, [](const F& f) { return deviation_of(play_of_servo(f)); },
     "its standard deviation"},
    {"servo_play_interval", "95 % of that play", u::deg, 2, [](const F& f) { return range_of(play_of_servo(f), 0.0); },
     "its 95 % interval"},
    {"residual_own_correlation", "rate residual: correlation with itself", u::none, 2,
     tests<&ResidualTests::own_correlation>,
     "strongest correlation of the roll rate residual with itself, within 0.2 s"},
    {"residual_correlation_by_chance", "by chance up to", u::none, 2, tests<&ResidualTests::chance>,
     "white noise exceeds it once in a hundred cases"},
    {"residual_canard_correlation", "its correlation with the canards", u::none, 2,
     tests<&ResidualTests::canard_correlation>, "the same with the canards, up to 0.2 s earlier"},
    {"residual_canard_correlation_by_chance", "by chance up to", u::none, 2, tests<&ResidualTests::canard_chance>,
     "a residual with this correlation in time exceeds it once in a hundred cases"},
    {"density", "density", u::none, 0, of_study<&Study::density>, "air density, in words"},
    {"speed", "speed", u::none, 0, of_study<&Study::speed>, "source of the speed"},
    {"inertia", "roll inertia", kg_m2, 5,
     [](const F& f) { return Cell{mean_inertia_kg_m2(f.window.record, f.study.airframe)}; },
     "mean roll inertia in the window"},
    {"reference_area", "reference area", u::m2, 7, [](const F& f) { return Cell{f.study.airframe.reference_area_m2}; },
     "reference area"},
});

/// The disturbance at one instant.
struct Node {
  Cell method;  ///< where there are several
  double time_s;
  output::Uncertain disturbance_rad;
  Cell interval_rad;
};
constexpr auto node_fields = output::fields<Node>({
    {"method", "method", u::none, 0, [](const Node& n) { return n.method; }, "grid or continuous"},
    {"time", "time on the log's clock", u::s, 2, &Node::time_s, "time on the log's clock"},
    {"disturbance", "disturbance", u::deg, 3, [](const Node& n) { return Cell{n.disturbance_rad}; },
     "as a canard angle"},
    {"interval", "95 %", u::deg, 3, [](const Node& n) { return n.interval_rad; }, "its 95 % interval"},
});

constexpr auto trial_fields = output::fields<NodeTrial>({
    {"intervals", "intervals", u::none, 0, &NodeTrial::intervals, "intervals of the disturbance that were tried"},
    {"mean_abs_angle_error", "mean angle error", u::deg, 3, &NodeTrial::mean_abs_angle_error_rad,
     "mean angle error with them"},
    {"alpha", "damping alpha", u::m2, 3, [](const NodeTrial& t) { return Cell{t.model.alpha_m2}; },
     "damping with them"},
    {"beta", "torque beta", u::m, 3, [](const NodeTrial& t) { return Cell{t.model.beta_m}; }, "torque with them"},
});

struct Sample {
  double time_s;
  double angle_rad;
  double model_angle_rad;
  double rate_rad_s;
  double model_rate_rad_s;
  double canard_rad;
  double disturbance_rad;
};
constexpr auto sample_fields = output::fields<Sample>({
    {"time", "time", u::s, 3, &Sample::time_s, "time on the log's clock"},
    {"roll_angle", "roll angle", u::deg, 2, &Sample::angle_rad, "roll angle of the log"},
    {"model_roll_angle", "roll angle, modelled", u::deg, 2, &Sample::model_angle_rad, "roll angle of the model"},
    {"roll_rate", "roll rate", u::deg_s, 2, &Sample::rate_rad_s, "roll rate of the log"},
    {"model_roll_rate", "roll rate, modelled", u::deg_s, 2, &Sample::model_rate_rad_s, "roll rate of the model"},
    {"canard", "canards", u::deg, 2, &Sample::canard_rad,
     "mean canard angle that drives the model: from the log; in the closed loop from the model"},
    {"disturbance", "disturbance", u::deg, 2, &Sample::disturbance_rad, "disturbance as a canard angle"},
});

}  // namespace

output::Figures figures_of(const Found& found, const std::string& place) {
  return output::figures(place, found, found_fields);
}

output::Table node_table(const WindowFindings& window) {
  std::vector<Node> nodes;
  for (const Identification& result : window.results) {
    for (std::size_t k = 0; k < result.model.node_rad.size(); ++k) {
      nodes.push_back({.method = window.results.size() > 1 ? Cell{std::string{name(result.method)}} : Cell{},
                       .time_s = window.record.window_begin_s + result.model.node_time_s[k],
                       .disturbance_rad = uncertain(result, k + 2),
                       .interval_rad = result.uncertainty ? Cell{interval_of(result, k + 2)} : Cell{}});
    }
  }
  return output::table({}, nodes, node_fields);
}

output::Table trial_table(const std::string& key, const Identification& result) {
  return output::table(key, result.node_trials, trial_fields);
}

json::Value list(const std::vector<double>& values, const output::Unit& unit) {
  json::Value all = json::Value::array();
  for (const double value : values) {
    all.push_back(output::json_of(unit, value, json_digits));
  }
  return all;
}

std::string key_in(const std::string& place, const std::string& key) { return place.empty() ? key : place + "." + key; }

output::Table model_table(const std::string& key, const model::Record& record, const Identification& result) {
  std::vector<Sample> samples;
  samples.reserve(record.size());
  for (std::size_t i = 0; i < record.size(); ++i) {
    const model::Simulation& simulation = result.simulation;
    samples.push_back({record.window_begin_s + record.time_s[i], record.roll_angle_rad[i], simulation.roll_angle_rad[i],
                       record.roll_rate_rad_s[i], simulation.roll_rate_rad_s[i], simulation.canard_rad[i],
                       result.model.disturbance_rad(record.time_s[i])});
  }
  return output::table(key, samples, sample_fields);
}

std::vector<std::string> stale_models(const std::filesystem::path& folder, const output::Document& document) {
  const std::string header = output::csv(output::table({}, std::vector<Sample>{}, sample_fields));
  const auto is_ours = [&](const std::string& name) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(folder / name, ignored) &&
           text::read_input(folder / name).starts_with(header);
  };
  std::vector<std::string> stale{"model.csv"};
  for (std::size_t i = 1; i < 3 || is_ours(stale.back()); ++i) {
    stale.push_back(fmt::format("model_{}.csv", i));
  }
  std::erase_if(stale, [&](const std::string& name) {
    return !is_ours(name) || std::ranges::any_of(document.spreadsheets, [&](const output::Table& sheet) {
      return *sheet.key + ".csv" == name;
    });
  });
  return stale;
}

std::vector<output::Listed> listed_found() {
  return {output::listed("one result, or results[]", found_fields), output::listed("node_curve[]", trial_fields),
          output::listed("model.csv", sample_fields)};
}

}  // namespace fantail::identify::result
