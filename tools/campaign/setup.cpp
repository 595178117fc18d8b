// SPDX-License-Identifier: MIT
#include "campaign/setup.hpp"

#include <algorithm>
#include <span>
#include <system_error>

#include <fmt/format.h>

#include "input/vehicle_file.hpp"
#include "json/value.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"
#include "text/sha256.hpp"

namespace fantail::campaign {
namespace {

std::string hash_of(const std::string& text) { return text::sha256(std::as_bytes(std::span{text})); }

}  // namespace

std::uint64_t seed_of(const std::string& scenario) { return input::ScenarioFiles::load(scenario).read().seed; }

input::ScenarioFiles files_of(const Campaign& campaign) {
  input::ScenarioFiles files = input::ScenarioFiles::load(campaign.scenario);
  for (const input::Override& change : campaign.changes) {
    files.apply(change);
  }
  return files;
}

Drawer drawer_of(const Campaign& campaign, const std::vector<Spread>& spreads) { return {spreads, campaign.seed}; }

std::string objection_to_sampling(const std::string& word) {
  return word == "independent" ? ""
                               : fmt::format(
                                     "sampling = \"{}\"; allowed: independent (Latin hypercube and Sobol points were "
                                     "removed: neither the interval nor the stop rule could show their benefit)",
                                     word);
}

std::string lines_of(const std::vector<input::Override>& changes) {
  std::string lines;
  for (const input::Override& change : changes) {
    std::string line = change.section + '.' + change.key + '=' + change.value;
    std::ranges::replace(line, '\n', ' ');  // which a list may have, and where it means a space
    lines += (lines.empty() ? "" : "\n") + line;
  }
  return lines;
}

std::vector<input::Override> changes_in(std::string_view lines) {
  std::vector<input::Override> changes;
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    changes.push_back(input::parse_override(lines.substr(0, end)));
    lines.remove_prefix(end == std::string_view::npos ? lines.size() : end + 1);
  }
  return changes;
}

Identity identity_of(const Campaign& campaign, const input::ScenarioFiles& files, const std::vector<Spread>& spreads,
                     const std::string& version) {
  std::string tables;
  for (const Spread& spread : spreads) {
    for (const auto& row : spread.rows) {
      tables += fmt::format("{}\n", fmt::join(row, ","));
    }
  }
  return {{"version", version},
          {"file", campaign.scenario},
          {"seed", fmt::format("{}", campaign.seed)},
          {"runs", fmt::format("{}", campaign.runs)},
          {"sampling", "independent"},
          {"stop", "never"},
          {"changes", lines_of(campaign.changes)},
          {"scenario", hash_of(file_content(files.scenario().file()))},
          {"plan", hash_of(file_content(files.plan().file()))},
          {"vehicle", hash_of(file_content(files.vehicle().file()))},
          {"motor", hash_of(file_content(input::motor_file(files.vehicle())))},
          {"tables", hash_of(tables)},
          {"shard", fmt::format("{} of {}", campaign.shard.number, campaign.shard.of)}};
}

std::vector<Spread> spreads_of(const Campaign& campaign, const input::ScenarioFiles& files) {
  std::vector<Spread> spreads = read_spreads(files);
  if (spreads.empty()) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      files.scenario().file() +
                          ": has no [[spread]] table. Add one or more, each with a field, a law and its values, for "
                          "example: field = \"body.roll_inertia_kg_m2\", law = \"normal\", effect = \"factor\", "
                          "standard_deviation = 0.03, one per line (man fantail.toml)"};
  }
  for (const input::Override& change : campaign.changes) {
    for (const Spread& spread : spreads) {
      const bool is_drawn = std::ranges::any_of(spread.fields, [&](const input::NumberField& field) {
        return field.section == change.section && field.key == change.key;
      });
      if (is_drawn && spread.ignores_the_file()) {
        throw text::Error{text::ErrorKind::bad_configuration,
                          fmt::format("{}.{} = {} changes nothing: {} draws a value that replaces it", change.section,
                                      change.key, change.value, spread.where)};
      }
    }
  }
  return spreads;
}

void require_no_other(const std::filesystem::path& folder, const Identity& identity) {
  std::error_code ignored;
  if (!std::filesystem::exists(folder / identity_name, ignored)) {
    return;
  }
  if (const std::string differs = runs::difference(read_identity(folder), "there", identity, "here");
      !differs.empty()) {
    throw text::Error{text::ErrorKind::bad_configuration, folder.string() + ": holds another campaign: " + differs +
                                                              "; take another folder, or remove that one"};
  }
}

std::string file_content(const std::filesystem::path& file, std::size_t most) {
  return text::read_if_there(file, text::InputKind::data, most).value_or(std::string{});
}

Identity read_identity(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / identity_name;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    throw text::Error{text::ErrorKind::no_such_input, file.string() + ": no such file, so no campaign was flown there"};
  }
  try {
    return runs::parse_identity(file_content(file));
  } catch (const json::Error& error) {
    throw text::Error{text::ErrorKind::bad_data, file.string() + ": was not written by a campaign: " + error.what()};
  }
}

}  // namespace fantail::campaign
