// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "result/document.hpp"
#include "tune/tuning.hpp"

namespace fantail::tune {

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
/// That the old plan may be kept, and what it has; empty where is_old_enough() is not so.
[[nodiscard]] std::string present_plan(const Tuning& tuning);
/// What to do where no plan is proposed and nothing that was tried is better; empty elsewhere.
[[nodiscard]] std::string next_step(const Tuning& tuning);
/// What was searched and how, a sentence each.
[[nodiscard]] std::vector<std::string> basis(const Tuning& tuning);

/// Is there a better plan? Undecided: it is not better, or outside of the model. `plan_file`: where the plan was
/// written; empty: nowhere.
[[nodiscard]] result::Document answer(const Tuning& tuning, const std::string& plan_file, const result::Made& made);
/// Every figure in its JSON, for the manual.
[[nodiscard]] std::vector<result::Listed> listed_fields();
/// A plan file: every field, and where it came from. Only of a plan that is proposed.
[[nodiscard]] std::string plan_text(const Tuning& tuning);

/// Gain and phase of the open loop over frequency, with its margins: of the new plan, or of the old one where no law
/// was found.
[[nodiscard]] std::vector<result::Block> bode_diagram(const Tuning& tuning);  // none without a loop

// Pictures of tune.html, each of both plans; of a tuning that has found a law.

/// Least phase margin and crossover over air speed.
[[nodiscard]] std::vector<result::Block> loop_pictures(const Tuning& tuning);
/// Roll angle and command over time, as the vehicle as it is was flown.
[[nodiscard]] std::vector<result::Block> step_pictures(const Tuning& tuning);

}  // namespace fantail::tune
