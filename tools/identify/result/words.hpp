// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "identify/result/findings.hpp"
#include "result/field.hpp"

namespace fantail::identify::result {

// What results say in words. A `number` counts as in RollModel::numbers().

[[nodiscard]] std::string_view name(Method method);
[[nodiscard]] std::string_view name(Loop loop);
/// "excitation"
[[nodiscard]] std::string_view name(Instrument instrument);

// Alpha and beta go with one over the reference area, so a rocket may have 20 m2 or 0.0002 m2.

/// "22.87", "0.1304": two decimals, or four digits where those would tell less.
[[nodiscard]] std::string constant_text(double value);
/// "0.1467 m2 instead of 0.1304": as many digits as tell the two apart. "0.1121 m as before" where that takes more than
/// anybody can measure.
[[nodiscard]] std::string change_text(double now, double before, std::string_view unit);

/// A number of the model with its standard deviation, where that is known.
[[nodiscard]] fantail::result::Uncertain uncertain(const Identification& result, std::size_t number);
/// "22.87 \u00b1 0.41" of alpha or beta.
[[nodiscard]] std::string with_deviation(const Identification& result, std::size_t number);
/// "22.1 to 23.7", "above 22.1", "below 23.7"; `scale` turns SI into the unit shown.
[[nodiscard]] std::string interval_text(const Interval& interval, double scale = 1.0);
/// The interval to show for one of a model's numbers: alpha's is that of its profile.
[[nodiscard]] const Interval& interval_of(const Identification& result, std::size_t number);

/// "Damping alpha lies between 22.10 and 23.72 m2 (95 %, \u00b13.5 %).", for someone who flies rockets.
[[nodiscard]] std::string precision_sentence(const Identification& result, std::size_t number);
/// The same for each number of a result with an uncertainty, and why it is not known better.
[[nodiscard]] std::vector<std::string> precision_sentences(const Identification& result);

/// By how much the canards were taken to lag; empty where they were not.
[[nodiscard]] std::string lag_sentence(const WindowFindings& window);
/// "310", or "fewer than 1": the effective samples.
[[nodiscard]] std::string worth_text(double effective_samples);
/// "0.64 s to 10.36 s on the log's clock, 9720 samples".
[[nodiscard]] std::string extent(const model::Record& record);

/// "alpha and beta are ..." as a sentence of its own.
[[nodiscard]] std::string sentence(std::string text);

/// What the frequency response says, in one or two sentences; what the estimate was taken with, and where it is biased.
[[nodiscard]] std::string frequency_sentence(const FrequencyResponse& response);
[[nodiscard]] std::string instrument_sentence(const FrequencyResponse& response);

/// Everything that a reader of one result has to know beside the numbers.
[[nodiscard]] std::vector<std::string> remarks(const WindowFindings& window, const Identification& result);

/// The one that the summary speaks of: without a grid's steps where there is one.
[[nodiscard]] const Identification& main_result(const WindowFindings& window);

/// Are damping and torque both identifiable in it?
[[nodiscard]] bool determines_both(const WindowFindings& window);

}  // namespace fantail::identify::result
