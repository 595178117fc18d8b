// SPDX-License-Identifier: MIT
#include "detection/parts_file.hpp"

#include <span>
#include <system_error>
#include <vector>

#include <fmt/core.h>

#include "detection/fingerprint.hpp"
#include "json/value.hpp"
#include "text/error.hpp"
#include "text/output_folder.hpp"
#include "text/sha256.hpp"

namespace fantail::detection {
namespace {

std::string identity_line(const Campaign& campaign, const std::string& version) {
  std::vector<json::Value> rules;
  for (const Rule& rule : campaign.rules) {
    const std::string rule_text = identity_of(rule);
    rules.push_back({{"names", rule.name()}, {"sha256", text::sha256(std::as_bytes(std::span{rule_text}))}});
  }
  return json::Value{{"events", fingerprint(campaign.rules)},
                     {"version", version},
                     {"seed", campaign.seed},
                     {"both_well", campaign.both_well},
                     {"rules", rules}}
      .dump();
}

}  // namespace

PartsFile::PartsFile(const std::filesystem::path& folder, const Campaign& campaign, const std::string& version)
    : file_{folder / name} {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const std::string identity = identity_line(campaign, version);
  const bool is_there = std::filesystem::exists(file_, error);
  if (is_there) {
    read(identity, campaign.rules.size());
  }
  out_.open(file_, std::ios::app);
  if (!is_there) {
    out_ << identity << '\n';
  } else {
    out_ << '\n';  // ends a line that was cut
  }
  if (!out_.flush()) {
    throw text::OutputError{file_.string() + ": cannot be written"};
  }
}

void PartsFile::read(const std::string& identity, std::size_t rules) {
  std::ifstream in{file_};
  std::string line;
  std::getline(in, line);
  if (line != identity) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      fmt::format("{}: is of another campaign: {} there, {} here; choose another --out, or remove it",
                                  file_.string(), line.substr(0, 400), identity)};
  }
  while (std::getline(in, line)) {
    try {
      const json::Value value = json::parse(line);
      const auto kind = kind_of(value["kind"].text());
      if (kind) {
        parts_.insert_or_assign({*kind, value["chunk"].count()},
                                Part{value["events"].count(), tally_of(value["tally"], rules)});
      }
    } catch (const json::Error&) {
      continue;  // cut, and so played again
    }
  }
}

const Tally* PartsFile::find(Kind kind, std::uint64_t chunk, std::uint64_t events) const {
  const auto found = parts_.find({kind, chunk});
  return found != parts_.end() && found->second.events == events ? &found->second.tally : nullptr;
}

void PartsFile::store(Kind kind, std::uint64_t chunk, std::uint64_t events, const Tally& tally) {
  const json::Value value{
      {"kind", info(kind).name}, {"chunk", chunk}, {"events", events}, {"tally", tally_json(tally)}};
  const std::string line = value.dump() + '\n';
  const std::lock_guard lock{mutex_};
  if (!out_.write(line.data(), static_cast<std::streamsize>(line.size())).flush()) {
    throw text::OutputError{file_.string() + ": cannot be written; what was finished before is kept"};
  }
}

}  // namespace fantail::detection
