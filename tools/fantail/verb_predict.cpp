// SPDX-License-Identifier: MIT
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "campaign/spread.hpp"
#include "fantail/deliver.hpp"
#include "fantail/many_flights.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "fantail/terminal.hpp"
#include "input/shipped.hpp"
#include "predict/answer.hpp"
#include "predict/assumed_fins.hpp"
#include "report/results.hpp"
#include "stability/margins_asked.hpp"
#include "text/error.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

constexpr double most_runs = 100000;
constexpr std::size_t usual_runs = 200;

struct PredictOptions {
  ScenarioOptions scenario{.scenario = "tasha3_launch2", .seed = {}, .changes = {}};
  std::optional<std::string> tunnel;
  std::optional<double> swirl_deg;
  std::string damping_factor = "1:1";
  std::optional<std::size_t> runs;
  unsigned threads = 0;
  std::optional<double> servo_lag_s;
  std::optional<double> servo_delay_s;
  double authority_percent = 95.0;
  double held_percent = 90.0;
  double phase_margin_deg = stability::least_phase_margin_deg;
  std::string out;
  bool other_vehicle = false;
  std::optional<std::size_t> run;
  bool json = false;
};

std::optional<predict::DampingFactor> parse_damping_factor(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::optional<double> low = text::number(text.substr(0, colon));
  const std::optional<double> high = colon == std::string_view::npos ? low : text::number(text.substr(colon + 1));
  if (!low || !high || !(*low >= 0.1) || !(*high >= *low) || !(*high <= 10.0)) {
    return std::nullopt;
  }
  return predict::DampingFactor{.low = *low, .high = *high};
}

std::string objection_to_damping_factor(const std::string& text) {
  return parse_damping_factor(text) ? ""
                                    : '"' + text + "\" is not a range; allowed: LOW:HIGH, 0.1 to 10, for example 1:1.6";
}

/// Empty: the fins are not measured yet.
std::optional<std::filesystem::path> tunnel_file(const sim::Scenario& scenario, const PredictOptions& options) {
  return options.tunnel           ? input::find_input(input::Shipped::tunnel_result, *options.tunnel)
         : scenario.tunnel_result ? std::optional<std::filesystem::path>{*scenario.tunnel_result}
                                  : std::nullopt;
}

std::vector<std::filesystem::path> inputs_of(const sim::Scenario& scenario, const PredictOptions& options) {
  std::vector<std::filesystem::path> files = files_of(options.scenario);
  if (const auto tunnel = tunnel_file(scenario, options)) {
    files.push_back(*tunnel);
  }
  return files;
}

std::optional<double> in_radians(const std::optional<double>& degrees) {
  return degrees ? std::optional{text::radians(*degrees)} : std::nullopt;
}

predict::Options prediction_options(const PredictOptions& options) {
  return {.runs = options.runs.value_or(usual_runs),
          .threads = options.threads,
          .damping = *parse_damping_factor(options.damping_factor),
          .other_vehicle = options.other_vehicle,
          .servo_lag_s = options.servo_lag_s,
          .servo_delay_s = options.servo_delay_s,
          .request = {.changes = changes_of(options.scenario),
                      .command = command_of(options.scenario),
                      .not_drawn = predict::fields_not_drawn(
                          campaign::read_spreads(input::ScenarioFiles::load(options.scenario.scenario)))}};
}

predict::Prediction fly_the_spread(const sim::Scenario& scenario, const predict::TunnelResult& tunnel,
                                   predict::Options asked, const runs::Place& place, const runs::Folder& kept) {
  Progress progress{"predicting " + scenario.name,
                    {.unit = "runs", .rate = " a second", .total = static_cast<double>(asked.runs)}};
  asked.kept = &kept;
  return predict::predict(scenario, tunnel, asked, [&](std::size_t done) {
    leave_if_interrupted(place.folder, place.parts);
    progress.show(static_cast<double>(done));
  });
}

/// Flies what may help before it is said; how many flights that takes is known afterwards.
predict::Decision decided(const predict::Prediction& prediction, const PredictOptions& options,
                          const runs::Place& place) {
  Progress progress{"trying changes that may help " + prediction.scenario,
                    {.unit = "flights", .rate = " a second", .total = {}}};
  double flights = 0.0;
  return predict::decide(prediction,
                         {.authority_share = 0.01 * options.authority_percent,
                          .held_share = 0.01 * options.held_percent,
                          .phase_margin_rad = text::radians(options.phase_margin_deg)},
                         [&] {
                           leave_if_interrupted(place.folder, place.parts);
                           progress.show(++flights);
                         });
}

