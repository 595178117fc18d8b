// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/spread.hpp"
#include "dormancy/opening.hpp"
#include "flight/flight.hpp"
#include "fly/fly_scenario.hpp"
#include "predict/tunnel_result.hpp"
#include "report/verdict.hpp"
#include "runs/row_text.hpp"
#include "sim/scenario.hpp"
#include "sim/wind.hpp"

namespace fantail::predict {

/// Between two points of a run's roll, in seconds; the first is at lift-off.
inline constexpr double track_step_s = 0.02;

/// One launch with one airframe of the spread.
struct Run {
  std::uint64_t seed = 0;
  TunnelStep airframe{};
  double offset_rad = 0.0;            ///< the largest under control; without control of the airframe's two
  double authority_margin_rad = 0.0;  ///< canard_reach() less |offset|
  report::Outcome outcome = report::Outcome::no_control;
  std::string verdict{};                       ///< what the flight report says of it
  bool ended_early = false;                    ///< control; whatever the outcome
  bool ended_by_tilt = false;                  ///< likewise, at the plan's tilt limit
  std::optional<double> allowed_tilt_end_s{};  ///< report::Verdict
  std::optional<double> largest_tilt_rad{};  ///< of the long axis from where the plan counts it, under control; in six
                                             ///< degrees of freedom
  std::vector<std::string> notes{};  ///< whatever the outcome, without what was assumed beforehand, a sentence each
  std::optional<double> largest_hold_error_rad{};
  std::optional<double> saturated_share{};
  std::optional<double> settle_rad{};            ///< R + u_d / kp as control ends, where the canards reach it
  std::optional<double> settle_reference_rad{};  ///< R then
  std::optional<double> lowest_speed_m_s{};      ///< under control, of fly::speeds_under_control_m_s()
  std::optional<dormancy::Opening> opening{};    ///< after lift-off; empty: canards stay at trim
  bool gate_stays_closed = false;                ///< to apogee
  std::optional<double> begun_on_guide_s{};      ///< report::Verdict
  double top_speed_m_s = 0.0;
  flight::Extremes extremes{};
  std::optional<double> apogee_m{};
  std::optional<sim::WindParameters> wind{};  ///< in six degrees of freedom, as the next
  std::optional<double> drift_m{};            ///< at apogee, over ground from the foot of the guide
  /// Without authority, at top speed, the canards at their limit against the offset of then, where that is larger:
  /// where the roll rate ends.
  std::optional<double> spin_rate_rad_s{};
  std::vector<double> roll_angle_rad{};  ///< from lift-off to apogee, what truly was; every track_step_s
  std::vector<double> roll_rate_rad_s{};
  std::vector<std::optional<double>> reference_rad{};  ///< at the same times, under control
};
inline void fields(runs::RowText& text, TunnelStep& step) {
  text(step.damping_m2, step.torque_m, step.offset_begin_rad, step.offset_end_rad);
}
/// All but the wind, which drawn_wind() gives again.
inline void fields(runs::RowText& text, Run& run) {
  text(run.seed, run.airframe, run.offset_rad, run.authority_margin_rad, run.outcome, run.verdict, run.ended_early,
       run.ended_by_tilt, run.allowed_tilt_end_s, run.largest_tilt_rad, run.notes, run.largest_hold_error_rad,
       run.saturated_share, run.settle_rad, run.settle_reference_rad, run.lowest_speed_m_s, run.opening,
       run.gate_stays_closed, run.begun_on_guide_s, run.top_speed_m_s, run.extremes.top_mach,
       run.extremes.static_margin_calibres, run.extremes.angle_of_attack_rad, run.apogee_m, run.drift_m,
       run.spin_rate_rad_s, run.roll_angle_rad, run.roll_rate_rad_s, run.reference_rad);
}

/// Flies the scenario with this airframe in the place of the vehicle's own damping and torque and of the scenario's
/// disturbance. The offset goes from its begin value at lift-off to its end value 1.7 s later and stays: on the first
/// launch, the only flight where the rise was seen, it took from detection to then. A roll that the scenario imposes
/// is left out: it is unknown beforehand. The wind is drawn_wind().
[[nodiscard]] flight::Flight fly_airframe(const sim::Scenario& scenario, const TunnelStep& airframe, std::uint64_t seed,
                                          fly::Log log);

/// Of the fields that a campaign would draw, those that such a flight does not replace.
[[nodiscard]] std::vector<std::string> fields_not_drawn(const std::vector<campaign::Spread>& spreads);

/// What such a flight came to.
[[nodiscard]] Run run_of(const flight::Flight& flight, const sim::Scenario& scenario, const TunnelStep& airframe);

/// The fin offset of an airframe at a time of its flight.
[[nodiscard]] double offset_rad(const TunnelStep& airframe, double after_liftoff_s);

/// Is called after a flight, and may throw to give up.
using Look = std::function<void()>;
inline constexpr auto look_nowhere = [] {};

/// Flies it, and gives what the flight came to.
[[nodiscard]] Run fly_run(const sim::Scenario& scenario, const TunnelStep& airframe, std::uint64_t seed);

/// Where a roll rate ends at this speed with the canards held at their limit against the offset; empty when they can
/// balance it.
[[nodiscard]] std::optional<double> spin_rate_rad_s(const TunnelStep& airframe, double offset_rad, double limit_rad,
                                                    double speed_m_s);

/// What the flights of the runs remark, each sentence once, with the number of runs that have it. Sentences that differ
/// in their figures only count as one; it has the figures of the first run.
[[nodiscard]] std::vector<std::string> notes_of(const std::vector<Run>& runs);

/// Whether such a note tells a static margin or an angle of attack and nothing that follows from it.
[[nodiscard]] bool is_figure_alone(std::string_view note);

/// The wind of one run: its speed normal about the stated one, drawn again until it is not below zero, and where it
/// comes from anywhere within the spread to both sides of what is stated, each direction alike. Profile, gust and
/// turbulence stay as stated; turbulence has a stream of its own. The same seed draws the same wind, and a spread of
/// zero the stated one.
[[nodiscard]] sim::WindParameters drawn_wind(const sim::WindParameters& stated, const sim::WindSpread& spread,
                                             std::uint64_t seed);

}  // namespace fantail::predict
