// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaign/analysis.hpp"
#include "flight/flight.hpp"
#include "predict/airframe.hpp"
#include "predict/authority_over_speed.hpp"
#include "predict/margins.hpp"
#include "predict/roll_resonance.hpp"
#include "predict/run.hpp"
#include "predict/tunnel_result.hpp"
#include "runs/folder.hpp"
#include "sim/scenario.hpp"

namespace fantail::predict {

using campaign::Quantiles;
using campaign::Share;
using campaign::share;

/// What a person asked for, for the results to repeat.
struct Request {
  std::vector<std::string> changes{};    ///< of the scenario, as on the command line: "controller.canard_limit_deg=9"
  std::string command{};                 ///< with "--run 17" behind it, it flies run 17 alone
  std::vector<std::string> not_drawn{};  ///< fields of the scenario's [[spread]] that no tunnel step has
};

struct Options {
  std::size_t runs = 200;
  unsigned threads = 0;  ///< 0: as many as the machine has; no figure depends on it
  DampingFactor damping{};
  bool other_vehicle = false;             ///< take tunnel steps that say they are of another vehicle
  std::optional<double> servo_lag_s{};    ///< measured; else the vehicle's
  std::optional<double> servo_delay_s{};  ///< measured, from command to canard, lag apart; else what the vehicle says
  Request request{};
  const runs::Folder* kept = nullptr;  ///< of finished runs; null: none are kept
};

/// The scenario with the servo that was measured.
[[nodiscard]] sim::Scenario with_servo(const sim::Scenario& scenario, const Options& options);

/// Roll over time, over all runs that left the pad.
struct Band {
  std::vector<double> time_s;  ///< after lift-off
  std::vector<Quantiles> roll_angle_rad;
  std::vector<Quantiles> roll_rate_rad_s;
};

/// What a launch will do, as far as the tunnel tells.
struct Prediction {
  std::string scenario{};
  std::string vehicle{};
  std::string plan_name{};
  std::uint64_t seed = 0;
  TunnelResult tunnel{};  ///< damping and torque for the reference area of the vehicle
  Request request{};
  DampingFactor damping{};
  std::optional<AreaFactor> area{};         ///< empty: the reference area is not in the spread
  std::vector<std::string> notes{};         ///< what was assumed, a sentence each
  std::vector<std::string> flight_notes{};  ///< what the flights of the runs remark, a sentence each
  CanardReach reach{};                      ///< against an offset of the sense of usual_offset_rad()
  sim::Scenario flown{};                    ///< with the servo that was measured; every run has an airframe of its own
  double servo_lag_s = 0.0;
  double delay_s = 0.0;  ///< all dead time of the loop
  std::vector<Run> runs{};

  Quantiles offset_size_rad{};  ///< |offset|
  Quantiles authority_margin_rad{};
  Share authority{};  ///< runs with a margin above zero
  Share held{};       ///< of all runs: what cannot be judged was not seen to hold
  std::size_t not_judged = 0;
  std::size_t without_control = 0;
  std::size_t outside_model = 0;  ///< runs that the simulation of roll does not hold for, whatever they came to
  Quantiles top_speed_m_s{};
  std::optional<Quantiles> wind_m_s{};  ///< at its reference height; in six degrees of freedom, as the next two
  std::optional<Quantiles> apogee_m{};
  std::optional<Quantiles> drift_m{};  ///< at apogee
  std::optional<Quantiles> settle_rad{};
  std::optional<Quantiles> settle_reference_rad{};  ///< of the same runs
  std::optional<Quantiles> settle_off_rad{};        ///< how far the one is from the other
  std::optional<Quantiles> saturated_share{};
  /// Of the runs whose canards leave trim, of a plan that waits for more than the guide; as the next four.
  std::optional<Quantiles> gate_time_s{};
  std::optional<Quantiles> gate_height_m{};
  std::optional<Quantiles> gate_speed_m_s{};
  std::optional<Quantiles> gate_rate_rad_s{};
  std::optional<Quantiles> captured_after_s{};           ///< of those that are captured
  Share opened{};                                        ///< runs whose canards leave trim
  Share captured{};                                      ///< of them
  std::optional<Quantiles> spin_rate_rad_s{};            ///< size; of the runs without authority
  std::optional<RollResonance> resonance{};              ///< with the pitch; empty: nothing is known of the pitch
  std::vector<AuthorityAtSpeed> authority_over_speed{};  ///< at the speeds of run 0, up to its highest
  Band band{};
  std::vector<double> speeds_m_s{};  ///< from the lowest at control start to the highest flown; empty without control
  std::vector<MarginsAtSpeed> over_speed{};     ///< at those of them where the loop can swing
  std::optional<MarginsAtSpeed> worst_speed{};  ///< where the low end of the phase margin is least
};

/// Whether it waits for more than the guide.
[[nodiscard]] inline bool has_gate(const core::FlightPlan& plan) {
  return plan.dormancy.until != core::DormantUntil::guide;
}

/// The median of the runs; its sense is that of most.
[[nodiscard]] double usual_offset_rad(const std::vector<Run>& runs);

/// Throws text::Error for a scenario that is not a launch.
void require_launch(const sim::Scenario& scenario);

/// One run of a prediction, with all that a flight report is made from.
struct RepeatedRun {
  Run run{};
  flight::Flight flight{};
};

/// Flies one run of predict() alone: it is the same with every number of runs. Throws what predict() throws.
[[nodiscard]] RepeatedRun repeat_run(const sim::Scenario& scenario, const TunnelResult& tunnel, const Options& options,
                                     std::size_t number);

/// Flies the launch over the spread. `look` receives the number of finished runs and may throw to give up. Throws
/// what require_launch() throws and, unless another vehicle is allowed, what require_same_vehicle() throws.
[[nodiscard]] Prediction predict(const sim::Scenario& scenario, const TunnelResult& tunnel, const Options& options,
                                 const std::function<void(std::size_t done)>& look);

}  // namespace fantail::predict
