// SPDX-License-Identifier: MIT
#include "files/tidy.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "files/cells.hpp"
#include "files/quantities.hpp"
#include "text/encoding.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::files {
namespace {

constexpr std::array separators{',', ';', '\t'};

/// How commas within numbers are meant.
enum class Comma : std::uint8_t { none, decimal, thousands };

std::string with_point(std::string_view number, Comma comma) {
  std::string out{number};
  if (comma == Comma::decimal) {
    std::ranges::replace(out, ',', '.');
  } else if (comma == Comma::thousands) {
    std::erase(out, ',');
  }
  return out;
}

class Tidier {
 public:
  explicit Tidier(std::string text) : text_{std::move(text)} {
    for (std::size_t begin = 0; begin < text_.size();) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      lines_.push_back(text::trimmed(std::string_view{text_}.substr(begin, end - begin)));
      begin = end + 1;
    }
  }

  [[nodiscard]] bool is_own() const {
    const auto first =
        std::ranges::find_if(lines_, [](std::string_view line) { return !line.empty() && !is_comment(line); });
    if (first == lines_.end()) {
      return false;
    }
    const auto cells = cells_of(*first, ',');
    return std::ranges::find(cells, "time_s", text::trimmed) != cells.end();
  }

  Tidied tidy() {
    choose_separator();
    const auto row = std::ranges::find_if(lines_, [&](std::string_view line) { return is_row(line, separator_); });
    first_row_ = static_cast<std::size_t>(row - lines_.begin());
    find_header();
    note_commas();
    return write();
  }

 private:
  void choose_separator() {
    if (!lines_.empty()) {
      const std::string_view first = unquoted(lines_.front());
      constexpr std::string_view said = "sep=";
      if (first.size() == said.size() + 1 && first.starts_with(said)) {
        separator_ = first.back();
        lines_.front() = {};
        return;
      }
    }
    // The one that makes most numbers and fewest words out of the rows.
    constexpr std::size_t looked_at = 200;
    const std::size_t begin = lines_.size() > looked_at ? lines_.size() / 2 : 0;
    long most = 0;
    for (const char separator : separators) {
      std::map<std::size_t, long> numbers;  // less words, by how many cells a line has
      for (std::size_t i = begin; i < std::min(lines_.size(), begin + looked_at); ++i) {
        if (is_row(lines_[i], separator)) {
          const auto cells = cells_of(lines_[i], separator);
          for (const std::string_view cell : cells) {
            const bool is_number = looks_like_number(cell) || looks_like_time(cell);
            numbers[cells.size()] += unquoted(cell).empty() ? 0 : is_number ? 1 : -1;
          }
        }
      }
      for (const auto& [cells, count] : numbers) {
        if (cells > 1 && count > most) {
          most = count;
          separator_ = separator;
        }
      }
    }
  }

  /// A comment that only says what happened ("# Event LAUNCH occurred,,,") has cells, but nothing in them.
  [[nodiscard]] bool is_mostly_empty(std::string_view line, std::size_t wanted) const {
    const auto cells = cells_of(without_mark(line), separator_);
    const auto filled = std::ranges::count_if(cells, [](std::string_view cell) { return !unquoted(cell).empty(); });
    return wanted > 2 && 2 * static_cast<std::size_t>(filled) < wanted;
  }

  /// "# MET Acc Vel": as many words as the rows have cells.
  [[nodiscard]] bool has_words(std::string_view line, std::size_t wanted) const {
    const auto cells = cells_of(text::trimmed(without_mark(line)), ' ');
    return is_comment(line) && wanted > 2 && cells.size() == wanted && !is_row(without_mark(line), ' ') &&
           std::ranges::none_of(cells, [](std::string_view cell) { return cell.empty(); });
  }

  void find_header() {
    const std::size_t end = first_row_;
    const std::size_t wanted = end == lines_.size() ? 0 : cells_of(lines_[end], separator_).size();
    std::optional<std::size_t> another;  // with another number of cells than the rows
    std::optional<std::size_t> of_words;
    for (std::size_t i = end; i-- > 0;) {
      const std::size_t cells = cells_of(lines_[i], separator_).size();
      const bool is_named = !lines_[i].empty() && !is_row(text::trimmed(without_mark(lines_[i])), separator_);
      if (is_named && cells == wanted && (wanted > 1 || !is_comment(lines_[i])) && !is_of_units(lines_[i]) &&
          !is_mostly_empty(lines_[i], wanted)) {
        header_ = i;
        return;
      }
      of_words = !of_words && has_words(lines_[i], wanted) ? i : of_words;
      another = is_named && !another && (cells > 1 || (wanted == 0 && !is_comment(lines_[i]))) ? i : another;
    }
    // A remark can have as many words as the rows have cells: names that are separated as the rows go before it.
    header_ = wanted == 1 ? std::nullopt : another ? another : of_words;
    if (of_words && header_ == of_words) {
      header_separator_ = ' ';
    }
  }

