// SPDX-License-Identifier: MIT
#include <algorithm>

#include <gtest/gtest.h>

#include "report/answer.hpp"
#include "report/sections.hpp"
#include "synthetic_flight.hpp"

namespace fantail::report {
namespace {

// 3.8 s by the events, and 3.75 s from the first row to the last.
TEST(Html, SaysWhyTheTimeUnderControlIsShorterThanItsEventsAreApart) {
  SyntheticFlight synthetic;
  synthetic.end_control(4.4, core::PhaseReason::apogee);
  const auto page = [&synthetic] {
    const Figures f = figures(synthetic.flight);
    return result::html(answer(synthetic.flight, f, verdict(synthetic.flight, f)));
  };
  EXPECT_EQ(page().find("from its first row to its last"), std::string::npos);
  std::erase_if(synthetic.flight.rows, [count = 0](const flight::Row&) mutable { return count++ % 50 != 0; });
  EXPECT_NE(page().find("<dt>time under control</dt><dd>3.75 <span>s</span><small>from its first row to its last"),
            std::string::npos)
      << page().substr(page().find("<dt>time under"), 200);
}

// A plot of no time at all has no ticks, and what draws it in a browser gives up.
TEST(Charts, ShowSomeTimeOfTheShortestTableAndOfEventsFarFromItsRows) {
  const auto least_view_s = [](const flight::Flight& flight) {
    double least_s = 1e9;
    for (const auto& view : charts(flight).views) {
      least_s = std::min(least_s, view.end_s - view.begin_s);
    }
    return least_s;
  };
  flight::Flight table;
  table.rows = {SyntheticFlight{}.flight.rows[1000]};
  EXPECT_GE(least_view_s(table), 0.01) << "one row";
  table.rows.push_back(table.rows.front());
  table.rows.back().time_s += 1e-6;
  EXPECT_GE(least_view_s(table), 0.01) << "two rows";
  table.events = {.liftoff_s = 900.0, .control_start_s = 700.0, .control_end_s = 600.0, .apogee_s = -50.0};
  EXPECT_GE(least_view_s(table), 0.01) << "events in no order";
}

}  // namespace
}  // namespace fantail::report
