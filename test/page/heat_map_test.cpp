// SPDX-License-Identifier: MIT
#include "page/heat_map.hpp"

#include "svg_reader.hpp"
#include "test.hpp"

namespace fantail::page {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

HeatMap two_by_two(std::vector<double> value) { return {.x = {1, 2}, .y = {10, 20}, .value = std::move(value)}; }

std::vector<std::string> fills(const std::string& svg, const std::string& group) {
  const std::size_t begin = svg.find("<g class=\"" + group + "\">");
  const std::string part = svg.substr(begin, svg.find("</g>", begin) - begin);
  std::vector<std::string> found;
  const std::regex pattern{"<rect [^>]*>"};
  for (std::sregex_iterator it{part.begin(), part.end(), pattern}; it != std::sregex_iterator{}; ++it) {
    found.push_back(it->str());
  }
  return found;
}

std::string colour(const std::string& tag) { return SvgReader::text(tag, "fill"); }

TEST(HeatMap, SmallestAndLargestCellHaveTheEndColoursOfTheKey) {
  for (const bool logarithmic : {true, false}) {
    HeatMap map = two_by_two({3.0, 1.0, 2.0, 9.0});
    map.logarithmic = logarithmic;
    const std::string text = svg(map);
    const auto cells = fills(text, "cells");
    const auto key = fills(text, "key");
    ASSERT_EQ(cells.size(), 4U);
    EXPECT_EQ(colour(cells[1]), colour(key.front()));
    EXPECT_EQ(colour(cells[3]), colour(key.back()));
    EXPECT_GT(SvgReader::number(key.front(), "y"), SvgReader::number(key.back(), "y"));  // large is up
  }
}

TEST(HeatMap, ACellLiesWhereItsAxesSay) {
  const std::string text = svg(two_by_two({1.0, 2.0, 3.0, 9.0}));
  const SvgReader read{text};
  const auto cells = fills(text, "cells");
  // value[3] belongs to the larger x and the larger y: right and above.
  EXPECT_NEAR(SvgReader::number(cells[3], "x"), read.at(0.5, 1.0).x, 0.06);
  EXPECT_NEAR(SvgReader::number(cells[3], "y"), read.at(0.5, 1.0).y, 0.06);
  EXPECT_NEAR(SvgReader::number(cells[0], "x"), read.at(0.0, 0.5).x, 0.06);
  EXPECT_NEAR(SvgReader::number(cells[0], "y"), read.at(0.0, 0.5).y, 0.06);
}

TEST(HeatMap, ASpotLiesInTheMiddleOfItsCell) {
  HeatMap map = two_by_two({1.0, 2.0, 3.0, 9.0});
  map.spots = {{2.0, 10.0, "winner"}};
  const SvgReader read{svg(map)};
  const std::string spot = read.tags("circle", "spot").at(0);
  EXPECT_NEAR(SvgReader::number(spot, "cx"), read.at(0.75, 0.25).x, 0.06);
  EXPECT_NEAR(SvgReader::number(spot, "cy"), read.at(0.75, 0.25).y, 0.06);
  EXPECT_TRUE(read.has_text("winner"));
}

TEST(HeatMap, TheMiddleOfALogarithmicScaleIsTheGeometricMean) {
  HeatMap map{.x = {1, 2, 3}, .y = {1}, .value = {1.0, 10.0, 100.0}};
  const auto logarithmic = fills(svg(map), "cells");
  map.logarithmic = false;
  map.value = {1.0, 50.5, 100.0};
  const auto straight = fills(svg(map), "cells");
  EXPECT_EQ(colour(logarithmic[1]), colour(straight[1]));
}

TEST(HeatMap, AZeroAmongErrorsDoesNotWashOutTheRest) {
  const std::string text = svg(HeatMap{.x = {1, 2, 3}, .y = {1}, .value = {0.0, 1.0, 10.0}});
  const auto cells = fills(text, "cells");
  ASSERT_EQ(cells.size(), 2U);  // zero and the smallest of the others are both at the low end
  EXPECT_NE(text.find("text-anchor=\"end\">and below"), std::string::npos);  // ends inside the drawing
  const auto tiny = fills(svg(HeatMap{.x = {1, 2, 3}, .y = {1}, .value = {1e-12, 1.0, 10.0}}), "cells");
  ASSERT_EQ(tiny.size(), 3U);
  // Three decades are shown: 1 lies at two thirds of them below 10.
  HeatMap straight{.x = {1, 2, 3}, .y = {1}, .value = {0.0, 2.0, 3.0}};
  straight.logarithmic = false;
  EXPECT_EQ(colour(tiny[1]), colour(fills(svg(straight), "cells")[1]));
}

// 897.01 + 13.45 in one cell and 910.47 in the next left a white line between them.
TEST(HeatMap, NeighboursOverlap) {
  HeatMap map;
  for (int i = 0; i < 60; ++i) {
    map.x.push_back(i);
    map.value.push_back(1.0 + i);
  }
  map.y = {1.0, 2.0};
  map.value.insert(map.value.end(), map.value.begin(), map.value.begin() + 60);
  const auto cells = fills(svg(map), "cells");
  ASSERT_EQ(cells.size(), 120U);
  for (std::size_t i = 1; i < 60; ++i) {
    EXPECT_GT(SvgReader::number(cells[i - 1], "x") + SvgReader::number(cells[i - 1], "width"),
              SvgReader::number(cells[i], "x") + 0.1);
  }
  EXPECT_GT(SvgReader::number(cells[60], "y") + SvgReader::number(cells[60], "height"),
            SvgReader::number(cells[0], "y") + 0.1);
}

TEST(HeatMap, CellsWithoutAValueStayEmpty) {
  EXPECT_EQ(fills(svg(two_by_two({1.0, no_value, 3.0, 9.0})), "cells").size(), 3U);
}

TEST(HeatMap, LabelsOfSpotsAtOnePlaceDoNotCoverEachOtherOrARing) {
  HeatMap map{.value_label = "error"};
  for (int i = 0; i < 60; ++i) {
    map.x.push_back(i);
  }
  for (int j = 0; j < 20; ++j) {
    map.y.push_back(j);
  }
  for (std::size_t i = 0; i < 1200; ++i) {
    map.value.push_back(1.0 + static_cast<double>(i));
  }
  for (int i = 0; i < 7; ++i) {
    map.spots.push_back({30.0 + 0.2 * i, 10.0, "a label of some length"});
  }
  map.spots.push_back({0.0, 0.0, "a corner"});
  map.spots.push_back({59.0, 19.0, "the other corner"});
  const SvgReader read{svg(map)};
  const auto tags = read.tags("rect", "tag");
  ASSERT_EQ(tags.size(), map.spots.size());
  const auto n = [](const std::string& tag, const char* what) { return SvgReader::number(tag, what); };
  for (std::size_t i = 0; i < tags.size(); ++i) {
    EXPECT_GE(n(tags[i], "x"), n(read.frame(), "x") - 0.1);
    EXPECT_LE(n(tags[i], "x") + n(tags[i], "width"), n(read.frame(), "x") + n(read.frame(), "width") + 0.1);
    for (std::size_t j = 0; j < i; ++j) {
      const bool apart = n(tags[i], "x") + n(tags[i], "width") <= n(tags[j], "x") + 0.2 ||
                         n(tags[j], "x") + n(tags[j], "width") <= n(tags[i], "x") + 0.2 ||
                         n(tags[i], "y") + n(tags[i], "height") <= n(tags[j], "y") + 0.2 ||
                         n(tags[j], "y") + n(tags[j], "height") <= n(tags[i], "y") + 0.2;
      EXPECT_TRUE(apart) << tags[i] << tags[j];
    }
    for (const std::string& ring : read.tags("circle", "spot")) {
      const bool inside = n(ring, "cx") > n(tags[i], "x") && n(ring, "cx") < n(tags[i], "x") + n(tags[i], "width") &&
                          n(ring, "cy") > n(tags[i], "y") && n(ring, "cy") < n(tags[i], "y") + n(tags[i], "height");
      EXPECT_FALSE(inside);
    }
  }
}

TEST(HeatMap, TextIsEscapedAndEmptyDataSaySo) {
  HeatMap map = two_by_two({1, 2, 3, 4});
  map.label = map.x_label = map.y_label = map.value_label = "<b>";
  map.spots = {{1, 10, "<i>"}};
  EXPECT_FALSE(SvgReader{svg(map)}.holds("<b>"));
  EXPECT_FALSE(SvgReader{svg(map)}.holds("<i>"));
  EXPECT_TRUE(SvgReader{svg(HeatMap{})}.has_text("no data"));
  EXPECT_TRUE(SvgReader{svg(two_by_two({no_value, no_value, no_value, no_value}))}.has_text("no data"));
  EXPECT_TRUE(SvgReader{svg(two_by_two({1.0}))}.has_text("no data"));  // too few values
}

TEST(HeatMap, DegenerateDataGiveFiniteDrawings) {
  for (const bool logarithmic : {true, false}) {
    for (const auto& value : std::vector<std::vector<double>>{{5, 5, 5, 5},
                                                              {0, 0, 0, 0},
                                                              {-1, -2, -3, -4},
                                                              {no_value, 1, no_value, no_value},
                                                              {1e-300, 1e300, 0, 1},
                                                              {0, 1, 2, no_value}}) {
      HeatMap map = two_by_two(value);
      map.logarithmic = logarithmic;
      map.spots = {{no_value, 1, "nowhere"}, {500, 1, "outside"}};
      EXPECT_TRUE(SvgReader{svg(map)}.finite()) << svg(map);
      EXPECT_FALSE(SvgReader{svg(map)}.has_text("outside"));
    }
  }
  EXPECT_TRUE(SvgReader{svg(HeatMap{.x = {1}, .y = {1}, .value = {2}})}.finite());
}

}  // namespace
}  // namespace fantail::page
