// SPDX-License-Identifier: MIT
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "result/document.hpp"

namespace fantail::result {
namespace {

/// From its left edge to its right one, of each plot in a page that is as wide as its page.
std::vector<std::pair<double, double>> frames(const std::string& page) {
  std::vector<std::pair<double, double>> all;
  const auto number = [&page](std::size_t from, const std::string& attribute) {
    return std::stod(page.substr(page.find(" " + attribute + "=\"", from) + attribute.size() + 3, 12));
  };
  for (std::size_t at = page.find("viewBox=\"0 0 880"); at != std::string::npos;
       at = page.find("viewBox=\"0 0 880", at + 1)) {
    const std::size_t frame = page.find("<rect class=\"frame\"", at);
    all.emplace_back(number(frame, "x"), number(frame, "x") + number(frame, "width"));
  }
  return all;
}

TEST(Page, ChartsOverOneXBelowEachOtherHaveTheirFramesLinedUp) {
  const auto over = [](const char* x_label, double largest) {
    return Picture{.chart = {.x_label = x_label, .series = {{.x = {0.0, 10.0}, .y = {0.0, largest}}}}};
  };
  Document document;
  document.sections = {{"Found", {over("time / s", 4.0), over("time / s", 123456.0)}},
                       {"More", {over("time / s", 9.0), over("speed / (m/s)", 4.0)}}};
  const auto found = frames(html(document));
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(found[0], found[2]);
  EXPECT_LT(found[3].first, found[0].first) << "over another x it keeps its room";
}

}  // namespace
}  // namespace fantail::result
