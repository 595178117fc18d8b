// SPDX-License-Identifier: MIT
#include "result/document.hpp"

#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace fantail::result {
namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

struct Flight {
  std::size_t canard = 0;
  double turned_rad = 0.0;
  std::optional<double> apogee_m{};
  double limited_share = 0.0;
  Spread speed_m_s{};
  Share held{};
  std::string cause{};
};

constexpr auto flight_fields = fields<Flight>({
    {"canard", "canard", units::none, 0, &Flight::canard, "a figure"},
    {"turned", "way turned", units::deg, 1, &Flight::turned_rad, "the largest angle to the other one", Worse::larger},
    {"apogee", "apogee", units::m, 0, &Flight::apogee_m, "a figure", Worse::smaller},
    {"limited", "time at the limit", units::share, 0, &Flight::limited_share, "a figure"},
    {"speed", "speed", units::m_s, 1, &Flight::speed_m_s, "a figure"},
    {"held", "held", units::percent, 0, &Flight::held, "a figure"},
    {"cause", "cause", units::none, 0, &Flight::cause, "a figure"},
});

Flight quarter_turn() {
  return {.canard = 3,
          .turned_rad = std::numbers::pi / 2,
          .apogee_m = 1234.56,
          .limited_share = 0.254,
          .speed_m_s = {.mean = 21.0, .p5 = 19.96, .p50 = 20.04, .p95 = 25.0},
          .held = {.count = 9, .of = 10, .value = 0.9, .low = 0.598, .high = 0.982},
          .cause = "stuck, \"bent\""};
}

Document document_of(std::vector<Block> blocks) {
  return {
      .title = "a rocket",
      .subtitle = "a plan",
      .verdict = {.answer = Answer::no, .heading = "No go", .sentence = "No go: it turns."},
      .sections = {{"Found", std::move(blocks)}},
      .made = {.command = "fantail x", .version = "1", .seed = 7, .changes = {"a.b=c"}, .inputs = {{"p.toml", "ab"}}}};
}

TEST(Document, AFigureIsOneFieldInEveryOutput) {
  const Document document = document_of({figures("", quarter_turn(), flight_fields)});
  const json::Value data = json::parse(json(document));
  EXPECT_EQ(data["turned_deg"], 90.0);
  EXPECT_EQ(data["apogee_m"], 1234.56);
  EXPECT_EQ(data["limited_share"], 0.254);
  EXPECT_EQ(data["speed_m_s"]["p5"], 19.96);
  EXPECT_EQ(data["held"]["count"], 9);
  const std::string shown = text(document);
  const std::string page = html(document);
  for (const std::string& all : {shown, page}) {
    for (const char* const part : {"way turned", "90.0", "1235", "25", "20.0 to 25.0"}) {
      EXPECT_TRUE(holds(all, part)) << part << " in\n" << all;
    }
  }
  EXPECT_TRUE(holds(shown, "  time at the limit  25 %\n")) << shown;
  EXPECT_EQ(csv(table("flights", std::vector{quarter_turn()}, flight_fields)),
            "canard,turned_deg,apogee_m,limited_share,speed_p5_m_s,speed_p50_m_s,speed_p95_m_s,held,cause\n"
            "3,90.000000,1234.560000,0.254000,19.960000,20.040000,25.000000,90 (9 of 10),\"stuck, \"\"bent\"\"\"\n");
}

TEST(Document, AnIntervalNeverLooksNarrowerThanItIs) {
  const std::string shown = text(document_of({figures("", quarter_turn(), flight_fields)}));
  EXPECT_TRUE(holds(shown, "90 % (9 of 10; 95 % interval 59 to 99)")) << shown;
}

TEST(Document, AValueThatIsUnknownIsNullForProgramsAndLeftOutForPeople) {
  Flight flight = quarter_turn();
  flight.apogee_m.reset();
  const Document document = document_of({figures("", flight, flight_fields)});
  EXPECT_TRUE(json::parse(json(document))["apogee_m"].is_null());
  EXPECT_FALSE(holds(text(document), "apogee"));
  EXPECT_FALSE(holds(html(document), "apogee"));
  EXPECT_TRUE(csv(table("x", std::vector{flight}, flight_fields))
                  .ends_with("\n3,90.000000,,0.254000,19.960000,20.040000,25.000000,"
                             "90 (9 of 10),\"stuck, \"\"bent\"\"\"\n"));
}

