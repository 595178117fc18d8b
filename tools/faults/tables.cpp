// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "faults/results.hpp"

// What the results are shown in: a matrix of fault against phase for each device, and lists. Every colour is a word,
// too.
namespace fantail::faults {
namespace {

using result::Judged;

result::Column words(const std::string& label) { return {.key = label, .label = label, .absent = ""}; }

/// The matrix is plain where nothing more is asked.
result::Answer mark_of(Colour colour) {
  return colour == Colour::not_judged ? result::Answer::none : answer_of(colour);
}

bool is_not_green(const CellResult& cell) {
  return cell.colour == Colour::red || cell.colour == Colour::known_limit || cell.colour == Colour::limit_without_need;
}

std::string with_flights(const CellResult& cell) {
  switch (cell.colour) {
    case Colour::green: return fmt::format("safe, {}", cell.flights);
    case Colour::red: return fmt::format("RED, {} of {}", cell.red, cell.flights);
    case Colour::known_limit: return fmt::format("limit, {} of {}", cell.red, cell.flights);
    case Colour::limit_without_need: return fmt::format("safe, {}; a limit is listed", cell.flights);
    case Colour::not_judged: return fmt::format("not judged further, {}", cell.flights);
    case Colour::not_applicable: break;
  }
  return cell.is_reached ? "not applicable" : "never happened: phase not reached";
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

}  // namespace

std::vector<result::Block> matrix(const Result& result, std::string_view device) {
  result::Table table{.columns = {words("fault")}};
  std::array<std::size_t, phases> column_of{};  // of the phases that were asked for
  for (std::size_t i = 0; i < phases; ++i) {
    const auto phase = static_cast<Phase>(i);
    if (std::ranges::any_of(result.cells, [phase](const CellResult& cell) { return cell.cell.phase == phase; })) {
      column_of[i] = table.columns.size();
      table.columns.push_back(words(std::string{name(phase)}));
    }
  }
  const FaultRow* last = nullptr;
  bool is_flown = false;
  for (const CellResult& cell : result.cells) {
    if (cell.cell.row->device != device) {
      continue;
    }
    if (cell.cell.row != last) {
      last = cell.cell.row;
      table.rows.emplace_back(table.columns.size(), Judged{});
      table.rows.back()[0] = Judged{.words = std::string{last->fault}, .below = std::string{last->meaning}};
    }
    is_flown = is_flown || cell.colour != Colour::not_applicable || !cell.is_reached;
    table.rows.back()[column_of[static_cast<std::size_t>(cell.cell.phase)]] =
        Judged{mark_of(cell.colour), with_flights(cell),
               cell.colour == Colour::red || cell.colour == Colour::known_limit ? "" : cell.figure};
  }
  if (!table.rows.empty() && !is_flown) {
    return {"Not applicable: this rocket flies without it."};
  }
  return {table};
}

result::Table not_green(const Result& result) {
  result::Table table{
      .columns = {words("result"), words("cell"), words("red flights"), words("run"), words("worst flight")}};
  for (const Colour colour : {Colour::red, Colour::known_limit, Colour::limit_without_need}) {
    for (const CellResult& cell : result.cells) {
      if (cell.colour == colour) {
        table.rows.push_back({Judged{mark_of(colour), word_of(colour)}, cell.cell.name(),
                              fmt::format("{} of {}", cell.red, cell.flights), cell.worst->number, cell.figure});
      }
    }
  }
  return table;
}

result::Table reasons(const Result& result) {
  result::Table table{.columns = {words("fault"), words("why"), words("to do")}};
  const CellResult* last = nullptr;
  for (const CellResult& cell : result.cells) {
    if (!is_not_green(cell)) {
      continue;
    }
    const std::string phase{name(cell.cell.phase)};
    if (last != nullptr && last->cell.row == cell.cell.row && last->limit == cell.limit &&
        last->of_rocket == cell.of_rocket) {
      std::get<Judged>(table.rows.back()[0]).below += ", " + phase;
      continue;
    }
    last = &cell;
    const std::string fault = fmt::format("{} {}", cell.cell.row->device, cell.cell.row->fault);
    table.rows.push_back(
        {Judged{mark_of(cell.colour), fault, phase},
         cell.limit == nullptr ? "Not among the known limits of Fantail." : std::string{cell.limit->why},
         cell.limit == nullptr ? fmt::format("Read the flight report of its worst run: {}",
                                             run_command(result.campaign, cell.cell, cell.worst->number))
                               : what_to_do(cell)});
  }
  return table;
}

result::Table stated(const Result& result) {
  result::Table table{.columns = {words("device, faults"), words("phase"), words("safe outcome")}};
  for (const std::string_view device : device_names()) {
    if (std::ranges::none_of(result.cells, [&](const CellResult& cell) { return cell.cell.row->device == device; })) {
      continue;
    }
    for (const SameSafe& group : same_safe(device)) {
      std::string before;
      std::string* phase_words = nullptr;
      for (std::size_t i = 0; i < phases; ++i) {
        const std::string phase{name(static_cast<Phase>(i))};
        if (group.safe[i] == before) {
          *phase_words += ", " + phase;
          continue;
        }
        before = group.safe[i];
        table.rows.push_back(
            {i == 0 ? Judged{.words = std::string{device} + ": " + group.faults, .below = group.shaft} : Judged{},
             phase, before});
        phase_words = &std::get<std::string>(table.rows.back()[1]);
      }
    }
  }
  return table;
}

result::Links worst_flights(const Result& result) {
  result::Links links;
  for (const std::size_t i : worst_cells(result)) {
    const CellResult& cell = result.cells[i];
    links.all.push_back({.href = cell.report.empty() ? "" : cell.report + "/report.html",
                         .text = fmt::format("{}, run {}", cell.cell.name(), cell.worst->number),
                         .about = fmt::format(": {}; {}", word_of(cell.colour), cell.figure)});
  }
  return links;
}

}  // namespace fantail::faults
