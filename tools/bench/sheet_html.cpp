// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string_view>

#include <fmt/core.h>

#include "bench/page_assets.hpp"
#include "bench/sheet.hpp"
#include "bench/sheet_cells.hpp"
#include "bench/sheet_charts.hpp"
#include "core/tick_record.hpp"
#include "report/escape.hpp"
#include "report/numbers.hpp"

namespace fantail::bench {
namespace {

using report::escape_html;
using report::with_minus;

std::string head(const Sheet& sheet) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{} \u00b7 {} \u00b7 Fantail bench</title>\n<style>{}</style>\n</head>\n",
      escape_html(sheet.heading.vehicle), sheet_title(sheet.kind), sheet_css);
}

std::string fact(std::string_view label, const std::string& value) {
  return value.empty() ? std::string{} : fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", label, escape_html(value));
}

std::string opening(const Sheet& sheet) {
  const Heading& h = sheet.heading;
  std::string page =
      fmt::format("<header>\n<p class=\"kind\">Fantail bench \u00b7 {}</p>\n<h1>{}</h1>\n<dl>\n",
                  sheet_title(sheet.kind), escape_html(h.vehicle.empty() ? "Unnamed rocket" : h.vehicle));
  page += fact("Plan", h.plan) + fact("Plan CRC-32C", h.plan_crc) + fact("Date", h.date) + fact("Avionics", h.avionics);
  page += "</dl>\n</header>\n";
  page += fmt::format("<section class=\"verdict {}\">\n<p class=\"word\">{}</p>\n<ul>\n",
                      sheet.passed() ? "pass" : "fail", sheet.passed() ? "PASS" : "FAIL");
  for (const std::string& conclusion : conclusions(sheet)) {
    std::string text = with_minus(escape_html(conclusion));
    // The finding is bold, up to the colon that the numbers follow.
    if (const std::size_t colon = text.find(": "); text.starts_with("Canard ") && colon != std::string::npos) {
      text = fmt::format("<b>{}</b>{}", text.substr(0, colon + 1), text.substr(colon + 1));
    }
    page += fmt::format("<li>{}</li>\n", text);
  }
  return page + "</ul>\n</section>\n";
}

std::string cell(const std::string& text, bool passed, std::string_view tag) {
  const std::string shown = text == "none" ? "\u2013" : text == "-" ? "\u2212" : with_minus(text);
  return passed ? fmt::format("<{0}>{1}</{0}>", tag, shown)
                : fmt::format("<{0} class=\"bad\">\u2717&nbsp;{1}</{0}>", tag, shown);
}

std::string table(const Sheet& sheet) {
  std::string page = "<section>\n<h2>Figures</h2>\n<table>\n<thead><tr><th></th><th class=\"allowed\">Allowed</th>";
  bool two_turns = false;
  for (const CanardResult& result : sheet.canards) {
    page += fmt::format("<th>Canard {}</th>", result.canard + 1);
    two_turns = two_turns || (result.alone && result.together);
  }
  page += "</tr></thead>\n<tbody>\n<tr class=\"cause\"><th>Finding</th><td></td>";
  for (const CanardResult& result : sheet.canards) {
    std::string cause{name(result.diagnosis.cause)};
    std::ranges::replace(cause, '_', ' ');
    page += fmt::format("<td class=\"{}\">{}</td>", result.passed() ? "good" : "bad", cause);
  }
  page += "</tr>\n";
  for (const SheetRow& row : sheet_rows(sheet)) {
    page += fmt::format("<tr><th>{}{}</th><td class=\"allowed\">{}</td>", row.label,
                        row.unit.empty() ? "" : fmt::format(" <span>{}</span>", row.unit), with_minus(row.allowed));
    for (const Cell& one : row.cells) {
      page += fmt::format("<td>{}{}</td>", cell(one.alone, one.alone_passed, "b"),
                          one.together.empty() ? "" : cell(one.together, one.together_passed, "small"));
    }
    page += "</tr>\n";
  }
  std::string monitors;
  bool any = false;
  for (const CanardResult& result : sheet.canards) {
    const auto& verdict = sheet.heading.monitor[result.canard];
    any = any || verdict;
    monitors += fmt::format("<td>{}</td>", verdict ? core::name(*verdict) : "");
  }
  if (any) {
    page += "<tr class=\"aside\"><th>Avionics\u2019 own verdict</th><td class=\"allowed\">not judged</td>" + monitors +
            "</tr>\n";
  }
  page += "</tbody>\n</table>\n";
  page += two_turns ? "<p class=\"note\">Upper figure: moving alone. Lower figure: all four together. Times come from "
                      "the avionics\u2019 own millisecond counter.</p>\n"
                    : "<p class=\"note\">Times come from the avionics\u2019 own millisecond counter.</p>\n";
  page += "<ul class=\"general\">\n";
  for (const GeneralCheck& check : sheet.general) {
    page +=
        fmt::format("<li class=\"{}\">{}</li>\n", check.passed ? "good" : "bad", with_minus(escape_html(check.text)));
  }
  return page + "</ul>\n</section>\n";
}

std::string closing(const Sheet& sheet) {
  std::string page;
  if (!sheet.heading.notes.empty()) {
    page += "<section class=\"keep\">\n<h2>Notes</h2>\n<ul class=\"notes\">\n";
    for (const std::string& note : sheet.heading.notes) {
      page += fmt::format("<li>{}</li>\n", escape_html(note));
    }
    page += "</ul>\n</section>\n";
  }
  page += "<section class=\"sign keep\">\n<p>Name</p><p>Date</p><p>Signature</p>\n</section>\n";
  return page + fmt::format("<footer>Fantail {}</footer>\n", escape_html(sheet.heading.version));
}

}  // namespace

std::string sheet_html(const Sheet& sheet, const link::Recording& recording, const Exercise& exercise) {
  std::string page = head(sheet) + "<body>\n<main>\n" + opening(sheet) + table(sheet);
  for (const CanardResult& result : sheet.canards) {
    page += fmt::format(
        "<section class=\"canard\">\n<h2>Canard {} <span class=\"{}\">{}</span>"
        "<span class=\"key\"><i class=\"command\"></i>command <i "
        "class=\"encoder\"></i>encoder</span></h2>\n{}</section>\n",
        result.canard + 1, result.passed() ? "good" : "bad", words(result.diagnosis.cause),
        canard_charts(result, sheet, recording, exercise));
  }
  return page + closing(sheet) + "</main>\n</body>\n</html>\n";
}

}  // namespace fantail::bench
