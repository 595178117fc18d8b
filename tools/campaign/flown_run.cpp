// SPDX-License-Identifier: MIT
#include "campaign/flown_run.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "campaign/criteria.hpp"
#include "flight/table.hpp"
#include "fly/fly_scenario.hpp"
#include "report/results.hpp"
#include "report/running_figures.hpp"
#include "runs/runner.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"
#include "text/sha256.hpp"

namespace fantail::campaign {
namespace {

void take_figures(FlownRun& flown, const JudgedFlight& judged) {
  const report::Figures& figures = judged.figures;
  flown.outcome = report::name(judged.verdict.outcome);
  flown.failed_by = failed_criteria(judged);
  if (judged.verdict.begun_on_guide_s) {
    flown.note = fmt::format("{}{} s before the rocket left the launch guide", begun_on_guide_note,
                             text::fixed(*judged.verdict.begun_on_guide_s, 3));
  }
  flown.figures = {text::in_degrees(figures.largest_hold_error_rad),
                   figures.saturated_fraction,
                   text::in_degrees(figures.authority_margin_rad),
                   figures.control_time_s,
                   figures.control_start_height_m,
                   figures.max_speed_m_s,
                   figures.apogee_m,
                   text::in_degrees(figures.rest_error_rad),
                   figures.ended_before_apogee_s,
                   {},
                   {},
                   {},
                   {},
                   {},
                   judged.flight.extremes.top_mach,
                   judged.flight.extremes.static_margin_calibres,
                   text::in_degrees(judged.flight.extremes.angle_of_attack_rad)};
  if (judged.opening && judged.flight.plan.dormancy.until != core::DormantUntil::guide) {
    const dormancy::Opening& gate = *judged.opening;
    const std::array<std::optional<double>, 5> of_gate{gate.time_s, gate.height_m, text::degrees(gate.rate_rad_s),
                                                       text::degrees(gate.angle_rad), gate.captured_after_s};
    std::ranges::copy(of_gate, flown.figures.begin() + gate_time_column);
  }
  for (std::size_t i = 0; i < flown.figures.size(); ++i) {
    if (flown.figures[i] && !std::isfinite(*flown.figures[i])) {
      flown.outcome = "not_finite";
      flown.failed_by = {flown.outcome};
      flown.note += fmt::format("{}{} is not a number", flown.note.empty() ? "" : "; ", figure_columns[i]);
      flown.figures[i].reset();
    }
  }
}

[[noreturn]] void refuse(const flight::Table& table, std::size_t row, const std::string& complaint) {
  throw text::Error{text::ErrorKind::bad_data, table.where(row) + ": " + complaint};
}

std::uint64_t whole(const flight::Table& table, std::size_t row, std::size_t column) {
  const auto value = text::whole_number(table.cell(row, column));
  if (!value) {
    refuse(table, row,
           table.columns()[column] + " = " + flight::in_quotes(table.cell(row, column)) + " is not a whole number");
  }
  return *value;
}

double number(const flight::Table& table, std::size_t row, std::size_t column) {
  const auto value = table.number(row, column);
  if (!value) {
    refuse(table, row,
           table.columns()[column] + " = " + flight::in_quotes(table.cell(row, column)) + " is not a number");
  }
  return *value;
}

/// Eight digits that a person who edits a row does not make by chance.
std::string check_of(std::string_view row) { return text::sha256(std::as_bytes(std::span{row})).substr(0, 8); }

/// Of a run: a flight report's, or "refused" or "not_finite".
bool is_outcome(std::string_view word) {
  return word == "refused" || word == "not_finite" ||
         std::ranges::any_of(report::outcomes,
                             [word](report::Outcome outcome) { return report::name(outcome) == word; });
}

/// Words with spaces between them.
std::vector<std::string> criteria_in(const flight::Table& table, std::size_t row, std::size_t column) {
  std::vector<std::string> all;
  std::istringstream words{std::string{table.cell(row, column)}};
  for (std::string word; words >> word;) {
    if (find_criterion(word) == nullptr) {
      refuse(table, row, "failed_by = " + flight::in_quotes(word) + " is not a criterion");
    }
    all.push_back(word);
  }
  return all;
}

}  // namespace

JudgedFlight fly_and_judge(const sim::Scenario& scenario, const fly::TakeRow& take) {
  const bool tunnel = scenario.surroundings != sim::Surroundings::flight;
  report::RunningFigures running{tunnel};
  dormancy::OpeningWatch opening{tunnel};
  JudgedFlight judged;
  judged.flight = fly::fly_without_rows(scenario, [&](const flight::Row& row, const flight::Flight& so_far) {
    running.add(row, so_far);
    opening.add(row, so_far);
    if (take) {
      take(row, so_far);
    }
  });
  judged.figures = running.figures(judged.flight, judged.flight.clock);
  judged.verdict = report::verdict(judged.flight, judged.figures);
  judged.opening = opening.found(judged.flight.clock);
  return judged;
}

void write_flight(const sim::Scenario& scenario, std::vector<std::string> changes, std::string note,
                  const std::filesystem::path& folder) {
  flight::Flight flight = fly::fly_scenario(scenario, {}, {}, fly::Log::kept);
  flight.changes = std::move(changes);
  flight.notes.insert(flight.notes.begin(), std::move(note));
  report::write_results(flight, report::results(flight), folder);
}

flight::Extremes extremes_of(const FlownRun& run) {
  flight::Extremes extremes{.top_mach = run.figures[top_mach_column],
                            .static_margin_calibres = run.figures[top_mach_column + 1]};
  if (const auto& attack_deg = run.figures[top_mach_column + 2]) {
    extremes.angle_of_attack_rad = text::radians(*attack_deg);
  }
  return extremes;
}

FlownRun fly_run(input::ScenarioFiles& files, const Drawer& drawer, std::uint64_t master_seed, std::uint64_t run) {
  FlownRun flown = fly_drawn(files, drawer.draw(run), runs::seed_of_run(master_seed, run));
  flown.run = run;
  return flown;
}

FlownRun fly_drawn(input::ScenarioFiles& files, Draw draw, std::uint64_t seed, const LookAtFlight& look) {
  FlownRun flown{.seed = seed, .numbers = std::move(draw.numbers), .drawn_again = draw.drawn_again};
  sim::Scenario scenario;
  try {
    for (const input::Override& change : draw.changes) {
      files.apply(change);
    }
    scenario = files.read();
  } catch (const text::Error& error) {
    flown.outcome = "refused";
    flown.failed_by = {flown.outcome};
    flown.note = error.what();
    return flown;
  }
  scenario.seed = flown.seed;
  scenario.changed_values = draw.changes.size();
  const JudgedFlight judged = fly_and_judge(scenario);
  take_figures(flown, judged);
  if (look) {
    look(scenario, flown, judged);
  }
  return flown;
}

std::vector<std::string> quantity_names(const std::vector<Spread>& spreads) {
  std::vector<std::string> names;
  for (const Spread& spread : spreads) {
    const char* effect = spread.effect == Effect::factor ? "_factor" : spread.effect == Effect::offset ? "_offset" : "";
    for (const input::NumberField& field : spread.fields) {
      names.push_back(field.name() + effect);
    }
  }
  return names;
}

std::string header_row(const std::vector<Spread>& spreads) {
  std::string text = "run,seed";
  for (const std::string& name : quantity_names(spreads)) {
    text += ',' + name;
  }
  text += ",drawn_again,outcome";
  for (const std::string_view column : figure_columns) {
    text += fmt::format(",{}", column);
  }
  return text + ",failed_by,note,row_check\n";
}

std::string csv_row(const FlownRun& run) {
  std::string text = fmt::format("{},{}", run.run, run.seed);
  for (const double number : run.numbers) {
    text += fmt::format(",{}", number);
  }
  text += fmt::format(",{},{}", run.drawn_again, run.outcome);
  for (const auto& figure : run.figures) {
    text += figure ? fmt::format(",{}", *figure) : ",";
  }
  text += fmt::format(",{},{}", fmt::join(run.failed_by, " "), text::csv_cell(run.note));
  return text + ',' + check_of(text) + '\n';
}

std::optional<std::uint64_t> edited_row(std::string_view rows) {
  for (std::uint64_t place = 0; !rows.empty(); ++place) {
    const std::string_view row = rows.substr(0, rows.find('\n'));
    const std::size_t last = row.rfind(',');
    if (last == std::string_view::npos || check_of(row.substr(0, last)) != row.substr(last + 1)) {
      return place;
    }
    rows.remove_prefix(std::min(rows.size(), row.size() + 1));
  }
  return {};
}

std::vector<FlownRun> read_rows(const std::string& rows, const std::vector<Spread>& spreads, const std::string& name) {
  const flight::Table table = flight::Table::parse(header_row(spreads) + rows, name);
  const std::size_t again = table.column("drawn_again");
  std::vector<FlownRun> all;
  all.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    FlownRun run{.run = whole(table, row, 0), .seed = whole(table, row, 1)};
    for (std::size_t column = 2; column < again; ++column) {
      run.numbers.push_back(number(table, row, column));
    }
    run.drawn_again = whole(table, row, again);
    run.outcome = table.cell(row, again + 1);
    if (!is_outcome(run.outcome)) {
      refuse(table, row, "outcome = " + flight::in_quotes(run.outcome) + " is not an outcome");
    }
    for (std::size_t i = 0; i < run.figures.size(); ++i) {
      const std::size_t column = again + 2 + i;
      run.figures[i] = table.cell(row, column).empty() ? std::nullopt : std::optional{number(table, row, column)};
    }
    run.failed_by = criteria_in(table, row, again + 2 + run.figures.size());
    run.note = table.cell(row, again + 3 + run.figures.size());
    all.push_back(std::move(run));
  }
  return all;
}

}  // namespace fantail::campaign
