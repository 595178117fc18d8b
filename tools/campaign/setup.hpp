// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign/draw.hpp"

namespace fantail::campaign {

// What a campaign's words stand for, before anything is flown.

/// Empty for "independent", which is how every run is drawn; earlier versions had more ways.
[[nodiscard]] std::string objection_to_sampling(const std::string& word);

/// What a scenario's own file says, for who asks for no other. Throws text::Error.
[[nodiscard]] std::uint64_t seed_of(const std::string& scenario);
/// With the changes of the campaign. Throws text::Error.
[[nodiscard]] input::ScenarioFiles files_of(const Campaign& campaign);
/// Throws text::Error, also for none, and for a change of a value in whose place a spread puts another.
[[nodiscard]] std::vector<Spread> spreads_of(const Campaign& campaign, const input::ScenarioFiles& files);
[[nodiscard]] Drawer drawer_of(const Campaign& campaign, const std::vector<Spread>& spreads);

[[nodiscard]] Identity identity_of(const Campaign& campaign, const input::ScenarioFiles& files,
                                   const std::vector<Spread>& spreads, const std::string& version);

/// "section.key=value", one a line, and back. The first throws nothing, the second text::Error.
[[nodiscard]] std::string lines_of(const std::vector<input::Override>& changes);
[[nodiscard]] std::vector<input::Override> changes_in(std::string_view lines);

}  // namespace fantail::campaign