/// One run alone, with the report that `fantail fly` writes of a flight.
void fly_one_run(const sim::Scenario& scenario, const predict::TunnelResult& tunnel, const PredictOptions& options,
                 const predict::Options& asked, const std::filesystem::path& folder) {
  const predict::RepeatedRun repeated = predict::repeat_run(scenario, tunnel, asked, *options.run);
  const std::vector<std::filesystem::path> inputs = inputs_of(scenario, options);
  const report::Results results =
      report::results(repeated.flight, made_with(inputs, repeated.flight.seed, asked.request.changes));
  report::write_results(repeated.flight, results, folder, inputs);
  deliver(results.document,
          {.json = options.json,
           .last_line = fmt::format("  report   {}", text::printable((folder / "report.html").string()))});
}

/// Without a tunnel result: what the fins may be.
void predict_with_assumed_fins(const sim::Scenario& scenario, const PredictOptions& options) {
  for (const auto& [name, is_given] : std::initializer_list<std::pair<std::string_view, bool>>{
           {"--swirl", options.swirl_deg.has_value()},
           {"--other-vehicle", options.other_vehicle},
           {"--damping-factor", options.damping_factor != PredictOptions{}.damping_factor},
           {"--runs", options.runs.has_value()},
           {"--run", options.run.has_value()},
           {"--authority-percent", options.authority_percent != PredictOptions{}.authority_percent},
           {"--held-percent", options.held_percent != PredictOptions{}.held_percent}}) {
    if (is_given) {
      throw UsageError{
          fmt::format("{}: needs --tunnel FILE, the steps.csv of fantail tunnel steps, as {} names no tunnel_result",
                      name, scenario.name)};
    }
  }
  predict::Options asked = prediction_options(options);
  const std::filesystem::path folder = results_folder(options.out, "predict", scenario.name, asked.request.changes);
  const std::vector<std::filesystem::path> inputs = inputs_of(scenario, options);
  const runs::Place place = place_of_flights("predict", asked.request.command, folder, inputs);
  const runs::Folder kept{place};
  asked.kept = &kept;
  const result::Made made = made_with(inputs, scenario.seed, asked.request.changes);
  Progress progress{"predicting " + scenario.name + " with assumed fins",
                    {.unit = "flights", .rate = " a second", .total = static_cast<double>(predict::assumed_flights())}};
  const predict::AssumedFins assumed =
      predict::assume_fins(scenario, asked, text::radians(options.phase_margin_deg), [&](std::size_t done) {
        leave_if_interrupted(place.folder, place.parts);
        progress.show(static_cast<double>(done));
      });
  deliver(predict::answer(assumed, made), {.folder = folder,
                                           .name = "predict",
                                           .inputs = inputs,
                                           .removed = {"band.csv"},
                                           .json = options.json,
                                           .yes_is_required = true,
                                           .shown_files = {"page", "runs"},
                                           .when_written = [&kept] { kept.remove(); }});
}

void predict_launch(const PredictOptions& options) {
  if (options.run && options.runs && *options.run >= *options.runs) {
    throw UsageError{
        fmt::format("--run {}: with --runs {} the last row is {}", *options.run, *options.runs, *options.runs - 1)};
  }
  const sim::Scenario scenario = load(options.scenario);
  predict::require_launch(scenario);
  const auto measured = tunnel_file(scenario, options);
  if (!measured) {
    predict_with_assumed_fins(scenario, options);
    return;
  }
  const predict::TunnelResult tunnel = predict::read_tunnel_result(*measured, in_radians(options.swirl_deg));
  const predict::Options question = prediction_options(options);
  const std::filesystem::path folder = results_folder(options.out, "predict", scenario.name, question.request.changes);
  if (options.run) {
    const std::string run = options.out.empty() ? fmt::format("run_{}", *options.run) : "";
    fly_one_run(scenario, tunnel, options, question, folder / run);
    return;
  }
  const std::vector<std::filesystem::path> inputs = inputs_of(scenario, options);
  const runs::Place place = place_of_flights("predict", question.request.command, folder, inputs);
  const runs::Folder kept{place};
  const result::Made made = made_with(inputs, scenario.seed, question.request.changes);
  const predict::Prediction prediction = fly_the_spread(scenario, tunnel, question, place, kept);
  const predict::Decision decision = decided(prediction, options, place);
  deliver(predict::answer(prediction, decision, made), {.folder = folder,
                                                        .name = "predict",
                                                        .inputs = inputs,
                                                        .json = options.json,
                                                        .yes_is_required = true,
                                                        .shown_files = {"page", "runs"},
                                                        .when_written = [&kept] { kept.remove(); }});
}

