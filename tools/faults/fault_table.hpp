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

#include "faults/shaft.hpp"
#include "sim/fault.hpp"
#include "sim/scenario.hpp"
#include "sim/units.hpp"

namespace fantail::faults {

/// What a rocket with a fault may come to. Each is looked for in the truth of the flight.
enum class Outcome : std::uint8_t {
  not_armed = 1U << 0U,   ///< stays in Safe
  no_control = 1U << 1U,  ///< never in Controlling
  holds =
      1U << 2U,  ///< control as long as without the fault, and the roll angle within `within_deg` of it all the time
  recovers = 1U << 3U,  ///< likewise, but from `settle_s` after the fault on; until then within `meanwhile_deg`
  goes_on = 1U << 4U,   ///< likewise, within `meanwhile_deg` all the time
  over = 1U << 5U,      ///< every canard commanded to trim `trim_s` after the fault began, from there on for good
  ended = 1U << 6U,  ///< the plan ends control for a failed canard: it ended early, and until then the roll angle was
                     ///< within `meanwhile_deg`
  anything = 1U << 7U,  ///< nothing can be done by the avionics: only what holds for every flight is asked
};
inline constexpr unsigned outcomes = 8;

/// What is safe in one cell, stated before anything is flown.
struct Expected {
  unsigned allowed = 0;  ///< any of these, as bits of Outcome; 0: the fault does not exist in this phase
  double within_deg = 10.0;
  double settle_s = 1.5;
  double meanwhile_deg = 60.0;
  double trim_s = 0.3;

  [[nodiscard]] constexpr bool allows(Outcome outcome) const { return (allowed & static_cast<unsigned>(outcome)) != 0; }
  [[nodiscard]] constexpr bool applies() const { return allowed != 0; }
};

[[nodiscard]] constexpr Expected any_of(auto... each) { return {.allowed = (static_cast<unsigned>(each) | ...)}; }

/// The same in a flight whose gate stays closed: no control, where more than what holds for every flight is asked.
[[nodiscard]] constexpr Expected at_trim(Expected expected) {
  if (expected.applies() && !expected.allows(Outcome::anything)) {
    expected.allowed =
        (expected.allowed & static_cast<unsigned>(Outcome::not_armed)) | static_cast<unsigned>(Outcome::no_control);
  }
  return expected;
}

/// The same for a fault of a canard or of its encoder, by a plan that ends control for it.
[[nodiscard]] constexpr Expected or_ended(Expected expected) {
  if (expected.applies() && !expected.allows(Outcome::anything) && !expected.allows(Outcome::over)) {
    expected.allowed |= static_cast<unsigned>(Outcome::no_control) | static_cast<unsigned>(Outcome::ended);
  }
  return expected;
}

/// "not armed, or no control". Of one that does not apply: "not applicable".
[[nodiscard]] std::string sentence(const Expected& expected);

/// For files: "over".
[[nodiscard]] const char* name(Outcome outcome);

/// When a fault begins, by what the same flight without it is doing then.
enum class Phase : std::uint8_t { pad, armed, launched, controlling, after_control };
inline constexpr std::size_t phases = 5;
[[nodiscard]] std::string_view name(Phase phase);
[[nodiscard]] std::string_view meaning(Phase phase);

/// A fault of the simulator, when it begins at 0: which it is, how long it lasts, and of how many. Two that are equal
/// are the same fault.
struct Recipe {
  sim::Fault fault{};        ///< its canard and its times are set for each flight
  double lasts_s = 0.0;      ///< 0: to the end of the flight
  int times = 1;             ///< resets, 0.2 s apart
  bool all_canards = false;  ///< of encoders and servos; else one, which the number of the run says
  friend constexpr bool operator==(const Recipe&, const Recipe&) = default;
};

constexpr Recipe broken(sim::Device device, sim::How how, double lasts_s = 0.0) {
  return {.fault = {.device = device, .how = how, .until_s = 0.0}, .lasts_s = lasts_s};
}
constexpr Recipe silent_for(double lasts_s, sim::Device device) {
  return broken(device, sim::Behaviour::dead, lasts_s);
}
constexpr Recipe again(sim::Device device, sim::How how, double on_s, double off_s) {
  return {.fault = {.device = device, .how = how, .until_s = 0.0, .on_s = on_s, .off_s = off_s}};
}
/// One sample of random counts in 50.
constexpr Recipe spike(sim::Device device) { return again(device, sim::Behaviour::garbage, 0.001, 0.049); }
/// One new sample in 10 ms.
constexpr Recipe slow_samples(sim::Device device) { return again(device, sim::Behaviour::repeated, 0.009, 0.001); }
constexpr Recipe offset(sim::Device device, double offset_deg_s) {
  return broken(device, sim::RateOffset{offset_deg_s * sim::radians_per_degree});
}
/// The gear stays broken.
constexpr Recipe gear(sim::ServoFault fault, std::optional<double> angle_rad = {}) {
  return {.fault = {.device = sim::Device::servo, .how = sim::GearFault{fault, angle_rad}}};
}
/// At its positive stop, and at its negative one.
inline constexpr Recipe hardover = broken(sim::Device::servo, sim::GearFault{sim::ServoFault::hardover});
inline constexpr Recipe hardover_back = gear(sim::ServoFault::stuck, -90.0 * sim::radians_per_degree);
constexpr Recipe all(sim::Device device, sim::Behaviour behaviour, double lasts_s = 0.0) {
  return {.fault = broken(device, behaviour).fault, .lasts_s = lasts_s, .all_canards = true};
}
constexpr Recipe reset(hal::ResetCause cause, double gap_s, int times = 1,
                       sim::MemoryAfterReset memory = sim::MemoryAfterReset::kept) {
  return {
      .fault = {.device = sim::Device::processor, .how = sim::Reset{.cause = cause, .gap_s = gap_s, .memory = memory}},
      .times = times};
}

/// One fault of one device, with what is safe in each phase.
struct FaultRow {
  std::string_view device;  ///< what a person calls them, on the command line and in results
  std::string_view fault;
  std::string_view meaning;
  Recipe recipe;
  std::array<Expected, phases> expected;
  Shaft shaft = Shaft::obeys;  ///< of each canard whose servo fails, while it does

  [[nodiscard]] const Expected& expect(Phase phase) const { return expected[static_cast<std::size_t>(phase)]; }
  /// "the failed canard may stand anywhere within its limit, at trim or not".
  [[nodiscard]] std::string shaft_sentence() const;
};

/// Of one canard: its servo, or the encoder that watches it.
[[nodiscard]] constexpr bool is_of_canard(const FaultRow& row) {
  return row.recipe.fault.device == sim::Device::servo || row.recipe.fault.device == sim::Device::encoder;
}
[[nodiscard]] constexpr bool ends_for_canards(const core::FlightPlan& plan) {
  return plan.run.canard_fault == core::CanardFaultPolicy::end_control;
}

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
  Recipe recipe;
  unsigned phases;     ///< bits, 1 << Phase
  bool with_one_gyro;  ///< only where the plan flies on one gyro
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
