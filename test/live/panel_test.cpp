// SPDX-License-Identifier: MIT
#include "live/panel.hpp"

#include <gtest/gtest.h>

namespace fantail::live {
namespace {

TEST(LivePanel, ANameWithHtmlInItIsText) {
  const std::string page =
      panel({.source = "<img src=x onerror=alert(1)>{js}", .command = "fantail fly '<b>'", .version = "1.2"}).html;
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_NE(page.find("<title>Fantail live: &lt;img src=x onerror=alert(1)&gt;{js}</title>"), std::string::npos);
  EXPECT_NE(page.find(">fantail fly &#39;&lt;b&gt;&#39;</code>, Fantail <span id=\"version\">1.2"), std::string::npos);
}

TEST(LivePanel, LoadsNothingAndSaysThatItMovesNothing) {
  const std::string page = panel({.source = "a rocket"}).html;
  EXPECT_NE(page.find("nothing on it can move or arm anything"), std::string::npos);
  for (const char* loads :
       {" src=", "@import", "url(", "fetch(", "XMLHttpRequest", "WebSocket", "<form", "<link rel=\"stylesheet\""}) {
    EXPECT_EQ(page.find(loads), std::string::npos) << loads;
  }
  EXPECT_NE(page.find("new EventSource(\"events\")"), std::string::npos);
  EXPECT_NE(page.find("uPlot"), std::string::npos);
}

}  // namespace
}  // namespace fantail::live
