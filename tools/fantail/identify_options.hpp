// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fantail/airframe_options.hpp"
#include "fantail/command_line.hpp"
#include "fantail/log_options.hpp"
#include "identify/study.hpp"

namespace fantail::tool {

/// What a person may say to `fantail identify`, as typed.
struct IdentifyOptions {
  std::vector<std::string> data;
  std::string shared;                   ///< "alpha,beta"; empty: each log by itself
  std::optional<std::string> validate;  ///< an identification.json, or its folder
  LogOptions log;

  std::optional<double> from_s;
  std::optional<double> to_s;
  std::vector<std::string> windows;
  double lag_s = 0.0;
  bool fit_lag = false;
  bool fit_initial = false;

  AirframeOptions airframe;
  std::optional<std::string> density;
  std::optional<double> elevation_m;
  std::optional<double> speed_m_s;

  std::string nodes = "even:1";
  std::string method = "continuous";
  std::string loss = "squares";
  std::string grid_alpha;  ///< A:B:STEP, empty: as published
  std::string grid_beta;

  std::string loop = "open";
  std::optional<std::string> plan;
  std::optional<double> proportional_gain;
  std::optional<double> derivative_gain_s;
  std::optional<double> limit_deg;
  std::optional<double> servo_lag_s;

  bool json = false;
  std::string out;
};

void add_identify_options(const Verb& verb, IdentifyOptions& options);

/// The closed loop needs the plan that flew: neither a plan nor all of the gains and the limit are given.
bool wants_flown_plan(const IdentifyOptions& options);

/// What they ask of the log `data`, without the rocket and its windows. Options that exclude each other are a
/// UsageError.
identify::Question question(const IdentifyOptions& options, const std::string& data);

}  // namespace fantail::tool
