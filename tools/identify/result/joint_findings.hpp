// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "identify/model/roll_model.hpp"
#include "identify/result/agreement.hpp"
#include "identify/result/findings.hpp"

namespace fantail::identify::result {

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

}  // namespace fantail::identify::result
