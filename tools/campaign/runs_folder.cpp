// SPDX-License-Identifier: MIT
#include "campaign/runs_folder.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include "campaign/seed_of_run.hpp"
#include "campaign/stored_parts.hpp"
#include "json/value.hpp"
#include "text/deflate.hpp"
#include "text/error.hpp"
#include "text/output_folder.hpp"

namespace fantail::campaign {
namespace {

namespace fs = std::filesystem;
using Json = json::Value;

constexpr const char* chunks_name = "chunks";

[[noreturn]] void refuse(const std::string& complaint) {
  throw text::Error{text::ErrorKind::bad_configuration, complaint};
}

}  // namespace

void require_no_other(const fs::path& folder, const Identity& identity) {
  require_no_other_kind(folder, RunsFolder::identity_name);
  std::error_code ignored;
  if (!fs::exists(folder / RunsFolder::identity_name, ignored)) {
    return;
  }
  if (const std::string differs = difference(read_identity(folder), "there", identity, "here"); !differs.empty()) {
    refuse(folder.string() + ": holds another campaign: " + differs + "; take another folder, or remove that one");
  }
}

std::string file_content(const fs::path& file, std::size_t most) {
  return text::read_if_there(file, text::InputKind::data, most).value_or(std::string{});
}

std::size_t most_bytes(const Stretch& runs) {
  constexpr std::size_t of_header = std::size_t{1} << 20U;
  constexpr std::size_t of_a_run = 4096;  // ten times what one has
  return of_header + of_a_run * static_cast<std::size_t>(runs.count);
}

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
  Json all;
  for (const auto& [name, value] : identity) {
    all[name] = value;
  }
  return all.dump() + "\n";
}

Identity read_identity(const fs::path& folder) {
  const fs::path file = folder / RunsFolder::identity_name;
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    throw text::Error{text::ErrorKind::no_such_input, file.string() + ": no such file, so no campaign was flown there"};
  }
  Identity identity;
  try {
    const Json all = json::parse(file_content(file));
    for (const std::string_view name : identity_names) {
      if (const Json* value = all.find(name)) {
        identity.emplace_back(name, value->text());
      }
    }
  } catch (const json::Error& error) {
    throw text::Error{text::ErrorKind::bad_data, file.string() + ": is not what a campaign writes: " + error.what()};
  }
  return identity;
}

Beginning::Beginning(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) {
    lock_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock_ < 0 || flock(lock_, LOCK_EX) != 0) {
      error = std::error_code{errno, std::generic_category()};
    }
  }
  if (error) {
    close(lock_);
    throw text::OutputError{folder.string() + ": " + error.message()};
  }
}

Beginning::~Beginning() { close(lock_); }

RunsFolder::RunsFolder(fs::path folder, const Identity& identity, std::vector<Spread> spreads)
    : folder_{std::move(folder)}, spreads_{std::move(spreads)}, lock_{-1} {
  const fs::path file = folder_ / identity_name;
  std::error_code error;
  require_no_other(folder_, identity);
  fs::create_directories(folder_ / chunks_name, error);
  if (error) {
    throw text::OutputError{(folder_ / chunks_name).string() + ": " + error.message()};
  }
  lock_ = open((folder_ / chunks_name).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0 || flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    const int why = errno;
    if (lock_ >= 0) {
      close(lock_);
    }
    if (why == EWOULDBLOCK) {
      refuse(folder_.string() +
             ": another campaign is at work in this folder; wait for its end, or take another folder with --out");
    }
    throw text::OutputError{folder_.string() + ": " + std::strerror(why)};
  }
  try {
    if (fs::exists(file, error)) {  // since the first look, by another process
      require_no_other(folder_, identity);
    } else {
      const std::array files{text::NamedFile{.name = identity_name, .content = identity_json(identity)}};
      text::OutputFolder{folder_}.write(files);
    }
  } catch (...) {
    close(lock_);
    throw;
  }
}

RunsFolder::~RunsFolder() { close(lock_); }

fs::path RunsFolder::chunk_file(std::uint64_t chunk) const {
  return folder_ / chunks_name / fmt::format("{:08}.csv.gz", chunk);
}

