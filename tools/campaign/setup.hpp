// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/draw.hpp"
#include "campaign/stop_rule.hpp"
#include "runs/runner.hpp"
#include "sim/scenario.hpp"
#include "text/input_file.hpp"

namespace fantail::campaign {

// What a campaign's words stand for, before anything is flown.

using runs::Identity;
using runs::Shard;

/// Many flights of one scenario, whose file says what is not known in tables [[spread]].
struct Campaign {
  std::string scenario{};                  ///< shipped name or path
  std::vector<input::Override> changes{};  ///< the same in every run
  std::uint64_t seed = 1;                  ///< of all runs
  std::uint64_t runs = 1'000;              ///< 1 or more
  Shard shard{};                           ///< of these runs; the others are left to others
  std::optional<StopRule> stop{};          ///< not of a shard
};

/// Empty for "independent", which is how every run is drawn; earlier versions had more ways.
[[nodiscard]] std::string objection_to_sampling(const std::string& word);

/// What a scenario's own file says, for who asks for no other. Throws text::Error.
[[nodiscard]] std::uint64_t seed_of(const std::string& scenario);
/// With the changes of the campaign. Throws text::Error.
[[nodiscard]] input::ScenarioFiles files_of(const Campaign& campaign);
/// Throws text::Error, also for none, and for a change of a value in whose place a spread puts another.
[[nodiscard]] std::vector<Spread> spreads_of(const Campaign& campaign, const input::ScenarioFiles& files);
[[nodiscard]] Drawer drawer_of(const Campaign& campaign, const std::vector<Spread>& spreads);

/// As if it had no stop rule.
[[nodiscard]] Identity identity_of(const Campaign& campaign, const input::ScenarioFiles& files,
                                   const std::vector<Spread>& spreads, const std::string& version);

/// The file that says which campaign the results in a folder are of.
inline constexpr const char* identity_name = "campaign.json";
/// Throws text::Error (bad_configuration) when campaign.json in `folder` is of another campaign, naming what differs.
void require_no_other(const std::filesystem::path& folder, const Identity& identity);
/// Of a folder. Throws text::Error: no_such_input without one, bad_data for one that cannot be read.
[[nodiscard]] Identity read_identity(const std::filesystem::path& folder);

/// Empty where there is no file. Throws as text::read_input() does for one with more than `most` bytes.
[[nodiscard]] std::string file_content(const std::filesystem::path& file,
                                       std::size_t most = text::most_bytes(text::InputKind::data));
/// "section.key=value", one a line, and back. The first throws nothing, the second text::Error.
[[nodiscard]] std::string lines_of(const std::vector<input::Override>& changes);
[[nodiscard]] std::vector<input::Override> changes_in(std::string_view lines);

/// One run of a campaign, to be flown again.
struct RepeatedRun {
  sim::Scenario scenario{};
  std::vector<std::string> changes{};  ///< of the whole campaign: "body.mass_kg=4.1"
  std::string note{};                  ///< which run it is, and what was drawn for it: a sentence for its report
};

/// Throws text::Error for a run that is none of its runs, or whose files do not allow what it draws together.
[[nodiscard]] RepeatedRun repeat_run(const Campaign& campaign, std::uint64_t run);

/// The campaign that was flown in a folder, or is on its way there. Throws text::Error: no_such_input without one,
/// bad_data for a file that does not say all of it, bad_configuration when scenario, plan, vehicle, motor, a table
/// or the program's `version` is not what it was.
[[nodiscard]] Campaign campaign_in(const std::filesystem::path& folder, const std::string& version);

}  // namespace fantail::campaign
