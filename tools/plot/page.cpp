// SPDX-License-Identifier: MIT
#include "plot/page.hpp"

#include <fmt/core.h>

#include "plot/lettering.hpp"
#include "plot/page_assets.hpp"
#include "report/escape.hpp"

namespace fantail::plot {
namespace {

std::string_view class_of(Tone tone) {
  switch (tone) {
    case Tone::good: return "good";
    case Tone::bad: return "bad";
    case Tone::unsure: return "unsure";
    case Tone::plain: break;
  }
  return "plain";
}

std::string class_attribute(bool number, Tone tone) {
  std::string names = number ? "number" : "";
  if (tone != Tone::plain) {
    names += names.empty() ? "" : " ";
    names += class_of(tone);
  }
  return names.empty() ? names : fmt::format(" class=\"{}\"", names);
}

}  // namespace

std::string html(const Page& page) {
  const std::string title = report::escape_html(page.title);
  const std::string kind = report::escape_html(page.kind);
  std::string out = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{}{}{}</title>\n<style>{}</style>\n"
      "<style>{}</style>\n</head>\n<body>\n<main>\n<header>\n",
      title, title.empty() || kind.empty() ? "" : " \u00b7 ", kind, plot_css, page_css);
  if (!kind.empty()) {
    out += fmt::format("<p class=\"kind\">{}</p>\n", kind);
  }
  out += fmt::format("<h1>{}</h1>\n", title);
  if (!page.subtitle.empty()) {
    out += fmt::format("<p class=\"subtitle\">{}</p>\n", printed(page.subtitle));
  }
  out += "</header>\n";
  if (!page.verdict_heading.empty()) {
    out += fmt::format("<section class=\"verdict {}\">\n<h2>{}</h2>\n<p>{}</p>\n</section>\n", class_of(page.tone),
                       printed(page.verdict_heading), printed(page.verdict));
  }
  return out + page.body_html + "</main>\n</body>\n</html>\n";
}

std::string section(std::string_view heading, std::string_view body_html) {
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", printed(heading), body_html);
}

std::string paragraph(std::string_view text) { return fmt::format("<p>{}</p>\n", printed(text)); }

std::string figure(std::string_view svg, std::string_view caption) {
  return caption.empty() ? fmt::format("<figure>{}</figure>\n", svg)
                         : fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", svg, printed(caption));
}

std::string figures(std::span<const std::string> figures_html) {
  std::string out = "<div class=\"pair\">\n";
  for (const std::string& one : figures_html) {
    out += one;
  }
  return out + "</div>\n";
}

std::string table(std::span<const Column> columns, std::span<const std::vector<Cell>> rows) {
  std::string out = "<div class=\"table\"><table>\n<thead><tr>";
  for (const Column& column : columns) {
    out += fmt::format("<th scope=\"col\"{}>{}</th>", class_attribute(column.number, Tone::plain),
                       printed(column.heading));
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const std::vector<Cell>& row : rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      out += fmt::format("<td{}>{}</td>", class_attribute(i < columns.size() && columns[i].number, row[i].tone),
                         printed(row[i].text));
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

std::string list(std::span<const std::string> sentences) {
  std::string out = "<ul>\n";
  for (const std::string& sentence : sentences) {
    out += fmt::format("<li>{}</li>\n", printed(sentence));
  }
  return out + "</ul>\n";
}

}  // namespace fantail::plot
