// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "campaign/setup.hpp"
#include "faults/results.hpp"
#include "flight/model_end.hpp"
#include "json/value.hpp"
#include "text/quoting.hpp"

namespace fantail::faults {
namespace {

namespace u = result::units;

constexpr result::Unit deg{"_deg", "deg"};  // as it is stored

template <Colour colour>
result::Cell cells_of(const Result& result) {
  return std::uint64_t{count(result, colour)};
}

constexpr auto result_fields = result::fields<Result>({
    {"flights", "flights", u::none, 0, &Result::flights, "flights with a fault"},
    {"green", "safe", u::none, 0, cells_of<Colour::green>, "cells that are safe in every flight"},
    {"red", "red", u::none, 0, cells_of<Colour::red>, "cells that are not safe and that no known limit explains"},
    {"known_limits", "known limits", u::none, 0, cells_of<Colour::known_limit>,
     "cells that are not safe because of a known limit"},
    {"limits_without_need", "limits not needed", u::none, 0, cells_of<Colour::limit_without_need>,
     "cells that are safe, though a limit is listed"},
    {"not_judged", "not judged", u::none, 0, cells_of<Colour::not_judged>,
     "cells that are checked only against the rules for every flight"},
    {"not_applicable", "not applicable", u::none, 0, cells_of<Colour::not_applicable>,
     "cells that do not apply to this rocket"},
});

using C = CellResult;
constexpr auto cell_fields = result::fields<C>({
    {"cell", "cell", u::none, 0, [](const C& c) { return result::Cell{c.cell.name()}; },
     "device, fault and phase, as --cell takes them"},
    {"device", "device", u::none, 0, [](const C& c) { return result::Cell{std::string{c.cell.row->device}}; },
     "the device that fails"},
    {"fault", "fault", u::none, 0, [](const C& c) { return result::Cell{std::string{c.cell.row->fault}}; },
     "how it fails"},
    {"phase", "phase", u::none, 0, [](const C& c) { return result::Cell{std::string{name(c.cell.phase)}}; },
     "phase in which the fault begins"},
    {"safe", "safe outcome", u::none, 0, [](const C& c) { return result::Cell{c.cell.safe()}; },
     "what counts as safe, stated beforehand"},
    {"result", "result", u::none, 0, [](const C& c) { return result::Cell{std::string{name(c.colour)}}; },
     "verdict on the cell"},
    {"flights", "flights", u::none, 0, &C::flights, "number of flights"},
    {"red", "red flights", u::none, 0, &C::red, "flights that are not safe"},
});

constexpr auto run_fields = result::fields<Run>({
    {"run", "run", u::none, 0, &Run::number, "number of the run in its cell"},
    {"begin", "fault begins", u::s, 3, [](const Run& r) { return result::Cell{1e-3 * r.begin_ms}; },
     "when the fault begins, after ignition"},
    {"apart", "roll difference", deg, 1, &Run::apart_deg,
     "largest difference from the roll of the same flight without the fault"},
    {"trim_after", "commands at trim after", u::s, 3, &Run::trim_after_s,
     "time from the start of the fault to the last command off trim; 0: none"},
    {"stands_after", "canards at trim after", u::s, 3, &Run::stands_after_s,
     "time from the start of the fault until the last working shaft was at trim"},
});

constexpr auto alone_fields = result::fields<Alone>({
    {"cell", "cell", u::none, 0, [](const Alone& a) { return result::Cell{a.judged.cell.name()}; },
     "device, fault and phase"},
    {"safe", "safe outcome", u::none, 0, [](const Alone& a) { return result::Cell{a.judged.cell.safe()}; },
     "what counts as safe, stated beforehand"},
    {"result", "result", u::none, 0, [](const Alone& a) { return result::Cell{std::string{name(a.judged.colour)}}; },
     "verdict on the run"},
    {"was", "outcome", u::none, 0, [](const Alone& a) { return result::Cell{a.findings.what_it_was()}; },
     "what happened"},
});

json::Value limit_of(const CellResult& cell) { return {{"why", cell.limit->why}, {"what_to_do", what_to_do(cell)}}; }

json::Value json_of_cell(const CellResult& result, const Campaign& campaign) {
  json::Value value = result::json_of(result, cell_fields);
  if (result.worst) {
    json::Value counts{};
    for (unsigned bit = 0; bit < outcomes; ++bit) {
      const auto outcome = static_cast<Outcome>(1U << bit);
      if (result.cell.expected().allows(outcome)) {
        counts[name(outcome)] = result.counts[bit];
      }
    }
    value["outcomes"] = counts;
    json::Value& worst = value["worst"] = result::json_of(*result.worst, run_fields);
    worst["seed"] = result.worst->seed;
    worst["what"] = result.figure;
    worst["command"] = run_command(campaign, result.cell, result.worst->number);
    json::keep_exact(worst, "seed");
  }
  if (!result.report.empty()) {
    value["worst"]["report"] = result.report + "/report.html";
  }
  if (result.limit != nullptr) {
    value["limit"] = limit_of(result);
  }
  return value;
}

std::string onsets_of(const Campaign& campaign) {
  const std::string seeds = campaign.seeds == 1 ? fmt::format("seed {}", campaign.seed)
                                                : fmt::format("{} seeds from {}", campaign.seeds, campaign.seed);
  const std::string closer =
      campaign.every == 1
          ? ""
          : fmt::format(", or closer together to give at least three, but not closer than {} ms", campaign.step_ms);
  return fmt::format("in each phase one onset every {} ms{}; {}", campaign.step_ms * campaign.every, closer, seeds);
}

std::string meaning_of_phases() {
  std::string all = "Each cell shows its verdict, its number of flights and its worst flight. Phases: ";
  for (std::size_t i = 0; i < phases; ++i) {
    const auto phase = static_cast<Phase>(i);
    all += fmt::format("{}{}: {}", i == 0 ? "" : "; ", name(phase), meaning(phase));
  }
  return all + ".";
}

std::vector<std::string> how() {
  return {
      // NOLINT(bugprone-suspicious-missing-comma): sentences that go on in the next line
      "A cell is a device, a fault and the phase in which the fault begins. Its flights differ in the start of the "
      "fault and in the seed.",
      "These rules hold for every flight. No command exceeds the smallest of plan limit, hard limit and mechanical "
      "stop. No command is off trim in Armed, Launched, Dormant or Finished. No command moves away from trim in Safe "
      "after ignition. Every tick completes. Controlling follows only Launched or Dormant, or a resumed flight.",
      "The same rules hold for the true shaft angles, with allowance for the play, spread and travel time of the "
      "servos. The permitted angles of a failed servo's shaft are stated with its fault, below. All other shafts must "
      "keep every rule.",
      "\"Not judged further\" means that only these rules are checked: where no servo obeys, the air alone turns the "
      "rocket.",
      "Roll is compared with the same flight, with the same seed, without the fault. Degrees off are the difference "
      "between the two; with controller.entry = \"capture\" without whole turns.",
      "The verdict uses the true roll angle, the true shaft angles, the pulses on the servo lines and the phase. "
      "Estimates of the avionics are not used."};
}

std::vector<result::Section> sections(const Result& result) {
  using enum result::Readers;
  json::Value cells = json::Value::array();
  for (const CellResult& cell : result.cells) {
    cells.push_back(json_of_cell(cell, result.campaign));
  }
  const result::Table open = not_green(result);
  std::vector<result::Block> worst{worst_flights(result)};
  if (const std::vector<std::size_t> first = worst_cells(result); !first.empty()) {
    const CellResult& cell = result.cells[first.front()];
    worst.emplace_back(
        "The worst flight of each of the worst faults, with its flight report. To fly any run again, give its cell and "
        "run; for the first of these: " +
        run_command(result.campaign, cell.cell, cell.worst->number));
  }
  std::vector<result::Section> list{
      {"Every cell",
       {result::Drawing{map_svg(result, page::full_page), map_svg(result, page::half_page),
                        "A cell is a fault and the phase in which it begins."}},
       files},
      {"The worst flights", worst},
      {"Not green", open.rows.empty() ? std::vector<result::Block>{"None."} : std::vector<result::Block>{open}},
      {"Reasons and remedies", {reasons(result)}, files},
      {"Cell by cell", {meaning_of_phases()}, files}};
  for (const std::string_view device : device_names()) {
    list.push_back({std::string{device}, matrix(result, device), files});
  }
  list.push_back({.heading = "How it is judged",
                  .blocks = {result::Sentences{.all = how()}},
                  .readers = files,
                  .folded = "The rules for every flight"});
  list.push_back({"Safe outcomes, stated beforehand", {stated(result)}, files});
  list.push_back({"Repeat", {command_of(result.campaign)}});
  list.push_back(
      {"For programs", {result::figures("", result, result_fields), result::Data{"cells", cells}}, programs});
  return list;
}

}  // namespace

std::vector<result::Listed> listed_fields() {
  return {result::listed("", result_fields), result::listed("cells[]", cell_fields),
          result::listed("cells[].worst; with --cell in the object itself", run_fields),
          result::listed("with --cell", alone_fields)};
}

result::Document answer(const Result& result, const result::Made& made) {
  return {.kind = "fault campaign",
          .title = result.scenario,
          .subtitle = fmt::format("{}, plan {}; {}", result.vehicle, result.plan, onsets_of(result.campaign)),
          .verdict =
              {.answer = answer_of(result),
               .heading = has_red(result)                ? "Red"
                          : has_red_limit(result)        ? "Known limits"
                          : !result.beyond_model.empty() ? "Outside the model"
                                                         : "No red cell",
               .sentence = headline(result),
               .not_in_it = {"An outcome that was stated beforehand; the page lists them at its end. In some of them "
                             "control has ended and the rocket rolls freely. With capture, the roll is not compared in "
                             "the first 1.2 s of control. A safe cell does not rule out injury, and it does not "
                             "cover where the rocket lands. All results come from a model on a PC."},
               .not_in_it_heading = "Safe means here:"},
          .facts = {{"scenario", "", result.scenario},
                    {"vehicle", "", result.vehicle},
                    {"plan", "", result.plan},
                    {"outside_model", "", json::text_or_null(result.beyond_model)},
                    {"version", "", made.version},
                    {"command", "", command_of(result.campaign)}},
          .sections = sections(result),
          .made = made};
}

result::Document answer(const Campaign& campaign, const Alone& alone, const std::string& report,
                        const result::Made& made) {
  const CellResult& judged = alone.judged;
  const bool safe_outside_model = judged.colour == Colour::green && !alone.beyond_model.empty();
  result::Figures run = result::figures("", alone.run, run_fields);
  std::vector<result::Block> limit;
  if (judged.colour == Colour::known_limit) {
    limit = {fmt::format("Why: {}.", judged.limit->why), fmt::format("To do: {}.", what_to_do(judged)),
             result::Data{"limit", limit_of(judged)}};
  }
  return {.title = judged.cell.name(),
          .subtitle = fmt::format("run {}", alone.run.number),
          .verdict = {.answer = safe_outside_model ? result::Answer::undecided : answer_of(judged.colour),
                      .heading = safe_outside_model ? "Outside the model" : word_of(judged.colour),
                      .sentence = flight::outside_model(alone.beyond_model) + alone.findings.what_it_was()},
          .facts = {{"version", "", made.version},
                    {"scenario", "", alone.scenario.name},
                    {"seed", "", alone.run.seed},
                    {"command", "", run_command(campaign, judged.cell, alone.run.number)},
                    {"report", "report", report}},
          .sections = {{"Safe outcome", {judged.cell.safe()}},
                       {"This run", {run}},
                       {"A known limit", limit},
                       {"For programs", {result::figures("", alone, alone_fields)}, result::Readers::programs}},
          .made = made};
}

}  // namespace fantail::faults