TEST(Document, ANameIsAKeyForProgramsAndWordsOnAPageAndASecondLineStandsThereAlone) {
  const Table found{.key = "found",
                    .columns = {{.key = "figure", .label = "figure"}, {.key = "result", .label = "result"}},
                    .rows = {{Named{"apogee_m", "apogee / m"}, Judged{Answer::no, "not met", "run 7"}},
                             {Named{"top_mach", "top Mach"}, Digits{"0.79", Answer::yes, "run 8"}}}};
  const Document document = document_of({found, Links{{{"run_7/report.html", "run 7", ": not held"}, {"", "run 8"}}}});
  EXPECT_EQ(json::parse(json(document))["found"][0]["figure"], "apogee_m");
  EXPECT_TRUE(
      holds(text(document), "  apogee_m  not met\n  top_mach  0.79\n  run 7: not held, run_7/report.html\n  run 8\n"))
      << text(document);
  const std::string page = html(document);
  for (const char* const part : {"apogee / m<small>apogee_m</small>", "not met<small>run 7</small>", "0.79<small>run 8",
                                 "<a href=\"run_7/report.html\">run 7</a>: not held", "<li>run 8</li>"}) {
    EXPECT_TRUE(holds(page, part)) << part << " in\n" << page;
  }
}

TEST(Document, EveryJsonHasAnswerSentenceAndHowItWasMade) {
  const json::Value data = json::parse(json(document_of({})));
  EXPECT_EQ(data["answer"], "no");
  EXPECT_EQ(data["sentence"], "No go: it turns.");
  EXPECT_EQ(data["made"]["command"], "fantail x");
  EXPECT_EQ(data["made"]["seed"], 7);
  EXPECT_EQ(data["made"]["changes"][0], "a.b=c");
  EXPECT_EQ(data["made"]["inputs"][0]["file"], "p.toml");
  EXPECT_EQ(data["made"]["inputs"][0]["sha256"], "ab");
  Document drawn = document_of({});
  drawn.made.seed = 18446744073709551615U;
  EXPECT_EQ(json::parse(json(drawn))["made"]["seed_text"], "18446744073709551615");
  drawn.made.seed.reset();
  EXPECT_TRUE(json::parse(json(drawn))["made"]["seed"].is_null());
}

struct Swing {
  double frequency_rad_s = 0.0;
  double reach_rad_s = 0.0;
};
constexpr auto swing_fields = fields<Swing>({
    {"frequency", "frequency", units::rad_s, 2,
     [](const Swing& s) { return Cell{Estimate{s.frequency_rad_s, s.reach_rad_s}}; }, "a figure"},
    {"period", "period", units::s, 2, [](const Swing& s) { return Cell{6.0 / s.frequency_rad_s}; }, "a figure"},
    {"lot", "lot", units::none, 0, [](const Swing&) { return Cell{Digits{"7 or more"}}; }, "a figure"},
});

TEST(Document, AnEstimateHasItsIntervalInEveryOutput) {
  const Table swings = table("swings", std::vector{Swing{2.0, 0.125}, Swing{0.0, 0.0}}, swing_fields);
  Document document = document_of({swings});
  document.json_decimals = 2;
  const json::Value first = json::parse(json(document))["swings"][0];
  EXPECT_EQ(first["frequency_rad_s"]["value"], 2.0);
  EXPECT_EQ(first["frequency_rad_s"]["low_95"], 1.88) << "two decimals";
  EXPECT_EQ(first["frequency_rad_s"]["high_95"], 2.13);
  EXPECT_EQ(first["lot"], "7 or more");
  EXPECT_TRUE(json::parse(json(document))["swings"][1]["period_s"].is_null()) << "an infinite one";
  EXPECT_TRUE(holds(text(document),
                    "  frequency, rad/s     period, s        lot\n"
                    "       2.00 ± 0.12          3.00  7 or more\n"))
      << text(document);
  EXPECT_TRUE(holds(html(document), "2.00<small>± 0.12</small>")) << html(document);
  EXPECT_EQ(csv(only(swings, {"lot", "frequency"})), "lot,frequency_rad_s\n7 or more,2.000000\n7 or more,0.000000\n");
}

