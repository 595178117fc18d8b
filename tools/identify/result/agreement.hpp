// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/result/findings.hpp"

// Do several windows tell of one alpha and one beta, and does a known pair of them hold in another window?
namespace fantail::identify::result {

/// Damping (m2) and torque constant (m) with how well both are known.
struct Constants {
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  double degrees_of_freedom = 0.0;  ///< that the covariance was found with
};

/// Of a result with an uncertainty.
[[nodiscard]] Constants constants_of(const Identification& result);

/// 95 %, from the covariance: of alpha (0) or beta (1).
[[nodiscard]] Interval interval_of(const Constants& constants, Eigen::Index which);

/// How far estimates are from their common mean, each weighed with its own covariance.
struct Agreement {
  double chi_square = 0.0;
  double limit = 0.0;  ///< estimates of the same two numbers are below it in 95 of 100 cases

  [[nodiscard]] bool agree() const { return chi_square <= limit; }
};

/// Differences of alpha and beta that are no larger, as a share of them, do not matter: a prediction has larger errors.
inline constexpr double no_matter = 0.02;

/// Of two or more. The limit is the quantile of the chi-square distribution, and wider where a covariance rests on few
/// degrees of freedom.
[[nodiscard]] Agreement agreement(const std::vector<Constants>& estimates);

/// Of two estimates, of which one may be exact: no covariance and endless degrees of freedom.
[[nodiscard]] Agreement difference(const Constants& a, const Constants& b);

/// One window of several that share alpha and beta.
struct JointWindow {
  std::string data{};       ///< the log, as the person wrote it
  Identification own{};     ///< what the window says by itself
  WindowFindings window{};  ///< its one result has the shared alpha and beta, its own disturbance, and no uncertainty
  double information_share = 0.0;  ///< of all that is known of alpha and beta
};

/// Several windows with one alpha and one beta.
struct JointFindings {
  std::vector<JointWindow> windows{};
  Constants together{};
  Agreement agreement{};
  model::Airframe airframe{};  ///< of the first window; the reference area is that of all
  std::string vehicle{};       ///< in words, as in Study
  std::string density{};
  std::string speed{};
  std::vector<std::string> warnings{};

  [[nodiscard]] bool determines_both() const;
  /// Of any window's own alpha or beta from the common one, as a share of that; of windows that determine both.
  [[nodiscard]] double largest_difference() const;
  /// No more than their noise explains, or too little to matter.
  [[nodiscard]] bool are_of_one_rocket() const;
};

/// Alpha and beta as an identification found them.
struct KnownModel {
  std::string source{};  ///< the file, as the person wrote it
  std::string how{};     ///< it was identified: "continuous, open loop, window control of out/f1"; empty: unknown
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
