// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "faults/results.hpp"
#include "page/page.hpp"

// The page: a matrix of device and fault against phase. Every colour is a word, too.
namespace fantail::faults {
namespace {

page::Tone tone_of(Colour colour) {
  switch (colour) {
    case Colour::green: return page::Tone::good;
    case Colour::red: return page::Tone::bad;
    case Colour::known_limit:
    case Colour::limit_without_need: return page::Tone::unsure;
    case Colour::not_applicable: break;
  }
  return page::Tone::plain;
}

std::string word_of(const CellResult& cell) {
  switch (cell.colour) {
    case Colour::green: return fmt::format("safe, {}", cell.flights);
    case Colour::red: return fmt::format("RED, {} of {}", cell.red, cell.flights);
    case Colour::known_limit: return fmt::format("limit, {} of {}", cell.red, cell.flights);
    case Colour::limit_without_need: return fmt::format("safe, {}; a limit is listed", cell.flights);
    case Colour::not_applicable: break;
  }
  return "not applicable";
}

std::string matrix(const Result& result, std::string_view device) {
  std::vector<page::Column> columns{{"fault"}};
  for (std::size_t i = 0; i < phases; ++i) {
    columns.push_back({std::string{name(static_cast<Phase>(i))}});
  }
  std::vector<std::vector<page::Cell>> rows;
  const FaultRow* last = nullptr;
  for (const CellResult& cell : result.cells) {
    if (cell.cell.row->device != device) {
      continue;
    }
    if (cell.cell.row != last) {
      last = cell.cell.row;
      rows.emplace_back(columns.size());
      rows.back()[0] = {.text = std::string{last->fault}, .below = std::string{last->meaning}};
    }
    page::Cell& shown = rows.back()[1 + static_cast<std::size_t>(cell.cell.phase)];
    shown = {.text = word_of(cell),
             .tone = tone_of(cell.colour),
             .below = cell.colour == Colour::red || cell.colour == Colour::known_limit ? std::string{} : cell.figure};
  }
  return rows.empty() ? "" : page::section(device, page::table(columns, rows));
}

std::string not_green(const Result& result) {
  const std::array<page::Column, 3> columns{{{"cell"}, {"worst flight, and what is safe"}, {"why, and what to do"}}};
  const CellResult* last = nullptr;
  std::vector<std::vector<page::Cell>> rows;
  for (const CellResult& cell : result.cells) {
    if (cell.colour == Colour::green || cell.colour == Colour::not_applicable) {
      continue;
    }
    last = &cell;
    rows.push_back({{.text = cell.cell.name(),
                     .tone = tone_of(cell.colour),
                     .below = fmt::format("{}; run {}, from {:.2f} s after ignition on, seed {}", word_of(cell),
                                          cell.worst->number, 1e-3 * cell.worst->begin_ms, cell.worst->seed)},
                    {.text = cell.figure, .below = fmt::format("safe is: {}", sentence(cell.cell.expected()))},
                    {.text = cell.limit != nullptr ? std::string{cell.limit->why} : "nobody knows yet",
                     .below = cell.limit != nullptr ? std::string{cell.limit->what_to_do} : ""}});
  }
  return last == nullptr
             ? page::paragraph("None.")
             : page::table(columns, rows) +
                   page::paragraph(fmt::format("Any run again, with its flight report, such as the last of these: {}",
                                               run_command(result.campaign, last->cell, last->worst->number)));
}

std::string stated() {
  const std::array<page::Column, 3> columns{{{"device, fault"}, {"phase"}, {"safe is"}}};
  std::vector<std::vector<page::Cell>> rows;
  for (const FaultRow& row : fault_table()) {
    std::string before;
    for (std::size_t i = 0; i < phases; ++i) {
      const auto phase = static_cast<Phase>(i);
      const std::string safe = sentence(row.expect(phase));
      if (safe == before) {
        rows.back()[1].text += ", " + std::string{name(phase)};
        continue;
      }
      rows.push_back({{.text = i == 0 ? fmt::format("{}, {}", row.device, row.fault) : ""},
                      {.text = std::string{name(phase)}},
                      {.text = safe}});
      before = safe;
    }
  }
  return page::table(columns, rows);
}

std::vector<std::string> how() {
  return {
      "A cell is a device, a fault and the phase in which the fault begins. Its flights differ by when it begins and "
      "by the seed.",
      "In every flight no command may go beyond the smallest of plan limit, hard limit and mechanical stop; none may "
      "be off "
      "trim in Armed, Launched or Finished; none may move away from trim in Safe after ignition; each tick comes to "
      "its end; and "
      "Controlling comes from Launched alone, or from a resumed flight.",
      "Roll is held against the same flight, of the same seed, without the fault: degrees apart are degrees from it.",
      "Judged are the true roll angle, the pulses on the servo lines and the phase. What the avionics believes does "
      "not count."};
}

}  // namespace

std::string report_html(const Result& result, const std::string& version) {
  std::string matrices;
  for (const std::string_view device : device_names()) {
    matrices += matrix(result, device);
  }
  std::string phases_text;
  for (std::size_t i = 0; i < phases; ++i) {
    const auto phase = static_cast<Phase>(i);
    phases_text += fmt::format("{}{}: {}", i == 0 ? "" : "; ", name(phase), meaning(phase));
  }
  const bool red = has_red(result);
  return page::html(
      {.kind = "Fantail campaign of faults",
       .title = result.scenario,
       .subtitle = fmt::format("{}, plan {}; onsets {} ms apart, each {}th, {} seed(s) from {}; Fantail {}",
                               result.vehicle, result.plan, result.campaign.step_ms, result.campaign.every,
                               result.campaign.seeds, result.campaign.seed, version),
       .tone = red ? page::Tone::bad : page::Tone::good,
       .verdict_heading = red ? "Red" : "No red cell",
       .verdict = headline(result),
       .body_html = page::section("Not green", not_green(result)) +
                    page::paragraph("Below: what a cell came to, with its number of flights, and its worst flight. "
                                    "Phases: " +
                                    phases_text + ".") +
                    matrices + page::section("How it is judged", page::list(how())) +
                    page::section("What is safe, stated beforehand", stated()) +
                    page::section("Again", page::paragraph(command_of(result.campaign)))});
}

}  // namespace fantail::faults
