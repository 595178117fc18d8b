// SPDX-License-Identifier: MIT
#include "identify/validate.hpp"

#include "identify/model/open_loop.hpp"

namespace fantail::identify {

using namespace model;
using namespace result;

Validation validate(const KnownModel& known, const Study& study, Start start) {
  Validation validation{.model = known, .airframe = study.airframe};
  const double scale = known.reference_area_m2 / study.airframe.reference_area_m2;
  Constants& constants = validation.model.constants;
  constants.value *= scale;
  constants.covariance *= scale * scale;
  validation.model.reference_area_m2 = study.airframe.reference_area_m2;
  for (const WindowFindings& window : study.windows) {
    ValidatedWindow validated{.own = window.results.front(), .window = window};
    Identification& held = validated.window.results.front();
    const NodeTimes nodes = held.model.node_time_s;
    held.uncertainty.reset();
    held.residual_tests.reset();
    held.error_map.reset();
    held.node_trials.clear();
    held.model =
        fit_open_loop_with(constants.value(0), constants.value(1), window.record, study.airframe, nodes, start);
    held.simulation = simulate_open_loop(window.record, study.airframe, held.model);
    validated.agreement = difference(constants, constants_of(validated.own));
    validation.windows.push_back(std::move(validated));
  }
  return validation;
}

}  // namespace fantail::identify
