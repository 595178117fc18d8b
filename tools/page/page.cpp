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

// For charts to be zoomed and folds to be opened on paper.
std::string chart_scripts(std::string_view content_html) {
  const bool any = content_html.find("<svg class=\"curves\"") != std::string_view::npos ||
                   content_html.find("<details>") != std::string_view::npos;
  return any ? fmt::format("<script>\n{}</script>\n", chart_js) : "";
}

}  // namespace

std::string_view class_of(Tone tone) {
  switch (tone) {
    case Tone::good: return "good";
    case Tone::bad: return "bad";
    case Tone::unsure: return "unsure";
    case Tone::plain: break;
  }
  return "plain";
}

std::string unless_empty(std::string_view tag, std::string_view kind, std::string_view text) {
  return text.empty() ? "" : fmt::format("<{0} class=\"{1}\">{2}</{0}>\n", tag, kind, printed(text));
}

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
      title, title.empty() || kind.empty() ? "" : " \u00b7 ", kind, page.live ? uplot_css : "", chart_css, page_css,
      content, footer(page, content), page.stamped ? "" : chart_scripts(content),
      page.live ? live_scripts(*page.live) : "");
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

}  // namespace fantail::page
