// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/core.h>

#include "campaign/campaign.hpp"
#include "campaign/runs_file.hpp"
#include "json/value.hpp"
#include "runs/runner.hpp"
#include "text/deflate.hpp"
#include "text/error.hpp"
#include "text/number.hpp"
#include "text/output_folder.hpp"

namespace fantail::campaign {
namespace {

namespace fs = std::filesystem;
using text::ErrorKind;

[[noreturn]] void refuse(ErrorKind kind, const std::string& complaint) { throw text::Error{kind, complaint}; }

/// What a finished shard has left.
struct Part {
  fs::path folder;
  Identity identity;  ///< without the shard
  Shard shard;
};

std::uint64_t number_of(const Part& part, std::string_view name) {
  for (const auto& [key, value] : part.identity) {
    if (const auto number = key == name ? text::whole_number(value) : std::nullopt) {
      return *number;
    }
  }
  refuse(ErrorKind::bad_data, fmt::format("{}: has no {}", (part.folder / identity_name).string(), name));
}

Part read_part(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder / runs_name, ignored)) {
    refuse(ErrorKind::no_such_input, folder.string() + ": no runs.csv.gz; this shard has not been flown to its end");
  }
  Part part{.folder = folder, .identity = read_identity(folder), .shard = {}};
  for (auto entry = part.identity.begin(); entry != part.identity.end(); ++entry) {
    if (entry->first != "shard") {
      continue;
    }
    const std::string_view text = entry->second;
    const std::size_t gap = text.find(" of ");
    const auto number = gap == std::string_view::npos ? std::nullopt : text::whole_number(text.substr(0, gap));
    const auto of = gap == std::string_view::npos ? std::nullopt : text::whole_number(text.substr(gap + 4));
    if (number && of && *number >= 1 && *number <= *of) {
      part.shard = {.number = *number, .of = *of};
      part.identity.erase(entry);
      return part;
    }
    break;
  }
  refuse(ErrorKind::bad_data, (folder / identity_name).string() + ": does not name its shard");
}

void require_same(const Part& first, const Part& other) {
  if (const std::string differs = runs::difference(first.identity, "in the first", other.identity, "in the other");
      !differs.empty()) {
    refuse(ErrorKind::bad_configuration, fmt::format("{} and {} belong to different campaigns: {}",
                                                     first.folder.string(), other.folder.string(), differs));
  }
  if (first.shard.of != other.shard.of) {
    refuse(ErrorKind::bad_configuration,
           fmt::format("{} is one of {} shards, and {} is one of {}", first.folder.string(), first.shard.of,
                       other.folder.string(), other.shard.of));
  }
}

/// By number. All are there once.
std::map<std::uint64_t, Part> all_parts(std::span<const fs::path> folders) {
  std::map<std::uint64_t, Part> parts;
  for (const fs::path& folder : folders) {
    Part part = read_part(folder);
    if (!parts.empty()) {
      require_same(parts.begin()->second, part);
    }
    const auto [there, is_new] = parts.emplace(part.shard.number, part);
    if (!is_new) {
      refuse(ErrorKind::bad_configuration, fmt::format("shard {} is there twice: {} and {}", part.shard.number,
                                                       there->second.folder.string(), folder.string()));
    }
  }
  if (parts.empty()) {
    refuse(ErrorKind::bad_configuration, "no shard is named; allowed: the folders of all shards");
  }
  const std::uint64_t of = parts.begin()->second.shard.of;
  std::string missing;
  for (std::uint64_t number = 1; number <= of; ++number) {
    if (!parts.contains(number)) {
      missing += fmt::format("{}{}", missing.empty() ? "" : ", ", number);
    }
  }
  if (!missing.empty()) {
    refuse(ErrorKind::bad_configuration, fmt::format("{} shards in all; missing: {}", of, missing));
  }
  return parts;
}

/// The compressed rows, without the header's member, which must be `header` in all of them.
std::string rows_of(const Part& part, std::string& header) {
  const fs::path file = part.folder / runs_name;
  const Stretch runs = runs_of_shard(number_of(part, "runs"), part.shard);
  const std::string bytes = file_content(file, most_bytes(runs));
  const auto text = text::gunzip(bytes, most_bytes(runs));
  if (!text) {
    refuse(ErrorKind::bad_data, file.string() + ": is damaged, not complete, or longer than its runs are");
  }
  const std::string own_header = text::gzip(text->substr(0, text->find('\n') + 1));
  if (!bytes.starts_with(own_header) || (!header.empty() && own_header != header)) {
    refuse(ErrorKind::bad_data, file.string() +
                                    ": begins with other columns than the first shard, or was not written "
                                    "by a campaign");
  }
  header = own_header;
  const std::uint64_t seed = number_of(part, "seed");
  const std::string_view columns = std::string_view{*text}.substr(0, text->find('\n'));
  if (!columns.ends_with(",row_check")) {
    refuse(ErrorKind::bad_data, file.string() +
                                    ": was written by an earlier version, whose rows carry no check; fly this shard "
                                    "again, which replaces it");
  }
  std::string_view rows = std::string_view{*text}.substr(columns.size() + 1);
  for (std::uint64_t run = runs.first; run < runs.first + runs.count; ++run) {
    if (!rows.starts_with(fmt::format("{},{},", run, runs::seed_of_run(seed, run)))) {
      refuse(ErrorKind::bad_data, fmt::format("{}: run {} is missing or has another seed", file.string(), run));
    }
    const std::size_t length = rows.find('\n');
    if (edited_row(rows.substr(0, length))) {
      refuse(ErrorKind::bad_data,
             fmt::format("{}: the row of run {} is not as it was written; fly this shard again, which replaces it",
                         file.string(), run));
    }
    rows.remove_prefix(length + 1);
  }
  if (!rows.empty()) {
    refuse(ErrorKind::bad_data, file.string() + ": has more runs than its shard");
  }
  return bytes.substr(own_header.size());
}

}  // namespace

std::uint64_t merge(std::span<const fs::path> shards, const fs::path& out) {
  const std::map<std::uint64_t, Part> parts = all_parts(shards);
  std::string header;
  std::string rows;
  for (const auto& [number, part] : parts) {
    rows += rows_of(part, header);
  }
  Identity whole = parts.begin()->second.identity;
  whole.emplace_back("shard", "1 of 1");
  require_no_other(out, whole);
  const std::array files{text::NamedFile{.name = identity_name, .content = runs::identity_json(whole)},
                         text::NamedFile{.name = runs_name, .content = header + rows}};
  text::OutputFolder{out, {shards.begin(), shards.end()}}.write(files);
  return number_of(parts.begin()->second, "runs");
}

}  // namespace fantail::campaign
