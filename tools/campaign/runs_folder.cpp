// SPDX-License-Identifier: MIT
#include "campaign/runs_folder.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include "campaign/gzip.hpp"
#include "json/value.hpp"
#include "text/error.hpp"
#include "text/output_folder.hpp"

namespace fantail::campaign {
namespace {

namespace fs = std::filesystem;
using Json = json::Value;

constexpr const char* identity_name = "campaign.json";
constexpr const char* chunks_name = "chunks";

std::string content(const fs::path& file) {
  std::ifstream stream{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

[[noreturn]] void refuse(const std::string& complaint) {
  throw text::Error{text::ErrorKind::bad_configuration, complaint};
}

std::string as_json(const Identity& identity) {
  Json all;
  for (const auto& [name, value] : identity) {
    all[name] = value;
  }
  return all.dump() + "\n";
}

void require_same(const fs::path& file, const Identity& identity) {
  Json there;
  try {
    there = json::parse(content(file));
  } catch (const json::Error& error) {
    refuse(file.string() + ": is not what a campaign writes: " + error.what());
  }
  for (const auto& [name, value] : identity) {
    const Json* other = there.find(name);
    if (other == nullptr || !other->is_text() || other->text() != value) {
      refuse(fmt::format(
          "{}: holds another campaign: {} is {} there and {} here; take another folder, or remove that "
          "one",
          file.parent_path().string(), name, other != nullptr && other->is_text() ? other->text() : "missing", value));
    }
  }
}

}  // namespace

RunsFolder::RunsFolder(fs::path folder, const Identity& identity, std::vector<Spread> spreads)
    : folder_{std::move(folder)}, spreads_{std::move(spreads)}, lock_{-1} {
  std::error_code error;
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
      refuse(folder_.string() + ": another campaign is at work in this folder");
    }
    throw text::OutputError{folder_.string() + ": " + std::strerror(why)};
  }
  try {
    const fs::path file = folder_ / identity_name;
    if (fs::exists(file, error)) {
      require_same(file, identity);
    } else {
      const std::array files{text::NamedFile{.name = identity_name, .content = as_json(identity)}};
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

std::optional<std::vector<FlownRun>> RunsFolder::stored(std::uint64_t chunk, std::uint64_t first_run,
                                                        std::uint64_t count, std::uint64_t master_seed) const {
  const fs::path file = chunk_file(chunk);
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    return std::nullopt;
  }
  const auto rows = gunzip(content(file));
  if (!rows) {
    return std::nullopt;
  }
  try {
    std::vector<FlownRun> runs = read_rows(*rows, spreads_, file.string());
    bool whole = runs.size() == count;
    for (std::uint64_t i = 0; whole && i < count; ++i) {
      whole = runs[i].run == first_run + i && runs[i].seed == seed_of_run(master_seed, first_run + i);
    }
    return whole ? std::optional{std::move(runs)} : std::nullopt;
  } catch (const text::Error&) {
    return std::nullopt;
  }
}

void RunsFolder::store(std::uint64_t chunk, const std::vector<FlownRun>& runs) const {
  std::string rows;
  for (const FlownRun& run : runs) {
    rows += csv_row(run);
  }
  const std::array files{text::NamedFile{.name = chunk_file(chunk).filename().string(), .content = gzip(rows)}};
  text::OutputFolder{folder_ / chunks_name}.write(files);
}

void RunsFolder::finish(std::uint64_t chunks) const {
  std::string all = gzip(header_row(spreads_));
  for (std::uint64_t chunk = 0; chunk < chunks; ++chunk) {
    all += content(chunk_file(chunk));
  }
  const std::array files{text::NamedFile{.name = "runs.csv.gz", .content = std::move(all)}};
  text::OutputFolder{folder_}.write(files);
  std::error_code ignored;
  fs::remove_all(folder_ / chunks_name, ignored);
}

}  // namespace fantail::campaign
