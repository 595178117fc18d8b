// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "page/page.hpp"
#include "page/parts.hpp"

namespace fantail::page {
namespace {

std::string class_attribute(bool number, Tone tone) {
  std::string names = number ? "number" : "";
  if (tone != Tone::plain) {
    names += names.empty() ? "" : " ";
    names += class_of(tone);
  }
  return names.empty() ? names : fmt::format(" class=\"{}\"", names);
}

// Columns of these beside others would be narrow and very high ones on a telephone, and the last would be cut off. So
// would several of half a sentence.
bool has_sentences(std::span<const Column> columns, std::span<const std::vector<Cell>> rows) {
  constexpr std::size_t sentence = 36;
  constexpr std::size_t beside_each_other = 3;
  const auto words = [&columns](const std::vector<Cell>& row) {
    std::size_t letters = 0;
    for (std::size_t i = 1; i < row.size() && i < columns.size(); ++i) {
      letters += columns[i].number ? 0 : row[i].text.size();
    }
    return letters;
  };
  return columns.size() > beside_each_other &&
         std::ranges::any_of(rows, [&](const std::vector<Cell>& row) { return words(row) > sentence; });
}

// Of a table on a telephone: cards, or a first column that has room for its names.
std::string_view table_class(std::span<const Column> columns, std::span<const std::vector<Cell>> rows) {
  constexpr std::size_t short_name = 12;
  if (has_sentences(columns, rows)) {
    return "cards";
  }
  const bool named = std::ranges::any_of(
      rows, [](const std::vector<Cell>& row) { return !row.empty() && row.front().text.size() > short_name; });
  return named ? "named" : "plain";
}

// Of the svg itself, beside those that it has.
std::string with_class(std::string_view svg, std::string_view name) {
  constexpr std::string_view begin = "<svg class=\"";
  return svg.starts_with(begin) ? fmt::format("{}{} {}", begin, name, svg.substr(begin.size())) : std::string{svg};
}

}  // namespace

std::string section(std::string_view heading, std::string_view body_html) {
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", printed(heading), body_html);
}

std::string paragraph(std::string_view text) { return fmt::format("<p>{}</p>\n", printed(text)); }

std::string note(std::string_view text) { return unless_empty("p", "note", text); }

std::string note(std::string_view text, std::string_view id) {
  return fmt::format("<p class=\"note\" id=\"{}\">{}</p>\n", id, printed(text));
}

std::string figure(std::string_view svg, std::string_view caption) {
  return caption.empty() ? fmt::format("<figure>{}</figure>\n", svg)
                         : fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", svg, printed(caption));
}

std::string figure(std::string_view wide_svg, std::string_view narrow_svg, std::string_view caption) {
  return figure(with_class(wide_svg, "wide") + with_class(narrow_svg, "narrow"), caption);
}

std::string figure(const Chart& chart, std::string_view caption) {
  if (chart.width <= half_page) {
    return figure(svg(chart), caption);
  }
  Chart narrow = chart;
  narrow.width = half_page;
  return figure(svg(chart), svg(narrow), caption);
}

std::string on_demand(std::string_view what, std::string_view body_html) {
  return fmt::format("<details><summary>{}</summary>\n{}</details>\n", printed(what), body_html);
}

std::string side_by_side(std::span<const std::string> parts_html) {
  std::string out = "<div class=\"pair\">\n";
  for (const std::string& one : parts_html) {
    out += one;
  }
  return out + "</div>\n";
}

std::string table(std::span<const Column> columns, std::span<const std::vector<Cell>> rows) {
  const std::string_view kind = table_class(columns, rows);
  const bool cards = kind == "cards";
  // With a place in the order of keys, because it may have to be scrolled.
  std::string out = fmt::format(
      "<div class=\"table\" tabindex=\"0\" role=\"group\" aria-label=\"Table of {} columns\"><table class=\"{}\">\n"
      "<thead><tr>",
      columns.size(), kind);
  for (const Column& column : columns) {
    out += column.heading.empty() ? "<td></td>"
                                  : fmt::format("<th scope=\"col\"{}>{}</th>",
                                                class_attribute(column.number, Tone::plain), printed(column.heading));
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const std::vector<Cell>& row : rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto& [text, tone, below, tone_below] = row[i];
      out += fmt::format(
          "<td{}{}>{}", class_attribute(i < columns.size() && columns[i].number, tone),
          cards && i > 0 && i < columns.size() ? fmt::format(" data-label=\"{}\"", printed(columns[i].heading)) : "",
          printed(text));
      out +=
          below.empty() ? "" : fmt::format("<small{}>{}</small>", class_attribute(false, tone_below), printed(below));
      out += "</td>";
    }
    out += "</tr>\n";
  }
  return out + "</tbody>\n</table></div>\n";
}

std::string figure_row(std::span<const Figure> list) {
  std::string out = "<dl class=\"figures\">\n";
  for (const Figure& one : list) {
    out += fmt::format("<div><dt>{}</dt><dd>{}", printed(one.label), printed(one.value));
    out += one.unit.empty() ? "" : fmt::format(" <span>{}</span>", printed(one.unit));
    out += one.remark.empty() ? "" : fmt::format("<small>{}</small>", printed(one.remark));
    out += "</dd></div>\n";
  }
  return out + "</dl>\n";
}

std::string list(std::span<const Cell> sentences) {
  std::string out = "<ul>\n";
  for (const Cell& sentence : sentences) {
    out += fmt::format("<li{}>{}</li>\n", class_attribute(false, sentence.tone), printed(sentence.text));
  }
  return out + "</ul>\n";
}

std::string list(std::span<const Link> links) {
  std::string out = "<ul>\n";
  for (const auto& [href, text, about] : links) {
    const std::string shown = printed(text);
    out += fmt::format("<li>{}{}</li>\n",
                       href.empty() ? shown : fmt::format("<a href=\"{}\">{}</a>", escape_html(href), shown),
                       printed(about));
  }
  return out + "</ul>\n";
}

std::string list(std::span<const std::string> sentences) {
  std::vector<Cell> plain;
  for (const std::string& sentence : sentences) {
    plain.push_back({sentence});
  }
  return list(plain);
}

}  // namespace fantail::page
