// SPDX-License-Identifier: MIT
#include "campaign/judged_flight.hpp"

#include "report/running_figures.hpp"

namespace fantail::campaign {

JudgedFlight fly_and_judge(const sim::Scenario& scenario, const fly::TakeRow& take) {
  report::RunningFigures running{scenario.surroundings != sim::Surroundings::flight};
  JudgedFlight judged;
  judged.flight = fly::fly_without_rows(scenario, [&](const flight::Row& row, const flight::Flight& so_far) {
    running.add(row, so_far);
    if (take) {
      take(row, so_far);
    }
  });
  judged.figures = running.figures(judged.flight, judged.flight.clock);
  judged.verdict = report::verdict(judged.flight, judged.figures);
  return judged;
}

}  // namespace fantail::campaign
