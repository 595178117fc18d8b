// SPDX-License-Identifier: MIT
#include "flight/table.hpp"

#include <algorithm>
#include <cstring>
#include <set>

#include <fmt/core.h>

#include "input/messages.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::flight {
namespace {

using text::Error;
using text::ErrorKind;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

bool says_nothing(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string_view::npos || line[first] == '#' ||
         line.find_first_not_of(" \t\r,") == std::string_view::npos;
}

constexpr std::size_t longest_piece = 48;
constexpr std::size_t most_names = 40;

std::string harmless(std::string_view text) {
  std::string shown{text.substr(0, longest_piece)};
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      c = '?';
    }
  }
  return text.size() > longest_piece ? shown + "..." : shown;
}

}  // namespace

std::string csv_text(const Table& table) {
  std::string text;
  const std::vector<std::string>& names = table.columns();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool looks_like_a_remark = i == 0 && names[i].starts_with('#');
    text += (i == 0 ? "" : ",") + (looks_like_a_remark ? '"' + names[i] + '"' : text::csv_cell(names[i]));
  }
  text += '\n';
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      text += i == 0 ? "" : ",";
      text += text::csv_cell(std::string{table.cell(row, i)});
    }
    text += '\n';
  }
  return text;
}

std::string in_quotes(std::string_view text) { return '"' + harmless(text) + '"'; }

std::string missing_column(std::string_view wanted, std::span<const std::string> there) {
  std::vector<std::string> names;
  for (const std::string& name : there.first(std::min(there.size(), most_names))) {
    names.push_back(harmless(name));
  }
  std::string message = "no column " + std::string{wanted};
  if (const auto meant = input::suggestion(wanted, names)) {
    message += " (did you mean " + *meant + "?)";
  }
  message += "; the columns are: ";
  for (const std::string& name : names) {
    message += name + ", ";
  }
  return there.size() > most_names ? message + "..." : message.substr(0, message.size() - 2);
}

Table Table::parse(std::string text, std::string name, Rows rows, std::size_t first_line) {
  Table table{std::move(text), std::move(name), rows};
  table.read_all(first_line);
  return table;
}

Table Table::load(const std::string& path) { return parse(text::read_input(path), path); }

void Table::read_all(std::size_t first_line) {
  // Half an hour at 1 kHz.
  if (constexpr std::size_t most = text::most_bytes(text::InputKind::data); text_.size() > most) {
    throw Error{ErrorKind::bad_data, fmt::format("{}: has more than {} MiB as text", name_, most >> 20U)};
  }
  if (text_.find('\0') != std::string::npos) {
    throw Error{ErrorKind::bad_data, name_ + ": contains zero bytes, so it is not CSV text in UTF-8"};
  }
  std::size_t begin = text_.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  for (std::size_t line = first_line; begin < text_.size(); ++line) {
    const std::size_t end = std::min(text_.find('\n', begin), text_.size());
    if (!says_nothing(std::string_view{text_}.substr(begin, end - begin))) {
      read_line(begin, end, line);
      if (columns_.empty()) {
        read_header(line);
      } else {
        lines_.push_back(line);
      }
    }
    begin = end + 1;
  }
  if (columns_.empty()) {
    throw Error{ErrorKind::bad_data, name_ + ": is empty; a header with the column names is needed"};
  }
}

void Table::read_header(std::size_t line) {
  header_line_ = line;
  std::set<std::string_view> seen;
  bool all_numbers = true;
  for (const Cell cell : cells_) {
    const std::string_view name = view(cell);
    if (!name.empty() && !seen.insert(name).second) {
      refuse(line, fmt::format("the column {} appears twice", in_quotes(name)));
    }
    all_numbers = all_numbers && (name.empty() || text::number(name));
    columns_.emplace_back(name);
  }
  if (row_names_ == Rows::by_number) {  // nobody has typed this header
    cells_.clear();
    return;
  }
  if (all_numbers) {
    refuse(line, "only numbers; the first line must be a header with the column names");
  }
  for (const char separator : {';', '\t'}) {
    if (columns_.size() == 1 && columns_[0].find(separator) != std::string::npos) {
      refuse(line, fmt::format("the columns seem to be separated by {}; commas are expected",
                               separator == ';' ? "semicolons" : "tabs"));
    }
  }
  cells_.clear();
}