struct Damping {
  Uncertain alpha_m2{};
  Range interval_m2{};
};
constexpr auto damping_fields = fields<Damping>({
    {"alpha", "damping", units::m2, 0, [](const Damping& d) { return Cell{d.alpha_m2}; }, "a figure"},
    {"interval", "95 %", units::m2, 0, [](const Damping& d) { return Cell{d.interval_m2}; }, "a figure"},
});

TEST(Document, ADeviationSaysWithHowManyDigitsANumberIsRead) {
  const Column column{.unit = units::m2};
  for (const auto& [cell, as_read] :
       std::vector<std::pair<Cell, std::string>>{{Uncertain{22.871, 0.41}, "22.87 ± 0.41"},
                                                 {Uncertain{9.05, 0.052}, "9.050 ± 0.052"},
                                                 {Uncertain{0.0019271, 0.0000034}, "0.0019271 ± 0.0000034"},
                                                 {Uncertain{22.871, 0.0}, "22.8710"},
                                                 {Range{22.1, 23.72}, "22.10 to 23.72"},
                                                 {Range{0.0019199, 0.0019341}, "0.0019199 to 0.0019341"},
                                                 {Range{12.0, {}}, "above 12.00"},
                                                 {Range{{}, 30.0}, "below 30.0"},
                                                 {Range{}, "without bounds"}}) {
    EXPECT_EQ(shown(column, cell), as_read);
  }
  EXPECT_EQ(shown({.unit = units::deg}, Uncertain{-0.1, 0.002}), "-5.73 ± 0.11");
}

TEST(Document, ADeviationIsNoPartOfTheNumberInFiles) {
  const std::vector<Damping> all{{{22.8711111, 0.41}, {0.00012345678912, {}}}};
  Document document = document_of({figures("list.0", all.front(), damping_fields), Data{"list.1", "other"}});
  document.json_decimals = -8;
  const json::Value data = json::parse(json(document));
  EXPECT_EQ(data["list"][0]["alpha_m2"], 22.871111) << "eight digits";
  EXPECT_EQ(data["list"][0]["interval_m2"], (json::Value::array({0.00012345679, {}})));
  EXPECT_EQ(data["list"][1], "other");
  EXPECT_TRUE(holds(text(document), "  damping  22.87 m2 (± 0.41)\n")) << text(document);
  EXPECT_EQ(csv(only(table("x", all, damping_fields), {"alpha"})), "alpha_m2\n22.871111\n");
  document.facts = {{"", "air", "thin"}, {"rocket", "", "ours"}};
  EXPECT_TRUE(holds(text(document), "  air      thin\n")) << "for people alone";
  EXPECT_FALSE(holds(json(document), "thin"));
  EXPECT_FALSE(holds(text(document), "ours")) << "for programs alone";
}

TEST(Document, FiguresOfTwoThingsStandBesideEachOther) {
  Flight one = quarter_turn();
  Flight other = quarter_turn();
  one.apogee_m.reset();
  const auto figures_of = [](const Flight& flight) { return figures("", flight, flight_fields); };
  Document document = document_of({beside({{"the law", figures_of(one)}, {"the log", figures_of(other)}})});
  EXPECT_TRUE(holds(text(document), "  apogee, m                               -                 1235\n"))
      << text(document);
  other.apogee_m.reset();
  document = document_of({beside({{"the law", figures_of(one)}, {"the log", figures_of(other)}})});
  EXPECT_FALSE(holds(text(document), "apogee")) << "known of neither";
}

TEST(Document, APageFoldsASectionAndDrawsByHand) {
  Document document = document_of({Drawing{"<svg class=\"a\"></svg>", "<svg class=\"b\"></svg>", "To scale."}});
  EXPECT_TRUE(holds(html(document), "<figcaption>To scale.</figcaption>")) << html(document);
  EXPECT_FALSE(holds(html(document), "<details>"));
  document.sections.front().folded = "Show it";
  EXPECT_TRUE(holds(html(document), "<h2>Found</h2>\n<details><summary>Show it</summary>\n<figure>")) << html(document);
}

