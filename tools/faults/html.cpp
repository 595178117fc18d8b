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
    case Colour::not_judged:
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
    case Colour::not_judged: return fmt::format("not judged further, {}", cell.flights);
    case Colour::not_applicable: break;
  }
  return "not applicable";
}

std::string matrix(const Result& result, std::string_view device) {
  std::vector<page::Column> columns{{"fault"}};
  std::array<std::size_t, phases> column_of{};  // of the phases that were asked for
  for (std::size_t i = 0; i < phases; ++i) {
    const auto phase = static_cast<Phase>(i);
    if (std::ranges::any_of(result.cells, [phase](const CellResult& cell) { return cell.cell.phase == phase; })) {
      column_of[i] = columns.size();
      columns.push_back({std::string{name(phase)}});
    }
  }
  std::vector<std::vector<page::Cell>> rows;
  const FaultRow* last = nullptr;
  bool is_flown = false;
  for (const CellResult& cell : result.cells) {
    if (cell.cell.row->device != device) {
      continue;
    }
    if (cell.cell.row != last) {
      last = cell.cell.row;
      rows.emplace_back(columns.size());
      rows.back()[0] = {.text = std::string{last->fault}, .below = std::string{last->meaning}};
    }
    is_flown = is_flown || cell.colour != Colour::not_applicable;
    page::Cell& shown = rows.back()[column_of[static_cast<std::size_t>(cell.cell.phase)]];
    shown = {.text = word_of(cell),
             .tone = tone_of(cell.colour),
             .below = cell.colour == Colour::red || cell.colour == Colour::known_limit ? std::string{} : cell.figure};
  }
  if (!rows.empty() && !is_flown) {
    return page::section(device, page::paragraph("Not applicable: this rocket flies without it."));
  }
  return rows.empty() ? "" : page::section(device, page::table(columns, rows));
}

/// Cells of one fault with one limit, which say the same: a row of them all.
std::string not_green(const Result& result) {
  const std::array<page::Column, 2> columns{
      {{"fault, and red flights by phase"}, {"worst flight; why, and what to do"}}};
  std::vector<std::vector<page::Cell>> rows;
  for (const Colour colour : {Colour::red, Colour::known_limit, Colour::limit_without_need}) {
    const CellResult* first = nullptr;
    const CellResult* worst = nullptr;
    for (const CellResult& cell : result.cells) {
      if (cell.colour != colour) {
        continue;
      }
      if (first == nullptr || first->cell.row != cell.cell.row || first->limit != cell.limit) {
        first = worst = &cell;
        rows.push_back({{.text = fmt::format("{} {}", cell.cell.row->device, cell.cell.row->fault),
                         .tone = tone_of(colour),
                         .below = word_of(colour)},
                        {}});
      }
      worst = worst->worst->apart_deg < cell.worst->apart_deg ? &cell : worst;
      rows.back()[0].below += fmt::format("; {}: {} of {}", name(cell.cell.phase), cell.red, cell.flights);
      rows.back()[1] = {
          .text = fmt::format("{} ({}, run {})", worst->figure, name(worst->cell.phase), worst->worst->number),
          .below = cell.limit == nullptr ? "Nobody knows yet."
                                         : fmt::format("Why: {}. To do: {}.", cell.limit->why, what_to_do(cell))};
    }
  }
  return rows.empty() ? page::paragraph("None.") : page::table(columns, rows);
}

std::string worst_flights(const Result& result) {
  std::vector<page::Link> links;
  std::string command;
  for (const std::size_t i : worst_cells(result)) {
    const CellResult& cell = result.cells[i];
    links.push_back({.href = cell.report.empty() ? "" : cell.report + "/report.html",
                     .text = fmt::format("{}, run {}", cell.cell.name(), cell.worst->number),
                     .about = fmt::format(": {}; {}", word_of(cell.colour), cell.figure)});
    command = command.empty() ? run_command(result.campaign, cell.cell, cell.worst->number) : command;
  }
  return page::list(links) +
         page::paragraph(
             "The worst flight of each of the worst faults, with its flight report. Any other again, with "
             "its report, by its cell and run, as here the first of these: " +
             command);
}

/// Faults of one device of which the same is safe, in all phases.
struct SameSafe {
  std::array<std::string, phases> safe{};
  std::string shaft{};
  std::string faults{};
};

