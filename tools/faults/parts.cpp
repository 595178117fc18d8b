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
constexpr std::string_view end_mark = "end ";  // before the seal of a file that is whole
constexpr std::size_t end_size = 4 + 16 + 1;

std::string content_of(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) {
    throw text::OutputError{file.string() + ": is a folder, and no place for a file"};
  }
  return campaign::file_content(file);
}

campaign::Identity read_identity(const fs::path& file) {
  try {
    return campaign::parse_identity(content_of(file));
  } catch (const json::Error& error) {
    throw text::Error{text::ErrorKind::bad_data,
                      fmt::format("{}: choose another folder with --out, or remove this one; "
                                  "no campaign of faults has written this file: {}",
                                  file.string(), error.what())};
  }
}

fs::path file_of(const fs::path& folder, std::string part) {
  std::ranges::replace(part, '/', '.');
  return folder / (part + ".csv");
}

std::string end_of(const campaign::Identity& identity, const std::string& part, std::string_view rows) {
  return fmt::format("{}{}\n", end_mark, campaign::seal(identity, part, rows));
}

template <typename Number>
bool read(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

const char* word_of(const Run& run) {
  return run.outcome ? name(*run.outcome) : run.is_breach ? "breach" : run.came_back ? "came_back" : "none";
}

}  // namespace

std::string row_of(const Run& run) {
  return fmt::format("{},{},{},{},{},{},{},{}\n", run.number, run.seed, run.begin_ms, word_of(run), run.apart_deg,
                     run.trim_after_s, run.stands_after_s, run.what);
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
  run.is_breach = cells[3] == word_of({.is_breach = true});
  run.came_back = cells[3] == word_of({.came_back = true});
  bool known = cells[3] == word_of(run);
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

PartsFolder::PartsFolder(const fs::path& folder, campaign::Identity identity)
    : parts_{folder / "parts"}, identity_{std::move(identity)} {
  campaign::require_no_other_kind(folder, identity_name);
  const campaign::Beginning beginning{folder};
  const fs::path file = folder / identity_name;
  std::error_code error;
  if (fs::exists(file, error)) {
    campaign::require_same(folder, read_identity(file), identity_);
    return;
  }
  const std::array files{text::NamedFile{.name = identity_name, .content = campaign::identity_json(identity_)}};
  text::OutputFolder{folder}.write(files);
}

std::optional<std::vector<Run>> PartsFolder::stored(const std::string& part) const {
  const fs::path file = file_of(parts_, part);
  auto runs = read(part, content_of(file));
  std::error_code error;
  if (!runs && fs::exists(file, error)) {
    ++damaged_;
  }
  return runs;
}

std::optional<std::vector<Run>> PartsFolder::read(const std::string& part, const std::string& content) const {
  std::string_view text = content;
  if (!text.starts_with(head) || text.size() < std::string_view{head}.size() + end_size) {
    return std::nullopt;
  }
  const std::string_view rows = text.substr(0, text.size() - end_size);
  if (text.substr(rows.size()) != end_of(identity_, part, rows)) {
    return std::nullopt;
  }
  text = rows;
  text.remove_prefix(std::string_view{head}.size());
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
  content += end_of(identity_, part, content);
  const std::array files{
      text::NamedFile{.name = file_of(parts_, part).filename().string(), .content = std::move(content)}};
  text::OutputFolder{parts_}.write(files);
}

}  // namespace fantail::faults
