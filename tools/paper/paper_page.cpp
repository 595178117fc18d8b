// SPDX-License-Identifier: MIT
#include "paper/paper_page.hpp"

#include <algorithm>
#include <vector>

#include <fmt/core.h>

#include "json/value.hpp"
#include "page/page.hpp"
#include "paper/printed_figures.hpp"

namespace fantail::paper {
namespace {

page::Tone tone(const Claim& claim) {
  if (!claim.agrees) {
    return page::Tone::bad;
  }
  if (counts_as_reproduced(claim.kind)) {
    return page::Tone::good;
  }
  return claim.kind == Kind::error_in_print ? page::Tone::unsure : page::Tone::plain;
}

std::string claim_table(std::span<const Claim> claims) {
  static const std::vector<page::Column> columns{{"Where"},      {"What"}, {"Printed"}, {"Ours"},
                                                 {"Difference"}, {"Kind"}, {"Remark"}};
  std::vector<std::vector<page::Cell>> rows;
  for (const Claim& claim : claims) {
    rows.push_back({{claim.place},
                    {claim.what},
                    {claim.theirs},
                    {claim.ours},
                    {claim.difference},
                    {kind_words(claim), tone(claim)},
                    {claim.why}});
  }
  return page::table(columns, rows);
}

std::string chapter_html(const Chapter& chapter) {
  std::vector<Claim> shown;
  std::vector<Claim> folded;
  for (const Claim& claim : chapter.claims) {
    (is_folded(claim) ? folded : shown).push_back(claim);
  }
  const auto differs = std::ranges::count_if(chapter.claims, [](const Claim& claim) { return !claim.agrees; });
  const std::string tables = (shown.empty() ? "" : claim_table(shown)) +
                             (folded.empty() ? "" : page::on_demand(folded_words(folded), claim_table(folded)));
  return page::section(chapter.title,
                       page::paragraph(chapter.introduction) +
                           page::on_demand(fmt::format("{} statements, {} different", chapter.claims.size(), differs),
                                           tables + page::side_by_side(chapter.figures_html)));
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
  const auto figure = [](const char* label, std::size_t value, std::string remark) {
    return page::Figure{.label = label, .value = std::to_string(value), .unit = "", .remark = std::move(remark)};
  };
  return {figure("Reproduced", count.reproduced(),
                 fmt::format("{} computed, {} simulated, {} described", count.of(Kind::computed),
                             count.of(Kind::simulated), count.of(Kind::described))),
          figure("Fitted", count.of(Kind::fitted), "our inputs were chosen to meet them"),
          figure("Read back", count.of(Kind::read_back), "round trips"),
          figure("Different", count.differs, "with the reason"),
          figure("Errors in print", count.of(Kind::error_in_print), "with the correct reading"),
          figure("Not reproducible", count.of(Kind::not_reproducible), "an input is not printed"),
          figure("Taken or outside", count.of(Kind::definition) + count.of(Kind::outside),
                 fmt::format("{} definitions and inputs, {} outside the model", count.of(Kind::definition),
                             count.of(Kind::outside)))};
}

}  // namespace

std::size_t Tally::reproduced() const {
  std::size_t sum = 0;
  for (const Kind kind : kinds) {
    sum += counts_as_reproduced(kind) ? of(kind) : 0;
  }
  return sum;
}

Tally tally(std::span<const Chapter> chapters) {
  Tally count;
  for (const Chapter& chapter : chapters) {
    for (const Claim& claim : chapter.claims) {
      ++(claim.agrees ? count.agreeing[place_of(claim.kind)] : count.differs);
    }
  }
  return count;
}

std::string summary(const Tally& count) {
  return fmt::format(
      "{} printed statements are reproduced: {} computed from other printed numbers, {} simulated, {} described in "
      "words "
      "and seen here. Not counted: {} that our inputs were fitted to, {} read back from our own simulator, {} taken as "
      "printed, {} outside the model. {} came out differently, {} are errors in print, and {} need data that are not "
      "printed.",
      count.reproduced(), count.of(Kind::computed), count.of(Kind::simulated), count.of(Kind::described),
      count.of(Kind::fitted), count.of(Kind::read_back), count.of(Kind::definition), count.of(Kind::outside),
      count.differs, count.of(Kind::error_in_print), count.of(Kind::not_reproducible));
}

std::string folded_words(std::span<const Claim> claims) {
  std::string said;
  for (const Kind kind : kinds) {
    const auto count =
        std::ranges::count_if(claims, [kind](const Claim& claim) { return claim.kind == kind && is_folded(claim); });
    if (count > 0) {
      said += fmt::format("{}{} {}", said.empty() ? "Rows: " : ", ", count, words(kind));
    }
  }
  return said;
}

std::string paper_html(std::span<const Chapter> chapters, const std::string& version) {
  const Tally count = tally(chapters);
  std::string body =
      page::section("How it came out", page::figure_row(tally_figures(count)) +
                                           page::on_demand("What the kinds mean", page::paragraph(rule_text())));
  for (const Chapter& chapter : chapters) {
    body += chapter_html(chapter);
  }
  body += page::section("The printed figures and tables", page::on_demand("Which is drawn where", figure_table()));
  return page::html({.kind = "Fantail reproduction report",
                     .title = "Vertical Wind Tunnel for Prediction of Rocket Flight Dynamics",
                     .subtitle = "Bryson et al., Aerospace 2016, 3(2), 10, repeated with Fantail " + version +
                                 ". Every number under \u201cOurs\u201d was worked out when this page was made.",
                     .tone = count.differs == 0 ? page::Tone::good : page::Tone::unsure,
                     .verdict_heading = count.differs == 0 ? "Reproduced" : fmt::format("{} different", count.differs),
                     .verdict = summary(count),
                     .body_html = body});
}

std::string paper_json(std::span<const Chapter> chapters, const std::string& version, const result::Made& made) {
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
                        {"finding", finding(claim)},
                        {"basis", basis(claim)},
                        {"kind", name(claim.kind)},
                        {"why", claim.why}});
    }
  }
  json::Value by_kind;
  for (const Kind kind : kinds) {
    by_kind[std::string{name(kind)}] = count.of(kind);
  }
  // Fitted and read-back statements are counted under "kinds"; among the reproduced there are none.
  json::Value all{{"reproduced", count.reproduced()},
                  {"reproduced_derived", count.of(Kind::computed)},
                  {"reproduced_simulated", count.of(Kind::simulated)},
                  {"reproduced_described", count.of(Kind::described)},
                  {"reproduced_fitted", 0},
                  {"reproduced_round_trip", 0},
                  {"differs", count.differs},
                  {"error_in_print", count.of(Kind::error_in_print)},
                  {"not_reproducible", count.of(Kind::not_reproducible)},
                  {"kinds", by_kind},
                  {"claims", claims},
                  {"version", version}};
  result::put_answer(all, count.differs == 0 ? result::Answer::yes : result::Answer::no, summary(count), made);
  return all.pretty();
}

}  // namespace fantail::paper
