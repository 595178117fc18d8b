// SPDX-License-Identifier: MIT
#include "fantail/offers.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace fantail::tool {

manual::Offering shipped(input::Shipped kind) {
  return [kind](std::string_view /*begun*/) {
    return manual::Offer{.words = input::shipped_names(kind), .paths = manual::Paths::files};
  };
}

manual::Offer files(std::string_view /*begun*/) { return {.paths = manual::Paths::files}; }

manual::Offer folders(std::string_view /*begun*/) { return {.paths = manual::Paths::folders}; }

manual::Offer can_interfaces(std::string_view /*begun*/) {
  constexpr int can = 280;  // ARPHRD_CAN
  manual::Offer offer;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator{"/sys/class/net", ignored}) {
    int type = 0;
    if (std::ifstream{entry.path() / "type"} >> type && type == can) {
      offer.words.push_back(entry.path().filename().string());
    }
  }
  std::ranges::sort(offer.words);
  return offer;
}

}  // namespace fantail::tool
