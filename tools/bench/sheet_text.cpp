// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/core.h>

#include "bench/sheet.hpp"
#include "bench/sheet_parts.hpp"
#include "bench/watch.hpp"
#include "core/tick_record.hpp"
#include "text/layout.hpp"

namespace fantail::bench {
namespace {

constexpr std::size_t label_width = 28;
constexpr std::size_t allowed_width = 16;
constexpr std::size_t cell_width = 10;

class Page {
 public:
  Page(const Sheet& sheet, std::size_t columns) : sheet_{sheet}, columns_{columns} {}

  std::string write() {
    heading();
    table();
    for (const GeneralCheck& check : sheet_.general) {
      line("{} {}", check.passed ? " " : "!", check.text);
    }
    if (monitored_) {
      line("  {}", about_monitor);
    }
    line("");
    line("{}", headline(sheet_));
    for (const std::string& conclusion : conclusions(sheet_)) {
      line("  {}", conclusion);
    }
    return out_;
  }

 private:
  template <typename... T>
  void line(fmt::format_string<T...> format, T&&... values) {
    std::string text = fmt::format(format, std::forward<T>(values)...);
    text.erase(text.find_last_not_of(' ') + 1);
    out_ += text + "\n";
  }

  void heading() {
    line("Canard {}", name(sheet_.kind));
    out_ += heading_lines(sheet_.heading);
    line("");
  }

  void row(const std::string& label, const std::string& allowed, const std::vector<std::string>& cells) {
    std::vector<std::string> all{fmt::format("{:<{}}", label, label_width),
                                 fmt::format("{:<{}}", allowed, allowed_width)};
    for (const std::string& one : cells) {
      // The mark of a failure hangs to the right of the column, so that figures stay in line.
      const bool failed = one.ends_with(" !");
      all.push_back(
          fmt::format("{:>{}}{}", failed ? one.substr(0, one.size() - 2) : one, cell_width - 2, failed ? " !" : "  "));
    }
    table_.row_to_its_last_word(all);
  }

  void table() {
    std::vector<std::string> cells;
    cells.reserve(sheet_.canards.size());
    for (const CanardResult& result : sheet_.canards) {
      cells.push_back(fmt::format("canard {}", result.canard + 1));
    }
    row("", "allowed", cells);
    const std::vector<SheetRow> rows = sheet_rows(sheet_);
    write(rows, &Cell::alone, &Cell::alone_passed);
    monitor();
    table_.row({""});
    if (std::ranges::any_of(rows, [](const SheetRow& r) { return has(r, &Cell::together); })) {
      table_.row({"All four together"});
      write(rows, &Cell::together, &Cell::together_passed);
      table_.row({""});
    }
    out_ += table_.text(columns_);
  }

  static bool has(const SheetRow& row, std::string Cell::* text) {
    return std::ranges::any_of(row.cells, [text](const Cell& cell) { return !(cell.*text).empty(); });
  }

  void write(const std::vector<SheetRow>& rows, std::string Cell::* text, bool Cell::* passed) {
    for (const SheetRow& r : rows) {
      std::vector<std::string> cells;
      cells.reserve(r.cells.size());
      for (const Cell& one : r.cells) {
        cells.push_back(one.*text + (one.*passed ? "" : " !"));
      }
      if (has(r, text)) {
        row(r.unit.empty() ? r.label : fmt::format("{}, {}", r.label, r.unit), r.allowed, cells);
      }
    }
  }

  void monitor() {
    std::vector<std::string> cells;
    bool any = false;
    for (const CanardResult& result : sheet_.canards) {
      const auto& verdict = sheet_.heading.monitor[result.canard];
      any = any || verdict;
      cells.emplace_back(verdict ? core::name(*verdict) : "");
    }
    if (any) {
      row("Avionics' own verdict", "not judged", cells);
      monitored_ = true;
    }
  }

  const Sheet& sheet_;
  std::size_t columns_;
  bool monitored_ = false;
  text::Table table_{std::vector<text::Table::Column>(2 + core::canard_count)};
  std::string out_;
};

}  // namespace

std::string printable(std::string text) {
  std::ranges::replace_if(text, [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

std::string heading_lines(const Heading& heading) {
  std::string lines;
  for (const auto& [label, value] : {std::pair{"vehicle", heading.vehicle},
                                     {"plan", heading.plan},
                                     {"plan CRC", heading.plan_crc},
                                     {"gate", heading.gate},
                                     {"date", heading.date},
                                     {"avionics", heading.avionics},
                                     {"board", heading.board ? board_text(*heading.board) : std::string{}}}) {
    lines += value.empty() ? "" : fmt::format("  {:<10}{}\n", label, printable(value));
  }
  return lines;
}

std::string sheet_text(const Sheet& sheet, std::size_t columns) { return Page{sheet, columns}.write(); }

}  // namespace fantail::bench
