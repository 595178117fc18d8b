// SPDX-License-Identifier: MIT
#include "flight/barometer.hpp"

namespace fantail::flight {

void note_barometer(Flight& flight, const core::TickRecord& record, double time_s) {
  std::vector<BarometerSpell>& all = flight.barometer_spells;
  if (!record.barometer_state || !core::is_flight(record.phase)) {
    return;
  }
  if (record.phase == core::Phase::launched && flight.phase_changes.back().time_s == time_s) {
    all.clear();
  }
  if (all.empty() || all.back().state != *record.barometer_state) {
    all.push_back({.state = *record.barometer_state, .from_s = time_s});
  }
  all.back().to_s = time_s;
}

}  // namespace fantail::flight
