// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "identify/model/planted.hpp"
#include "identify/study.hpp"
#include "logs/roll_log.hpp"

namespace fantail::identify {

/// A planted roll as a log whose clock begins at 2 s.
inline logs::RollLog planted_log(const model::Planting& planting) {
  const model::Record record = model::planted_record(planting);
  logs::RollLog log;
  log.name = "planted.csv";
  for (const double t : record.time_s) {
    log.time_s.push_back(2.0 + t);
  }
  log.roll_angle_rad = record.roll_angle_rad;
  log.roll_rate_rad_s = record.roll_rate_rad_s;
  log.canard_rad = record.canard_rad;
  log.speed_m_s = record.speed_m_s;
  return log;
}

/// Makes the canard column late by so many samples (early if negative).
inline void delay_canards(logs::RollLog& log, int samples) {
  const std::vector<double> before = log.canard_rad;
  const auto count = static_cast<int>(before.size());
  for (int i = 0; i < count; ++i) {
    const int from = i - samples;
    log.canard_rad[static_cast<std::size_t>(i)] = before[static_cast<std::size_t>(from < 0        ? 0
                                                                                  : from >= count ? count - 1
                                                                                                  : from)];
  }
}

/// What to ask of such a log; a small grid keeps tests quick.
inline Question planted_question(std::string nodes = "even:1") {
  Question question;
  question.windows.push_back({.name = "all"});
  question.nodes = std::move(nodes);
  question.airframe = model::tasha;
  question.record.density_kg_m3 = 1.2;
  question.options.grid = {.alpha_m2 = {10.0, 30.0, 1.0}, .beta_m = {8.0, 10.0, 0.5}};
  return question;
}

}  // namespace fantail::identify
