// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/flight_plan.hpp"
#include "result/document.hpp"
#include "sim/scenario.hpp"

/// One sheet of A4 for the range safety officer: what this rocket does by the simulation, what its plan allows the
/// canards, and what the team must fill in.
namespace fantail::brief {

/// What a rule pack says of the rocket, ready to be printed.
struct Rules {
  struct Clause {
    std::string id;
    std::string outcome;  ///< "PASS", "NOT KNOWN"
  };
  std::string pack;      ///< its title and date
  std::string sentence;  ///< the verdict
  std::string caution;   ///< which document counts
  std::string flown{};   ///< a sentence, where the flight that was judged moves in another way than those of the sheet
  std::vector<Clause> clauses{};
};

struct Request {
  sim::Scenario scenario;
  double step_s = 1.0;           ///< between the instants at which a canard fails
  unsigned threads = 0;          ///< 0: as many as the machine has
  std::optional<Rules> rules{};  ///< empty: not checked
};

/// A moment of the nominal flight.
struct Moment {
  double time_s = 0.0;  ///< after lift-off
  double height_m = 0.0;
  double speed_m_s = 0.0;
};

/// Of control before apogee.
struct ControlEnd {
  double time_s = 0.0;  ///< after lift-off
  double before_apogee_s = 0.0;
  std::string why{};  ///< "the rocket tilted too far"
};

/// The scenario as it stands, flown once; in six degrees of freedom where the vehicle has an airframe.
struct NominalFlight {
  double apogee_m = 0.0;
  double top_speed_m_s = 0.0;
  Moment guide_exit{};
  std::optional<Moment> control_start{};
  std::optional<ControlEnd> control_end{};  ///< empty: it did not begin, or it went on to apogee
  bool was_armed = true;
  bool was_dormant = false;  ///< the plan's gate was closed when the guide was clear
  bool burns_at_control_start = false;
  std::string roll{};          ///< what the flight report says of it: "Held"
  bool ascent_failed = false;  ///< likewise
  std::string beyond_model{};  ///< how far it is beyond the roll model (flight/model_end.hpp); empty: not
};

/// Throws text::Error for a rocket that does not leave its guide or reaches no apogee.
[[nodiscard]] NominalFlight fly_nominal(const sim::Scenario& scenario);

inline constexpr double most_wind_m_s = 15.0;
inline constexpr double wind_step_m_s = 1.0;
/// The scenario in steady winds of its own profile, wind_step_m_s apart, each from four directions: along the lean of
/// the guide, against it and across. A wind passes when the flight stays within the roll model (flight/model_end.hpp)
/// under control, which begins, and the tilt limit does not end control early (report::Verdict::ended_by_tilt).
struct WindLimit {
  std::optional<double> passed_m_s{};     ///< it and all smaller ones pass; empty: not even calm does
  std::string first_failure{};            ///< of the next one, a clause; empty: none up to most_wind_m_s
  double tilt_end_before_apogee_s = 0.0;  ///< so long before apogee the tilt limit may end control
  double exit_attack_rad = 0.0;           ///< largest at the end of the guide in the winds that pass
};
/// Of a vehicle with an airframe: other flights know no wind.
[[nodiscard]] WindLimit wind_limit(const sim::Scenario& scenario, const std::function<void()>& look);

/// Where the healthy rocket comes down and the one with a canard that runs to a stop, in the scenario's own wind:
/// distances from the foot of the guide.
struct Landing {
  bool has_parachute = false;
  std::optional<double> healthy_m{};            ///< under the parachute
  std::optional<double> healthy_bearing_rad{};  ///< from north over east; empty: hardly away from the guide
  std::optional<double> failed_m{};             ///< the worst
  std::size_t failed_without_landing = 0;       ///< of `flights`
  double healthy_fall_m = 0.0;                  ///< hardover::Study::sound_fall_from_guide_m
  double failed_fall_m = 0.0;                   ///< the worst
  std::size_t flights = 0;                      ///< with a failed canard
  double step_s = 0.0;
};

struct Brief {
  std::string scenario{};
  std::string vehicle{};
  std::string plan_name{};
  std::uint64_t seed = 0;
  core::FlightPlan plan{};
  std::optional<double> length_m{};
  std::optional<double> diameter_m{};
  double mass_kg = 0.0;
  double impulse_n_s = 0.0;
  std::string motor_class{};
  double guide_length_m = 0.0;
  double guide_tilt_rad = 0.0;
  double guide_azimuth_rad = 0.0;
  std::size_t faults = 0;  ///< of the scenario: every flight here has them
  bool is_six_dof = false;
  double wind_m_s = 0.0;  ///< flown in six degrees of freedom
  double wind_from_rad = 0.0;
  NominalFlight nominal{};
  std::optional<WindLimit> wind_limit{};  ///< empty without an airframe, and where control does not begin
  std::optional<Landing> landing{};
  std::string why_no_landing{};  ///< a clause; empty: there is one
  std::optional<Rules> rules{};
};

/// `look`: how many of how many flights with a failed canard are done; before them it is called with 0 of 0. It may
/// throw to give up. Throws text::Error for a scenario that launches no rocket, and what fly_nominal() throws.
[[nodiscard]] Brief make(Request request, const std::function<void(std::size_t done, std::size_t of)>& look);

/// "I" up to 640 N s, twice as much for each following letter; below an A and beyond a Z in words.
[[nodiscard]] std::string motor_class(double impulse_n_s);

/// For terminal and JSON; the page is page_html().
[[nodiscard]] result::Document answer(const Brief& brief, const result::Made& made);
/// One page of A4 when it is printed.
[[nodiscard]] std::string page_html(const Brief& brief, const result::Made& made);
/// Every figure in its JSON, for the manual.
[[nodiscard]] std::vector<result::Listed> listed_fields();

}  // namespace fantail::brief
