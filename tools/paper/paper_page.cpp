// SPDX-License-Identifier: MIT
#include "paper/paper_page.hpp"

#include <vector>

#include <fmt/core.h>

#include "json/value.hpp"
#include "page/page.hpp"
#include "paper/printed_figures.hpp"
#include "paper/printed_sentences.hpp"

namespace fantail::paper {
namespace {

page::Tone tone(Finding finding) {
  switch (finding) {
    case Finding::reproduced: return page::Tone::good;
    case Finding::differs: return page::Tone::bad;
    case Finding::error_in_print: return page::Tone::unsure;
    case Finding::not_reproducible: break;
  }
  return page::Tone::plain;
}

std::string claim_table(std::span<const Claim> claims) {
  static const std::vector<page::Column> columns{{"Where"},      {"What"},    {"Printed"}, {"Ours"},
                                                 {"Difference"}, {"Finding"}, {"Basis"},   {"Remark"}};
  std::vector<std::vector<page::Cell>> rows;
  for (const Claim& claim : claims) {
    rows.push_back({{claim.place},
                    {claim.what},
                    {claim.theirs},
                    {claim.ours},
                    {claim.difference},
                    {std::string{words(claim.finding)}, tone(claim.finding)},
                    {std::string{words(claim.basis)}},
                    {claim.why}});
  }
  return page::table(columns, rows);
}

std::string chapter_html(const Chapter& chapter) {
  return page::section(chapter.title, page::paragraph(chapter.introduction) + claim_table(chapter.claims) +
                                          page::side_by_side(chapter.figures_html));
}

std::string figure_table() {
  static const std::vector<page::Column> columns{{"Figure"}, {"Shows"}, {"On this page"}};
  std::vector<std::vector<page::Cell>> rows;
  rows.reserve(std::size(printed_figures));
  for (const PrintedFigure& figure : printed_figures) {
    rows.push_back({{std::string{figure.number}}, {std::string{figure.shows}}, {std::string{figure.here}}});
  }
  return page::table(columns, rows);
}

std::vector<page::Figure> tally_figures(const Tally& count) {
  return {{.label = "Reproduced",
           .value = std::to_string(count.reproduced),
           .unit = "",
           .remark = fmt::format("{} derived from the print, {} fitted to it, {} round trips", count.reproduced_derived,
                                 count.reproduced_fitted, count.reproduced_round_trip)},
          {.label = "Different", .value = std::to_string(count.differs), .unit = "", .remark = "with the reason"},
          {.label = "Errors in print",
           .value = std::to_string(count.error_in_print),
           .unit = "",
           .remark = "with what it must read"},
          {.label = "Without the data",
           .value = std::to_string(count.not_reproducible),
           .unit = "",
           .remark = "not reproducible"}};
}

std::string basis_text() {
  return "\u201cDerived from the print\u201d: worked out from other printed numbers, so an agreement confirms them. "
         "\u201cFitted to the print\u201d: motor, drag area, reference area or the way to count height were chosen to "
         "meet this number, so an agreement shows that one model can meet them together. \u201cRound trip\u201d: put "
         "into our simulator and found again, so an agreement tests our analysis and says nothing of the measurement.";
}

std::string sentence_table() {
  static const std::vector<page::Column> columns{{"Where"}, {"Numbers"}, {"On this page"}};
  std::vector<std::vector<page::Cell>> rows;
  rows.reserve(std::size(printed_sentences));
  for (const PrintedSentence& sentence : printed_sentences) {
    rows.push_back({{std::string{sentence.place}}, {std::string{sentence.numbers}}, {std::string{sentence.here}}});
  }
  return page::table(columns, rows);
}

void count_reproduced(Tally& count, Basis basis) {
  ++count.reproduced;
  switch (basis) {
    case Basis::derived: ++count.reproduced_derived; break;
    case Basis::fitted: ++count.reproduced_fitted; break;
    case Basis::round_trip: ++count.reproduced_round_trip; break;
    case Basis::none: break;
  }
}

}  // namespace

Tally tally(std::span<const Chapter> chapters) {
  Tally count;
  for (const Chapter& chapter : chapters) {
    for (const Claim& claim : chapter.claims) {
      switch (claim.finding) {
        case Finding::reproduced: count_reproduced(count, claim.basis); break;
        case Finding::differs: ++count.differs; break;
        case Finding::not_reproducible: ++count.not_reproducible; break;
        case Finding::error_in_print: ++count.error_in_print; break;
      }
    }
  }
  return count;
}

std::string summary(const Tally& count) {
  return fmt::format(
      "Of what was printed, {} statements are reproduced: {} are derived from other printed numbers, {} are met by a "
      "simulation that was fitted to them, and {} are round trips through our own simulator. {} came out differently, "
      "{} are slips of the print, and {} rest on measurements that were not published.",
      count.reproduced, count.reproduced_derived, count.reproduced_fitted, count.reproduced_round_trip, count.differs,
      count.error_in_print, count.not_reproducible);
}

std::string paper_html(std::span<const Chapter> chapters, const std::string& version) {
  const Tally count = tally(chapters);
  std::string body =
      page::section("How it came out", page::figure_row(tally_figures(count)) + page::paragraph(basis_text()));
  for (const Chapter& chapter : chapters) {
    body += chapter_html(chapter);
  }
  body += page::section("Printed numbers without a row above", sentence_table());
  body += page::section("The printed figures and tables", figure_table());
  return page::html({.kind = "Fantail reproduction report",
                     .title = "Vertical Wind Tunnel for Prediction of Rocket Flight Dynamics",
                     .subtitle = "Bryson et al., Aerospace 2016, 3(2), 10, repeated with Fantail " + version +
                                 ". Every number under \u201cOurs\u201d was worked out when this page was made.",
                     .tone = count.differs == 0 ? page::Tone::good : page::Tone::unsure,
                     .verdict_heading = "Summary",
                     .verdict = summary(count),
                     .body_html = body});
}

std::string paper_json(std::span<const Chapter> chapters, const std::string& version) {
  const Tally count = tally(chapters);
  json::Value claims = json::Value::array();
  for (const Chapter& chapter : chapters) {
    for (const Claim& claim : chapter.claims) {
      claims.push_back({{"chapter", chapter.title},
                        {"place", claim.place},
                        {"what", claim.what},
                        {"theirs", claim.theirs},
                        {"ours", claim.ours},
                        {"difference", claim.difference},
                        {"finding", name(claim.finding)},
                        {"basis", name(claim.basis)},
                        {"why", claim.why}});
    }
  }
  const json::Value all{{"reproduced", count.reproduced},
                        {"reproduced_derived", count.reproduced_derived},
                        {"reproduced_fitted", count.reproduced_fitted},
                        {"reproduced_round_trip", count.reproduced_round_trip},
                        {"differs", count.differs},
                        {"error_in_print", count.error_in_print},
                        {"not_reproducible", count.not_reproducible},
                        {"claims", claims},
                        {"version", version}};
  return all.pretty();
}

}  // namespace fantail::paper
