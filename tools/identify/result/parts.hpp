// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identify/result/agreement.hpp"
#include "identify/result/words.hpp"
#include "result/document.hpp"

namespace fantail::identify::result {

// What the documents of identification are made of.

namespace output = fantail::result;
namespace u = fantail::result::units;
using output::Cell;
using Blocks = std::vector<output::Block>;

inline constexpr output::Unit ms{"_s", "ms", 1.0, 1000.0}, kg_m2{"_kg_m2", "kg m2"};
inline constexpr int json_digits = -8;  // more than any of these numbers is known to, and no ...0000001

[[nodiscard]] json::Value list(const std::vector<double>& values, const output::Unit& unit = u::none);

/// "runs.0" and "alpha": "runs.0.alpha".
[[nodiscard]] std::string key_in(const std::string& place, const std::string& key);

/// One result, where it stands; its figures, of which programs read those that are known.
struct Found {
  const Study& study;
  const WindowFindings& window;
  const Identification& result;
};
[[nodiscard]] output::Figures figures_of(const Found& found, const std::string& place = {});
/// The disturbance of each result, for people; and the numbers of nodes that were tried.
[[nodiscard]] output::Table node_table(const WindowFindings& window);
[[nodiscard]] output::Table trial_table(const std::string& key, const Identification& result);
/// A row a sample, model beside log, for a spreadsheet.
[[nodiscard]] output::Table model_table(const std::string& key, const model::Record& record,
                                        const Identification& result);

[[nodiscard]] std::vector<output::Listed> listed_found();
[[nodiscard]] std::vector<output::Listed> listed_joint();
[[nodiscard]] std::vector<output::Listed> listed_validation();

// The pictures of one window, all methods in each. Time is that of the log.

/// Angle and rate, measured and modelled; and measured minus modelled.
void add_motion(Blocks& to, const WindowFindings& window);
void add_residuals(Blocks& to, const WindowFindings& window);
/// The disturbance with the band in which it lies with a probability of 95 %, every instant taken by itself; the
/// canards as measured, and in the closed loop also as the model commands.
[[nodiscard]] Blocks input_pictures(const WindowFindings& window);
/// The error over the number of intervals. For a result with trials.
[[nodiscard]] output::Picture node_picture(const Identification& result);
/// The error over alpha and beta with every winner that lies on the map.
[[nodiscard]] output::Drawing error_map_drawing(const WindowFindings& window, const model::ErrorMap& errors);
/// Gain, phase and coherence over the frequency. For a response with lines.
void add_frequency(Blocks& to, const FrequencyResponse& response);

}  // namespace fantail::identify::result
