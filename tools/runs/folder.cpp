// SPDX-License-Identifier: MIT
#include "runs/folder.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <span>
#include <system_error>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "json/value.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"
#include "text/output_folder.hpp"
#include "text/sha256.hpp"

namespace fantail::runs {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view end_mark = "end ";  // before the seal of a part that is whole
constexpr std::size_t end_size = end_mark.size() + 16 + 1;
constexpr const char* part_suffix = ".part";
constexpr const char* what_to_do = "choose another folder with --out, or remove this one";

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

[[noreturn]] void refuse_another(const fs::path& folder, const std::string& why) {
  throw text::Error{text::ErrorKind::bad_configuration,
                    fmt::format("{}: {}; it holds another campaign: {}", folder.string(), what_to_do, why)};
}

/// What the versions before kept in a folder of results.
void refuse_earlier_version(const fs::path& folder) {
  for (const char* const name : {"chunks", "faults.json", "parts.jsonl"}) {
    if (is_there(folder / name)) {
      throw text::Error{
          text::ErrorKind::bad_configuration,
          fmt::format("{}: {}; it holds {} of an earlier version of Fantail, which this version cannot continue",
                      folder.string(), what_to_do, name)};
    }
  }
}

Identity read_identity(const fs::path& file) {
  try {
    return parse_identity(text::read_input(file));
  } catch (const json::Error& error) {
    throw text::Error{text::ErrorKind::bad_data, fmt::format("{}: {}; this file was not written by Fantail: {}",
                                                             file.string(), what_to_do, error.what())};
  }
}

fs::path uppermost_missing(fs::path folder) {
  fs::path missing;
  for (folder = fs::absolute(folder); !is_there(folder); folder = folder.parent_path()) {
    missing = folder;
  }
  return missing;
}

}  // namespace

std::string difference(const Identity& one, std::string_view where, const Identity& other,
                       std::string_view where_other) {
  for (const auto& [name, value] : other) {
    const auto same = std::ranges::find(one, name, &Identity::value_type::first);
    if (name != "file" && (same == one.end() || same->second != value)) {
      constexpr std::array hashed{"scenario", "plan", "vehicle", "motor", "tables"};
      if (same != one.end() && std::ranges::find(hashed, name) != hashed.end()) {
        return fmt::format("{} has different contents {} and {} (SHA-256 {:.8} and {:.8})", name, where, where_other,
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

Folder::Lock::Lock(const fs::path& folder) {
  constexpr int tries = 100;  // who has ended meanwhile may have removed the folder
  for (int i = 0; i < tries; ++i) {
    std::error_code error;
    fs::create_directories(folder, error);
    file_ = error ? -1 : open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file_ < 0) {
      throw text::OutputError{folder.string() + ": " +
                              (error ? error : std::error_code{errno, std::generic_category()}).message()};
    }
    if (flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      close(file_);
      throw text::Error{text::ErrorKind::bad_configuration,
                        folder.parent_path().string() +
                            ": another run of Fantail is at work in this folder; wait until it ends, or choose another "
                            "folder with --out"};
    }
    struct stat held{};
    struct stat named{};
    if (fstat(file_, &held) == 0 && stat(folder.c_str(), &named) == 0 && held.st_ino == named.st_ino) {
      return;
    }
    close(file_);
  }
  throw text::OutputError{folder.string() + ": another process keeps removing this folder"};
}

Folder::Lock::~Lock() { close(file_); }

Folder::Folder(const Place& place)
    : parts_{place.folder / place.parts}, identity_{identity_json(place.identity)}, made_{uppermost_missing(parts_)} {
  if (!place.replaces_others) {
    refuse_earlier_version(place.folder);
  }
  if (!place.not_beside.empty() && is_there(place.folder / place.not_beside)) {
    refuse_another(place.folder, "the results that " + place.not_beside + " describes");
  }
  lock_.emplace(parts_);
  const fs::path file = parts_ / identity_name;
  if (is_there(file) && place.replaces_others) {
    if (const auto there = text::read_if_there(file); there != identity_) {
      for (const auto& entry : fs::directory_iterator{parts_}) {
        fs::remove_all(entry);
      }
    }
  }
  if (!is_there(file)) {
    text::OutputFolder{parts_}.write(std::array{text::NamedFile{.name = identity_name, .content = identity_}});
    return;
  }
  if (const std::string differs = difference(read_identity(file), "there", place.identity, "here"); !differs.empty()) {
    refuse_another(place.folder, differs);
  }
}

Folder::~Folder() {
  std::error_code ignored;
  if (made_.empty() || has_parts({.folder = parts_.parent_path(), .parts = parts_.filename().string()})) {
    return;
  }
  fs::remove(parts_ / identity_name, ignored);
  const fs::path above = made_.parent_path();
  for (fs::path made = fs::absolute(parts_); made != above && fs::remove(made, ignored); made = made.parent_path()) {
  }
}

fs::path Folder::file_of(const std::string& part) const { return parts_ / (part + part_suffix); }

std::string Folder::seal(const std::string& part, std::string_view content) const {
  return fmt::format("{}{}\n", end_mark, short_digest(fmt::format("{}{}\n{}", identity_, part, content)));
}

std::optional<std::string> Folder::stored(const std::string& part) const {
  const fs::path file = file_of(part);
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) {
    throw text::OutputError{file.string() + ": is a folder, not a file"};
  }
  std::optional<std::string> content = text::read_if_there(file);
  if (!content) {
    return std::nullopt;
  }
  const std::size_t size = content->size() - std::min(content->size(), end_size);
  if (std::string_view{*content}.substr(size) != seal(part, std::string_view{*content}.substr(0, size))) {
    ++damaged_;
    return std::nullopt;
  }
  content->resize(size);
  return content;
}

void Folder::store(const std::string& part, std::string_view content) const {
  text::OutputFolder{parts_}.write(std::array{text::NamedFile{
      .name = file_of(part).filename().string(), .content = fmt::format("{}{}", content, seal(part, content))}});
}

void Folder::remove() const {
  std::error_code ignored;  // what stays is flown by nobody
  fs::remove_all(parts_, ignored);
}

bool has_parts(const Place& place) {
  std::error_code error;
  const fs::directory_iterator files{place.folder / place.parts, error};
  return !error &&
         std::any_of(begin(files), end(files), [](const auto& file) { return file.path().extension() == part_suffix; });
}

}  // namespace fantail::runs
