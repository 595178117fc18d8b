// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "result/answer.hpp"
#include "tune/tuning.hpp"

namespace fantail::tune {

/// Is there a plan that is better? Undecided where it is not better, or outside of the model.
[[nodiscard]] result::Answer answer(const Tuning& tuning);

// Sentences that text, page and plan share.

/// "0.5, 0.05 s, integral gain 0.5 1/s and a schedule".
[[nodiscard]] std::string law_words(const core::FlightPlan& plan);
/// That the simulation of roll does not hold for the flights; empty where it does.
[[nodiscard]] std::string model_sentence(const Tuning& tuning);
/// What the linear loop has by both plans.
[[nodiscard]] std::string loop_sentence(const Tuning& tuning);
/// What the flights came to, and whether the new plan is better.
[[nodiscard]] std::string flights_sentence(const Tuning& tuning);
/// What is little about the new law: its margin, what its range left it, what the canards' limit leaves. Each a
/// sentence.
[[nodiscard]] std::vector<std::string> remarks(const Tuning& tuning);
/// What was searched and how, a sentence each.
[[nodiscard]] std::vector<std::string> basis(const Tuning& tuning);

/// For the terminal.
[[nodiscard]] std::string tuning_text(const Tuning& tuning);
/// `plan_file`: where the plan was written; empty: nowhere.
[[nodiscard]] std::string tuning_json(const Tuning& tuning, const std::string& plan_file,
                                      const result::Made& made = {});
[[nodiscard]] std::string tuning_html(const Tuning& tuning, const std::string& plan_file);
/// A plan file: every field, and where it came from. Only of a plan that is proposed.
[[nodiscard]] std::string plan_text(const Tuning& tuning);

}  // namespace fantail::tune
