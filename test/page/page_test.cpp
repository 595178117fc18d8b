// SPDX-License-Identifier: MIT
#include "page/page.hpp"

#include "page/chart.hpp"
#include "test.hpp"

namespace fantail::page {
namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Page example() {
  return {.kind = "Fantail <kind>",
          .title = "a & b",
          .subtitle = "from \"there\"",
          .tone = Tone::bad,
          .verdict_heading = "No <go>",
          .verdict = "Offset -7 deg",
          .body_html = section("One", figure(svg(Chart{}), "A caption"))};
}

TEST(Page, LoadsNothingFromAnywhere) {
  const std::string page = html(example());
  for (const char* way :
       {"src=", "@import", "<link", "url(", "href", "fetch(", "import(", "XMLHttpRequest", "Socket"}) {
    EXPECT_FALSE(holds(page, way)) << way;
  }
}

TEST(Page, AScriptComesOnlyWithAChartOrAFold) {
  Page page = example();
  EXPECT_TRUE(holds(html(page), "<script>"));
  page.body_html = section("One", paragraph("Words."));
  EXPECT_FALSE(holds(html(page), "<script>"));
  page.body_html = on_demand("More", paragraph("Words."));
  EXPECT_TRUE(holds(html(page), "beforeprint")) << "or paper would not have what is folded";
}

TEST(Page, TheFirstSentenceOfAVerdictStandsAlone) {
  Page page = example();
  page.verdict = "Roll is held in 5 % of 3.5 m runs. The rest is not. It was tried.";
  EXPECT_TRUE(holds(html(page), "<p>Roll is held in 5 % of 3.5 m runs.</p>\n<p>The rest is not. It was tried.</p>"));
}

TEST(Page, IsWholeAndEscaped) {
  const std::string page = html(example());
  EXPECT_EQ(page.find("<!doctype html>"), 0U);
  EXPECT_TRUE(holds(page, "<title>a &amp; b \u00b7 Fantail &lt;kind&gt;</title>"));
  EXPECT_TRUE(holds(page, "<h1>a &amp; b</h1>"));
  EXPECT_TRUE(holds(page, "from &quot;there&quot;"));
  EXPECT_TRUE(holds(page, "<section class=\"verdict bad\">\n<h2>No &lt;go&gt;</h2>\n<p>Offset \u22127 deg</p>"));
  EXPECT_TRUE(holds(page, "prefers-color-scheme: dark"));
  EXPECT_TRUE(holds(page, "@media print"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
}

TEST(Page, WhatNoPageMayHaveIsReplacedAndSaid) {
  EXPECT_EQ(escape_html("fl\xFCg \xC3\xBC \xF0\x9F\x9A\x80\xF0\x9F"), "fl\uFFFDg \u00FC \U0001F680\uFFFD\uFFFD");
  EXPECT_EQ(escape_html(std::string_view{"a\0b\x1B[31m\x7F\tc\nd\r\n", 15}), "a\uFFFDb\uFFFD[31m\uFFFD\tc\nd\r\n");
  EXPECT_EQ(escape_html("\xED\xA0\x80 \xC0\xAF \xC2\x85"), "\uFFFD\uFFFD\uFFFD \uFFFD\uFFFD \uFFFD\uFFFD")
      << "half a character, one in too many bytes, a control character";
  Page page = example();
  EXPECT_FALSE(holds(html(page), "\uFFFD"));
  page.facts = {{"Log", "fl\xFCg.csv"}};
  EXPECT_TRUE(holds(html(page), "<dd>fl\uFFFDg.csv</dd>"));
  EXPECT_TRUE(holds(html(page), "\uFFFD stands for a byte that is not text in UTF-8, as names of files can have."));
}

TEST(Page, WithoutAVerdictThereIsNone) {
  Page page = example();
  page.verdict_heading.clear();
  EXPECT_FALSE(holds(html(page), "<section class=\"verdict"));
}

TEST(Page, FactsAndFindingsStandWithTitleAndVerdict) {
  Page page = example();
  page.facts = {{"Plan", "p<1>"}, {"Date", ""}};
  page.findings = {{"Canard 3:", "told -9"}, {"", "and <so> on"}};
  page.stamped = true;
  page.footer = "Made by x & y";
  const std::string text = html(page);
  EXPECT_TRUE(holds(text, "<div><dt>Plan</dt><dd>p&lt;1&gt;</dd></div>"));
  EXPECT_FALSE(holds(text, "Date"));
  EXPECT_TRUE(holds(text, "<section class=\"verdict bad stamped\">"));
  EXPECT_TRUE(holds(text, "<li><b>Canard 3:</b> told \u22129</li>\n<li>and &lt;so&gt; on</li>"));
  EXPECT_TRUE(holds(text, "<footer>\n<p>Made by x &amp; y</p>\n</footer>\n</main>"));
  page.command = "fantail fly --set a.b=-1 <x>";
  EXPECT_TRUE(
      holds(html(page), "<p>Made by <code>fantail fly --set a.b=-1 &lt;x&gt;</code>.</p>"));  // it can be copied
}

TEST(Page, SaysWhatMadeItOnceThatIsKnown) {
  EXPECT_FALSE(holds(html(example()), "Made by"));
  set_made_by("fantail identify <a>", "1.2");
  const std::string page = html(example());
  set_made_by("", "");
  EXPECT_TRUE(holds(page, "<p>Made by <code>fantail identify &lt;a&gt;</code>, Fantail 1.2.</p>\n</footer>\n</main>"));
}

TEST(Page, ParagraphsListsAndCaptionsAreEscaped) {
  EXPECT_EQ(paragraph("a < -3"), "<p>a &lt; \u22123</p>\n");
  const std::vector<std::string> sentences{"<1>", "two"};
  EXPECT_EQ(list(sentences), "<ul>\n<li>&lt;1&gt;</li>\n<li>two</li>\n</ul>\n");
  EXPECT_EQ(list(std::vector<Cell>{{"kept", Tone::good}, {"lost", Tone::bad}}),
            "<ul>\n<li class=\"good\">kept</li>\n<li class=\"bad\">lost</li>\n</ul>\n");
  EXPECT_TRUE(holds(figure("<svg></svg>", "a & b"), "<figcaption>a &amp; b</figcaption>"));
  EXPECT_TRUE(holds(section("a & b", ""), "<h2>a &amp; b</h2>"));
}

TEST(Page, AWideChartIsDrawnNarrowTooAndOneOfThemIsShown) {
  const std::string both = figure(Chart{.label = "Roll"}, "A caption");
  EXPECT_TRUE(holds(both, "<figure><svg class=\"wide chart\""));
  EXPECT_TRUE(holds(both, "</svg><svg class=\"narrow chart\""));
  EXPECT_TRUE(holds(both, "--w:428"));
  EXPECT_TRUE(both.ends_with("</svg><figcaption>A caption</figcaption></figure>\n"));
  EXPECT_EQ(figure(Chart{.width = half_page}), figure(svg(Chart{.width = half_page}), ""));
  const std::string page = html(example());
  EXPECT_TRUE(holds(page, "figure > .narrow { display: none; }"));
  EXPECT_TRUE(holds(page, "figure > .wide { display: none; }"));
}

TEST(Page, ATableThatIsWiderThanItsPlaceShowsAShadowWhereThereIsMore) {
  EXPECT_TRUE(holds(html(example()), "right / 18px calc(100% - 2px) no-repeat scroll"));
}

TEST(Page, NumbersOfATableStandRightAndTonesAreClasses) {
  const std::vector<Column> columns{{"what <is>"}, {"value", true}};
  const std::vector<std::vector<Cell>> rows{{{"a&b"}, {"-1.5", Tone::bad}}, {{"c", Tone::good}, {"2"}}};
  const std::string text = table(columns, rows);
  EXPECT_TRUE(holds(text, "<th scope=\"col\">what &lt;is&gt;</th><th scope=\"col\" class=\"number\">value</th>"));
  EXPECT_TRUE(holds(text, "<tr><td>a&amp;b</td><td class=\"number bad\">\u22121.5</td></tr>"));
  EXPECT_TRUE(holds(text, "<tr><td class=\"good\">c</td><td class=\"number\">2</td></tr>"));
  const std::vector<std::vector<Cell>> two_lines{{{"1", Tone::plain, "<2>", Tone::bad}}};
  EXPECT_TRUE(holds(table(columns, two_lines), "<td>1<small class=\"bad\">&lt;2&gt;</small></td>"));
}

TEST(Page, ATableIsReachedByKeysAndAColumnWithoutAHeadingHasNone) {
  const std::vector<Column> columns{{""}, {"value", true}};
  const std::string text = table(columns, std::vector<std::vector<Cell>>(1, {Cell{"a"}, Cell{"1"}}));
  EXPECT_TRUE(holds(
      text,
      "<div class=\"table\" tabindex=\"0\" role=\"group\" aria-label=\"Table of 2 columns\"><table class=\"plain\">"));
  EXPECT_TRUE(holds(text, "<thead><tr><td></td><th scope=\"col\" class=\"number\">value</th></tr></thead>"));
}

TEST(Page, ATableWithSentencesBesideOthersHasItsHeadingsAtItsCellsToo) {
  const std::string sentence = "The motor is not named, and the drag was fitted.";
  const auto beside = [](std::size_t others, const Cell& cell) {
    std::vector<Column> columns(others, {"figure", true});
    columns.push_back({"re<mark>"});
    std::vector<Cell> row(others, {"1"});
    row.push_back(cell);
    return table(columns, std::vector<std::vector<Cell>>{row});
  };
  const std::string cards = beside(3, {sentence});
  EXPECT_TRUE(holds(cards, "<table class=\"cards\">"));
  EXPECT_TRUE(holds(cards, "<tr><td class=\"number\">1</td><td class=\"number\" data-label=\"figure\">1</td>"));
  EXPECT_TRUE(holds(cards, "<td data-label=\"re&lt;mark&gt;\">The motor"));
  EXPECT_FALSE(holds(beside(2, {sentence}), "cards"));
  EXPECT_FALSE(holds(beside(3, {"not named"}), "cards"));
  // Criterion, found, asked for, judgement: the last one was cut off at the edge of a telephone.
  const std::vector<Column> judged{{"criterion"}, {"found"}, {"asked for"}, {"judgement"}};
  EXPECT_TRUE(holds(table(judged,
                          std::vector<std::vector<Cell>>{
                              {{"Roll is held"}, {"all runs (98 to 100 %)"}, {"at least 90 % of the runs"}, {"met"}}}),
                    "class=\"cards\""));
  EXPECT_TRUE(holds(table(std::vector<Column>(1), std::vector<std::vector<Cell>>(1, {Cell{"a name of words"}})),
                    "class=\"named\""));
}

TEST(Page, AListLinksWhereThereIsAnAddress) {
  const std::vector<Link> links{{"a&b/report.html", "run <3>", ": -1.5"}, {"", "run 4", ""}};
  EXPECT_EQ(list(links),
            "<ul>\n<li><a href=\"a&amp;b/report.html\">run &lt;3&gt;</a>: \u22121.5</li>\n<li>run 4</li>\n</ul>\n");
}

TEST(Page, FiguresShowLabelValueUnitAndRemark) {
  const std::vector<Figure> figures{{"Offset", "-7", "deg", "at <burn-out>"}, {"Plain", "1", "", ""}};
  const std::string text = figure_row(figures);
  EXPECT_TRUE(holds(text, "<dt>Offset</dt><dd>\u22127 <span>deg</span><small>at &lt;burn-out&gt;</small></dd>"));
  EXPECT_TRUE(holds(text, "<dt>Plain</dt><dd>1</dd>"));
}

}  // namespace
}  // namespace fantail::page
