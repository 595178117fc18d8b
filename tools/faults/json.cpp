// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "campaign/setup.hpp"
#include "faults/results.hpp"
#include "json/value.hpp"
#include "text/quoting.hpp"

// The results for scripts and for the terminal.
namespace fantail::faults {
namespace {

std::string options_of(const Campaign& campaign) {
  const Campaign usual;
  std::string words;
  for (const input::Override& change : campaign.changes) {
    words += " --set " + text::shell_word(campaign::lines_of({change}));
  }
  words += fmt::format(" --seed {}", campaign.seed);
  const auto add = [&words](const char* option, int value, int usually) {
    words += value == usually ? std::string{} : fmt::format(" {} {}", option, value);
  };
  add("--step-ms", campaign.step_ms, usual.step_ms);
  add("--every", campaign.every, usual.every);
  add("--seeds", static_cast<int>(campaign.seeds), static_cast<int>(usual.seeds));
  return words;
}

json::Value json_of(const CellResult& result, const Campaign& campaign) {
  json::Value counts{};
  for (unsigned bit = 0; bit < outcomes; ++bit) {
    const auto outcome = static_cast<Outcome>(1U << bit);
    if (result.cell.expected().allows(outcome)) {
      counts[name(outcome)] = result.counts[bit];
    }
  }
  json::Value value{{"cell", result.cell.name()},      {"device", result.cell.row->device},
                    {"fault", result.cell.row->fault}, {"phase", name(result.cell.phase)},
                    {"safe", result.cell.safe()},      {"result", name(result.colour)},
                    {"flights", result.flights},       {"red", result.red}};
  if (result.worst) {
    value["outcomes"] = counts;
    value["worst"] = {{"run", result.worst->number},
                      {"begin_s", json::rounded(1e-3 * result.worst->begin_ms)},
                      {"seed", result.worst->seed},
                      {"apart_deg", result.worst->apart_deg},
                      {"trim_after_s", json::rounded(result.worst->trim_after_s)},
                      {"stands_after_s", json::rounded(result.worst->stands_after_s)},
                      {"what", result.figure},
                      {"command", run_command(campaign, result.cell, result.worst->number)}};
    json::keep_exact(value["worst"], "seed");
  }
  if (!result.report.empty()) {
    value["worst"]["report"] = result.report + "/report.html";
  }
  if (result.limit != nullptr) {
    value["limit"] = {{"why", result.limit->why}, {"what_to_do", what_to_do(result)}};
  }
  return value;
}

/// ", at worst servo/dead/controlling (control went on, 12.3 deg apart)": the flight that is farthest off.
std::string worst_of(const Result& result, Colour colour) {
  const CellResult* worst = nullptr;
  for (const CellResult& cell : result.cells) {
    if (cell.colour == colour && (worst == nullptr || worst->worst->apart_deg < cell.worst->apart_deg)) {
      worst = &cell;
    }
  }
  return worst == nullptr
             ? ""
             : fmt::format(", at worst {} ({})", worst->cell.name(), worst->figure.substr(0, worst->figure.find(';')));
}

std::size_t count(const Result& result, Colour colour) {
  return static_cast<std::size_t>(std::ranges::count(result.cells, colour, &CellResult::colour));
}

}  // namespace

const char* word_of(Colour colour) {
  switch (colour) {
    case Colour::red: return "RED";
    case Colour::known_limit: return "a known limit";
    case Colour::limit_without_need: return "safe, though a limit is listed";
    case Colour::not_judged: return "not judged further";
    case Colour::green:
    case Colour::not_applicable: break;
  }
  return "safe";
}

bool has_red(const Result& result) { return count(result, Colour::red) > 0; }

bool has_red_limit(const Result& result) { return count(result, Colour::known_limit) > 0; }

std::string what_to_do(const CellResult& cell) {
  return fmt::format("{}{}{}", cell.limit->what_to_do, cell.of_rocket.empty() ? "" : ". ", cell.of_rocket);
}

std::string headline(const Result& result) {
  const std::size_t flown = result.cells.size() - count(result, Colour::not_applicable);
  const std::size_t red = count(result, Colour::red);
  const std::size_t limits = count(result, Colour::known_limit);
  const std::size_t without_need = count(result, Colour::limit_without_need);
  const std::size_t not_judged = count(result, Colour::not_judged);
  const std::size_t safe = flown - red - limits - without_need - not_judged;
  const auto line = [](std::string_view what, std::size_t number, const std::string& more = {}) {
    return number == 0 ? std::string{} : fmt::format(" {}: {} cell{}{}.", what, number, number == 1 ? "" : "s", more);
  };
  return fmt::format("{} flights in {} cells.{}{}{}{}{}{}", result.flights, flown, red == 0 ? " No cell is RED." : "",
                     line("RED", red, worst_of(result, Colour::red)),
                     line("Not safe, for a limit that is known", limits, worst_of(result, Colour::known_limit)),
                     line("Not judged beyond what holds for every flight", not_judged),
                     line("Safe, though a limit is listed", without_need), line("Safe in every flight", safe));
}

std::string command_of(const Campaign& campaign) {
  std::string words = "fantail campaign faults " + text::shell_word(campaign.scenario) + options_of(campaign);
  const auto add = [&words](const char* option, const std::string& value) {
    words += value.empty() ? std::string{} : fmt::format(" {} {}", option, value);
  };
  add("--device", campaign.device);
  add("--fault", campaign.fault);
  add("--phase", campaign.phase);
  return words;
}

std::string run_command(const Campaign& campaign, const Cell& cell, std::uint64_t number) {
  return fmt::format("fantail campaign faults {}{} --cell {} --run {}", text::shell_word(campaign.scenario),
                     options_of(campaign), cell.name(), number);
}

result::Answer answer(const Result& result) {
  return has_red(result) ? result::Answer::no : has_red_limit(result) ? result::Answer::undecided : result::Answer::yes;
}

result::Answer answer(Colour colour) {
  switch (colour) {
    case Colour::green: return result::Answer::yes;
    case Colour::red: return result::Answer::no;
    case Colour::not_applicable: return result::Answer::none;
    default: return result::Answer::undecided;
  }
}

std::string report_json(const Result& result, const std::string& version, const result::Made& made) {
  json::Value cells = json::Value::array();
  for (const CellResult& cell : result.cells) {
    cells.push_back(json_of(cell, result.campaign));
  }
  json::Value all{{"version", version},
                  {"scenario", result.scenario},
                  {"vehicle", result.vehicle},
                  {"plan", result.plan},
                  {"command", command_of(result.campaign)},
                  {"flights", result.flights},
                  {"green", count(result, Colour::green)},
                  {"red", count(result, Colour::red)},
                  {"known_limits", count(result, Colour::known_limit)},
                  {"limits_without_need", count(result, Colour::limit_without_need)},
                  {"not_judged", count(result, Colour::not_judged)},
                  {"not_applicable", count(result, Colour::not_applicable)},
                  {"cells", cells}};
  result::put_answer(all, answer(result), headline(result), made);
  return all.pretty();
}

std::string run_text(const Alone& alone, const std::string& report) {
  const CellResult& judged = alone.judged;
  std::string text = fmt::format("{}, run {}: {}\n  safe is: {}\n  it was:  {}\n", judged.cell.name(), alone.run.number,
                                 word_of(judged.colour), judged.cell.safe(), alone.findings.what_it_was());
  if (judged.colour == Colour::known_limit) {
    text += fmt::format("  why:     {}\n  to do:   {}\n", judged.limit->why, what_to_do(judged));
  }
  return text + fmt::format("  report   {}\n", report);
}

std::string run_json(const Campaign& campaign, const Alone& alone, const std::string& report,
                     const std::string& version, const result::Made& made) {
  const CellResult& judged = alone.judged;
  json::Value value{{"version", version},
                    {"scenario", alone.scenario.name},
                    {"cell", judged.cell.name()},
                    {"run", alone.run.number},
                    {"begin_s", json::rounded(1e-3 * alone.run.begin_ms)},
                    {"seed", alone.run.seed},
                    {"safe", judged.cell.safe()},
                    {"result", name(judged.colour)},
                    {"was", alone.findings.what_it_was()},
                    {"apart_deg", alone.run.apart_deg},
                    {"trim_after_s", json::rounded(alone.run.trim_after_s)},
                    {"stands_after_s", json::rounded(alone.run.stands_after_s)},
                    {"command", run_command(campaign, judged.cell, alone.run.number)},
                    {"report", report}};
  if (judged.colour == Colour::known_limit) {
    value["limit"] = {{"why", judged.limit->why}, {"what_to_do", what_to_do(judged)}};
  }
  json::keep_exact(value, "seed");
  result::put_answer(value, answer(judged.colour), alone.findings.what_it_was(), made);
  return value.pretty();
}

std::string report_text(const Result& result) {
  std::string text = headline(result) + "\n";
  for (const CellResult& cell : result.cells) {
    if (cell.colour == Colour::red || cell.colour == Colour::known_limit || cell.colour == Colour::limit_without_need) {
      text += fmt::format("  {:13} {:36} {} of {} flights; worst, run {}: {}\n",
                          cell.colour == Colour::red           ? "RED"
                          : cell.colour == Colour::known_limit ? "known limit"
                                                               : "limit, green",
                          cell.cell.name(), cell.red, cell.flights, cell.worst->number, cell.figure);
    }
  }
  return text;
}

}  // namespace fantail::faults
