// SPDX-License-Identifier: MIT
#include "listen/load.hpp"

#include <algorithm>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "files/convert.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"
#include "text/number.hpp"

namespace fantail::listen {
namespace {

struct Line {
  std::size_t begin = 0;
  std::size_t end = 0;  ///< of the line, without its line end

  [[nodiscard]] std::string_view of(const std::string& text) const {
    return text::trimmed(std::string_view{text}.substr(begin, end - begin));
  }
};

Line line_at(const std::string& text, std::size_t begin) {
  return {begin, std::min(text.find('\n', begin), text.size())};
}

std::string_view first_cell(std::string_view line) { return text::trimmed(line.substr(0, line.find(','))); }

// The header, and whether it stands behind a '#': the last such line, when what follows it begins with a number.
struct Header {
  Line line;
  bool commented = false;
};

Header header_of(const std::string& text) {
  Header comment;
  for (std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0; at < text.size();) {
    const Line line = line_at(text, at);
    const std::string_view content = line.of(text);
    if (content.starts_with('#')) {
      if (content.find(',') != std::string_view::npos) {
        comment = {line, true};
      }
    } else if (!content.empty()) {
      return comment.commented && text::number(first_cell(content)) ? comment : Header{line};
    }
    at = line.end + 1;
  }
  return comment;
}

// Names have no commas in quotes here: a header that has quotes is left as it is.
std::string distinct(std::string_view header) {
  std::string names;
  std::map<std::string, int, std::less<>> seen;
  while (true) {
    const std::size_t comma = std::min(header.find(','), header.size());
    const std::string name{text::trimmed(header.substr(0, comma))};
    const int before = name.empty() ? 0 : seen[name]++;
    names += before == 0 ? name : fmt::format("{}.{}", name, before);
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

}  // namespace

std::string tidy(std::string text, std::vector<std::string>& notes) {
  const Header header = header_of(text);
  const std::string_view content = header.line.of(text);
  if (content.find('"') != std::string_view::npos) {
    return text;
  }
  const std::string names = distinct(header.commented ? content.substr(1) : content);
  text.replace(header.line.begin, header.line.end - header.line.begin, names);
  drop_cut_line(text, std::ranges::count(names, ','), notes);
  return text;
}

Loaded load(const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::string ending = file.extension().string();
  if (files::is_read(file)) {
    files::Read read = files::read(file);
    return {flight::Table::parse(std::move(read.csv), name, flight::Table::Rows::by_number), std::move(read.notes),
            ending == ".ulg" ? Clocks::several : Clocks::one};
  }
  if (ending == ".ftl" || ending == ".lcmlog") {
    (void)text::InputFile{file};  // one that is missing is that first
    throw text::Error{text::ErrorKind::bad_data,
                      fmt::format("{}: listen reads no files that end in {}; allowed: CSV (any other ending), {} "
                                  "(fantail log export writes CSV and some of these from an .ftl)",
                                  name, ending, files::listed(files::read_endings))};
  }
  std::vector<std::string> notes;
  std::string text = tidy(text::read_input(file), notes);
  return {.table = flight::Table::parse(std::move(text), name), .notes = std::move(notes)};
}

}  // namespace fantail::listen
