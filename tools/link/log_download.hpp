// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "link/log_reader.hpp"

namespace fantail::link {

/// What has been downloaded so far, in a file that outlives this program. Verified bytes only are written to it, in
/// order; a program that is killed can leave it shorter. A power cut, a disk or a person can leave it wrong, so what is
/// read back is to be verified again (log_verify.hpp). Every call throws text::OutputError with the path and the
/// system's reason.
class LogPart {
 public:
  /// Goes on with the file that is there; makes its folder.
  explicit LogPart(std::filesystem::path path);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] std::vector<std::byte> read(std::uint32_t offset, std::uint32_t size) const;
  void append(std::span<const std::byte> bytes);
  /// Puts other bytes in the place of some that are there.
  void overwrite(std::uint32_t offset, std::span<const std::byte> bytes);
  void start_anew();
  /// When it is no longer needed.
  void remove();

 private:
  void open(std::ios::openmode mode);
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  std::ofstream file_;
  std::uint32_t size_ = 0;
};

/// A stretch of the record, from `offset` on.
struct LogStretch {
  std::uint32_t offset = 0;
  std::uint32_t size = 0;
};

/// As many bytes as asked for, in as many requests as it takes.
[[nodiscard]] std::vector<std::byte> read_all(LogReader& reader, std::uint32_t offset, std::uint32_t size);

/// Whether the avionics still has these bytes from `offset` on, by the first and the last 1792 of them.
[[nodiscard]] bool still_there(LogReader& reader, std::uint32_t offset, std::span<const std::byte> bytes);

/// Fills the part until it holds the stretch, and returns the bytes that were there already. It goes on with those when
/// their first and last 1792 bytes are still what the avionics has; otherwise they are of another record, and it starts
/// anew. `progress` is told the bytes done; it may throw to give up, and so may the place where the bench waits: then
/// the part stays.
std::uint32_t download(LogReader& reader, const LogStretch& stretch, LogPart& part,
                       const std::function<void(std::uint32_t)>& progress);

/// A flight in the avionics' record, of which only the beginning has been read.
struct ListedFlight {
  LogStretch stretch{};  ///< up to the next one, or to the end of the record
  std::string vehicle{};
  std::uint32_t power_up = 0;
};

/// Looks where flights begin. Each begins on a fresh sector with its header, so the first bytes of every sector are
/// asked for: 3 MB take some 20 s. A flight whose first header is damaged is taken for a part of the one before it.
/// `progress` is told the bytes looked through.
[[nodiscard]] std::vector<ListedFlight> list_flights(LogReader& reader, std::uint32_t used_bytes,
                                                     const std::function<void(std::uint32_t)>& progress);

}  // namespace fantail::link
