// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "identify/identification.hpp"
#include "identify/make_record.hpp"
#include "logs/roll_log.hpp"

namespace fantail::identify {

/// What a person wants to know from a log.
struct Question {
  std::vector<Window> windows{};  ///< each is identified by itself
  std::vector<Method> methods{Method::continuous};
  Airframe airframe{};
  RecordOptions record{};
  std::string nodes = "even:1";  ///< as find_nodes reads it
  bool fit_lag = false;          ///< instead of record.lag_s; open loop only
  Options options{};             ///< nodes and method apart
};

/// What one window of the log says.
struct WindowFindings {
  Record record{};
  double lag_s = 0.0;
  bool lag_is_fitted = false;
  std::vector<std::string> remarks{};     ///< about the record: gaps, the lag
  std::vector<Identification> results{};  ///< one a method
};

/// All there is to report.
struct Study {
  std::string data{};     ///< the log, as the person wrote it
  std::string vehicle{};  ///< in words
  std::string density{};
  std::string speed{};
  Airframe airframe{};
  std::vector<std::string> warnings{};  ///< about the log as a whole
  std::vector<WindowFindings> windows{};
};

/// Fills in data, airframe, warnings and windows. Throws as find_nodes, make_record and identify do.
[[nodiscard]] Study study(const logs::RollLog& log, const Question& question);

}  // namespace fantail::identify
