// SPDX-License-Identifier: MIT
// What the page says of a barometer that the plan fuses.
#include "flight/barometer.hpp"

#include "report/verdict_parts.hpp"
#include "test.hpp"

namespace fantail::report {
namespace {

using core::BarometerState;

core::TickRecord tick(core::Phase phase, std::optional<BarometerState> state) {
  core::TickRecord record;
  record.phase = phase;
  record.barometer_state = state;
  return record;
}

TEST(Barometer, IsSaidToBeUsedFromWhenToWhenAndWhyNotElse) {
  flight::Flight flight;
  flight.barometer_spells = {{BarometerState::on_pad, 0.1, 0.6},
                             {BarometerState::used, 0.601, 1.1},
                             {BarometerState::too_fast, 1.101, 9.0},
                             {BarometerState::used, 9.001, 18.0}};
  EXPECT_EQ(barometer_sentences(flight),
            "The barometer was used for 9.50 s in all, between 0.60 s and 18.00 s. It was not used from 0.10 s to 0.60 "
            "s: it had not agreed with the accelerometer for half a second yet. It was not used from 1.10 s to 9.00 s: "
            "the rocket was too fast, or had been half a second before.");
  flight.barometer_spells = {{BarometerState::silent, 0.1, 18.0}};
  EXPECT_EQ(barometer_sentences(flight),
            "The barometer that the plan asks for was not used in flight. It was not used from 0.10 s to 18.00 s: it "
            "gave no usable pressure, in flight or before it.");
  flight.barometer_spells.clear();
  EXPECT_EQ(barometer_sentences(flight), "") << "the plan asks for none";
}

TEST(Barometer, IsWatchedFromTheLastLaunchDetectionToTheEndOfControl) {
  using enum core::Phase;
  flight::Flight flight;
  double time_s = 0.0;
  const auto fly = [&](core::Phase phase, std::optional<BarometerState> state) {
    flight::note_tick(flight, tick(phase, state), time_s);
    time_s += 1.0;
  };
  fly(armed, BarometerState::on_pad);
  fly(launched, BarometerState::disagrees);  // at 1 s; no launch
  fly(safe, BarometerState::on_pad);
  fly(armed, BarometerState::on_pad);
  fly(launched, BarometerState::too_fast);  // at 4 s
  fly(launched, BarometerState::too_fast);
  fly(controlling, BarometerState::used);
  fly(finished, BarometerState::disagrees);
  flight::set_time_zero(flight, 4.0);
  ASSERT_EQ(flight.barometer_spells.size(), 2U);
  EXPECT_EQ(flight.barometer_spells[0].state, BarometerState::too_fast);
  EXPECT_EQ(flight.barometer_spells[0].from_s, 0.0);
  EXPECT_EQ(flight.barometer_spells[0].to_s, 1.0);
  EXPECT_EQ(flight.barometer_spells[1].from_s, 2.0);

  flight::Flight without;
  flight::note_tick(without, tick(launched, std::nullopt), 0.0);
  EXPECT_TRUE(without.barometer_spells.empty());
}

}  // namespace
}  // namespace fantail::report
