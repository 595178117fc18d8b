// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "result/document.hpp"
#include "result/parts.hpp"
#include "text/layout.hpp"
#include "text/quoting.hpp"

namespace fantail::result {
namespace {

/// What stands in a file makes no lines of its own.
std::string line(std::string_view sentence) { return fmt::format("  {}\n", text::printable(sentence)); }

std::string text(const std::string& paragraph) { return line(paragraph); }
std::string text(const Picture&) { return {}; }
std::string text(const Live&) { return {}; }
std::string text(const Drawing&) { return {}; }
std::string text(const Data&) { return {}; }
std::string text(const Links& links) {
  std::string all;
  for (const page::Link& link : links.all) {
    all += line(fmt::format("{}{}{}{}", link.text, link.about, link.href.empty() ? "" : ", ", link.href));
  }
  return all;
}
std::string text(const Table&) { return {}; }  // by its own width

std::string text(const Sentences& sentences) {
  std::string all;
  for (const std::string& sentence : sentences.all) {
    all += line(sentence);
  }
  return all;
}

std::string text(const Figures& figures) {
  std::size_t widest = 0;
  for (const Figure& one : figures.all) {
    widest = std::max(widest, one.label.size());
  }
  std::string all;
  for (const Figure& one : known(figures.all)) {
    const auto [number, more] = parts(one);
    const std::string behind = one.remark + (one.remark.empty() || more.empty() ? "" : "; ") + more;
    all += line(fmt::format("{:<{}}  {}{}{}{}", one.label, widest, number, one.unit.symbol.empty() ? "" : " ",
                            one.unit.symbol, behind.empty() ? "" : " (" + behind + ")"));
  }
  return all;
}

/// "criterion roll is held; found none of the runs", for a place that is narrower than the table.
std::string in_a_line(const Table& table, const std::vector<std::size_t>& columns, const std::vector<Cell>& row) {
  std::string all;
  for (const std::size_t i : columns) {
    if (row[i].index() == 0) {
      continue;
    }
    all += fmt::format("{}{} {}", all.empty() ? "" : "; ", heading(table.columns[i]), shown(table.columns[i], row[i]));
  }
  return line(all);
}

std::string text(const Table& table, std::size_t columns) {
  const std::vector<std::size_t> shown_columns = known_columns(table);
  std::vector<std::size_t> widths;
  for (const std::size_t i : shown_columns) {
    std::size_t& widest = widths.emplace_back(text::display_width(heading(table.columns[i])));
    for (const std::vector<Cell>& row : table.rows) {
      widest = std::max(widest, text::display_width(shown(table.columns[i], row[i])));
    }
  }
  std::string narrow;
  if (std::accumulate(widths.begin(), widths.end(), 2 * widths.size()) > columns) {
    for (const std::vector<Cell>& row : table.rows) {
      narrow += in_a_line(table, shown_columns, row);
    }
  }
  if (table.rows.empty() || !narrow.empty()) {
    return narrow;
  }
  text::Table lines{std::vector<text::Table::Column>(shown_columns.size())};
  const auto add = [&](const auto& cell) {
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < shown_columns.size(); ++i) {
      const std::string text = cell(shown_columns[i]);
      cells.push_back(is_words(table, shown_columns[i]) ? fmt::format("  {:<{}}", text, widths[i])
                                                        : fmt::format("  {:>{}}", text, widths[i]));
    }
    lines.row_to_its_last_word(std::move(cells));
  };
  add([&](std::size_t i) { return heading(table.columns[i]); });
  for (const std::vector<Cell>& row : table.rows) {
    add([&](std::size_t i) { return text::printable(shown(table.columns[i], row[i])); });
  }
  return lines.text(text::any_width);
}

}  // namespace

std::string text(const Document& document, Paint paint, std::size_t columns) {
  const Verdict& verdict = document.verdict;
  std::string all = fmt::format("{}{}{}\n", text::printable(document.title), document.subtitle.empty() ? "" : ": ",
                                text::printable(document.subtitle));
  all += paint != nullptr ? paint(tone(verdict), verdict.heading) : verdict.heading;
  all += ": " + text::printable(behind_heading(verdict));
  for (const std::string& sentence : verdict.beside) {
    all += "\n" + text::printable(sentence);
  }
  all += verdict.not_in_it.empty() ? "\n" : "\n\n" + verdict.not_in_it_heading + "\n";
  for (const std::string& sentence : verdict.not_in_it) {
    all += line(sentence);
  }
  for (const Section& section : document.sections) {
    std::string inside;
    for (const Block& block : section.blocks) {
      const auto* table = std::get_if<Table>(&block);
      inside += table != nullptr ? text(*table, columns) : std::visit([](const auto& one) { return text(one); }, block);
    }
    if (section.readers == Readers::all && !inside.empty()) {
      all += "\n" + section.heading + (section.heading.empty() ? "" : ":\n") + inside;
    }
  }
  all += "\n";
  for (const auto& [label, value] : read_facts(document)) {
    all += value.empty() ? "" : fmt::format("  {:<8} {}\n", label, text::printable(value));
  }
  return all;
}

}  // namespace fantail::result
