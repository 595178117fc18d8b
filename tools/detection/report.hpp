// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "detection/campaign.hpp"

namespace fantail::detection {

struct Report {
  Campaign campaign;
  Results results;
  std::string version;
  std::optional<double> at_most;  ///< missed launches of a judged rule, a share
  double false_at_most = 0.0;     ///< false actuations of a judged rule, a share
};

/// A rule's counts over some kinds and conditions.
struct Sum {
  std::uint64_t events = 0;
  std::uint64_t detected = 0;
  std::uint64_t controlling = 0;
};

/// Of all events that are no launches, in every condition.
[[nodiscard]] Sum events_of(const Results& results, std::size_t rule);
/// Of all launches with both accelerometers well.
[[nodiscard]] Sum launches_of(const Results& results, std::size_t rule);
/// Of one kind, all conditions but `well`.
[[nodiscard]] Sum one_bad_of(const Tally& tally, std::size_t rule);

/// What a judged rule did that it must not, a sentence each; empty when nothing.
[[nodiscard]] std::vector<std::string> failures(const Report& report);

[[nodiscard]] std::string report_text(const Report& report);
/// Events that a command can show again are named by it.
[[nodiscard]] std::string report_json(const Report& report);
[[nodiscard]] std::string report_html(const Report& report);

/// "fantail campaign detection --kind shaking --event 12", with the seed where it is not the usual one.
[[nodiscard]] std::string command_of(const Campaign& campaign, Kind kind, std::uint64_t event);

/// A number of events as "0 (at most 0.0031 %)", with the 95 % bound of their share.
[[nodiscard]] std::string with_bound(std::uint64_t count, std::uint64_t of);

}  // namespace fantail::detection