TEST(Document, APageHasThePictureBehindItsVerdictAndFoldsALongTable) {
  const std::vector<Flight> few(4, quarter_turn());
  const std::vector<Flight> many(5, quarter_turn());
  Document document = document_of({table("few", few, flight_fields)});
  document.sections.push_back({"Many", {table("many", many, flight_fields)}});
  document.sections.push_back({"Seen", {Picture{}}});
  const std::string page = html(document);
  EXPECT_LT(page.find("<h2>Seen</h2>"), page.find("<h2>Found</h2>"));
  EXPECT_LT(page.find("<h2>Found</h2>"), page.find("<h2>Many</h2>"));
  EXPECT_FALSE(holds(page.substr(0, page.find("<h2>Many</h2>")), "<details>"));
  EXPECT_TRUE(holds(page.substr(page.find("<h2>Many</h2>")), "<details><summary>Table: many (5 rows)</summary>"));
}

TEST(Document, ASectionWithNothingToShowHasNoHeading) {
  Document document = document_of({Sentences{"remarks"}, Table{.key = "rows"}, Figures{}});
  EXPECT_FALSE(holds(text(document), "Found"));
  EXPECT_FALSE(holds(html(document), "Found"));
  EXPECT_EQ(json::parse(json(document))["remarks"].size(), 0U);
  document.sections.front().blocks.emplace_back("Here.");
  EXPECT_TRUE(holds(text(document), "\nFound:\n  Here.\n")) << text(document);
}

TEST(Document, TwoBlocksWithOneKeyAreRefused) {
  const Figures once = figures("worst", quarter_turn(), flight_fields);
  EXPECT_THROW((void)json(document_of({once, once})), std::logic_error);
  EXPECT_THROW((void)json(document_of({Data{"answer", "yes"}})), std::logic_error);
  EXPECT_EQ(json::parse(json(document_of({figures("a.worst", quarter_turn(), flight_fields)})))["a"]["worst"]["canard"],
            3);
}

TEST(Document, TheWorstOfEachFigureMayStandInAnotherRow) {
  Flight other = quarter_turn();
  other.canard = 1;
  other.turned_rad = 0.1;
  other.apogee_m = 900.0;
  Flight unknown = other;
  unknown.apogee_m.reset();
  const Flight found = worst(std::vector{unknown, other, quarter_turn()}, flight_fields);
  EXPECT_EQ(found.canard, 1U) << "of a figure that cannot be worse the first";
  EXPECT_EQ(found.turned_rad, std::numbers::pi / 2);
  EXPECT_EQ(found.apogee_m, 900.0);
  EXPECT_EQ(meanings(found, flight_fields).front(), "Way turned: the largest angle to the other one.");
}

TEST(Document, TheAnswerColoursItsHeadingOnPageAndTerminal) {
  const auto paint = [](page::Tone tone, std::string_view words) {
    return (tone == page::Tone::bad      ? "<bad>"
            : tone == page::Tone::unsure ? "<unsure>"
                                         : "<>") +
           std::string{words} + "</>";
  };
  Document document = document_of({});
  EXPECT_TRUE(holds(text(document, paint), "\n<bad>No go</>: it turns.\n")) << text(document, paint);
  EXPECT_TRUE(holds(html(document), "<section class=\"verdict bad\">\n<h2>No go</h2>\n<p>It turns.</p>"))
      << html(document);
  document.verdict = {.answer = Answer::yes, .heading = "Go", .sentence = "Go: but near.", .with_caution = true};
  EXPECT_TRUE(holds(text(document, paint), "<unsure>Go</>")) << "a go with caution is not in the colour of a go";
  EXPECT_EQ(json::parse(json(document))["answer"], "yes");
}

TEST(Document, SectionsForProgramsOrFilesAreNotOnTheTerminal) {
  Document document = document_of({std::string{"for everybody"}});
  document.sections.push_back({"A long table", {std::string{"for pages"}}, Readers::files});
  document.sections.push_back({"Data", {figures("more", quarter_turn(), flight_fields)}, Readers::programs});
  document.sections.push_back({"Empty", {}});
  const std::string shown = text(document);
  EXPECT_TRUE(holds(shown, "Found:\n  for everybody\n"));
  EXPECT_FALSE(holds(shown, "for pages") || holds(shown, "Data") || holds(shown, "Empty")) << shown;
  const std::string page = html(document);
  EXPECT_TRUE(holds(page, "for pages"));
  EXPECT_FALSE(holds(page, "way turned") || holds(page, "Empty"));
  EXPECT_EQ(json::parse(json(document))["more"]["canard"], 3);
}

}  // namespace
}  // namespace fantail::result