std::optional<std::vector<FlownRun>> RunsFolder::whole(const std::string& rows, const std::string& name,
                                                       const Stretch& stretch, std::uint64_t master_seed,
                                                       bool may_be_fewer, Rows kind) const {
  constexpr std::size_t piece = 1U << 26U;  // of rows that are read at once
  try {
    std::vector<FlownRun> runs;
    for (std::size_t begin = 0; begin < rows.size();) {
      const std::size_t end = rows.size() - begin <= piece ? rows.size() : rows.rfind('\n', begin + piece) + 1;
      if (end <= begin) {
        return std::nullopt;  // no row is so long
      }
      std::ranges::move(read_rows(rows.substr(begin, end - begin), spreads_, name, kind), std::back_inserter(runs));
      begin = end;
    }
    bool is_whole = runs.size() == stretch.count || (may_be_fewer && !runs.empty() && runs.size() < stretch.count &&
                                                     runs.size() % runs_of_a_chunk == 0);
    for (std::uint64_t i = 0; is_whole && i < runs.size(); ++i) {
      const std::uint64_t run = stretch.first + i;
      is_whole = runs[i].run == run && runs[i].seed == seed_in_rows(kind == Rows::checked, master_seed, run);
    }
    return is_whole ? std::optional{std::move(runs)} : std::nullopt;
  } catch (const text::Error&) {
    return std::nullopt;
  }
}

RunsFolder::Finished RunsFolder::finished(const Stretch& stretch, std::uint64_t master_seed, bool may_be_fewer) const {
  const fs::path file = folder_ / runs_name;
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    return {};
  }
  Finished found{.remark = file.string() + ": was damaged"};
  const std::size_t most = most_bytes(stretch);
  const auto text = text::gunzip(file_content(file, most), most);
  for (const Rows kind : {Rows::checked, Rows::unchecked}) {
    const std::string header = header_row(spreads_, kind);
    if (!text || !text->starts_with(header)) {
      continue;
    }
    const std::string rows = text->substr(header.size());
    if (const auto place = kind == Rows::checked ? edited_row(rows) : std::nullopt) {
      found.remark =
          fmt::format("{}: the row of run {} is not as it was written", file.string(), stretch.first + *place);
    } else if ((found.runs = whole(rows, file.string(), stretch, master_seed, may_be_fewer, kind))) {
      found.remark = kind == Rows::checked ? ""
                                           : file.string() +
                                                 ": was written by an earlier version, whose rows carry no check; an "
                                                 "edited row would not be noticed";
    }
    break;
  }
  return found;
}

std::optional<std::vector<FlownRun>> RunsFolder::stored(std::uint64_t chunk, const Stretch& stretch,
                                                        std::uint64_t master_seed) const {
  const fs::path file = chunk_file(chunk);
  const std::size_t most = most_bytes(stretch);
  const auto rows = text::gunzip(file_content(file, most), most);
  return rows && !edited_row(*rows) ? whole(*rows, file.string(), stretch, master_seed, false, Rows::checked)
                                    : std::nullopt;
}

void RunsFolder::store(std::uint64_t chunk, const std::vector<FlownRun>& runs) const {
  std::string rows;
  for (const FlownRun& run : runs) {
    rows += csv_row(run);
  }
  const std::array files{text::NamedFile{.name = chunk_file(chunk).filename().string(), .content = text::gzip(rows)}};
  text::OutputFolder{folder_ / chunks_name}.write(files);
}

void RunsFolder::finish(std::uint64_t first_chunk, std::uint64_t end_chunk) const {
  std::string all = text::gzip(header_row(spreads_));
  for (std::uint64_t chunk = first_chunk; chunk < end_chunk; ++chunk) {
    all += file_content(chunk_file(chunk));
  }
  const std::array files{text::NamedFile{.name = runs_name, .content = std::move(all)}};
  text::OutputFolder{folder_}.write(files);
  remove_chunks();
}

void RunsFolder::remove_chunks() const {
  std::error_code ignored;  // what stays is flown by nobody
  fs::remove_all(folder_ / chunks_name, ignored);
}

}  // namespace fantail::campaign