// Puts the cells of one line at the end of cells_.
void Table::read_line(std::size_t begin, std::size_t end, std::size_t line) {
  const std::size_t before = cells_.size();
  while (true) {
    while (begin < end && is_blank(text_[begin])) {
      ++begin;
    }
    if (begin < end && text_[begin] == '"') {
      begin = read_quoted(begin, end, line);
    } else {
      const void* comma = std::memchr(text_.data() + begin, ',', end - begin);
      const std::size_t stop =
          comma == nullptr ? end : static_cast<std::size_t>(static_cast<const char*>(comma) - text_.data());
      std::size_t last = stop;
      while (last > begin && is_blank(text_[last - 1])) {
        --last;
      }
      cells_.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(last)});
      begin = stop;
    }
    if (begin == end) {
      break;
    }
    ++begin;  // behind the comma
  }
  const std::size_t count = cells_.size() - before;
  if (!columns_.empty() && count != columns_.size()) {
    const bool last_line = end == text_.size();
    refuse(line, fmt::format("{} {} where the header has {}{}", count, count == 1 ? "cell" : "cells", columns_.size(),
                             last_line && count < columns_.size() ? "; the last line seems to be cut off" : ""));
  }
}

// Takes the quotes out in place, where the text only gets shorter. Returns where the comma or the end of the line is.
std::size_t Table::read_quoted(std::size_t begin, std::size_t end, std::size_t line) {
  const std::size_t first = begin + 1;
  std::size_t out = first;
  std::size_t in = first;
  for (; in < end; ++in) {
    if (text_[in] == '"') {
      if (in + 1 < end && text_[in + 1] == '"') {
        ++in;
      } else {
        break;
      }
    }
    text_[out++] = text_[in];
  }
  if (in == end) {
    refuse(line, "a quoted cell does not end on its line");
  }
  ++in;
  while (in < end && is_blank(text_[in])) {
    ++in;
  }
  if (in < end && text_[in] != ',') {
    refuse(line, "text after a closing quote");
  }
  const std::string_view inside = text::trimmed(std::string_view{text_}.substr(first, out - first));
  const std::size_t start = inside.empty() ? first : static_cast<std::size_t>(inside.data() - text_.data());
  const auto from = static_cast<std::uint32_t>(start);
  cells_.push_back({from, static_cast<std::uint32_t>(from + inside.size())});
  return in;
}

std::optional<std::size_t> Table::find(std::string_view column) const {
  const auto found = std::ranges::find(columns_, column);
  return found == columns_.end() ? std::nullopt : std::optional{static_cast<std::size_t>(found - columns_.begin())};
}

std::size_t Table::column(std::string_view column) const {
  if (const auto found = find(column); found && !column.empty()) {
    return *found;
  }
  throw Error{ErrorKind::bad_data, fmt::format("{}: {}", name_, missing_column(column, columns_))};
}

std::string_view Table::view(Cell cell) const { return {text_.data() + cell.begin, cell.end - cell.begin}; }

std::string_view Table::cell(std::size_t row, std::size_t column) const {
  return view(cells_[row * columns_.size() + column]);
}

std::optional<double> Table::number(std::size_t row, std::size_t column) const {
  return text::number(cell(row, column));
}

std::string Table::place(std::size_t row) const {
  const std::size_t line = lines_[row];
  return row_names_ == Rows::by_line ? fmt::format("line {}", line) : fmt::format("row {}", line - header_line_);
}

std::string Table::at(std::size_t line) const {
  if (row_names_ == Rows::by_line) {
    return fmt::format("{}:{}", name_, line);
  }
  return line == header_line_ ? name_ : fmt::format("{}: row {}", name_, line - header_line_);
}

void Table::refuse(std::size_t line, const std::string& complaint) const {
  throw Error{ErrorKind::bad_data, fmt::format("{}: {}", at(line), complaint)};
}

}  // namespace fantail::flight
