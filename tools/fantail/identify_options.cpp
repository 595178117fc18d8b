// SPDX-License-Identifier: MIT
#include "fantail/identify_options.hpp"

#include "core/flight_plan_fields.hpp"
#include "fantail/offers.hpp"
#include "identify/choices.hpp"
#include "input/document.hpp"
#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "logs/flight_file.hpp"

namespace fantail::tool {
namespace {

std::string objection_to_axis(const std::string& text) {
  return identify::parse_axis(text)
             ? ""
             : '"' + text + "\": expected FIRST:LAST:STEP above 0, as in 1:60:1, with at most 1000 values";
}

void add_reading(const Verb& verb, IdentifyOptions& o) {
  verb.option("DATA", o.data,
              "A CSV, MAT or Parquet file, a flight log (.ftl), or a folder that `fantail fly` wrote; several with "
              "--shared")
      .offers(files)
      .required();
  auto shared = verb.option("--shared", o.shared,
                            "alpha,beta: one pair for all logs and windows; disturbance and start are fitted for each")
                    .one_of({"alpha,beta"});
  verb.option("--validate", o.validate,
              "Check an earlier identification with this log: its alpha and beta are kept, the disturbance is fitted "
              "[into out/validate/DATA]")
      .offers(files)
      .value_name("FOLDER|FILE")
      .excludes(shared);
  verb.section("Columns of the log");
  add_log_options(verb, o.log);
}

void add_windows(const Verb& verb, IdentifyOptions& o) {
  verb.section("Window and timing");
  auto from = verb.option("--from", o.from_s, "Start of the window on the log's clock, in seconds")
                  .check(within(-1e6, 1e6))
                  .value_name("S");
  auto to = verb.option("--to", o.to_s, "End of the window, in seconds").check(within(-1e6, 1e6)).value_name("S");
  verb.option("--window", o.windows,
              "control, thrust, coast, step:N or A:B in seconds; repeat it for several [control, or the whole log if "
              "it has no phases]")
      .one_word_each_time()
      .offers(
          [](std::string_view /*begun*/) { return manual::Offer{.words = {"control", "thrust", "coast", "step:"}}; })
      .excludes(from)
      .excludes(to);
  auto lag = verb.option("--lag", o.lag_s, "Seconds by which the canard column lags the gyro's")
                 .check(within(-1.0, 1.0))
                 .value_name("S")
                 .show_default();
  verb.flag("--fit-lag", o.fit_lag, "Fit that lag, up to 50 ms either way, with its interval").excludes(lag);
  verb.flag("--fit-initial", o.fit_initial, "Fit the first angle and rate, too, instead of using the measured ones");
}

void add_rocket(const Verb& verb, IdentifyOptions& o) {
  verb.section("Rocket and air");
  add_airframe_options(verb, o.airframe);
  verb.option("--density", o.density,
              "Air density: kg/m3, exponential or isa [exponential if the log climbs, else 1.2]");
  verb.option("--elevation", o.elevation_m, "Height of the site above sea level, for the standard atmosphere")
      .check(within(-500, 9000))
      .value_name("M");
  verb.option("--speed", o.speed_m_s, "Constant speed in m/s, instead of the log's")
      .check(within(0.1, 1e4))
      .value_name("M/S");
}

void add_method(const Verb& verb, IdentifyOptions& o) {
  verb.section("Method");
  verb.option("--nodes", o.nodes,
              "Nodes of the disturbance: seconds on the log's clock as in 0,5; even:N; thrust:N,coast:M; auto")
      .show_default();
  verb.option("--method", o.method,
              "grid (as published; its intervals include the rounding to the grid), continuous or both")
      .one_of({"grid", "continuous", "both"})
      .show_default();
  verb.option("--loss", o.loss,
              "Weight of angle errors: squares; huber for a log with outliers. huber needs the continuous method and "
              "the open loop, and also fits the first angle and rate")
      .one_of({"squares", "huber"})
      .show_default();
  verb.option("--grid-alpha", o.grid_alpha,
              "FIRST:LAST:STEP in m2 [1:60:1 for an area of 5.03e-5 m2, else in inverse proportion]")
      .check(objection_to_axis);
  verb.option("--grid-beta", o.grid_beta, "FIRST:LAST:STEP in m [5:15:0.5, likewise]").check(objection_to_axis);
  verb.section("Closed loop");
  verb.option("--loop", o.loop, "open: canards as measured; closed: as commanded by the controller in the model")
      .one_of({"open", "closed"})
      .show_default();
  verb.option("--plan", o.plan,
              "Closed loop: plan with gains, schedule and limit; a shipped name or a path [the plan in the flight log, "
              "if DATA is or contains one]")
      .offers(shipped(input::Shipped::plan));
  verb.option("--kp", o.proportional_gain, "Closed loop: canard angle per roll angle error").check(within(0, 100));
  verb.option("--kd", o.derivative_gain_s, "Closed loop: canard angle per roll rate, in s")
      .check(within(0, 100))
      .value_name("S");
  verb.option("--limit", o.limit_deg, "Closed loop: canard limit in degrees").check(within(0.01, 90)).value_name("DEG");
  verb.option("--servo-lag", o.servo_lag_s,
              "Closed loop: first guess of the servo lag in s; lag and play are fitted [0.02]")
      .check(within(0, 0.5))
      .value_name("S");
}

core::FlightPlan plan_of(const IdentifyOptions& o, const std::string& data) {
  if (o.plan) {
    return input::read_plan(input::Document::load(input::find_input(input::Shipped::plan, *o.plan)));
  }
  if (!wants_flown_plan(o)) {
    return core::default_plan();
  }
  const std::optional<core::FlightPlan> flown = logs::flown_plan(data, reading(o.log));
  if (!flown) {
    throw UsageError{
        "--loop closed needs the controller: --plan NAME|FILE; or --kp, --kd and --limit; or a flight log (.ftl), "
        "which contains the plan that flew"};
  }
  return *flown;
}

constexpr double usual_servo_lag_s = 0.02;

identify::closed_loop::Control closed_loop(const IdentifyOptions& o, const std::string& data) {
  if (o.fit_lag) {
    throw UsageError{"--fit-lag: the closed loop does not use the measured canards; allowed with --loop open"};
  }
  const core::FlightPlan plan = plan_of(o, data);
  core::ControllerPlan controller = plan.controller;
  if (o.proportional_gain) {
    controller.proportional_gain = static_cast<float>(*o.proportional_gain);
  }
  if (o.derivative_gain_s) {
    controller.derivative_gain_s = static_cast<float>(*o.derivative_gain_s);
  }
  if (o.limit_deg) {
    controller.canard_limit = core::Angle::from_degrees(static_cast<float>(*o.limit_deg));
  }
  return {.controller = controller,
          .gain_schedule = plan.gain_schedule,
          .offset_rejection = plan.offset.rejection,
          .servo_lag_s = o.servo_lag_s.value_or(usual_servo_lag_s),
          .servo_is_fitted = true};
}

void use_huber_loss(const IdentifyOptions& o, identify::Options& options) {
  if (o.method != "continuous" || o.loop != "open" || o.fit_lag) {
    throw UsageError{
        "--loss huber: allowed with --method continuous and --loop open, and without --fit-lag (find the lag first, "
        "then give it with --lag)"};
  }
  options.loss = identify::model::Loss::huber;
  options.start = identify::model::Start::fitted;
}

}  // namespace

void add_identify_options(const Verb& verb, IdentifyOptions& options) {
  add_reading(verb, options);
  add_windows(verb, options);
  add_rocket(verb, options);
  add_method(verb, options);
  verb.section("Results");
  verb.flag("--json", options.json, "Print one JSON object instead of the text");
  verb.option("--out", options.out,
              "Folder for report.html, model.csv and identification.json [out/identify/DATA, with "
              "several A+B]")
      .offers(folders);
}

bool wants_flown_plan(const IdentifyOptions& o) {
  return o.loop == "closed" && !o.plan && (!o.proportional_gain || !o.derivative_gain_s || !o.limit_deg);
}

identify::Question question(const IdentifyOptions& o, const std::string& data) {
  using identify::result::Method;
  identify::Question q;
  q.nodes = o.nodes;
  q.fit_lag = o.fit_lag;
  q.methods = o.method == "both"   ? std::vector{Method::grid, Method::continuous}
              : o.method == "grid" ? std::vector{Method::grid}
                                   : std::vector{Method::continuous};
  q.record.lag_s = o.lag_s;
  q.record.speed_m_s = o.speed_m_s;
  q.options.start = o.fit_initial ? identify::model::Start::fitted : identify::model::Start::measured;
  if (o.loss == "huber") {
    use_huber_loss(o, q.options);
  }
  if (o.loop == "closed") {
    q.options.closed_loop = closed_loop(o, data);
    q.told_servo_lag_s = o.servo_lag_s;
    q.record.canard_needed = false;
  }
  return q;
}

}  // namespace fantail::tool
