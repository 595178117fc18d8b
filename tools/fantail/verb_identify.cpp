// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "core/flight_plan.hpp"
#include "core/flight_plan_fields.hpp"
#include "fantail/airframe_options.hpp"
#include "fantail/command_line.hpp"
#include "fantail/interrupt.hpp"
#include "fantail/log_options.hpp"
#include "fantail/run.hpp"
#include "identify/choices.hpp"
#include "identify/make_record.hpp"
#include "identify/result/outputs.hpp"
#include "identify/study.hpp"
#include "input/document.hpp"
#include "input/messages.hpp"
#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "logs/roll_log.hpp"

namespace fantail::tool {
namespace {

/// What a person may say to `fantail identify`, as typed.
struct IdentifyOptions {
  std::string data;
  LogOptions log;

  std::optional<double> from_s;
  std::optional<double> to_s;
  std::vector<std::string> windows;
  double lag_s = 0.0;
  bool fit_lag = false;
  bool fit_initial = false;

  AirframeOptions airframe;
  std::optional<std::string> density;
  std::optional<double> elevation_m;
  std::optional<double> speed_m_s;

  std::string nodes = "even:1";
  std::string method = "continuous";
  std::string loss = "squares";
  std::string grid_alpha;  ///< A:B:STEP, empty: as published
  std::string grid_beta;

  std::string loop = "open";
  std::optional<std::string> plan;
  std::optional<double> proportional_gain;
  std::optional<double> derivative_gain_s;
  std::optional<double> limit_deg;
  double servo_lag_s = 0.0;

