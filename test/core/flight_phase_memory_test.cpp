// SPDX-License-Identifier: MIT
// The phases of a law whose memory is not what it left there.
#include <vector>

#include <gtest/gtest.h>

#include "core/flight_phase.hpp"
#include "phase_sequence.hpp"

namespace fantail::core {
namespace {

/// The times that a log would hold.
struct Times {
  std::vector<Microseconds> found;
  template <typename... T>
  void operator()(T&... values) {
    (each(values), ...);
  }
  template <typename T>
  void below(std::size_t /*limit*/, T& /*value*/) {}

 private:
  void each(const Microseconds& time) { found.push_back(time); }
  template <typename T>
  void each(const T& /*other*/) {}
};

TEST(FlightPhase, DamagedMemoryEndsAFlightAndNothingElse) {
  Sequence sequence;
  FlightPhase safe = sequence.phases();
  safe.give_up(ms(1));
  EXPECT_EQ(safe.phase(), Phase::safe);
  FlightPhase armed = sequence.arm().phases();
  armed.give_up(ms(1));
  EXPECT_EQ(armed.phase(), Phase::armed);
  EXPECT_EQ(armed.reason(), PhaseReason::armed_by_switch_and_command);
  FlightPhase launched = sequence.launch().phases();
  launched.give_up(ms(1));
  EXPECT_EQ(launched.phase(), Phase::finished);
  EXPECT_EQ(launched.reason(), PhaseReason::memory_fault);
  Times since;
  launched.visit_state(since);
  EXPECT_EQ(since.found, std::vector{ms(1)});
  launched.give_up(ms(2));
  EXPECT_EQ(launched.reason(), PhaseReason::memory_fault);
}

}  // namespace
}  // namespace fantail::core