std::vector<SameSafe> same_safe(std::string_view device) {
  std::vector<SameSafe> all;
  for (const FaultRow& row : fault_table()) {
    if (row.device != device) {
      continue;
    }
    SameSafe one{.shaft = row.shaft == Shaft::obeys ? "" : row.shaft_sentence(), .faults = std::string{row.fault}};
    for (std::size_t i = 0; i < phases; ++i) {
      one.safe[i] = sentence(row.expected[i]);
    }
    const auto same =
        std::ranges::find_if(all, [&](const SameSafe& it) { return it.safe == one.safe && it.shaft == one.shaft; });
    if (same == all.end()) {
      all.push_back(std::move(one));
    } else {
      same->faults += ", " + one.faults;
    }
  }
  return all;
}

std::string stated(const Result& result) {
  const std::array<page::Column, 3> columns{{{"device, faults"}, {"phase"}, {"safe is"}}};
  std::vector<std::vector<page::Cell>> rows;
  for (const std::string_view device : device_names()) {
    if (std::ranges::none_of(result.cells, [&](const CellResult& cell) { return cell.cell.row->device == device; })) {
      continue;
    }
    for (const SameSafe& group : same_safe(device)) {
      std::string before;
      for (std::size_t i = 0; i < phases; ++i) {
        const std::string phase{name(static_cast<Phase>(i))};
        if (group.safe[i] == before) {
          rows.back()[1].text += ", " + phase;
          continue;
        }
        before = group.safe[i];
        rows.push_back({{}, {.text = phase}, {.text = before}});
        if (i == 0) {
          rows.back()[0] = {.text = std::string{device} + ": " + group.faults, .below = group.shaft};
        }
      }
    }
  }
  return page::table(columns, rows);
}

std::string onsets_of(const Campaign& campaign) {
  const std::string seeds = campaign.seeds == 1 ? fmt::format("seed {}", campaign.seed)
                                                : fmt::format("{} seeds from {}", campaign.seeds, campaign.seed);
  const std::string closer =
      campaign.every == 1
          ? ""
          : fmt::format(", or closer so that there are at least three, but not closer than {} ms", campaign.step_ms);
  return fmt::format("in each phase an onset each {} ms{}; {}", campaign.step_ms * campaign.every, closer, seeds);
}

std::vector<std::string> how() {
  return {
      "A cell is a device, a fault and the phase in which the fault begins. Its flights differ by when it begins and "
      "by the seed.",
      "In every flight no command may go beyond the smallest of plan limit, hard limit and mechanical stop; none may "
      "be off trim in Armed, Launched or Finished; none may move away from trim in Safe after ignition; each tick "
      "comes to its end; and Controlling comes from Launched alone, or from a resumed flight.",
      "The true shafts are held to the same, by the play and the spread of the servos, and with the time that a servo "
      "needs to get there. What the shaft of a failed servo may do is stated with its fault, below; the shafts of the "
      "others are held to all of it.",
      "\"Not judged further\" are flights of which nothing is asked beyond that: where no servo obeys, the air alone "
      "turns the rocket.",
      "Roll is held against the same flight, of the same seed, without the fault: degrees apart are degrees from it.",
      "Judged are the true roll angle, the true canard shafts, the pulses on the servo lines and the phase. What the "
      "avionics believes does not count."};
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
  const bool limit = has_red_limit(result);
  return page::html(
      {.kind = "Fantail campaign of faults",
       .title = result.scenario,
       .subtitle =
           fmt::format("{}, plan {}; {}; Fantail {}", result.vehicle, result.plan, onsets_of(result.campaign), version),
       .tone = result::tone(answer(result)),
       .verdict_heading = red     ? "Red"
                          : limit ? "Known limits"
                                  : "No red cell",
       .verdict = headline(result),
       .findings = {{.what = "Safe",
                     .about = "is here an outcome that was stated beforehand, at the end of the page; control that is "
                              "over is one of "
                              "them, and the rocket then rolls freely. It does not say that nobody is hurt, nor where "
                              "the rocket comes "
                              "down, and all of it is a model on a PC."}},
       .body_html = page::section("The worst flights", worst_flights(result)) +
                    page::section("Not green", not_green(result)) +
                    page::section("Cell by cell",
                                  page::paragraph("What it came to, its number of flights, and its worst flight. "
                                                  "Phases: " +
                                                  phases_text + ".")) +
                    matrices + page::section("How it is judged", page::list(how())) +
                    page::section("What is safe, stated beforehand", stated(result)) +
                    page::section("Again", page::paragraph(command_of(result.campaign)))});
}

}  // namespace fantail::faults