  bool json = false;
  std::string out;
};

std::string objection_to_axis(const std::string& text) {
  return identify::parse_axis(text)
             ? ""
             : '"' + text + "\": expected FIRST:LAST:STEP above 0, as in 1:60:1, with at most 1000 values";
}

void add_reading(const Verb& verb, IdentifyOptions& o) {
  verb.option("DATA", o.data, "A CSV file, a flight log (.ftl), or a folder that `fantail fly` wrote").required();
  add_log_options(verb, o.log);
}

void add_windows(const Verb& verb, IdentifyOptions& o) {
  auto from =
      verb.option("--from", o.from_s, "Start of the window on the log's clock, in seconds").check(within(-1e6, 1e6));
  auto to = verb.option("--to", o.to_s, "End of the window, in seconds").check(within(-1e6, 1e6));
  verb.option("--window", o.windows,
              "control, thrust, coast, step:N or A:B in seconds; several, each by itself [control, or all of a log "
              "without phases]")
      .one_word_each_time()
      .excludes(from)
      .excludes(to);
  auto lag = verb.option("--lag", o.lag_s, "Seconds by which the canard column lags the gyro's")
                 .check(within(-1.0, 1.0))
                 .show_default();
  verb.flag("--fit-lag", o.fit_lag, "Find that lag, up to 50 ms either way, with its interval").excludes(lag);
  verb.flag("--fit-initial", o.fit_initial, "Fit the first angle and rate, too, instead of taking them as measured");
}

void add_rocket(const Verb& verb, IdentifyOptions& o) {
  add_airframe_options(verb, o.airframe);
  verb.option("--density", o.density,
              "Air density: kg/m3, exponential or isa [exponential if the log climbs, else 1.2]");
  verb.option("--elevation", o.elevation_m, "Of the site above the sea, for the standard atmosphere")
      .check(within(-500, 9000))
      .value_name("M");
  verb.option("--speed", o.speed_m_s, "In m/s, the same throughout, instead of the log's").check(within(0.1, 1e4));
}

void add_method(const Verb& verb, IdentifyOptions& o) {
  verb.option("--nodes", o.nodes,
              "Of the disturbance: seconds on the log's clock as in 0,5; even:N; thrust:N,coast:M; auto")
      .show_default();
  verb.option("--method", o.method,
              "grid (as published; its intervals include the rounding to the grid), continuous or both")
      .one_of({"grid", "continuous", "both"})
      .show_default();
  verb.option("--loss", o.loss,
              "Of the angle errors: squares, or huber for a log with outliers, on which those have little influence "
              "(continuous method, open loop; fits the first angle and rate, too)")
      .one_of({"squares", "huber"})
      .show_default();
  verb.option("--grid-alpha", o.grid_alpha,
              "FIRST:LAST:STEP in m2 [1:60:1 for an area of 5.03e-5 m2, else in inverse proportion]")
      .check(objection_to_axis);
  verb.option("--grid-beta", o.grid_beta, "FIRST:LAST:STEP in m [5:15:0.5, likewise]").check(objection_to_axis);
  verb.option("--loop", o.loop, "open: canards as measured; closed: as the controller commands in the model")
      .one_of({"open", "closed"})
      .show_default();
  verb.option("--plan", o.plan, "Closed loop: gains and limit of a shipped plan or a path");
  verb.option("--kp", o.proportional_gain, "Closed loop: canard angle per roll angle error").check(within(0, 100));
  verb.option("--kd", o.derivative_gain_s, "Closed loop: canard angle per roll rate, in s").check(within(0, 100));
  verb.option("--limit", o.limit_deg, "Closed loop: canard limit in degrees").check(within(0.01, 90));
  verb.option("--servo-lag", o.servo_lag_s, "Closed loop: first-order lag of the servos in s")
      .check(within(0, 1))
      .show_default();
}

void add_identify_options(const Verb& verb, IdentifyOptions& options) {
  add_reading(verb, options);
  add_windows(verb, options);
  add_rocket(verb, options);
  add_method(verb, options);
  verb.flag("--json", options.json, "Print one JSON object instead of the text");
  verb.option("--out", options.out, "Folder for report.html, model.csv and identification.json [out/identify/DATA]")
      .check(objection_to_folder);
}

logs::RollLog read(const IdentifyOptions& o) {
  return logs::read_roll_log(o.data, reading(o.log), {.canard = o.loop == "open", .speed = !o.speed_m_s});
}

std::vector<identify::Window> windows(const IdentifyOptions& o, const logs::RollLog& log) {
  if (o.from_s || o.to_s) {
    return {{.from_s = o.from_s, .to_s = o.to_s}};
  }
  std::vector<identify::Window> all;
  all.reserve(o.windows.size() + 1);
  for (const std::string& text : o.windows) {
    all.push_back(identify::find_window(log, text));
  }
  if (all.empty()) {
    const bool controlled = std::ranges::find(log.phase, core::Phase::controlling) != log.phase.end();
    all.push_back(controlled ? identify::find_window(log, "control") : identify::Window{.name = "all"});
  }
  return all;
}

identify::closed_loop::Control closed_loop(const IdentifyOptions& o) {
  if (o.fit_lag) {
    throw UsageError{"--fit-lag: the closed loop does not use the measured canards; allowed with --loop open"};
  }
  core::ControllerPlan controller = core::default_plan().controller;
  if (o.plan) {
    controller = input::read_plan(input::Document::load(input::find_input(input::Shipped::plan, *o.plan))).controller;
  } else if (!o.proportional_gain || !o.derivative_gain_s || !o.limit_deg) {
    throw UsageError{"--loop closed needs the controller: --plan NAME|FILE, or --kp, --kd and --limit"};
  }
  if (o.proportional_gain) {
    controller.proportional_gain = static_cast<float>(*o.proportional_gain);
  }
  if (o.derivative_gain_s) {
    controller.derivative_gain_s = static_cast<float>(*o.derivative_gain_s);
  }
  if (o.limit_deg) {
    controller.canard_limit = core::Angle::from_degrees(static_cast<float>(*o.limit_deg));
  }
  return {.controller = controller, .servo_lag_s = o.servo_lag_s};
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

identify::Question question(const IdentifyOptions& o) {
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
    q.options.closed_loop = closed_loop(o);
    q.record.canard_needed = false;
  }
  return q;
}

// "out/identify/tasha3_launch2" for a folder, ".../log" for log.csv.
std::filesystem::path output_folder(const IdentifyOptions& o) {
  if (!o.out.empty()) {
    return o.out;
  }
  std::filesystem::path data = std::filesystem::absolute(o.data).lexically_normal();
  if (!data.has_filename()) {  // it ended in a slash
    data = data.parent_path();
  }
  const bool is_file = data.extension() == ".csv" || data.extension() == ".ftl";
  return std::filesystem::path{"out"} / "identify" / (is_file ? data.stem() : data.filename());
}

void identify_data(const IdentifyOptions& o) {
  identify::Question q = question(o);
  const NamedAirframe rocket = named_airframe(o.airframe, o.data);
  q.airframe = rocket.airframe;
  const identify::model::Grid published = identify::model::published_grid(q.airframe);
  q.options.grid.alpha_m2 = identify::parse_axis(o.grid_alpha).value_or(published.alpha_m2);
  q.options.grid.beta_m = identify::parse_axis(o.grid_beta).value_or(published.beta_m);
  const logs::RollLog log = read(o);
  if (o.log.save_map) {
    save_column_map(o.log.map, o.data, "--columns");
  }
  const identify::Air air = identify::choose_air(log, o.density, o.elevation_m);
  q.record.atmosphere = air.atmosphere;
  q.record.site_elevation_m = o.elevation_m.value_or(0.0);
  q.windows = windows(o, log);
  identify::result::Study result = study(log, q);
  result.vehicle = fmt::format("{}, I {} kg m2, A {} m2", rocket.name, input::about(rocket.airframe.inertia_kg_m2),
                               input::about(rocket.airframe.reference_area_m2));
  if (o.windows.empty() && log.phase.empty() && !o.from_s && !o.to_s) {
    result.warnings.emplace_back(
        "The log has no phases, so the window is the whole log, with what came before and after control.");
  }
  result.warnings.insert(result.warnings.end(), rocket.warnings.begin(), rocket.warnings.end());
  result.density = air.description;
  result.speed = o.speed_m_s   ? input::plain_number(*o.speed_m_s) + " m/s throughout"
                 : o.log.truth ? "true_speed_m_s"
                               : "speed_m_s";

  give_up_if_interrupted();
  const std::filesystem::path folder = output_folder(o);
  write_study(result, folder);
  if (o.json) {
    fmt::print("{}", as_json(result));
    return;
  }
  fmt::print("{}\n  report  {}\n", as_text(result), (folder / "report.html").string());
  for (const std::string& name : model_csv_names(result)) {
    fmt::print("  model   {}\n", (folder / name).string());
  }
}

void fill(const Verb& verb) {
  auto options = std::make_shared<IdentifyOptions>();
  add_identify_options(verb, *options);
  verb.examples(
      "Examples:\n"
      "  fantail identify out/tasha3_launch2 --method both\n"
      "                                          a simulated flight: the published grid beside the search without one\n"
      "  fantail identify run7.csv --columns time=t:ms,roll_rate=p:rad/s,canard=fin:deg --save-columns --speed 22\n"
      "      --inertia 0.00393 --area 5.0265e-5 --elevation 1400 --window 0:5 --window 5:10\n"
      "                                          another logger's tunnel run, two steps of it, each by itself\n"
      "  fantail identify out/tasha3_launch1 --nodes thrust:2,coast:2 --loop closed\n"
      "      --plan tasha3_launch1 --json        canards as the controller commands them, for a script");
  verb.action([options] { identify_data(*options); });
}

}  // namespace
}  // namespace fantail::tool

int main(int argc, char** argv) { return fantail::tool::run("identify", fantail::tool::fill, argc, argv); }
