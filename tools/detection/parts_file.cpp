// SPDX-License-Identifier: MIT
#include "detection/parts_file.hpp"

#include <array>
#include <optional>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "campaign/runs_folder.hpp"
#include "detection/fingerprint.hpp"
#include "json/value.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"
#include "text/output_folder.hpp"

namespace fantail::detection {
namespace {

constexpr std::string_view seal_mark = R"(,"seal":")";
constexpr std::string_view seal_end = R"("})";
constexpr std::size_t seal_digits = 16;

campaign::Identity identity_of(const Campaign& campaign, const std::string& program) {
  std::string names;
  std::string texts;
  for (const Rule& rule : campaign.rules) {
    names += (names.empty() ? "" : "; ") + rule.name();
    texts += identity_of(rule) + '\n';
  }
  return {{"seed", fmt::format("{}", campaign.seed)},
          {"both_well", campaign.both_well ? "yes" : "no"},
          {"plans", names},
          {"rules", campaign::short_digest(texts)},
          {"program", program},
          {"events", fingerprint(campaign.rules).substr(0, seal_digits)}};
}

/// The JSON that was sealed; empty when the line is no sealed one, or its seal is another.
std::optional<std::string> opened(const std::string& line, const campaign::Identity& identity) {
  const std::size_t tail = seal_mark.size() + seal_digits + seal_end.size();
  if (line.size() <= tail || !line.ends_with(seal_end) ||
      line.compare(line.size() - tail, seal_mark.size(), seal_mark) != 0) {
    return std::nullopt;
  }
  std::string content = line.substr(0, line.size() - tail) + '}';
  const std::string seal = line.substr(line.size() - seal_digits - seal_end.size(), seal_digits);
  return seal == campaign::seal(identity, PartsFile::name, content) ? std::optional{std::move(content)} : std::nullopt;
}

}  // namespace

PartsFile::PartsFile(const std::filesystem::path& folder, const Campaign& campaign, const std::string& program)
    : folder_{folder}, file_{folder / name}, identity_{identity_of(campaign, program)} {
  const campaign::Beginning beginning{folder};
  campaign::require_no_other_kind(folder, name);
  if (!read(campaign.rules.size()) || damaged_ > 0) {
    begin_anew();
  }
  out_.open(file_, std::ios::app);
  if (!out_.flush()) {
    throw text::OutputError{file_.string() + ": cannot be written"};
  }
}

bool PartsFile::read(std::size_t rules) {
  std::istringstream in{text::read_if_there(file_).value_or(std::string{})};
  std::string line;
  if (!std::getline(in, line)) {
    return false;
  }
  const bool is_torn = in.eof() && line.starts_with('{');  // by a disk that was full
  if (is_torn) {
    return false;
  }
  campaign::Identity there;
  try {
    there = campaign::parse_identity(line);
  } catch (const json::Error&) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      file_.string() +
                          ": choose another folder with --out, or remove this file; no campaign of "
                          "detections has written it"};
  }
  campaign::require_same(folder_, there, identity_);
  while (std::getline(in, line)) {
    try {
      const auto content = opened(line, identity_);
      if (!content) {
        ++damaged_;
        continue;
      }
      const json::Value value = json::parse(*content);
      parts_.insert_or_assign({kind_of(value["kind"].text()).value(), value["chunk"].count()},
                              Part{value["events"].count(), tally_of(value["tally"], rules)});
    } catch (const std::exception&) {
      ++damaged_;
    }
  }
  return true;
}

void PartsFile::begin_anew() const {
  std::string content = campaign::identity_json(identity_);
  for (const auto& [chunk, part] : parts_) {
    content += line_of(chunk, part.events, part.tally);
  }
  const std::array files{text::NamedFile{.name = name, .content = std::move(content)}};
  text::OutputFolder{folder_}.write(files);
}

std::string PartsFile::line_of(const Name& chunk, std::uint64_t events, const Tally& tally) const {
  std::string line =
      json::Value{
          {"kind", info(chunk.first).name}, {"chunk", chunk.second}, {"events", events}, {"tally", tally_json(tally)}}
          .dump();
  const std::string seal = campaign::seal(identity_, PartsFile::name, line);
  line.pop_back();
  return fmt::format("{}{}{}{}\n", line, seal_mark, seal, seal_end);
}

const Tally* PartsFile::find(Kind kind, std::uint64_t chunk, std::uint64_t events) const {
  const auto found = parts_.find({kind, chunk});
  return found != parts_.end() && found->second.events == events ? &found->second.tally : nullptr;
}

void PartsFile::store(Kind kind, std::uint64_t chunk, std::uint64_t events, const Tally& tally) {
  const std::string line = line_of({kind, chunk}, events, tally);
  const std::lock_guard lock{mutex_};
  if (!out_.write(line.data(), static_cast<std::streamsize>(line.size())).flush()) {
    throw text::OutputError{file_.string() + ": cannot be written; what was finished before is kept"};
  }
}

}  // namespace fantail::detection
