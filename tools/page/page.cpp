// SPDX-License-Identifier: MIT
#include "page/page.hpp"

#include <algorithm>
#include <cctype>
#include <ranges>
#include <utility>

#include <fmt/core.h>

#include "page/parts.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::page {
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

// <tag class="...">text</tag>, or nothing.
std::string unless_empty(std::string_view tag, std::string_view kind, std::string_view text) {
  return text.empty() ? "" : fmt::format("<{0} class=\"{1}\">{2}</{0}>\n", tag, kind, printed(text));
}

std::string header(const Page& page) {
  const std::string titles = fmt::format("<header>\n{}<h1>{}</h1>\n{}", unless_empty("p", "kind", page.kind),
                                         escape_html(page.title), unless_empty("p", "subtitle", page.subtitle));
  std::string facts;
  for (const Page::Fact& fact : page.facts) {
    if (!fact.value.empty()) {
      facts += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escape_html(fact.label), escape_html(fact.value));
    }
  }
  return titles + (facts.empty() ? "" : "<dl class=\"facts\">\n" + facts + "</dl>\n") + "</header>\n";
}

// The first sentence is the answer, and stands alone.
std::string answer_and_rest(std::string_view text) {
  for (std::size_t at = text.find(". "); at != std::string_view::npos; at = text.find(". ", at + 1)) {
    if (std::isupper(static_cast<unsigned char>(text[at + 2])) != 0) {
      return paragraph(text.substr(0, at + 1)) + paragraph(text.substr(at + 2));
    }
  }
  return text.empty() ? "" : paragraph(text);
}

std::string verdict(const Page& page) {
  if (page.verdict_heading.empty()) {
    return {};
  }
  std::string findings;
  for (const auto& [what, about, target] : page.findings) {
    findings +=
        fmt::format("<li>{}{}{}</li>\n", what.empty() ? "" : fmt::format("<b>{}</b> ", printed(what)), printed(about),
                    target.empty() ? "" : fmt::format(" <a href=\"#{}\">What that means</a>", target));
  }
  return fmt::format("<section class=\"verdict {}{}\">\n<h2>{}</h2>\n{}{}</section>\n", class_of(page.tone),
                     page.stamped ? " stamped" : "", printed(page.verdict_heading), answer_and_rest(page.verdict),
                     findings.empty() ? "" : "<ul>\n" + findings + "</ul>\n");
}

struct Origin {
  std::string command{};
  std::string version{};
};

Origin& origin_of_pages() {
  static Origin origin;
  return origin;
}

std::string made_by(const Page& page) {
  const auto& [typed, version] = origin_of_pages();
  const std::string& command = page.command.empty() ? typed : page.command;
  const std::string by = page.command.empty() && !version.empty() ? ", Fantail " + escape_html(version) : "";
  return command.empty() ? "" : fmt::format("<p>Made by <code>{}</code>{}.</p>\n", escape_html(command), by);
}

constexpr std::string_view replacement = "\uFFFD";

std::string footer(const Page& page, std::string_view content_html) {
  std::string text = (page.footer.empty() ? "" : paragraph(page.footer)) + made_by(page);
  if (content_html.find(replacement) != std::string_view::npos || text.find(replacement) != std::string::npos) {
    text += paragraph("\uFFFD stands for a byte that is not text in UTF-8, as names of files can have.");
  }
  return text.empty() ? "" : fmt::format("<footer>\n{}</footer>\n", text);
}

// A column of these beside others would be a narrow and very high one on a telephone.
bool has_sentences(std::span<const Column> columns, std::span<const std::vector<Cell>> rows) {
  constexpr std::size_t sentence = 36;
  constexpr std::size_t beside_each_other = 3;
  return columns.size() > beside_each_other && std::ranges::any_of(rows, [](const std::vector<Cell>& row) {
           return std::ranges::any_of(row | std::views::drop(1),
                                      [](const Cell& cell) { return cell.text.size() > sentence; });
         });
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

// For charts to be zoomed and folds to be opened on paper.
std::string chart_scripts(std::string_view content_html) {
  const bool any = content_html.find(" data-frame=") != std::string_view::npos ||
                   content_html.find("<details>") != std::string_view::npos;
  return any ? fmt::format("<script>\n{}</script>\n", chart_js) : "";
}

// Of the svg itself, beside those that it has.
std::string with_class(std::string_view svg, std::string_view name) {
  constexpr std::string_view begin = "<svg class=\"";
  return svg.starts_with(begin) ? fmt::format("{}{} {}", begin, name, svg.substr(begin.size())) : std::string{svg};
}

}  // namespace

std::string inner_html(const Page& page) { return header(page) + verdict(page) + page.body_html; }

std::string html(const Page& page) {
  const std::string title = escape_html(page.title);
  const std::string kind = escape_html(page.kind);
  const std::string content = inner_html(page);
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{}{}{}</title>\n<style>{}{}{}</style>\n</head>\n"
      "<body>\n<main>\n{}{}</main>\n{}{}</body>\n</html>\n",
      title, title.empty() || kind.empty() ? "" : " \u00b7 ", kind, page.live.charts.empty() ? "" : uplot_css,
      chart_css, page_css, content, footer(page, content), chart_scripts(content), live_scripts(page.live));
}

void set_made_by(std::string command, std::string version) {
  origin_of_pages() = {std::move(command), std::move(version)};
}

const std::string& made_by_command() { return origin_of_pages().command; }

std::string escape_html(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    std::size_t length = 1;
    switch (text.front()) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      case '\n':
      case '\r':
      case '\t': out += text.front(); break;
      default:
        length = text::printable_character(text);
        out += length > 0 ? text.substr(0, length) : replacement;
        length = std::max<std::size_t>(length, 1);
    }
    text.remove_prefix(length);
  }
  return out;
}

std::string printed(std::string_view text) { return text::with_minus(escape_html(text)); }

std::string escape_script_json(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

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
