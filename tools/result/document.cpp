// SPDX-License-Identifier: MIT
#include "result/document.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/core.h>

#include "result/parts.hpp"
#include "text/number.hpp"

namespace fantail::result {
namespace {

template <typename List>
auto& with_key(List& list, std::string_view key) {
  const auto found = std::ranges::find(list, key, &Column::key);
  if (found == list.end()) {
    throw std::logic_error{fmt::format("a document has no {}", key)};
  }
  return *found;
}

double number(const Column& column, const Cell& cell) {
  const auto* spread = std::get_if<Spread>(&cell);
  const auto* estimate = std::get_if<Estimate>(&cell);
  const auto* uncertain = std::get_if<Uncertain>(&cell);
  const auto* value = spread != nullptr      ? &spread->p50
                      : estimate != nullptr  ? &estimate->value
                      : uncertain != nullptr ? &uncertain->value
                                             : std::get_if<double>(&cell);
  return value != nullptr ? column.unit.shown_per_si * *value : std::numeric_limits<double>::quiet_NaN();
}

std::string axis(const Column& column) {
  return column.unit.symbol.empty() ? column.label : fmt::format("{} / {}", column.label, column.unit.symbol);
}

page::Series& curve(page::Chart& chart, const std::string& name) {
  constexpr page::Role roles[] = {page::Role::measured, page::Role::model, page::Role::second_model};
  const auto found = std::ranges::find(chart.series, name, &page::Series::name);
  if (found != chart.series.end()) {
    return *found;
  }
  return chart.series.emplace_back(page::Series{.name = name, .role = roles[chart.series.size() % std::size(roles)]});
}

// Two digits of a deviation; at most four decimals, and of a number that is smaller than that five digits.
int decimals_of(double deviation, double value) {
  constexpr int most_decimals = 4;  // no sensor tells more of a number of usual size
  const int most = std::max(most_decimals, decimals_for(value, most_decimals + 1));
  return deviation > 0.0 ? std::clamp(decimals_for(deviation, 2), 0, most) : most;
}

std::string shown_range(const Unit& unit, const Range& range) {
  const double low = unit.shown_per_si * range.low.value_or(0.0);
  const double high = unit.shown_per_si * range.high.value_or(0.0);
  const double deviation = range.low && range.high ? 0.25 * (high - low) : 0.05 * std::abs(low + high);
  const int places = decimals_of(deviation, std::max(std::abs(low), std::abs(high)));
  if (range.low && range.high) {
    return fmt::format("{} to {}", text::fixed(low, places), text::fixed(high, places));
  }
  return range.low    ? "above " + text::fixed(low, places)
         : range.high ? "below " + text::fixed(high, places)
                      : "without bounds";
}

}  // namespace

int decimals_for(double value, int digits) {
  return value == 0.0 || !std::isfinite(value) ? digits - 1
                                               : digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
}

bool is_worse(const Cell& one, const Cell& than, Worse worse) {
  const bool is_known = !std::holds_alternative<std::monostate>(one);
  return worse == Worse::larger    ? one > than  // the unknown is less than everything
         : worse == Worse::smaller ? is_known && (one < than || std::holds_alternative<std::monostate>(than))
                                   : false;
}

std::string sentence_of(const Column& column) {
  std::string text = fmt::format("{}: {}.", column.label, column.meaning);
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

std::string ends(const Column& column, const Spread& spread) {
  return fmt::format("{} to {}", shown(column, spread.p5), shown(column, spread.p95));
}

std::string shown(const Column& column, const Cell& cell) {
  if (const auto* words = std::get_if<std::string>(&cell)) {
    return *words;
  }
  if (const auto* digits = std::get_if<Digits>(&cell)) {
    return digits->text;
  }
  if (const auto* estimate = std::get_if<Estimate>(&cell)) {
    return fmt::format("{} ± {}", shown(column, estimate->value), shown(column, estimate->reach));
  }
  if (const auto* uncertain = std::get_if<Uncertain>(&cell)) {
    const double deviation = column.unit.shown_per_si * uncertain->deviation;
    const int places = decimals_of(deviation, number(column, cell));
    return text::fixed(number(column, cell), places) +
           (deviation > 0.0 ? " \u00b1 " + text::fixed(deviation, places) : "");
  }
  if (const auto* range = std::get_if<Range>(&cell)) {
    return shown_range(column.unit, *range);
  }
  if (const auto* count = std::get_if<std::uint64_t>(&cell)) {
    return fmt::format("{}", *count);
  }
  if (const auto* spread = std::get_if<Spread>(&cell)) {
    return fmt::format("{} ({})", shown(column, spread->p50), ends(column, *spread));
  }
  if (const auto* share = std::get_if<Share>(&cell)) {
    return fmt::format("{} ({} of {})", shown(column, share->value), share->count, share->of);
  }
  if (const auto* judged = std::get_if<Judged>(&cell)) {
    return judged->words;
  }
  if (const auto* named = std::get_if<Named>(&cell)) {
    return named->name;
  }
  if (const auto* is = std::get_if<bool>(&cell)) {
    return *is ? "yes" : "no";
  }
  const double value = number(column, cell);
  return std::holds_alternative<std::monostate>(cell) ? column.absent
         : column.words != nullptr                    ? column.words(value)
                                                      : text::fixed(value, column.decimals);
}

Picture Picture::wide() && {
  chart.width = page::full_page;
  return std::move(*this);
}

Figure& Figures::operator[](std::string_view figure_key) { return with_key(all, figure_key); }

std::size_t Table::column(std::string_view column_key) const {
  return static_cast<std::size_t>(&with_key(columns, column_key) - columns.data());
}

Table numbered(Table table, std::string key) {
  table.columns.insert(table.columns.begin(), Column{.key = key, .label = key});
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    table.rows[i].insert(table.rows[i].begin(), Cell{std::uint64_t{i}});
  }
  return table;
}

Table only(const Table& table, const std::vector<std::string_view>& keys) {
  Table some{.columns = {}, .rows = std::vector<std::vector<Cell>>(table.rows.size()), .read_every = table.read_every};
  for (const std::string_view key : keys) {
    const std::size_t from = table.column(key);
    some.columns.push_back(table.columns[from]);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      some.rows[i].push_back(table.rows[i][from]);
    }
  }
  return some;
}

