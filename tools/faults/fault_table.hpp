// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "faults/expected.hpp"
#include "faults/shaft.hpp"
#include "sim/fault.hpp"
#include "sim/scenario.hpp"

namespace fantail::faults {

/// When a fault begins, by what the same flight without it is doing then.
enum class Phase : std::uint8_t { pad, armed, launched, controlling, after_control };
inline constexpr std::size_t phases = 5;
[[nodiscard]] std::string_view name(Phase phase);
[[nodiscard]] std::string_view meaning(Phase phase);

/// How a fault is made in the simulator.
struct Recipe {
  sim::FaultKind kind = sim::FaultKind::device;
  sim::Device device = sim::Device::imu;
  sim::Behaviour behaviour = sim::Behaviour::dead;
  double lasts_s = 0.0;  ///< 0: to the end of the flight
  double on_s = 0.0;     ///< Misbehaviour
  double off_s = 0.0;
  double delay_s = 0.02;
  double offset_deg_s = 0.0;  ///< of an offset
  double angle_deg = 0.0;     ///< of canard_stuck
  sim::Reset reset{};         ///< of a reset
  int times = 1;              ///< resets, 0.2 s apart
  bool all_canards = false;   ///< of encoders and servos; else one, which the number of the run says
};

/// One fault of one device, with what is safe in each phase.
struct FaultRow {
  std::string_view device;
  std::string_view fault;
  std::string_view meaning;
  Recipe recipe;
  std::array<Expected, phases> expected;
  Shaft shaft = Shaft::obeys;  ///< of each canard whose servo fails, while it does

  [[nodiscard]] const Expected& expect(Phase phase) const { return expected[static_cast<std::size_t>(phase)]; }
  /// "the canard that fails may stand anywhere within its limit, at trim or not".
  [[nodiscard]] std::string shaft_sentence() const;
};

/// All of them, device by device.
[[nodiscard]] std::span<const FaultRow> fault_table();

/// The devices of the table in its order, each once.
[[nodiscard]] std::vector<std::string_view> device_names();

/// Of the limits of one canard: what must be true of the rocket and of the flight before one excuses anything.
enum class Excuse : std::uint8_t {
  any,         ///< nothing more
  three_lack,  ///< three canards cannot balance the fourth: StopRule
  comes_back,  ///< they can, and at the end of control the roll was back
};

/// Why a cell may be red all the same, and what a team has to do about it.
struct KnownLimit {
  std::string_view device;
  std::string_view fault;  ///< empty: every one of the device
  unsigned phases;         ///< bits, 1 << Phase
  bool with_one_gyro;      ///< only where the plan flies on one gyro
  std::string_view why;
  std::string_view what_to_do;
  int last_ms = 0;  ///< only of a fault that begins so late in its phase; 0: whenever it begins
  Excuse excuse = Excuse::any;
};
[[nodiscard]] std::span<const KnownLimit> known_limits();
/// Null: none is known for this rocket.
[[nodiscard]] const KnownLimit* known_limit(const FaultRow& row, Phase phase, const sim::Scenario& scenario);

/// Empty: the fault can be flown in this scenario. Else why not.
[[nodiscard]] std::string why_not(const FaultRow& row, const sim::Scenario& scenario);

/// The faults of a flight: `begin_s` after ignition. `run` says which canard, and which random numbers.
[[nodiscard]] std::vector<sim::Fault> faults_of(const Recipe& recipe, double begin_s, std::uint64_t run,
                                                const sim::Scenario& scenario);
/// What that allows each of the four shafts.
[[nodiscard]] Shafts shafts_of(const FaultRow& row, std::uint64_t run);
/// When it is gone for good, after ignition; of one that stays, long after every flight.
[[nodiscard]] double end_of(const Recipe& recipe, double begin_s);

}  // namespace fantail::faults
