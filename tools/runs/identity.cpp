// SPDX-License-Identifier: MIT
#include "runs/identity.hpp"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/core.h>

#include "json/value.hpp"
#include "text/sha256.hpp"

namespace fantail::runs {

std::string difference(const Identity& one, std::string_view where, const Identity& other,
                       std::string_view where_other) {
  for (const auto& [name, value] : other) {
    const auto same = std::ranges::find(one, name, &Identity::value_type::first);
    if (name != "file" && (same == one.end() || same->second != value)) {
      constexpr std::array hashed{"scenario", "plan", "vehicle", "motor", "tables"};
      if (same != one.end() && std::ranges::find(hashed, name) != hashed.end()) {
        return fmt::format("{} has another content {} than {} (SHA-256 {:.8} and {:.8})", name, where, where_other,
                           same->second, value);
      }
      const auto shown = [](const std::string& text) { return text.empty() ? "none" : text; };
      return fmt::format("{} is {} {} and {} {}", name, same != one.end() ? shown(same->second) : "missing", where,
                         shown(value), where_other);
    }
  }
  return {};
}

std::string identity_json(const Identity& identity) {
  json::Value all;
  for (const auto& [name, value] : identity) {
    all[name] = value;
  }
  return all.dump() + "\n";
}

Identity parse_identity(std::string_view json) {
  const json::Value all = json::parse(json);
  Identity identity;
  for (const json::Member& member : all.members()) {
    identity.emplace_back(member.key, member.value.is_text() ? member.value.text() : member.value.dump());
  }
  return identity;
}

std::string short_digest(std::string_view content) {
  return text::sha256(std::as_bytes(std::span{content.data(), content.size()})).substr(0, 16);
}

}  // namespace fantail::runs