void add_thresholds(const Verb& verb, PredictOptions& options) {
  verb.option("--authority-percent", options.authority_percent,
              "Share of the runs in which the canards must balance the fin offset")
      .range(0.0, 99.9)
      .show_default()
      .changes_result();
  verb.option("--held-percent", options.held_percent, "Share of the runs that must hold their roll")
      .range(0.0, 99.9)
      .show_default()
      .changes_result();
  verb.option("--phase-margin", options.phase_margin_deg,
              "Phase margin in degrees that 95 % of the runs must have at the worst speed flown")
      .range(0.0, 90.0)
      .value_name("DEG")
      .show_default()
      .changes_result();
}

void fill(const Verb& verb) {
  auto options = std::make_shared<PredictOptions>();
  add_scenario_options(verb, options->scenario);
  verb.section("Tunnel results and servos");
  verb.option("--tunnel", options->tunnel,
              "steps.csv of fantail tunnel steps, or a shipped name [tunnel_result of the scenario; without it the "
              "fins are "
              "assumed]")
      .offers(shipped(input::Shipped::tunnel_result))
      .value_name("FILE")
      .changes_result();
  verb.flag("--other-vehicle", options->other_vehicle, "Accept tunnel results of a vehicle other than the scenario's")
      .belongs_to_command();
  verb.option(
          "--swirl", options->swirl_deg,
          "Swirl of the tunnel as a fin offset in degrees, which is subtracted; 0: no swirl. The sign is that of "
          "fantail tunnel swirl: above zero it rolls the rocket clockwise, seen from the tail. [column swirl_deg of "
          "the file; required without that column]")
      .range(-45.0, 45.0)
      .value_name("DEG")
      .changes_result();
  verb.option("--damping-factor", options->damping_factor,
              "LOW:HIGH, damping in flight over damping in the tunnel, drawn from a uniform distribution")
      .check(objection_to_damping_factor)
      .value_name("RANGE")
      .show_default()
      .changes_result();
  verb.option("--servo-lag", options->servo_lag_s, "Measured first-order lag of the servos in seconds [vehicle's]")
      .range(0.0005, 1.0)
      .value_name("S")
      .changes_result();
  verb.option("--servo-delay", options->servo_delay_s,
              "Measured dead time from command to canard in seconds, without the lag [vehicle's, with the pulse frame]")
      .range(0.0, 0.05)
      .value_name("S")
      .changes_result();
  verb.section("Runs");
  verb.option("--runs", options->runs, "How many airframes to fly [200]").range(1.0, most_runs);
  add_threads_option(verb, options->threads);
  verb.section("Requirements for a go");
  add_thresholds(verb, *options);
  verb.section("Results");
  verb.option("--run", options->run, "Fly only this row of runs.csv, counted from 0, and write its flight report")
      .range(0.0, most_runs - 1.0)
      .value_name("NUMBER");
  verb.option("--out", options->out,
              "Folder for predict.html, predict.json, runs.csv, band.csv [out/predict/SCENARIO, with the changes in "
              "the name]")
      .offers(folders);
  verb.flag("--json", options->json, "Print predict.json instead of the text");
  verb.examples(
      "To resume an interrupted prediction, give the same command again.\n"
      "Exit code 0: go; 1: no go, or it depends on fins that are not measured.\n"
      "Examples:\n"
      "  fantail predict tasha3_launch1                      the launch that failed: no go, and why\n"
      "  fantail predict tasha3_launch2 --damping-factor 1:1.6 --runs 1000\n"
      "                                                      damping that the tunnel may underestimate\n"
      "  fantail predict my_rocket.toml --tunnel out/tunnel/steps/steps.csv --swirl -2 --servo-lag 0.018 --json\n"
      "                                                      your own rocket, after its tunnel and bench tests\n"
      "  fantail predict tasha3_launch2 --run 17             row 17 again, with its flight report");
  verb.action([options] { predict_launch(*options); });
}

const VerbCode code{"predict", fill};

}  // namespace
}  // namespace fantail::tool
