// SPDX-License-Identifier: MIT
#include "telemetry/packet.hpp"

#include <algorithm>

namespace fantail::telemetry {
namespace {

constexpr std::array<std::string_view, channel_count> names{"FANTAIL_STATE", "FANTAIL_CANARDS", "FANTAIL_EVENT",
                                                            "FANTAIL_HEALTH"};

}  // namespace

std::string_view name(Channel channel) { return names[static_cast<std::size_t>(channel)]; }

std::optional<Channel> channel_named(std::string_view name) {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? std::nullopt : std::optional{static_cast<Channel>(found - names.begin())};
}

}  // namespace fantail::telemetry
