// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "manual/roff.hpp"
#include "text/layout.hpp"
#include "text/number.hpp"

namespace fantail::manual {
namespace {

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

using text::trimmed;

/// Outside of code, "[words](address)" becomes "words", and stars are left out.
std::string plain(std::string_view text) {
  std::string result;
  bool is_code = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_code && text.substr(i).starts_with(" ([")) {  // nothing but a link stands in the brackets: "see there"
      const std::size_t end = text.find(')', i);
      if (end != std::string_view::npos && text.substr(end).starts_with("))")) {
        i = end + 1;
        continue;
      }
    }
    is_code ^= text[i] == '`';
    if (is_code || (text[i] != '[' && text[i] != '*')) {
      result += text[i];
      continue;
    }
    const std::size_t middle = text[i] == '[' ? text.find(']', i) : std::string_view::npos;
    const bool is_link = middle != std::string_view::npos && text.substr(middle).starts_with("](");
    const std::size_t end = is_link ? text.find(')', middle) : std::string_view::npos;
    if (end != std::string_view::npos) {
      result += plain(text.substr(i + 1, middle - i - 1));
      i = end;
    } else if (text[i] == '[') {
      result += '[';
    }
  }
  return result;
}

/// But for code.
std::string in_capitals(std::string_view text) {
  std::string result;
  bool is_code = false;
  for (const char c : text) {
    if (c == '`') {
      is_code = !is_code;
    } else {
      result += is_code ? c : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
  }
  return result;
}

std::string in_roff(std::string_view text) { return sentence(plain(text)); }

std::vector<std::string_view> cells_of(std::string_view row) {
  std::vector<std::string_view> cells;
  row.remove_prefix(1);
  for (std::size_t bar = row.find('|'); bar != std::string_view::npos; bar = row.find('|')) {
    cells.push_back(trimmed(row.substr(0, bar)));
    row.remove_prefix(bar + 1);
  }
  return cells;
}

/// What a cell says without the name of its column.
bool is_plain_fact(std::string_view column, std::string_view cell) {
  constexpr std::array<std::string_view, 5> columns{"", "unit", "range", "Type", "How often"};
  return std::ranges::find(columns, column) != columns.end() || cell == "required";
}

std::string with_small_letter(std::string text) {
  text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

std::string row_item(const std::vector<std::string_view>& head, const std::vector<std::string_view>& cells) {
  std::string facts;
  for (std::size_t i = 1; i + 1 < cells.size(); ++i) {
    if (!cells[i].empty()) {
      const std::string column = is_plain_fact(head[i], cells[i]) ? "" : with_small_letter(plain(head[i])) + " ";
      facts += (facts.empty() ? "" : "; ") + column + plain(cells[i]);
    }
  }
  const bool has_mark = cells.front().starts_with('`');
  const std::string tag = has_mark ? in_roff(cells.front()) : bold(plain(cells.front()));
  const std::string text = in_roff(cells.back());
  constexpr std::size_t longest_tag = 64;  // of a line of 80 columns; a tag is not wrapped
  if (facts.empty()) {
    return item(tag, text);
  }
  if (cells.front().size() + facts.size() <= longest_tag) {
    return item(tag + "  (" + sentence(facts) + ")", text);
  }
  return item(tag, text + " (" + sentence(facts) + ")");
}

std::string table(std::string_view first, std::string_view& text) {
  const std::vector<std::string_view> head = cells_of(first);
  take_line(text);  // the rule
  std::string rows;
  while (text.starts_with('|')) {
    rows += row_item(head, cells_of(take_line(text)));
  }
  return rows;
}

/// A comment that does not fit behind its line stands before it.
std::string narrow(std::string_view block) {
  constexpr std::size_t widest = 68;
  std::string result;
  while (!block.empty()) {
    const std::string_view line = take_line(block);
    const std::size_t mark = line.find("  #");
    if (line.size() <= widest || mark == std::string_view::npos) {
      result.append(line) += '\n';
      continue;
    }
    std::string comment{trimmed(line.substr(mark))};
    while (trimmed(block.substr(0, block.find('\n'))).starts_with("# ")) {  // it goes on
      comment += trimmed(take_line(block)).substr(1);
    }
    const std::string lines = text::wrapped(comment, widest);
    for (std::string_view rest = lines; !rest.empty();) {
      result.append(trimmed(take_line(rest))) += '\n';
    }
    result.append(line.substr(0, line.find_last_not_of(' ', mark) + 1)) += '\n';
  }
  return result;
}

std::string code(std::string_view& text) {
  const std::size_t end = std::min(text.find("```"), text.size());
  const std::string block = verbatim(narrow(text.substr(0, end)));
  text.remove_prefix(end);
  take_line(text);
  return block;
}

bool is_bullet(std::string_view line) { return trimmed(line).starts_with("- "); }

/// With the lines that go on with it.
std::string whole_block(std::string_view first, std::string_view& text) {
  std::string block{trimmed(first)};
  while (!text.empty() && text.front() != '\n' && text.front() != '|' && !text.starts_with("```") &&
         !is_bullet(text.substr(0, text.find('\n')))) {
    block.append(" ").append(trimmed(take_line(text)));
  }
  return block;
}

std::string bullet(std::string_view first, std::string_view& text) {
  const bool is_inner = first.starts_with(' ');
  const std::string block = in_roff(whole_block(first, text).substr(2));
  const std::string entry = ".IP \\(bu 2\n" + block + "\n";
  return is_inner ? ".RS 4\n" + entry + ".RE\n" : entry;
}

}  // namespace

std::string passages_for_manual(std::string_view page) {
  constexpr std::string_view begin = "<!-- manual -->\n";
  constexpr std::string_view end = "<!-- end of manual -->\n";
  std::string passages;
  for (std::size_t from = page.find(begin); from != std::string_view::npos; from = page.find(begin, from)) {
    from += begin.size();
    passages += page.substr(from, page.find(end, from) - from);
    passages += '\n';
  }
  if (passages.empty()) {
    throw std::runtime_error{"no passage is marked with <!-- manual -->"};
  }
  return passages;
}

std::string roff_of_markdown(std::string_view text) {
  std::string page;
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    if (line.empty() || line.starts_with("<!--")) {
      continue;
    }
    if (line.starts_with("## ")) {
      page += heading(in_capitals(plain(line.substr(3))));
    } else if (line.starts_with("### ")) {
      page += subheading(plain(line.substr(4)));
    } else if (line.starts_with("`[") && line.find("]`") != std::string_view::npos) {  // a section of a TOML file
      std::string title{line};
      std::erase(title, '`');
      page += subheading(title);
    } else if (line.starts_with('|')) {
      page += table(line, text);
    } else if (line.starts_with("```")) {
      page += code(text);
    } else if (is_bullet(line)) {
      page += bullet(line, text);
    } else {
      page += paragraph(in_roff(whole_block(line, text)));
    }
  }
  return page;
}

}  // namespace fantail::manual
