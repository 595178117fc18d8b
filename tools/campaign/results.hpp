// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "campaign/analysis.hpp"
#include "result/answer.hpp"
#include "text/layout.hpp"

namespace fantail::campaign {

/// A campaign with all that its results are made from.
struct Report {
  Campaign campaign{};
  FlownCampaign flown{};
  Analysis analysis{};
  result::Made made{};                     ///< with the version of the program
  std::string command{};                   ///< that flies it again
  std::string run_command{};               ///< that flies one run again, but for its number
  std::vector<std::string> run_folders{};  ///< one a worst run, where its flight report is; empty: it has none
};

/// Is the share that was asked for met? Undecided too where runs lie outside of the model; none without a question.
[[nodiscard]] result::Answer answer(const Report& report);
/// How many are faster than the simulation of roll holds for, whatever else they came to.
[[nodiscard]] std::size_t runs_outside_the_model(const Report& report);
/// What was found, in one sentence or two: the share and the interval, or that it is not decided.
[[nodiscard]] std::string headline(const Report& report);
/// What the interval is worth for the way the runs were drawn, a sentence.
[[nodiscard]] std::string interval_sentence(const Report& report);
/// What was left out or went wrong, a sentence each.
[[nodiscard]] std::vector<std::string> remarks(const Report& report);

/// How much the slopes explain, and what they do not show.
[[nodiscard]] std::string about_slopes(const Analysis& analysis);
/// In the place of a slope.
inline constexpr std::string_view no_slope = "not known";

/// For a terminal.
[[nodiscard]] std::string report_text(const Report& report, std::size_t columns = text::any_width);
/// summary.json: one object, every figure with its unit in its name; what does not exist is null.
[[nodiscard]] std::string report_json(const Report& report);
/// campaign.html: one page that loads nothing.
[[nodiscard]] std::string report_html(const Report& report);

}  // namespace fantail::campaign
