// SPDX-License-Identifier: MIT
#include "campaign/stored_parts.hpp"

#include <array>
#include <span>
#include <system_error>

#include <fmt/core.h>

#include "json/value.hpp"
#include "text/error.hpp"
#include "text/sha256.hpp"

namespace fantail::campaign {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& folder, const std::string& why) {
  throw text::Error{
      text::ErrorKind::bad_configuration,
      fmt::format("{}: choose another folder with --out, or remove this one; it holds another campaign: {}",
                  folder.string(), why)};
}

struct KindOfFolder {
  std::string_view file;
  std::string_view verb;
};
constexpr std::array<KindOfFolder, 3> kinds{{{RunsFolder::identity_name, "campaign"},
                                             {"faults.json", "campaign faults"},
                                             {"parts.jsonl", "campaign detection"}}};

}  // namespace

std::string seal(const Identity& identity, std::string_view part, std::string_view content) {
  return short_digest(fmt::format("{}{}\n{}", identity_json(identity), part, content));
}

std::string short_digest(std::string_view content) {
  return text::sha256(std::as_bytes(std::span{content.data(), content.size()})).substr(0, 16);
}

Identity parse_identity(std::string_view json) {
  const json::Value all = json::parse(json);
  Identity identity;
  for (const json::Member& member : all.members()) {
    identity.emplace_back(member.key, member.value.is_text() ? member.value.text() : member.value.dump());
  }
  return identity;
}

void require_same(const std::filesystem::path& folder, const Identity& there, const Identity& here) {
  if (const std::string differs = difference(there, "there", here, "here"); !differs.empty()) {
    refuse(folder, differs);
  }
}

void require_no_other_kind(const std::filesystem::path& folder, std::string_view own) {
  for (const KindOfFolder& kind : kinds) {
    std::error_code ignored;
    if (kind.file != own && std::filesystem::exists(folder / kind.file, ignored)) {
      refuse(folder, fmt::format("{} of fantail {}", kind.file, kind.verb));
    }
  }
}

}  // namespace fantail::campaign
