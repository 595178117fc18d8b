// SPDX-License-Identifier: MIT
#include "faults/parts.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/core.h>

#include "json/value.hpp"
#include "text/error.hpp"
#include "text/number.hpp"
#include "text/output_folder.hpp"

namespace fantail::faults {
namespace {

namespace fs = std::filesystem;

constexpr const char* head = "run,seed,begin_ms,outcome,apart_deg,trim_after_s,stands_after_s,what\n";
constexpr const char* end_mark = "end\n";  // of a file that is whole

campaign::Identity read_identity(const fs::path& file, const campaign::Identity& names) {
  campaign::Identity identity;
  try {
    const json::Value all = json::parse(campaign::file_content(file));
    for (const auto& [name, value] : names) {
      if (const json::Value* there = all.find(name)) {
        identity.emplace_back(name, there->text());
      }
    }
  } catch (const json::Error& error) {
    throw text::Error{text::ErrorKind::bad_data,
                      file.string() + ": is not what a campaign of faults writes: " + error.what()};
  }
  return identity;
}

fs::path file_of(const fs::path& folder, std::string part) {
  std::ranges::replace(part, '/', '.');
  return folder / (part + ".csv");
}

template <typename Number>
bool read(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

std::string row_of(const Run& run) {
  return fmt::format("{},{},{},{},{},{},{},{}\n", run.number, run.seed, run.begin_ms,
                     run.outcome ? name(*run.outcome) : "none", run.apart_deg, run.trim_after_s, run.stands_after_s,
                     run.what);
}

std::optional<Run> run_of(std::string_view row) {
  std::array<std::string_view, 7> cells;
  for (std::string_view& cell : cells) {
    const std::size_t comma = row.find(',');
    if (comma == std::string_view::npos) {
      return std::nullopt;
    }
    cell = row.substr(0, comma);
    row.remove_prefix(comma + 1);
  }
  Run run{.what = std::string{row}};
  bool known = cells[3] == "none";
  for (unsigned bit = 0; bit < outcomes; ++bit) {
    const auto outcome = static_cast<Outcome>(1U << bit);
    if (cells[3] == name(outcome)) {
      run.outcome = outcome;
      known = true;
    }
  }
  const bool is_read = read(cells[0], run.number) && read(cells[1], run.seed) && read(cells[2], run.begin_ms) &&
                       read(cells[4], run.apart_deg) && read(cells[5], run.trim_after_s) &&
                       read(cells[6], run.stands_after_s);
  return known && is_read ? std::optional{std::move(run)} : std::nullopt;
}

PartsFolder::PartsFolder(fs::path folder, const campaign::Identity& identity) : parts_{folder / "parts"} {
  const fs::path file = folder / identity_name;
  std::error_code error;
  if (fs::exists(file, error)) {
    const campaign::Identity there = read_identity(file, identity);
    if (const std::string differs = campaign::difference(there, "there", identity, "here"); !differs.empty()) {
      throw text::Error{text::ErrorKind::bad_configuration, folder.string() + ": holds another campaign: " + differs +
                                                                "; take another folder, or remove that one"};
    }
    return;
  }
  const std::array files{text::NamedFile{.name = identity_name, .content = campaign::identity_json(identity)}};
  text::OutputFolder{folder}.write(files);
}

std::optional<std::vector<Run>> PartsFolder::stored(const std::string& part) const {
  const std::string content = campaign::file_content(file_of(parts_, part));
  std::string_view text = content;
  if (!text.starts_with(head) || !text.ends_with(end_mark)) {
    return std::nullopt;
  }
  text.remove_prefix(std::string_view{head}.size());
  text.remove_suffix(std::string_view{end_mark}.size());
  std::vector<Run> runs;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    auto run = end == std::string_view::npos ? std::nullopt : run_of(text.substr(0, end));
    if (!run) {
      return std::nullopt;
    }
    runs.push_back(*std::move(run));
    text.remove_prefix(end + 1);
  }
  return runs;
}

void PartsFolder::store(const std::string& part, const std::vector<Run>& runs) const {
  std::string content = head;
  for (const Run& run : runs) {
    content += row_of(run);
  }
  content += end_mark;
  const std::array files{
      text::NamedFile{.name = file_of(parts_, part).filename().string(), .content = std::move(content)}};
  text::OutputFolder{parts_}.write(files);
}

}  // namespace fantail::faults
