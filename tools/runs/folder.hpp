// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fantail::runs {

/// What makes many flights these and no others, in the order of their names: "seed", "7". "file" does not: the same
/// scenario may lie elsewhere on another machine.
using Identity = std::vector<std::pair<std::string, std::string>>;

/// The first that `one` says otherwise than `other`, with where they are: "seed is 7 there and 8 here". Empty when both
/// say the same.
[[nodiscard]] std::string difference(const Identity& one, std::string_view where, const Identity& other,
                                     std::string_view where_other);

/// An identity's text, a line, and back. The second throws json::Error for what is none.
[[nodiscard]] std::string identity_json(const Identity& identity);
[[nodiscard]] Identity parse_identity(std::string_view json);

/// So much of a digest as tells two apart, where a person may have to read it: 16 digits.
[[nodiscard]] std::string short_digest(std::string_view content);

/// Where flights are kept while others are still to be flown, and whose they are.
struct Place {
  std::filesystem::path folder{};  ///< of the results
  std::string parts{"parts"};      ///< the folder in it; what has files of the same names in `folder` shares one
  Identity identity{};
  std::string not_beside{};      ///< a file in `folder` that says it holds other results of the same names
  bool replaces_others = false;  ///< parts of other flights are removed, and not a reason to refuse
};

/// The parts of many flights in a folder, each sealed with what is flown, its name and its content. A part is written
/// under another name, brought to the disk and then renamed; what is found without its seal is none. So whoever begins
/// again finds a part whole or not at all, whatever has ended the program before. One process at a time.
class Folder {
 public:
  static constexpr const char* identity_name = "identity.json";

  /// Makes the folder, or goes on in it. Throws text::Error (bad_configuration) when it holds other flights, naming
  /// what differs, or such of an earlier version, or when another process is at work in it; (bad_data) when it does not
  /// say what it holds; text::OutputError when it cannot be written.
  explicit Folder(const Place& place);
  /// A folder that it has made and in which no part was stored is gone afterwards.
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  /// Empty: not there, or without its seal. Throws as text::read_input() does for one of more than `most` bytes.
  [[nodiscard]] std::optional<std::string> stored(const std::string& part) const;
  /// From any thread. Throws text::OutputError; the parts before it stay.
  void store(const std::string& part, std::string_view content) const;
  /// All of them: when they have become a result.
  void remove() const;
  /// How many were there and damaged.
  [[nodiscard]] std::uint64_t damaged() const { return damaged_; }

 private:
  /// On a folder, which it makes; it goes with the process, however that ends.
  class Lock {
   public:
    explicit Lock(const std::filesystem::path& folder);
    ~Lock();
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

   private:
    int file_ = -1;
  };

  [[nodiscard]] std::filesystem::path file_of(const std::string& part) const;
  [[nodiscard]] std::string seal(const std::string& part, std::string_view content) const;

  std::filesystem::path parts_;
  std::string identity_;
  std::filesystem::path made_;  ///< the uppermost folder that was not there; empty: all were
  std::optional<Lock> lock_{};
  mutable std::atomic<std::uint64_t> damaged_{0};
};

/// Is any part of these flights finished?
[[nodiscard]] bool has_parts(const Place& place);

}  // namespace fantail::runs
