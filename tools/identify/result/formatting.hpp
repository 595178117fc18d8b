// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "identify/result/constant_text.hpp"
#include "identify/result/findings.hpp"

namespace fantail::identify::result {

// What text and page say alike. A `number` counts as in RollModel::numbers().

[[nodiscard]] std::string_view name(Method method);
[[nodiscard]] std::string_view name(Loop loop);

/// "22.87 +- 0.41": as many decimals as two digits of the standard deviation need. `scale` turns SI into the unit
/// shown.
[[nodiscard]] std::string with_deviation(const Identification& result, std::size_t number, double scale = 1.0);

/// The same for an alpha or beta that is no Identification's.
[[nodiscard]] std::string value_with_deviation(double value, double deviation);

/// "22.1 to 23.7", "above 22.1", "below 23.7" or "not bounded by this window".
[[nodiscard]] std::string interval_text(const Interval& interval, double scale = 1.0);

/// The interval to show for one of a model's numbers: alpha's is that of its profile.
[[nodiscard]] const Interval& interval_of(const Identification& result, std::size_t number);

/// "Damping alpha lies between 22.10 and 23.72 m2 (95 %, ±3.5 %).", for someone who flies rockets.
[[nodiscard]] std::string precision_sentence(const Identification& result, std::size_t number);

/// A node of the disturbance in a table with a column for each method: "at 1.62 s" (on the log's clock) and "-4.90 +-
/// 0.02"; where the methods chose different nodes, the time stands with the value. An empty value for a node that a
/// result has not got.
[[nodiscard]] std::string node_label(const WindowFindings& window, std::size_t node);
[[nodiscard]] std::string node_value(const WindowFindings& window, const Identification& result, std::size_t node);

/// " (fitted; 95 %: 18.2 to 21.4 ms)" behind a lag that was fitted, else nothing.
[[nodiscard]] std::string fitted_lag(const WindowFindings& window);

/// "17.9 to 18.6": of a lag or a play, in its own unit times `unit`.
[[nodiscard]] std::string servo_interval(double value, const std::optional<Spread>& known, double unit);

/// "18.2 +- 0.2" ms and "0.28 +- 0.01" deg, where the servo was fitted.
[[nodiscard]] std::string servo_lag_text(const Identification& result);
[[nodiscard]] std::string servo_play_text(const Identification& result);

/// "0.12 (chance 0.17)": the strongest correlation of the rate's residual with itself or with the canards.
[[nodiscard]] std::string residual_text(const Identification& result, double ResidualTests::* which);

/// "310", or "fewer than 1": the effective samples.
[[nodiscard]] std::string worth_text(const Uncertainty& known);

/// "310 of 9719".
[[nodiscard]] std::string effective_text(const Identification& result);

/// "0.64 s to 10.36 s on the log's clock, 9720 samples".
[[nodiscard]] std::string extent(const model::Record& record);

/// Everything that a reader of one result has to know beside the numbers.
[[nodiscard]] std::vector<std::string> remarks(const WindowFindings& window, const Identification& result);

/// The one that the summary speaks of: without a grid's steps where there is one.
[[nodiscard]] const Identification& main_result(const WindowFindings& window);

/// Are damping and torque both identifiable in it?
[[nodiscard]] bool determines_both(const WindowFindings& window);

/// The same for each number of a result with an uncertainty, and why it is not known better.
[[nodiscard]] std::vector<std::string> precision_sentences(const Identification& result);

/// With the signs that a terminal may not have: plus-minus, squares.
[[nodiscard]] std::string printable(std::string text);

/// "alpha and beta are ..." as a sentence of its own.
[[nodiscard]] std::string sentence(std::string text);

}  // namespace fantail::identify::result
