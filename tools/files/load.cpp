// SPDX-License-Identifier: MIT
#include "files/load.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <map>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "text/error.hpp"
#include "text/input_file.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::files {
namespace {

constexpr std::string_view separators = ",;\t";

std::string_view first_cell(std::string_view line) { return line.substr(0, line.find_first_of(separators)); }

bool begins_with_time(std::string_view cell) {
  constexpr std::string_view word = "time";
  cell = text::trimmed(cell);
  return std::ranges::equal(cell.substr(0, word.size()), word, {},
                            [](unsigned char c) { return static_cast<char>(std::tolower(c)); }) &&
         (cell.size() == word.size() || cell.substr(word.size()).starts_with(" ("));
}

bool has_a_time(std::string_view line) {
  while (!begins_with_time(first_cell(line))) {
    const std::size_t separator = line.find_first_of(separators);
    if (separator == std::string_view::npos) {
      return false;
    }
    line.remove_prefix(separator + 1);
  }
  return true;
}

// Where the names of the columns stand, without the '#' that may stand before them.
struct Header {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t line = 0;  ///< counted from 1
  bool is_commented = false;

  [[nodiscard]] std::string_view of(const std::string& text) const {
    return text::trimmed(std::string_view{text}.substr(begin, end - begin));
  }
};

// In the last comment that can be one before the first row, or in the first line that is no comment.
std::optional<Header> find_header(const std::string& text, Writer writer) {
  std::optional<Header> comment;
  std::size_t begin = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  for (std::size_t number = 1; begin < text.size(); ++number) {
    Header line{begin, std::min(text.find('\n', begin), text.size()), number};
    const std::string_view content = line.of(text);
    if (content.starts_with('#')) {
      if (writer == Writer::simulator ? has_a_time(content.substr(1)) : content.find(',') != std::string_view::npos) {
        comment = Header{text.find('#', begin) + 1, line.end, number, true};
      }
    } else if (!content.empty()) {
      const bool is_row =
          writer == Writer::simulator ? !has_a_time(content) : text::number(first_cell(content)).has_value();
      return comment && is_row ? comment : line;
    }
    begin = line.end + 1;
  }
  return comment;
}

void refuse_unnamed_velocities(const std::string& name, const Header& header, std::string_view names) {
  if (names.find("E3,W1 (rad/s)") != std::string_view::npos && names.find("Vx") == std::string_view::npos) {
    text::refuse(fmt::format(
        "{}:{}: RocketPy wrote this without variable names, so its header lacks the three velocities; name them: "
        "export_data(\"flight.csv\", \"altitude\", \"speed\", \"vz\", \"attitude_angle\", \"density\", "
        "time_step=0.01)",
        name, header.line));
  }
}

void make_commas(std::string& text, const std::string& name, char separator) {
  std::size_t line = 1;
  bool is_comment = false;
  bool at_begin = true;
  for (char& c : text) {
    if (c == '\n') {
      ++line;
      at_begin = true;
      is_comment = false;
      continue;
    }
    is_comment = is_comment || (at_begin && c == '#');
    at_begin = at_begin && (c == ' ' || is_comment);
    if (c == ',' && !is_comment) {
      text::refuse(fmt::format("{}:{}: a comma, but the columns are separated by {}; numbers need a decimal point",
                               name, line, separator == ';' ? "semicolons" : "tabs"));
    }
    c = c == separator ? ',' : c;
  }
}

// Names have no commas in quotes here: a header that has quotes is left as it is.
std::string distinct(std::string_view header, std::vector<std::string>& notes) {
  std::string names;
  std::map<std::string, int, std::less<>> seen;
  while (true) {
    const std::size_t comma = std::min(header.find(','), header.size());
    const std::string name{text::trimmed(header.substr(0, comma))};
    const int before = name.empty() ? 0 : seen[name]++;
    names += before == 0 ? name : fmt::format("{}.{}", name, before);
    if (before == 1) {
      notes.push_back(
          fmt::format("The header has {0} more than once: {0} is the first column of that name, {0}.1 the second.",
                      text::printable(name)));
    }
    if (comma == header.size()) {
      return names;
    }
    names += ',';
    header.remove_prefix(comma + 1);
  }
}

// A logger that lost its power ends in the middle of a line.
void drop_cut_line(std::string& text, std::ptrdiff_t commas, std::vector<std::string>& notes) {
  const std::size_t last = text.rfind('\n');
  if (last == std::string::npos || last + 1 == text.size()) {
    return;
  }
  if (std::ranges::count(std::string_view{text}.substr(last + 1), ',') < commas) {
    text.erase(last + 1);
    notes.emplace_back("The last line of the file is cut off; it is left out.");
  }
}

// As a header and rows that flight::Table reads, each row still on its line.
void tidy(std::string& text, const std::string& name, Writer writer, std::vector<std::string>& notes) {
  const auto header = find_header(text, writer);
  if (!header) {
    return;
  }
  refuse_unnamed_velocities(name, *header, header->of(text));
  if (header->is_commented) {
    text[header->begin - 1] = ' ';
  }
  const auto* const used =
      std::ranges::find_if(separators, [&](char c) { return header->of(text).find(c) != std::string_view::npos; });
  if (used != separators.end() && *used != ',') {
    make_commas(text, name, *used);
  }
  if (header->of(text).find('"') != std::string_view::npos) {
    return;
  }
  const std::string names = distinct(header->of(text), notes);
  text.replace(header->begin, header->end - header->begin, names);
  drop_cut_line(text, std::ranges::count(names, ','), notes);
}

}  // namespace

Loaded parse(std::string text, const std::string& name, Writer writer) {
  std::vector<std::string> notes;
  if (writer != Writer::ours) {
    tidy(text, name, writer, notes);
  }
  Loaded loaded{flight::Table::parse(std::move(text), name)};
  loaded.notes = std::move(notes);
  return loaded;
}

Loaded load(const std::filesystem::path& file, Writer writer) {
  const std::string name = file.string();
  const std::string ending = file.extension().string();
  if (is_read(file)) {
    Read read = files::read(file);
    Loaded loaded{flight::Table::parse(std::move(read.csv), name, flight::Table::Rows::by_number)};
    loaded.notes = std::move(read.notes);
    loaded.several_clocks = ending == ".ulg";
    loaded.units = std::move(read.units);
    loaded.not_columns = std::move(read.not_columns);
    return loaded;
  }
  const bool reads_logs = writer == Writer::ours;  // whoever asks for those has looked for an .ftl before
  if (ending == ".lcmlog" || ending == (reads_logs ? ".json" : ".ftl")) {
    (void)text::InputFile{file};  // one that is missing is that first
    text::refuse(fmt::format("{}: files that end in {} are not read as tables; allowed: CSV (any other ending){}, {}",
                             name, ending, reads_logs ? ", .ftl" : "", listed(read_endings)) +
                 (reads_logs ? "" : " (fantail log export writes CSV and some of these from an .ftl)"));
  }
  return parse(text::read_input(file), name, writer);
}

}  // namespace fantail::files