Figures only(const Figures& figures, const std::vector<std::string_view>& keys) {
  Figures some;
  for (const std::string_view key : keys) {
    some.all.push_back(with_key(figures.all, key));
  }
  return some;
}

Table beside(const std::vector<std::pair<std::string, Figures>>& things) {
  Table table{.columns = {{.key = "figure"}}};
  for (const auto& [name, figures] : things) {
    table.columns.push_back({.key = name, .label = name});
  }
  for (std::size_t i = 0; i < things.front().second.all.size(); ++i) {
    std::vector<Cell> row{heading(things.front().second.all[i])};
    for (const auto& [name, figures] : things) {
      const Figure& one = figures.all[i];
      row.push_back(is_known(one) ? Cell{Digits{shown(one, one.value)}} : Cell{});
    }
    if (std::ranges::any_of(row.begin() + 1, row.end(), [](const Cell& cell) { return cell.index() != 0; })) {
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

std::vector<text::NamedFile> files(const Document& document, const std::string& name, const std::string& page) {
  std::vector<text::NamedFile> all{{(page.empty() ? name : page) + ".html", html(document)},
                                   {name + ".json", json(document)}};
  for (const Table& sheet : document.spreadsheets) {
    all.push_back({sheet.key.value() + ".csv", csv(sheet)});
  }
  return all;
}

Picture plot(const Table& table, std::string_view y, const Over& over) {
  const std::size_t x_at = table.column(over.x);
  const std::size_t y_at = table.column(y);
  const Column& of = table.columns[y_at];
  const bool is_spread = !table.rows.empty() && std::holds_alternative<Spread>(table.rows.front()[y_at]);
  page::Chart chart{
      .label = axis(of), .x_label = axis(table.columns[x_at]), .y_label = axis(of), .width = page::half_page};
  for (const std::vector<Cell>& row : table.rows) {
    std::string name;
    if (!over.curves.empty()) {
      const Column& by = table.columns[table.column(over.curves)];
      const std::string value = shown(by, row[table.column(over.curves)]);
      name = value == by.absent ? "" : fmt::format("{} at {} {}", by.label, value, by.unit.symbol);
    }
    page::Series& to = curve(chart, name);
    const double x = number(table.columns[x_at], row[x_at]);
    const double value = number(of, row[y_at]);
    const auto place = std::ranges::lower_bound(to.x, x);
    const auto there = to.y.begin() + (place - to.x.begin());
    if (place == to.x.end() || *place != x) {
      to.y.insert(there, value);
      to.x.insert(place, x);
    } else {
      *there = of.worse == Worse::smaller ? std::fmin(*there, value) : std::fmax(*there, value);
    }
  }
  if (is_spread) {
    page::Area& area = chart.areas.emplace_back(page::Area{.name = "5 to 95 % of the runs"});
    for (const std::vector<Cell>& row : table.rows) {
      const auto& spread = std::get<Spread>(row[y_at]);
      area.x.push_back(number(table.columns[x_at], row[x_at]));
      area.low.push_back(number(of, spread.p5));
      area.high.push_back(number(of, spread.p95));
    }
    chart.series.front().name = "middle of the runs";
    chart.series.front().role = page::Role::model;
  }
  return {.chart = std::move(chart)};
}

}  // namespace fantail::result