  /// A second line below the names.
  [[nodiscard]] bool is_of_units(std::string_view line) const {
    return std::ranges::all_of(cells_of(without_mark(line), separator_), [](std::string_view cell) {
      std::string unit = plainly_spelt(unquoted(cell));
      std::erase_if(unit, [](char c) { return c == '(' || c == ')' || c == '[' || c == ']'; });
      return unit.empty() || unit == "-" || unit == "V" || unit == "counts" || find_unit(unit) != nullptr;
    });
  }

  /// Of a comment, and of PerfectFlite's "Data: (Time, Altitude, Voltage)".
  static std::string_view without_mark(std::string_view line) {
    constexpr std::string_view data = "Data: (";
    if (line.starts_with(data) && line.ends_with(')')) {
      return line.substr(data.size(), line.size() - data.size() - 1);
    }
    return is_comment(line) ? line.substr(1) : line;
  }

  void note_commas() {
    if (separator_ == ',') {
      comma_ = Comma::decimal;  // of quoted cells alone
      return;
    }
    for (std::size_t i = first_row_; i < lines_.size(); ++i) {
      if (lines_[i].find(',') == std::string_view::npos || is_comment(lines_[i])) {
        continue;
      }
      for (const std::string_view cell : cells_of(lines_[i], separator_)) {
        if (looks_like_number(cell) && cell.find(',') != std::string_view::npos) {
          const bool has_both = cell.find('.') != std::string_view::npos || cell.find(',') != cell.rfind(',');
          comma_ = has_both ? Comma::thousands : comma_ == Comma::none ? Comma::decimal : comma_;
        }
      }
    }
  }

  Tidied write() {
    Tidied out;
    std::size_t names = 0;
    if (!header_ && first_row_ < lines_.size()) {
      names = cells_of(lines_[first_row_], separator_).size();
      for (std::size_t i = 0; i < names; ++i) {
        out.text += fmt::format("{}\"#{}\"", i == 0 ? "" : ",", i + 1);
      }
      out.text += '\n';
      out.first_line = 0;
      out.notes.push_back(fmt::format("The file has no names of columns: they are called #1 to #{}.", names));
    }
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const std::string_view line = lines_[i];
      if (header_ == i) {
        out.text += names_of(line, names, out.notes);
      } else if (i >= first_row_ && !line.empty() && !is_comment(line)) {
        const bool is_cut = i + 1 == lines_.size() && text_.back() != '\n' && cells_of(line, separator_).size() < names;
        if (is_cut) {
          out.notes.emplace_back("The last line of the file is cut off; it is left out.");
          break;
        }
        out.text += row_of(line, names, i + 1);
      } else if (!line.empty()) {
        out.text += '#';  // about the logger, or units below the names
      }
      out.text += '\n';
    }
    if (short_rows_ > 0) {
      out.notes.push_back(fmt::format("Fewer cells than names in {} (first: line {}): the rest of them is unknown.",
                                      text::counted(short_rows_, "row"), first_short_line_));
    }
    return out;
  }

  std::string names_of(std::string_view line, std::size_t& count, std::vector<std::string>& notes) const {
    const auto cells = cells_of(text::trimmed(without_mark(line)), header_separator_.value_or(separator_));
    count = cells.size();
    std::string out;
    std::map<std::string, int, std::less<>> seen;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      std::string name{unquoted(cells[i])};
      const int before = name.empty() ? 0 : seen[name]++;
      if (before == 1) {
        notes.push_back(
            fmt::format("The header has {0} more than once: {0} is the first column of that name, {0}.1 the second.",
                        text::printable(name)));
      }
      name += before == 0 ? "" : fmt::format(".{}", before);
      const bool needs_quotes = name.find(',') != std::string::npos || name.starts_with('#');
      out += (i == 0 ? "" : ",") + (needs_quotes ? '"' + name + '"' : name);
    }
    return out;
  }

  std::string row_of(std::string_view line, std::size_t names, std::size_t number) {
    auto cells = cells_of(line, separator_);
    while (cells.size() > names && text::trimmed(cells.back()).empty()) {
      cells.pop_back();
    }
    if (cells.size() < names) {
      first_short_line_ = short_rows_++ == 0 ? number : first_short_line_;
      cells.resize(names);
    }
    std::string out;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      out += i == 0 ? "" : ",";
      if (looks_like_number(cells[i]) && cells[i].find(',') != std::string_view::npos) {
        out += with_point(unquoted(cells[i]), comma_);
      } else if (cells[i].find(',') != std::string_view::npos && separator_ != ',' && !cells[i].starts_with('"')) {
        out += '"' + std::string{text::trimmed(cells[i])} + '"';
      } else {
        out += cells[i];
      }
    }
    return out;
  }

  std::string text_;
  std::vector<std::string_view> lines_;  ///< without spaces around them
  char separator_ = ',';
  std::optional<char> header_separator_{};  ///< where it is another
  Comma comma_ = Comma::none;
  std::size_t first_row_ = 0;
  std::optional<std::size_t> header_;
  std::size_t short_rows_ = 0;
  std::size_t first_short_line_ = 0;
};

}  // namespace

Tidied tidied(std::string bytes) {
  std::string text = text::plain_text(std::move(bytes));
  Tidier tidier{text};
  return tidier.is_own() ? Tidied{.text = std::move(text)} : tidier.tidy();
}

}  // namespace fantail::files
