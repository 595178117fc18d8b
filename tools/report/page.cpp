// SPDX-License-Identifier: MIT
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "report/answer.hpp"
#include "report/sections.hpp"

namespace fantail::report {

result::Document answer(const flight::Flight& flight, const Figures& figures, const Verdict& verdict,
                        const result::Made& made) {
  result::Document document = summary(flight, figures, verdict, made);
  document.footer =
      "Every tick is in flight.csv, every figure in summary.json, beside this page. The plots leave out most samples "
      "but "
      "no peak. Plots drawn with uPlot (MIT licence, in the source of this page).";
  if (!flight.command.empty()) {  // without what only says where it goes
    document.made.command = flight.command;
  }
  std::vector<result::Section>& all = document.sections;
  if (page::LiveCharts live = charts(flight); !live.charts.empty()) {
    all.insert(all.begin(),
               {"The flight",
                {result::Live{std::make_shared<page::LiveCharts>(std::move(live)), "Roll angle over time"}},
                result::Readers::files});
  }
  const auto behind_figures = std::ranges::find(all, "Figures", &result::Section::heading) + 1;
  all.insert(behind_figures, {path_section(flight), turning_section(flight)});
  return document;
}

}  // namespace fantail::report
