// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identify/model/roll_model.hpp"
#include "identify/result/agreement.hpp"
#include "identify/result/findings.hpp"

namespace fantail::identify::result {

/// Alpha and beta as an identification found them.
struct KnownModel {
  std::string source{};  ///< the file, as the person wrote it
  Constants constants{};
  bool covariance_is_known = false;  ///< else it is zero: taken for exact
  double reference_area_m2 = 0.0;
};

/// From an identification.json, or the folder that it lies in. Throws text::Error: no_such_input; bad_data for another
/// file, and for one of several windows or methods without a common model.
[[nodiscard]] KnownModel read_model(const std::filesystem::path& file);

/// A known model held against one window.
struct ValidatedWindow {
  Identification own{};     ///< what the window says by itself
  WindowFindings window{};  ///< its one result has the known alpha and beta, its own disturbance, and no uncertainty
  Agreement agreement{};    ///< of the known constants with the window's own

  /// Whether the window says enough to tell.
  [[nodiscard]] bool can_tell() const;
  /// The larger difference of alpha or beta, as a share of the window's own.
  [[nodiscard]] double largest_difference() const;
  /// No more than noise explains, or too little to matter.
  [[nodiscard]] bool holds() const;
};

struct Validation {
  KnownModel model{};  ///< for the reference area of `airframe`
  model::Airframe airframe{};
  std::vector<ValidatedWindow> windows{};
  std::string data{};
  std::string vehicle{};
  std::string density{};
  std::string speed{};
  std::vector<std::string> warnings{};
};

/// Share of the variance of the measured roll rate that the simulation explains; below zero: it is worse than the mean.
[[nodiscard]] double explained_share(const model::Record& record, const model::Simulation& simulation);

}  // namespace fantail::identify::result
